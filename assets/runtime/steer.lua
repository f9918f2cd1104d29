-- ---- A game steers its world: bodies that go, keys of their own, sensors, bodies that stay where they are ----
has.steer = true

-- In a function, as a module has room for 200 local variables.
function World.begin_steering()

-- ---- Bodies come and go ----

local function kind_names(world)
  local names = {}
  for name in pairs(world.kinds) do names[#names + 1] = name end
  table.sort(names)
  return table.concat(names, ", ")
end

-- Tells what is wrong with a new body of a kind, if something is.
local function problem_of(world, body, kind)
  if not kind then return ("no kind %q; this level has %s"):format(tostring(body.kind), kind_names(world)) end
  local foot = body.foot or kind.foot
  if kind.rule ~= "fall" and kind.rule ~= "run" and kind.rule ~= "still" then
    return ("the kind %q has the rule %q; the rules are fall, run and still"):format(body.kind, tostring(kind.rule))
  end
  if foot and foot ~= "box" and foot ~= "centre" then
    return ("the foot of a %s is box or centre, not %s"):format(body.kind, tostring(foot))
  end
  local given = {x = body.x, y = body.y, w = body.w or kind.w, h = body.h or kind.h,
                 vx = body.vx or 0, vy = body.vy or 0, run_speed = body.run_speed or kind.run_speed or 0}
  for _, name in ipairs {"x", "y", "w", "h", "vx", "vy", "run_speed"} do
    if type(given[name]) ~= "number" then
      return ("%s of a %s is a number of px, not %s"):format(name, body.kind, tostring(given[name]))
    end
  end
end

-- The bodies that stop others. all: a list
local function without_sensors(all)
  local others = {}
  for _, body in ipairs(all) do
    if not body.sensor then others[#others + 1] = body end
  end
  return others
end

local add = World.add
function World:add(body)
  if type(body) ~= "table" then error("a body is a table with kind, x and y, not " .. tostring(body), 2) end
  local problem = problem_of(self, body, self.kinds[body.kind])
  if problem then error(problem, 2) end
  local all = self.bodies
  self.bodies = body.sensor and {} or without_sensors(all)  -- sensors need no part for bodies that block one another
  local is_added, message = pcall(add, self, body)
  self.bodies = all
  if not is_added then error(message, 2) end
  all[#all + 1] = body
  self.last_id = (self.last_id or 0) + 1  -- ids of bodies that are gone are not given again
  body.id, body.touched = self.last_id, {}
  return body
end

-- Takes a body out of the world. The list of bodies is a new one then, so that a loop over it goes on as it began.
function World:remove(body)
  local left, is_there = {}, false
  for _, other in ipairs(self.bodies) do
    if other == body then is_there = true else left[#left + 1] = other end
  end
  if not is_there then
    local is_body = type(body) == "table" and body.kind and body.id
    error((is_body and "the " .. body.kind .. " " .. body.id or tostring(body)) .. " is not in the world", 2)
  end
  self.bodies = left
end

-- ---- Rules ----

-- A body of this rule never moves by itself.
rules.still = function() end

if rules.run then
  local run, no_keys = rules.run, {}
  rules.run = function(world, body, box, input)
    local kind, tuning = world.kinds[body.kind], world.tuning
    local speed_of_all = tuning.run_speed
    tuning.run_speed = (body.run_speed or kind.run_speed or speed_of_all) + 0.0
    run(world, body, box, body.input or kind.takes_keys and input or no_keys)
    tuning.run_speed = speed_of_all
  end
end

local function has_sensor(bodies)
  for _, body in ipairs(bodies) do
    if body.sensor then return true end
  end
  return false
end

-- Sensors stop nobody, and nobody stops them. They move after all others.
local step_bodies, nobody, solid, sensors = World.step_bodies, {}, {}, {}
function World:step_bodies(input)
  local all, count, others = self.bodies, 0, 0
  if not has_sensor(all) then return step_bodies(self, input) end
  for _, body in ipairs(all) do
    if body.sensor then
      count = count + 1
      sensors[count] = body
    else
      others = others + 1
      solid[others] = body
    end
  end
  for i = #solid, others + 1, -1 do solid[i] = nil end
  self.bodies = solid
  step_bodies(self, input)
  self.bodies = nobody
  for i = 1, count do step_body(self, sensors[i], input) end
  self.bodies = all
end

-- ---- What a body touches ----

-- The bodies that a box overlaps, in the order of the world. found: a table that gets them; without it, a new one.
function World:bodies_in(x, y, w, h, found)
  if not (x and y and w and h) then
    error(("a box is four numbers, x, y, w and h in px, not %s, %s, %s and %s"):format(
          tostring(x), tostring(y), tostring(w), tostring(h)), 2)
  end
  found = found or {}
  local count = 0
  for _, body in ipairs(self.bodies) do
    if body.x < x + w and x < body.x + body.w and body.y < y + h and y < body.y + body.h then
      count = count + 1
      found[count] = body
    end
  end
  for i = #found, count + 1, -1 do found[i] = nil end
  return found
end

local SIDES = {floor = {0.0, 1.0}, ceiling = {0.0, -1.0}, left = {-1.0, 0.0}, right = {1.0, 0.0}}

-- The cell of the map that a body touches at a side, column and row from 0; nil if it touches no ground there.
function World:cell_beside(body, side)
  local way = SIDES[side]
  if not way then error(("no side %q; the sides are floor, ceiling, left and right"):format(tostring(side)), 2) end
  local contact = self:cast(body.x, body.y, body.w, body.h, way[1] * LIP, way[2] * LIP, body.foot)
  if contact then return contact.column, contact.row end
end

-- Whether there is ground beside a body, at its side left or right: a wall, or a floor at most `reach` px below its
-- foot, half its height if left out.
function World:floor_ahead(body, side, reach)
  if side ~= "left" and side ~= "right" then
    error(("no side %q; the sides are left and right"):format(tostring(side)), 2)
  end
  local x = side == "left" and body.x - 1 or body.x + body.w
  return self:overlaps(x, body.y, 1, body.h) or self:cast(x, body.y, 1, body.h, 0, reach or body.h / 2) ~= nil
end

-- The body that one stands on, if it is not the ground.
local function under(world, body)
  local bottom = body.y + body.h
  for _, other in ipairs(world.bodies) do
    if other ~= body and not other.sensor and abs(other.y - bottom) <= LIP and other.x < body.x + body.w and
        body.x < other.x + other.w then return other end
  end
end

local step = World.step
function World:step(input)
  for _, body in ipairs(self.bodies) do
    local touched = body.touched
    touched.floor, touched.ceiling, touched.left, touched.right = nil, nil, nil, nil
  end
  step(self, input)
  for _, body in ipairs(self.bodies) do
    if body.grounded and not body.touched.floor then body.touched.floor = under(self, body) or true end
  end
end

end

World.begin_steering()
