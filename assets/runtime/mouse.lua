-- ---- The mouse: it grabs a body, and throws it when the button is let go ----
has.mouse = true
World.grabbed = 0  -- the id of the body that it holds; 0: none

local function body_at(world, x, y)
  for _, body in ipairs(world.bodies) do
    if x > body.x and x < body.x + body.w and y > body.y and y < body.y + body.h then return body.id end
  end
  return 0
end

local function has_body(world, id)
  for _, body in ipairs(world.bodies) do
    if body.id == id then return true end
  end
  return false
end

function World:take_input(input)
  if input.mouse_down then
    if (input.grab or 0) ~= 0 and has_body(self, input.grab) then self.grabbed = input.grab end
    if self.grabbed == 0 then self.grabbed = body_at(self, input.mouse_x, input.mouse_y) end
    return
  end
  if self.grabbed == 0 then return end
  for _, body in ipairs(self.bodies) do
    if body.id == self.grabbed then body.vx, body.vy = body.x - body.previous_x, body.y - body.previous_y end
  end
  self.grabbed = 0
end

local function reachable(at, goal)
  return clamp(clamp(goal, at - FAST, at + FAST), -FAR, FAR)
end

-- A dragged body goes part of the way to the mouse, and slides along what it meets.
local function drag(world, body, box, input)
  local n = world.tuning
  body.previous_x, body.previous_y = body.x, body.y
  local x = reachable(body.x, lerp(body.x, input.mouse_x - n.drag_offset, n.drag_blend)) - body.x
  local y = reachable(body.y, lerp(body.y, input.mouse_y - n.drag_offset, n.drag_blend)) - body.y
  move(world, body, box, x, y, slide)
end

local step_of = World.step_of
function World:step_of(body)
  if body.id == self.grabbed then return drag end
  return step_of(self, body)
end
