-- A level made with Talus. Arrows or A and D run, up, W or space jumps; the mouse drags bodies; R starts anew.
--   love . --trace FRAMES   prints frame, id, x, y, vx and vy of every body in every frame, and ends
local talus = require "talus"
local level = require "level"

local TILE = 8            -- px
local STEP = 1 / 60       -- s
local MOST_STEPS = 4      -- after a longer pause the rest is dropped
local world, sheet, tiles, zoom, left, top, due

local function start()
  world, due = talus.new(level), 0
end

local function trace(frames)
  for _ = 1, frames do
    world:step()
    for _, b in ipairs(world.bodies) do
      print(string.format("%d %d %.17g %.17g %.17g %.17g", world.frame, b.id, b.x, b.y, b.vx, b.vy))
    end
  end
  love.event.quit()
end

-- The map never changes: it is drawn once into a batch. Balls are bodies, and tile 0 is the background.
local function load_tiles()
  local picture = love.image.newImageData("sheet.png")
  love.graphics.setBackgroundColor(picture:getPixel(0, 0))
  sheet = love.graphics.newImage(picture)
  sheet:setFilter("nearest", "nearest")
  tiles = love.graphics.newSpriteBatch(sheet, level.width * level.height)
  for y = 0, level.height - 1 do
    for x = 0, level.width - 1 do
      local tile = level.tiles[y * level.width + x + 1]
      if tile ~= 0 and not level.balls[tile] then
        tiles:add(love.graphics.newQuad(tile % 16 * TILE, math.floor(tile / 16) * TILE, TILE, TILE,
                                        sheet:getDimensions()), x * TILE, y * TILE)
      end
    end
  end
end

function love.load(arguments)
  start()
  if arguments[1] == "--trace" then return trace(tonumber(arguments[2])) end
  load_tiles()
end

local function is_down(...) return love.keyboard.isDown(...) end

local function input()
  local x, y = love.mouse.getPosition()
  return {left = is_down("left", "a"), right = is_down("right", "d"), jump = is_down("up", "w", "space"),
          mouse_x = left + x / zoom, mouse_y = top + y / zoom, mouse_down = love.mouse.isDown(1)}
end

-- The first player is followed, or the first body.
local function place_camera()
  local width, height = love.graphics.getDimensions()
  zoom = math.max(1, math.floor(height / 180))
  local seen = world.bodies[1] or {x = 0, y = 0, w = 0, h = 0}
  for _, body in ipairs(world.bodies) do
    if body.kind == "player" then
      seen = body
      break
    end
  end
  local function within(at, shown, whole) return math.max(0, math.min(at - shown / 2, whole - shown)) end
  left = within(seen.x + seen.w / 2, width / zoom, level.width * TILE)
  top = within(seen.y + seen.h / 2, height / zoom, level.height * TILE)
end

function love.update(seconds)
  place_camera()
  due = math.min(due + seconds, MOST_STEPS * STEP)
  while due >= STEP do
    world:step(input())
    due = due - STEP
  end
end

function love.draw()
  place_camera()
  love.graphics.scale(zoom)
  love.graphics.translate(-math.floor(left * zoom) / zoom, -math.floor(top * zoom) / zoom)
  love.graphics.setColor(1, 1, 1)
  love.graphics.draw(tiles)
  for _, body in ipairs(world.bodies) do
    if body.tile then
      local quad = love.graphics.newQuad(body.tile % 16 * TILE, math.floor(body.tile / 16) * TILE, TILE, TILE,
                                         sheet:getDimensions())
      love.graphics.setColor(1, 1, 1)
      love.graphics.draw(sheet, quad, body.x, body.y)
    else
      if body.kind == "player" then
        love.graphics.setColor(0.25, 0.65, 0.96)
      else
        love.graphics.setColor(0.94, 0.49, 0.34)
      end
      love.graphics.rectangle("fill", body.x, body.y, body.w, body.h)
    end
  end
end

function love.keypressed(key)
  if key == "r" then start() end
  if key == "escape" then love.event.quit() end
end
