-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- A level made with Talus, in LÖVE 11: `love .` runs it. It is yours to change; talus.lua tells what a world
-- can do. `love . --trace FRAMES` prints frame, id, x, y, vx and vy of every body in every frame, and ends.
local talus, level = require "talus", require "level"
local area, camera = require "camera"(level)
local controls, curve_points, pictures = require "controls", require "curve_points", require "pictures"

local HELP = "arrows: run, jump     mouse: drag     R: start again     Esc: end"
local HELP_TIME = 10      -- s; H shows it again
local STEP = 1 / 60       -- s
local MOST_STEPS = 4      -- after a longer pause the rest is dropped
local world, drawing, curves, zoom, left, top, due, help_left

local function trace(frames)
  for _ = 1, frames do
    world:step()
    for _, b in ipairs(world.bodies) do
      print(string.format("%d %d %.17g %.17g %.17g %.17g", world.frame, b.id, b.x, b.y, b.vx, b.vy))
    end
  end
  love.event.quit()
end

function love.load(arguments)
  world, due, help_left = talus.new(level), 0, HELP_TIME
  if arguments[1] == "--trace" then return trace(tonumber(arguments[2])) end
  drawing, curves = pictures(level, "sheet.png"), {}
  for i, curve in ipairs(level.curves) do curves[i] = curve_points(curve) end
end

local function input()
  local held, x, y = controls(), love.mouse.getPosition()
  held.mouse_x, held.mouse_y, held.mouse_down = left + x / zoom, top + y / zoom, love.mouse.isDown(1)
  return held
end

-- Pixels are squares of whole pixels of the screen: 22.5 tiles of them from top to bottom, or fewer for a small
-- level.
local function place_view()
  local width, height = love.graphics.getDimensions()
  local whole = math.min(width / (area.right - area.left), height / (area.bottom - area.top))
  zoom = math.max(1, math.floor(math.max(height / (22.5 * (level.tile_height or 8)), whole)))
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

function love.draw()
  place_view()
  love.graphics.push()
  love.graphics.scale(zoom)
  love.graphics.translate(-math.floor(left * zoom) / zoom, -math.floor(top * zoom) / zoom)
  local width, height = love.graphics.getDimensions()
  drawing.draw_ground(left + width / zoom / 2, top + height / zoom / 2, world)
  for _, points in ipairs(curves) do love.graphics.line(points) end
  for _, body in ipairs(world.bodies) do drawing.draw_body(body, world.frame) end
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
