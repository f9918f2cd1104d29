-- ---- Balls that touch two sides at one time ----
-- Which of two sides a ball meets first is a matter of rounding. So what they do to its velocity does not depend on it.
has.sides = true

-- A function, as the names of a file of Lua are few.
function World.begin_sides()

local TOUCH = 1.0 / 1073741824  -- px; sides so near to one another are met at one time
local SAME_SIDE = 1.0 / 1048576  -- sides whose normals differ by less, in radians, are one

-- Whether what a side leaves of a velocity does not lead into another one.
local function stops(side, x, y, other)
  local into = max(0.0, Bounce.into(side, x, y))
  return Bounce.into(other, x + side.nx * into, y + side.ny * into) <= (abs(x) + abs(y)) * SAME_SIDE
end

-- Those of two sides that stop a velocity: one, or both. There may be just one to begin with.
local function what_stops(x, y, side, other)
  if not other or stops(side, x, y, other) then return side end
  if stops(other, x, y, side) then return other end
  return side, other
end

-- The velocity after two sides that stop another one together.
function Bounce.reflect_between(a, b, x, y)
  local across = a.nx * b.ny - a.ny * b.nx
  local from_a, from_b = Bounce.into(a, x, y) * a.bounce, Bounce.into(b, x, y) * b.bounce
  return (from_a * b.ny - from_b * a.ny) / across, (from_b * a.nx - from_a * b.nx) / across
end

-- The side that the ball touches beside one that it has met, and that stops what this leaves of a velocity; or nil.
-- Sides of tiles are level or upright: two of them do the same one by one.
local function side_beside(world, ball, contact, side, x, y)
  if not world.terrain:has_pieces() or contact.other then return nil end
  local into = Bounce.into(side, x, y)
  x, y = x + side.nx * into, y + side.ny * into
  local length = abs(x) + abs(y)
  if not (length > 0) then return nil end
  local share = max(settled(ball), TOUCH) / length
  local met = cast_box(world.terrain, ball.x, ball.y, ball.w, ball.h, x * share, y * share, ball.centre, nil, nil, 0.0)
  if not met or ball.centre and met.ny == 0 then return nil end  -- `move` alone knows how deep it may sink
  Bounce.make(world.tuning, met)
  return met
end

-- As what_stops(), of the side of a contact, and the one that the ball touches beside it.
function Bounce.with_other(world, ball, contact, side, x, y)
  return what_stops(x, y, side, side_beside(world, ball, contact, side, x, y))
end

function Bounce.after(world, ball, contact)
  local x, y, side, other = ball.vx, ball.vy, contact, nil
  if world.tuning.rebound ~= 0 then
    if not (Bounce.into(side, x, y) > 0) then return x, y end
    side, other = Bounce.with_other(world, ball, contact, side, x, y)
  elseif contact.other or not world.terrain:has_pieces() then
    ball.met = nil
  else
    local met = ball.met
    if met and abs(ball.x - met.x) + abs(ball.y - met.y) <= max(settled(ball), TOUCH) then  -- both were met at one time
      x, y = met.vx, met.vy
      side, other = what_stops(x, y, met, contact)
    end
    ball.met, contact.vx, contact.vy = contact, x, y
  end
  if other then return Bounce.reflect_between(side, other, x, y) end
  if not (Bounce.into(side, x, y) > 0) then return x, y end
  return Bounce.reflect(side, x, y)
end

end
World.begin_sides()
