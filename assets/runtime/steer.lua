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

local add = World.add
function World:add(body)
  if not self.kinds[body.kind] then
    error(("no kind %q; this level has %s"):format(tostring(body.kind), kind_names(self)), 2)
  end
  local is_added, message = pcall(add, self, body)
  if not is_added then error(message, 2) end
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
  if not is_there then error("this body is not in the world", 2) end
  self.bodies = left
end

-- ---- Rules ----

-- A body of this rule never moves by itself.
rules.still = function() end

if rules.run then
  local run, no_keys = rules.run, {}
  rules.run = function(world, body, box, input)
    return run(world, body, box, body.input or world.kinds[body.kind].takes_keys and input or no_keys)
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
