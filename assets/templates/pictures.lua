-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- Draws a level in LÖVE 11 as Talus's editor does, from its sheet: a picture of the tiles in which colour 0 is
-- clear. pictures(level, file) gives
--   draw_ground(x, y, world)  the layers from the back to the front, without those in front of the bodies; a cell with
--                      a ball, which is a body, shows tile 0. x, y: px, the middle of the view, from which layers with
--                      parallax have their places. Animated tiles show the frame that is due since pictures() was
--                      called. world: has tiles that the game changed by world:set_tile; may be missing
--   draw_body(body, step)  its kind, x, y, w and h; step: those made so far. A body with a `picture` shows the frame of
--                      what it does, see frames.lua, and one with a `tile` that tile, animated, and turned by
--                      `tile_turn`, a number of a layer's turns. Of other bodies kinds that look like a figure, such as
--                      players, are boxes with a face; crates, wheels and marbles have looks of their own; the rest has
--                      the picture of the level's first ball tile, and without any they are circles
--   draw_front(x, y)   after the bodies: the layers in front of them. These have the name `front`; the game may also
--                      set `front`, true or false, of any of level.layers. The world is that of draw_ground()
local frames = require "frames"
local TYRE = {41 / 255, 54 / 255, 111 / 255}
local LIGHT, BLUE = {244 / 255, 244 / 255, 244 / 255}, {65 / 255, 166 / 255, 246 / 255}
local DARK = {11 / 255, 12 / 255, 20 / 255}
local RIM, GLASS = {37 / 255, 113 / 255, 121 / 255}, {115 / 255, 239 / 255, 247 / 255}  -- of marbles
local EYE = {239 / 255, 125 / 255, 87 / 255}
local BOARD, FRAME = {160 / 255, 112 / 255, 60 / 255}, {92 / 255, 61 / 255, 32 / 255}  -- of crates

local function image(picture)
  local drawable = love.graphics.newImage(picture)
  drawable:setFilter("nearest", "nearest")
  return drawable
end

-- Whether nothing is seen of tile 0.
local function is_blank(picture, tile_width, tile_height)
  for y = 0, tile_height - 1 do
    for x = 0, tile_width - 1 do
      local _, _, _, opacity = picture:getPixel(x, y)
      if opacity > 0 then return false end
    end
  end
  return true
end

-- How a batch draws a tile in the cell at x, y, so that it is turned: x, y, angle, factors of its width and height,
-- and its middle. turn: 1 if its x and y change places, then + 2 if top and bottom do, + 4 if left and right do. A
-- turned tile keeps the bottom left corner of the cell.
local function turned(turn, x, y, tile_width, tile_height)
  local width, height, angle = tile_width, tile_height, 0
  local factor_x, factor_y = turn >= 4 and -1 or 1, turn % 4 >= 2 and -1 or 1
  if turn % 2 == 1 then
    width, height, angle = tile_height, tile_width, math.pi / 2
    factor_x, factor_y = factor_y, -factor_x
  end
  return x + width / 2, y + tile_height - height / 2, angle, factor_x, factor_y, tile_width / 2, tile_height / 2
end

-- A part of the file of pictures as a quad, and a transform that brings its px onto the map.
local function part_of(numbers, pictures)
  local x, y, w, h, to_x, to_y, right_x, right_y, down_x, down_y = unpack(numbers)
  local transform = love.math.newTransform()
  transform:setMatrix(right_x, down_x, 0, to_x, right_y, down_y, 0, to_y, 0, 0, 1, 0, 0, 0, 0, 1)
  return {quad = love.graphics.newQuad(x, y, w, h, pictures:getDimensions()), transform = transform, w = w, h = h}
end

-- Numbers from one to another, upwards or downwards.
local function range(from, to, is_down)
  if is_down then return to, from, -1 end
  return from, to, 1
end

-- The tiles of a layer go into batches, a new one where the picture changes. Of them only animated tiles change.
-- Gives the batches and those tiles. large: by tile and turn, parts of pictures
local function batches_of(level, layer, sheet, quads, skips_empty, tile_width, tile_height, large, pictures)
  local batches, animated, order = {}, {}, level.render_order or "right-down"
  local function batch_with(texture)
    local last = batches[#batches]
    if last and last:getTexture() == texture then return last end
    batches[#batches + 1] = love.graphics.newSpriteBatch(texture)
    return batches[#batches]
  end
  local function add(column, row)
    local number = layer.tiles[row * level.width + column + 1]
    local tile = layer.ground and level.balls[number] and 0 or number
    if tile == 0 and skips_empty then return end
    local x, y = column * tile_width, row * tile_height
    local turn = layer.turns and layer.turns[row * level.width + column + 1] or 0
    if large[tile] then
      local part = large[tile][turn] or large[tile][0]
      batch_with(pictures):add(part.quad, love.math.newTransform(x, y):apply(part.transform))
      return
    end
    local batch, place = batch_with(sheet), {x, y}
    if turn ~= 0 then place = {turned(turn, x, y, tile_width, tile_height)} end
    local id = batch:add(quads[tile], unpack(place))
    local frames = level.animations and level.animations[tile]
    if frames then animated[#animated + 1] = {batch = batch, id = id, place = place, frames = frames, tile = tile} end
  end
  local first_row, last_row, row_step = range(0, level.height - 1, order:find("up"))
  local first_column, last_column, column_step = range(0, level.width - 1, order:find("left"))
  for row = first_row, last_row, row_step do
    for column = first_column, last_column, column_step do add(column, row) end
  end
  return batches, animated
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

local function animate(animated, quads, time)
  for _, cell in ipairs(animated) do
    local tile = tile_at(cell.frames, time)
    if tile ~= cell.tile then
      cell.batch:set(cell.id, quads[tile], unpack(cell.place))
      cell.tile = tile
    end
  end
end

-- The parts of a layer of objects, in one batch.
local function batch_of_parts(layer, pictures)
  local batch = love.graphics.newSpriteBatch(pictures)
  for _, numbers in ipairs(layer.parts) do
    local part = part_of(numbers, pictures)
    batch:add(part.quad, part.transform)
  end
  return batch
end

-- The picture of a layer, as often as it is seen.
local function draw_image(layer, part, pictures, to_x, to_y)
  local left, top = love.graphics.inverseTransformPoint(0, 0)
  local right, bottom = love.graphics.inverseTransformPoint(love.graphics.getDimensions())
  local function span(from, to, origin, side, repeats)
    if not repeats then return origin, origin end
    return origin + math.floor((from - origin) / side) * side, to
  end
  local first_x, last_x = span(left, right, to_x, part.w, layer.repeats_x)
  local first_y, last_y = span(top, bottom, to_y, part.h, layer.repeats_y)
  for y = first_y, last_y, part.h do
    for x = first_x, last_x, part.w do love.graphics.draw(pictures, part.quad, x, y) end
  end
end

-- draw: draws the layer at a place, px. x, y: px, the middle of the view.
local function draw_layer(layer, draw, x, y)
  local tint = layer.tint or {255, 255, 255}
  local to_x = (layer.x or 0) + x * (1 - (layer.parallax_x or 1))
  local to_y = (layer.y or 0) + y * (1 - (layer.parallax_y or 1))
  if to_x ~= 0 or to_y ~= 0 then  -- whole pixels of the screen keep pixel art sharp
    local screen_x, screen_y = love.graphics.transformPoint(to_x, to_y)
    to_x, to_y = love.graphics.inverseTransformPoint(math.floor(screen_x + 0.5), math.floor(screen_y + 0.5))
  end
  love.graphics.setColor(tint[1] / 255, tint[2] / 255, tint[3] / 255, layer.opacity or 1)
  draw(to_x, to_y)
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

-- Boards in a frame, with one across.
local function draw_crate(body)
  local x, y, w, h = body.x, body.y, body.w, body.h
  local bar = math.min(w, h) * 0.14
  rectangle(FRAME, x, y, w, h)
  rectangle(BOARD, x + bar, y + bar, w - 2 * bar, h - 2 * bar)
  love.graphics.setColor(FRAME)
  love.graphics.polygon("fill", x, y + h - bar, x, y + h, x + bar, y + h, x + w, y + bar, x + w, y, x + w - bar, y)
end

-- A disc that stands on the middle of the box's bottom, with a spoke that shows how it is turned. The program's numbers.
local function draw_wheel(body)
  local radius, turn = math.min(body.w, body.h) / 2, body.turn or 0
  local x, y, rim = body.x + body.w / 2, body.y + body.h - radius, radius * 0.2
  local way_x, way_y = (radius - rim) * math.cos(turn), (radius - rim) * math.sin(turn)
  love.graphics.setColor(TYRE)
  love.graphics.circle("fill", x, y, radius)
  love.graphics.setColor(BLUE)
  love.graphics.circle("fill", x, y, radius - rim)
  love.graphics.setColor(LIGHT)
  love.graphics.setLineWidth(rim)
  love.graphics.line(x - way_x, y - way_y, x + way_x, y + way_y)
  love.graphics.circle("fill", x + way_x * 0.6, y + way_y * 0.6, rim)
end

-- A ball of glass that stands on the middle of the box's bottom. Its eye turns with it, its gleam does not.
local function draw_marble(body)
  local radius = math.min(body.w, body.h) / 2
  love.graphics.push()
  love.graphics.translate(body.x + body.w / 2, body.y + body.h - radius)
  love.graphics.setColor(RIM)
  love.graphics.circle("fill", 0, 0, radius)
  love.graphics.setColor(GLASS)
  love.graphics.circle("fill", 0, 0, radius * 0.85)
  love.graphics.rotate(body.turn or 0)
  love.graphics.setColor(EYE)
  love.graphics.ellipse("fill", 0, 0, radius * 0.65, radius * 0.25)
  love.graphics.rotate(-(body.turn or 0))
  love.graphics.setColor(LIGHT)
  love.graphics.circle("fill", -radius * 0.35, -radius * 0.4, radius * 0.18)
  love.graphics.pop()
end

return function(level, file)
  local tile_width, tile_height = level.tile_width or 8, level.tile_height or 8  -- px
  local picture = love.image.newImageData(file)
  local back = level.background or {0, 0, 0, 0}  -- what is not opaque lies over black
  local opacity = back[4] / 255 ^ 2
  love.graphics.setBackgroundColor(back[1] * opacity, back[2] * opacity, back[3] * opacity)
  local clear, sprites = image(picture), nil
  local quads, first_ball = {}, nil
  local columns, rows = picture:getWidth() / tile_width, picture:getHeight() / tile_height
  for tile = columns * rows - 1, 0, -1 do
    quads[tile] = love.graphics.newQuad(tile % columns * tile_width, math.floor(tile / columns) * tile_height,
                                        tile_width, tile_height, picture:getDimensions())
    if level.balls[tile] then first_ball = tile end
  end
  local layers, drawings, animated = level.layers or {{tiles = level.tiles, ground = true}}, {}, {}
  local pictures = level.pictures and image(level.pictures)
  local large = {}
  for tile, numbers in pairs(level.large_tiles or {}) do large[tile] = {[0] = part_of(numbers, pictures)} end
  for tile, turns in pairs(level.turned_large_tiles or {}) do
    for turn, numbers in pairs(turns) do large[tile][turn] = part_of(numbers, pictures) end
  end
  local is_0_blank, batches = not large[0] and is_blank(picture, tile_width, tile_height), {}
  -- world: gives the tiles, if the game has changed some; nil: they are those of the level
  local function lay_tiles(world)
    local skips_empty = is_0_blank
    for i, layer in ipairs(layers) do
      if layer.tiles then
        local shown = {tiles = layer.tiles, turns = layer.turns, ground = layer.ground}
        if world then shown.tiles, shown.turns = world:tiles_of(i) end
        batches[i], animated[i] =
          batches_of(level, shown, clear, quads, skips_empty, tile_width, tile_height, large, pictures)
        skips_empty = true  -- in layers in front of that one
      end
    end
  end
  lay_tiles()
  for i, layer in ipairs(layers) do
    if not layer.tiles then batches[i], animated[i] = {layer.parts and batch_of_parts(layer, pictures)}, {} end
    local part = layer.image and part_of(layer.image, pictures)
    drawings[i] = function(to_x, to_y)
      if part then draw_image(layer, part, pictures, to_x, to_y) end
      for _, batch in ipairs(batches[i]) do love.graphics.draw(batch, to_x, to_y) end
    end
  end

  for _, layer in ipairs(layers) do
    if layer.front == nil then layer.front = layer.name == "front" end
  end

  local start, changes, shown = love.timer.getTime(), 0, nil
  local function now() return (love.timer.getTime() - start) * 1000 end  -- ms
  local function draw_layers(x, y, front)
    for i, layer in ipairs(layers) do
      if layer.front == front and not layer.hidden then
        animate(animated[i], quads, now())
        draw_layer(layer, drawings[i], x or 0, y or 0)
      end
    end
  end
  local function draw_ground(x, y, world)
    if world and world.changes and (world.changes ~= changes or shown and shown ~= world) then
      lay_tiles(world)
      changes, shown = world.changes, world
    end
    draw_layers(x, y, false)
  end
  local function draw_front(x, y) draw_layers(x, y, true) end

  -- The frame stands on the bottom of the box, in its middle.
  local function draw_picture(body, step)
    local tile, looks_left = frames(body, step)
    local frame = body.picture
    local w, h = frame.columns * tile_width, frame.rows * tile_height
    if frame.sheet == "sprites" then sprites = sprites or image("sprites.png") end
    local sheet = frame.sheet == "sprites" and sprites or clear
    local in_a_row = sheet:getWidth() / tile_width
    local quad = love.graphics.newQuad(tile % in_a_row * tile_width, math.floor(tile / in_a_row) * tile_height, w, h,
                                       sheet:getDimensions())
    love.graphics.setColor(1, 1, 1)
    love.graphics.draw(sheet, quad, body.x + body.w / 2, body.y + body.h - h, 0, looks_left and -1 or 1, 1, w / 2)
  end
  -- A tile as large as the box, or one with a picture of its own, in the box's top left corner.
  local function draw_tile(body, tile, turn)
    love.graphics.setColor(1, 1, 1)
    love.graphics.push()
    love.graphics.translate(body.x, body.y)
    if large[tile] then
      local part = large[tile][turn] or large[tile][0]
      love.graphics.draw(pictures, part.quad, part.transform)
    else
      local frames = level.animations and level.animations[tile]
      love.graphics.scale(body.w / tile_width, body.h / tile_height)
      love.graphics.draw(clear, quads[frames and tile_at(frames, now()) or tile],
                         turned(turn, 0, 0, tile_width, tile_height))
    end
    love.graphics.pop()
  end
  local looks = {figure = draw_figure, crate = draw_crate, wheel = draw_wheel, marble = draw_marble}
  local function draw_body(body, step)
    local draw = looks[(level.kinds[body.kind] or {}).look]
    if body.picture then return draw_picture(body, step) end
    if body.tile then return draw_tile(body, body.tile, body.tile_turn or 0) end
    if draw then return draw(body) end
    if first_ball then return draw_tile(body, first_ball, 0) end
    love.graphics.setColor(LIGHT)
    love.graphics.circle("fill", body.x + body.w / 2, body.y + body.h / 2, body.w / 2)
  end
  return {draw_ground = draw_ground, draw_body = draw_body, draw_front = draw_front}
end
