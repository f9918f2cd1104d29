-- Draws a level in LÖVE 11 as Talus's editor does, from its sheet: a picture of the tiles in which colour 0 is
-- clear. pictures(level, file) gives
--   draw_ground(x, y)  the layers of tiles from the back to the front; a cell with a ball, which is a body, shows
--                      tile 0. x, y: px, the middle of the view, from which layers with parallax have their places.
--                      Animated tiles show the frame that is due since pictures() was called
--   draw_body(body)    its kind, x, y, w and h. Kinds that look like a figure, such as players, are boxes with a
--                      face. Others have the picture of their `tile`, without one that of the level's first ball
--                      tile, and without any they are discs
local LIGHT, BLUE = {244 / 255, 244 / 255, 244 / 255}, {65 / 255, 166 / 255, 246 / 255}
local DARK = {11 / 255, 12 / 255, 20 / 255}

local function image(picture)
  local drawable = love.graphics.newImage(picture)
  drawable:setFilter("nearest", "nearest")
  return drawable
end

-- Whether tile 0 has one colour: then the background is all that there is of it.
local function is_plain(picture, tile_width, tile_height)
  local r, g, b = picture:getPixel(0, 0)
  for y = 0, tile_height - 1 do
    for x = 0, tile_width - 1 do
      local other_r, other_g, other_b = picture:getPixel(x, y)
      if other_r ~= r or other_g ~= g or other_b ~= b then return false end
    end
  end
  return true
end

-- The tiles of a layer go into one batch, of which only animated tiles change. Gives the batch and those tiles.
local function batch_of(level, layer, sheet, quads, skips_empty, tile_width, tile_height)
  local batch, animated = love.graphics.newSpriteBatch(sheet), {}
  for i, number in ipairs(layer.tiles) do
    local tile = layer.ground and level.balls[number] and 0 or number
    if tile ~= 0 or not skips_empty then
      local x, y = (i - 1) % level.width * tile_width, math.floor((i - 1) / level.width) * tile_height
      local id = batch:add(quads[tile], x, y)
      local frames = level.animations and level.animations[tile]
      if frames then animated[#animated + 1] = {id = id, x = x, y = y, frames = frames, tile = tile} end
    end
  end
  return batch, animated
end

-- The tile that an animation shows. frames: tile and ms in turn. time: ms
local function tile_at(frames, time)
  local whole = 0
  for i = 2, #frames, 2 do whole = whole + frames[i] end
  local left = time % whole
  for i = 1, #frames, 2 do
    if left < frames[i + 1] then return frames[i] end
    left = left - frames[i + 1]
  end
end

local function animate(batch, animated, quads, time)
  for _, cell in ipairs(animated) do
    local tile = tile_at(cell.frames, time)
    if tile ~= cell.tile then
      batch:set(cell.id, quads[tile], cell.x, cell.y)
      cell.tile = tile
    end
  end
end

-- Whether a layer's picture is that of its tiles.
local function is_unchanged(layer)
  return not (layer.opacity or layer.x or layer.y or layer.parallax_x or layer.parallax_y or layer.tint)
end

-- x, y: px, the middle of the view.
local function draw_layer(layer, batch, x, y)
  local tint = layer.tint or {255, 255, 255}
  local to_x = (layer.x or 0) + x * (1 - (layer.parallax_x or 1))
  local to_y = (layer.y or 0) + y * (1 - (layer.parallax_y or 1))
  if to_x ~= 0 or to_y ~= 0 then  -- whole pixels of the screen keep pixel art sharp
    local screen_x, screen_y = love.graphics.transformPoint(to_x, to_y)
    to_x, to_y = love.graphics.inverseTransformPoint(math.floor(screen_x + 0.5), math.floor(screen_y + 0.5))
  end
  love.graphics.setColor(tint[1] / 255, tint[2] / 255, tint[3] / 255, layer.opacity or 1)
  love.graphics.draw(batch, to_x, to_y)
end

local function rectangle(color, x, y, w, h)
  love.graphics.setColor(color)
  love.graphics.rectangle("fill", x, y, w, h)
end

-- The bar below is what it stands on: all of its bottom side, or the middle of it.
local function draw_figure(body)
  local x, y, w, h = body.x, body.y, body.w, body.h
  rectangle(BLUE, x, y, w, h)
  for _, eye in ipairs {0.3, 0.6} do rectangle(DARK, x + w * eye, y + h * 0.2, w * 0.12, h * 0.25) end
  local inset, foot = body.foot == "centre" and w * 0.38 or 0, h * 0.15
  rectangle(LIGHT, x + inset, y + h - foot, w - 2 * inset, foot)
end

return function(level, file)
  local tile_width, tile_height = level.tile_width or 8, level.tile_height or 8  -- px
  local picture = love.image.newImageData(file)
  local r, g, b = picture:getPixel(0, 0)
  love.graphics.setBackgroundColor(r, g, b)
  local clear = image(picture)
  if not level.true_colour then  -- else what is clear on the sheet is clear on the map
    picture:mapPixel(function(_, _, red, green, blue) return red, green, blue, 1 end)
  end
  local quads, first_ball = {}, nil
  local columns, rows = picture:getWidth() / tile_width, picture:getHeight() / tile_height
  for tile = columns * rows - 1, 0, -1 do
    quads[tile] = love.graphics.newQuad(tile % columns * tile_width, math.floor(tile / columns) * tile_height,
                                        tile_width, tile_height, picture:getDimensions())
    if level.balls[tile] then first_ball = tile end
  end
  local full, has_plain_0 = image(picture), is_plain(picture, tile_width, tile_height)
  local layers, batches, animated = level.layers or {{tiles = level.tiles, ground = true}}, {}, {}
  for i, layer in ipairs(layers) do  -- in front of others, and in a changed layer, colour 0 is clear
    local is_back = i == 1 and is_unchanged(layer)
    batches[i], animated[i] = batch_of(level, layer, is_back and full or clear, quads, i > 1 or has_plain_0,
                                       tile_width, tile_height)
  end

  local start = love.timer.getTime()
  local function draw_ground(x, y)
    local time = (love.timer.getTime() - start) * 1000
    for i, layer in ipairs(layers) do
      animate(batches[i], animated[i], quads, time)
      if not layer.hidden then draw_layer(layer, batches[i], x or 0, y or 0) end
    end
  end
  local function draw_body(body)
    local kind, tile = level.kinds[body.kind], body.tile or first_ball
    if kind and kind.look == "figure" then return draw_figure(body) end
    love.graphics.setColor(tile and {1, 1, 1} or LIGHT)
    if tile then
      love.graphics.draw(clear, quads[tile], body.x, body.y, 0, body.w / tile_width, body.h / tile_height)
    else
      love.graphics.circle("fill", body.x + body.w / 2, body.y + body.h / 2, body.w / 2)
    end
  end
  return {draw_ground = draw_ground, draw_body = draw_body}
end
