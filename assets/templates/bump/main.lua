-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- A level made with Talus, moved by bump.lua, in LÖVE 11. bump.lua is one file, under the MIT license, and is
-- not in this folder: get it from https://github.com/kikito/bump.lua and put it here. Then run: love .
local is_found, bump = pcall(require, "bump")
local slopes, level = require "bump_slopes", require "level"
local camera, controls, pictures = require "camera"(level), require "controls", require "pictures"
local tuning = level.tuning

local TILE_WIDTH, TILE_HEIGHT = level.tile_width or 8, level.tile_height or 8  -- px
local STEP = 1 / 60           -- s
local SOFT = {floor_bounce = 0, floor_grip = 1, wall_bounce = 0, slope_bounce = 0}  -- a player's, in bounce()
local SNAP = 3 / 8 * TILE_HEIGHT  -- px below a player who walks where it still finds ground
local HELP = "arrows: run, jump     R: start again     Esc: end"
local world, bodies, drawing, due, steps

local function add_body(body)
  bodies[#bodies + 1] = body
  world:add(body, body.x, body.y, body.w, body.h)
end

local function start()
  world, bodies, due, steps = bump.newWorld(tuning.cell_size), {}, 0, 0
  slopes.install(world)
  slopes.add_level(world, level, {merge = true, on_ball = function(x, y, tile, kind)
    add_body {kind = kind, tile = tile, x = x, y = y, w = TILE_WIDTH, h = TILE_HEIGHT, vx = 0, vy = 0}
  end})
  for _, spawn in ipairs(level.spawns) do
    local body = {}
    for key, value in pairs(spawn) do body[key] = value end
    add_body(body)
  end
end

-- Bodies have a kind, the ground has none.
local function filter(body, other)
  if other.kind and tuning.bodies == "pass" then return false end
  return slopes.filter(body, other)
end

-- All that a body needs of slopes: one move(), and its hits for the velocity.
local function move(body, bounces)
  local hits, count
  body.x, body.y, hits, count = world:move(body, body.x + body.vx, body.y + body.vy, filter)
  body.vx, body.vy = slopes.bounce(body.vx, body.vy, hits, count, bounces)
end

local function blend(from, to, share) return (1 - share) * from + share * to end

local function fall(body)
  body.vx = blend(body.vx, tuning.drift_speed, tuning.drift_blend)
  body.vy = blend(body.vy, tuning.fall_speed, tuning.fall_blend)
  move(body, tuning)
end

local function run(body)
  local held = controls()
  local direction = (held.right and 1 or 0) - (held.left and 1 or 0)
  local jumps = held.jump and slopes.grounded(world, body, filter)
  local walks = not jumps and slopes.grounded(world, body, filter)
  local gain = direction * tuning.run_speed - body.vx
  body.vx = body.vx + math.max(-tuning.run_gain, math.min(gain, tuning.run_gain))
  body.vy = jumps and -tuning.jump_speed or math.min(body.vy + tuning.player_gravity, tuning.fall_limit)
  if walks then body.vy = 0 end  -- it neither hops downhill nor slips off a slope
  move(body, SOFT)
  local floor = walks and slopes.floor(world, body, SNAP, filter)
  if floor then
    body.y = floor
    world:update(body, body.x, body.y)
  end
end

function love.load()
  drawing = pictures(level, "sheet.png")
  if is_found then start() end
end

function love.update(seconds)
  if not is_found then return end
  due = math.min(due + seconds, 4 * STEP)
  while due >= STEP do
    for _, body in ipairs(bodies) do
      if level.kinds[body.kind].takes_keys then run(body) else fall(body) end
    end
    due, steps = due - STEP, steps + 1
  end
end

function love.draw()
  if not is_found then
    return love.graphics.print("bump.lua is missing: get it from https://github.com/kikito/bump.lua", 20, 20)
  end
  camera.follow(bodies)
  camera.begin()
  local middle_x, middle_y = camera.left + camera.width / 2, camera.top + camera.height / 2
  drawing.draw_ground(middle_x, middle_y)
  for _, body in ipairs(bodies) do drawing.draw_body(body, steps) end
  drawing.draw_front(middle_x, middle_y)
  love.graphics.pop()
  love.graphics.setColor(1, 1, 1)
  love.graphics.print(HELP, 8, love.graphics.getHeight() - 22)
end

function love.keypressed(key)
  if key == "r" then love.event.quit("restart") end  -- with the files as they are now
  if key == "escape" then love.event.quit() end
end
