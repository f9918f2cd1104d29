-- A level made with Talus, in LÖVE 11: `love .` runs it. It is yours to change; talus.lua tells what a world
-- can do. `love . --trace FRAMES` prints frame, id, x, y, vx and vy of every body in every frame, and ends.
local talus, level = require "talus", require "level"
local area, camera = require "camera"(level)
local curve_points = require "curve_points"

local HELP = "arrows: run, jump     mouse: drag     R: start again     Esc: end"
local HELP_TIME = 10      -- s; H shows it again
local TILE = 8            -- px
local STEP = 1 / 60       -- s
local MOST_STEPS = 4      -- after a longer pause the rest is dropped
local world, sheet, tiles, curves, zoom, left, top, due, help_left

local function trace(frames)
  for _ = 1, frames do
    world:step()
    for _, b in ipairs(world.bodies) do
      print(string.format("%d %d %.17g %.17g %.17g %.17g", world.frame, b.id, b.x, b.y, b.vx, b.vy))
    end
  end
  love.event.quit()
end

-- The ground never changes: its tiles go into one batch. Balls are bodies, and tile 0 is the background.
local function load_ground()
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
  curves = {}
  for i, curve in ipairs(level.curves) do curves[i] = curve_points(curve) end
end

function love.load(arguments)
  world, due, help_left = talus.new(level), 0, HELP_TIME
  if arguments[1] == "--trace" then return trace(tonumber(arguments[2])) end
  load_ground()
end

local function is_down(...) return love.keyboard.isDown(...) end

local function input()
  local x, y = love.mouse.getPosition()
  return {left = is_down("left", "a"), right = is_down("right", "d"), jump = is_down("up", "w", "space"),
          mouse_x = left + x / zoom, mouse_y = top + y / zoom, mouse_down = love.mouse.isDown(1)}
end

-- Pixels are squares of whole pixels of the screen: 180 of them from top to bottom, or fewer for a small level.
local function place_view()
  local width, height = love.graphics.getDimensions()
  local whole = math.min(width / (area.right - area.left), height / (area.bottom - area.top))
  zoom = math.max(1, math.floor(math.max(height / 180, whole)))
  left, top = camera(world.bodies, width / zoom, height / zoom)
end

function love.update(seconds)
  place_view()
  due = math.min(due + seconds, MOST_STEPS * STEP)
  while due >= STEP do
    world:step(input())
    due = due - STEP
  end
  help_left = help_left - seconds
end

local function draw_body(body)
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

function love.draw()
  place_view()
  love.graphics.push()
  love.graphics.scale(zoom)
  love.graphics.translate(-math.floor(left * zoom) / zoom, -math.floor(top * zoom) / zoom)
  love.graphics.setColor(1, 1, 1)
  love.graphics.draw(tiles)
  for _, points in ipairs(curves) do love.graphics.line(points) end
  for _, body in ipairs(world.bodies) do draw_body(body) end
  love.graphics.pop()
  if help_left > 0 then
    local height = love.graphics.getHeight()
    love.graphics.setColor(0, 0, 0, 0.6)
    love.graphics.rectangle("fill", 0, height - 26, love.graphics.getFont():getWidth(HELP) + 16, 26)
    love.graphics.setColor(1, 1, 1)
    love.graphics.print(HELP, 8, height - 21)
  end
end

function love.keypressed(key)
  if key == "r" then love.event.quit("restart") end  -- with the files as they are now
  if key == "h" then help_left = HELP_TIME end
  if key == "escape" then love.event.quit() end
end
