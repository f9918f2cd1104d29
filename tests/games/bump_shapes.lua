-- Tests what only the companion for bump has, and not the program's solver "bump": ceilings, one-way ground,
-- lines of many heights, slopes that move, and full tiles as few boxes.
--   lua5.3 bump_shapes.lua COMPANION_FOLDER
package.path = arg[1] .. "/?.lua;" .. arg[0]:match("^(.*/)[^/]*$") .. "?.lua"
local bump, slopes = require "bump_world", require "bump_slopes"

local function is(got, wanted, what)
  if type(wanted) == "number" and type(got) == "number" and math.abs(got - wanted) < 1e-9 then return end
  if got ~= wanted then error(what .. " is " .. tostring(got) .. " instead of " .. tostring(wanted), 2) end
end

local function new_world()
  local world = bump.newWorld(24)
  slopes.install(world)
  return world
end

local tests = {}

function tests.a_ceiling_stops_what_rises_and_turns_it_along()
  local world, body = new_world(), {}
  slopes.add_ground(world, 0, 0, 16, {0, 8}, {ceiling = true})  -- 8 px thick at its right end
  world:add(body, 4, 20, 8, 8)
  local x, y, hits, count = world:move(body, 4, 0, slopes.filter)
  is(count, 1, "hits")
  is(hits[1].type, "slope", "type")
  is(hits[1].normal.x, -1 / math.sqrt(5), "normal.x")
  is(hits[1].normal.y, 2 / math.sqrt(5), "normal.y")
  is(hits[1].touch.y, 6, "touch.y")                 -- the right corner, at 12, meets 6 px of ground
  is(x < 4 and y < 6 and y > 4, true, "going on to the left and up")
end

function tests.a_one_way_floor_lets_pass_from_below_and_carries_from_above()
  for _, heights in ipairs {{0, 8}, {8, 8}, {0, 0}} do
    local world, body = new_world(), {}
    slopes.add_ground(world, 0, 40, 16, heights, {one_way = true})
    world:add(body, 4, 60, 8, 8)
    local _, y = world:move(body, 4, 10, slopes.filter)
    is(y, 10, "y of what rises through it")
    is(slopes.floor(world, body, 2), nil, "the floor far below")
    local top = 40 - (heights[1] + (heights[2] - heights[1]) * 12 / 16) - 8
    is(slopes.floor(world, body, 60), top, "the floor")
    world:update(body, 4, top)
    is(slopes.grounded(world, body), true, "grounded")
    world:update(body, 4, top + 3)
    is(slopes.grounded(world, body), false, "grounded within it")
  end
end

function tests.a_line_of_heights_is_walked_along_without_a_stop()
  for _, heights in ipairs {{8, 12, 16, 12, 8}, {8, 0, 8}, {8, 6, 5, 5, 8}, {8, 8, 4, 4, 8, 8}} do
    local world, body = new_world(), {}
    world:add({}, -40, 40, 40, 8)
    slopes.add_ground(world, 0, 48, 32, heights)
    world:add({}, 32, 40, 60, 8)
    world:add(body, -20, 32, 8, 8)
    local function height(x)
      if x < 0 or x > 32 then return 8 end
      local at = x / 32 * (#heights - 1)
      local i = math.min(math.floor(at), #heights - 2)
      return heights[i + 1] + (heights[i + 2] - heights[i + 1]) * (at - i)
    end
    local x, y = -20, 32
    for _ = 1, 400 do
      x, y = world:move(body, x + 0.5, y + 0.125, slopes.filter)
      local floor = math.max(height(x), height(x + 8))
      for i, h in ipairs(heights) do
        local at = 32 * (i - 1) / (#heights - 1)
        if at > x and at < x + 8 then floor = math.max(floor, h) end
      end
      is(y + 8 <= 48 - floor + 1e-6, true, "over the ground at x " .. x .. ", y " .. y)
      if x > 60 then break end
    end
    is(x > 60, true, "beyond the line, at " .. x .. ": it")
  end
end

function tests.a_slope_that_moves_lifts_what_it_sinks_into_a_little()
  local world, body, lift = new_world(), {}, {slope = {h0 = 0, h1 = 8}}
  world:add(lift, 0, 32, 16, 8)
  world:add(body, 4, 26, 8, 8)  -- on it: its right corner, at 12, is 6 px up
  is(slopes.grounded(world, body), true, "grounded")
  world:update(lift, 0, 31)
  is(slopes.floor(world, body, 1), 25, "the floor, which has risen")
end

function tests.tiles_of_sti_are_slopes()
  local world, body = new_world(), {}
  world:add({properties = {collidable = true, slope = "floor", h0 = 0, h1 = 8}}, 0, 32, 16, 8)
  world:add({properties = {collidable = true, slope = "ceiling", h0 = 8, h1 = 8}}, 0, 0, 16, 8)
  world:add({properties = {collidable = true, one_way = true}}, 0, 16, 16, 8)
  world:add(body, 4, 24, 8, 8)
  is(slopes.floor(world, body, 60), 26, "the floor")
  is(select(2, world:move(body, 4, -20, slopes.filter)), 8, "y below the ceiling, through the one-way tile")
  is(slopes.floor(world, body, 60), 8, "the floor on the one-way tile")
end

function tests.full_tiles_become_few_boxes()
  local level = {width = 4, height = 3, shapes = {[1] = {kind = "solid"}}, balls = {[2] = true},
                 tiles = {1, 0, 2, 1,
                          1, 1, 1, 1,
                          1, 1, 1, 0}}
  local function boxes(merge)
    local world, balls = new_world(), 0
    slopes.add_level(world, level, {merge = merge, on_ball = function(x, y, tile)
      balls = balls + 1
      is(x == 16 and y == 0 and tile == 2, true, "the ball at 16, 0")
    end})
    is(balls, 1, "balls")
    local found = {}
    for item in pairs(world.rects) do
      found[#found + 1] = table.concat({item.x, item.y, item.w, item.h}, " ")
    end
    table.sort(found)
    return found
  end
  is(#boxes(false), 9, "boxes")
  is(table.concat(boxes(true), ", "), "0 0 8 24, 24 0 8 16, 8 8 16 16", "merged")
end

local count = 0
for name, test in pairs(tests) do
  local is_good, problem = pcall(test)
  if not is_good then
    print(name .. ": " .. problem)
    os.exit(1)
  end
  count = count + 1
end
print(count .. " tests of other shapes")
