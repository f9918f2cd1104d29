-- Moves a level's bodies by bump's World and the companion, as the program's solver "bump" does. Prints each
-- body after each frame: frame id x y vx vy. A zero has no sign: it depends on the order of contacts.
--   lua5.3 bump_play.lua FOLDER FRAMES [INPUT.jsonl [MAP.lua]]
-- FOLDER: a level that was exported for bump. INPUT: as for `talus sim --input`, only the mouse; "" for no
-- input. MAP: the level exported for STI. The ground is then what STI's plugin adds from it.
package.path = arg[1] .. "/?.lua;" .. arg[0]:match("^(.*/)[^/]*$") .. "?.lua"
local bump, slopes, level = require "bump_world", require "bump_slopes", require "level"
local tuning = level.tuning
-- bump.lua gives equal contacts in no certain order, so the companion's results must not depend on it.
function bump.tie_key(n) return jit and -n or n * 7919 % 10007 end
local world = bump.newWorld(tuning.cell_size)
slopes.install(world)

local bodies, ids = {}, {}
local function add_body(x, y, w, h, vx, vy)
  local body = {x = x, y = y, vx = vx, vy = vy, previous_x = x, previous_y = y}
  bodies[#bodies + 1], ids[body] = body, #bodies + 1
  world:add(body, x, y, w, h)
end
local elsewhere = {add = function() end}
if arg[4] then require "sti_plugin"(dofile(arg[4]), world) end
slopes.add_level(arg[4] and elsewhere or world, level, {on_ball = function(x, y) add_body(x, y, 8, 8, 0, 0) end})
for _, spawn in ipairs(level.spawns) do add_body(spawn.x, spawn.y, spawn.w, spawn.h, spawn.vx, spawn.vy) end

local function filter(item, other)
  if ids[other] and tuning.bodies == "pass" then return false end
  return slopes.filter(item, other)
end

local function lerp(a, b, t) return ((1 - t) * a) + (t * b) end
local function clamp(v, least, most) return v < least and least or v > most and most or v end
local function within(at, to) return clamp(clamp(to, at - 4096, at + 4096), -1e9, 1e9) end

local function move(body, goal_x, goal_y)
  local hits, count
  body.x, body.y, hits, count = world:move(body, within(body.x, goal_x), within(body.y, goal_y), filter)
  return hits, count
end

local function fall(body)
  body.vy = lerp(body.vy, tuning.fall_speed, tuning.fall_blend)
  body.vx = lerp(body.vx, tuning.drift_speed, tuning.drift_blend)
  local hits, count = move(body, body.x + body.vx, body.y + body.vy)
  local vx, vy = slopes.bounce(body.vx, body.vy, hits, count, tuning)
  body.vx, body.vy = clamp(vx, -4096, 4096), clamp(vy, -4096, 4096)
end

local grabbed
local function drag(body, mouse)
  body.previous_x, body.previous_y = body.x, body.y
  move(body, lerp(body.x, mouse.x - tuning.drag_offset, tuning.drag_blend),
       lerp(body.y, mouse.y - tuning.drag_offset, tuning.drag_blend))
end

local function take_mouse(mouse)
  if mouse.down then
    grabbed = grabbed or world:queryPoint(mouse.x, mouse.y, function(item) return ids[item] ~= nil end)[1]
  elseif grabbed then
    grabbed.vx, grabbed.vy = grabbed.x - grabbed.previous_x, grabbed.y - grabbed.previous_y
    grabbed = nil
  end
end

local inputs = {}
for line in (arg[3] or "") ~= "" and io.lines(arg[3]) or function() end do
  local frame, x, y, down = line:match('"frame": (%d+), "mouse": %[([^,]+), ([^]]+)%], "down": (%l+)')
  inputs[tonumber(frame)] = {x = tonumber(x), y = tonumber(y), down = down == "true"}
end

local mouse = {down = false}
for frame = 1, tonumber(arg[2]) do
  mouse = inputs[frame] or mouse
  take_mouse(mouse)
  for _, body in ipairs(bodies) do
    if body == grabbed then drag(body, mouse) else fall(body) end
  end
  for id, body in ipairs(bodies) do
    print(string.format("%d %d %.17g %.17g %.17g %.17g", frame, id, body.x + 0, body.y + 0, body.vx + 0, body.vy + 0))
  end
end
