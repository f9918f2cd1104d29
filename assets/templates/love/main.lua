-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- A level made with Talus, in LÖVE 11: `love .` runs it. It is yours to change, first of all rules.lua, which says
-- what the game is about. talus.lua tells what a world can do.
local talus, level = require "talus", require "level"
local camera, controls, rules = require "camera"(level), require "controls", require "rules"
local curve_points, pictures = require "curve_points", require "pictures"

local HELP = "arrows: run, jump     mouse: drag     P: pause     R: start again     Esc: end"
local STEP = 1 / 60  -- s
local world, game, drawing, curves, due, is_paused

local function start()
  world, due = talus.new(level), 0
  game = rules(world, level)
end

function love.load(arguments)
  if arguments[1] == "--trace" then return require "trace"(talus.new(level), tonumber(arguments[2])) end
  drawing, curves = pictures(level, "sheet.png"), {}
  for i, curve in ipairs(level.curves) do curves[i] = curve_points(curve) end
  start()
  camera.follow(world.bodies)
end

local function step()
  local input, x, y = controls(), love.mouse.getPosition()
  input.mouse_x, input.mouse_y = camera.left + x / camera.zoom, camera.top + y / camera.zoom
  input.mouse_down = love.mouse.isDown(1)
  world:step(input)
  if not game.goes_on() then start() end
end

function love.update(seconds)
  due = is_paused and 0 or math.min(due + seconds, 4 * STEP)  -- after a longer wait the rest is dropped
  while due >= STEP do
    due = due - STEP
    step()
  end
  camera.follow(world.bodies)
end

local function say(text, y)
  for light = 0, 1 do  -- a shadow, and the text
    love.graphics.setColor(light, light, light)
    love.graphics.print(text, 9 - light, y - light)
  end
end

function love.draw()
  local middle_x, middle_y = camera.left + camera.width / 2, camera.top + camera.height / 2
  camera.begin()
  drawing.draw_ground(middle_x, middle_y, world)
  for _, points in ipairs(curves) do love.graphics.line(points) end
  for _, body in ipairs(world.bodies) do drawing.draw_body(body, world.frame) end
  drawing.draw_front(middle_x, middle_y)
  love.graphics.pop()
  say(game.text(), 9)
  if is_paused or world.frame < 600 then say(HELP, love.graphics.getHeight() - 22) end
end

function love.keypressed(key)
  if key == "p" then is_paused = not is_paused end
  if key == "r" then love.event.quit("restart") end  -- with the files as they are now
  if key == "escape" then love.event.quit() end
end

function love.gamepadpressed(_, button) love.keypressed(({start = "p", back = "r"})[button]) end
