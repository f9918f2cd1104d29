-- ---- Flights of balls that rebound under gravity ----
has.flight = true

-- A function, as the names of a file of Lua are few.
function World.begin_flights()

local NEAR_HIT = 0.0009765625  -- frames; so short a chord is the parabola but for the hit's time
local MOST_AIMS = 8  -- of one contact; more are needed by what the parabola grazes

-- Under constant gravity a ball flies along a parabola. Casts go along its chords. So what a chord has met is looked
-- for once more by shorter chords, and then moved to where the parabola itself meets the surface. A flight is at
-- (px, py), px of the body, with a velocity there (ux, uy), px/frame, under `pull`, px/frame^2, for the `left` frames
-- of a part of a step. Its chord begins at (from_x, from_y), px: on what it has left, as a cast puts the body there.
function Bounce.begin_flight(ball, px, py, ux, uy, pull, left)
  ball.from_x, ball.from_y = px, py
  ball.px, ball.py, ball.ux, ball.uy, ball.pull, ball.left = px, py, ux, uy, pull, left
end

local function flight_at(ball, time)
  return ball.px + ball.ux * time + 0.0, ball.py + ball.uy * time + ball.pull * time * time / 2
end

-- Frames, until it meets a plane through (x, y).
local function time_to(ball, x, y, nx, ny)
  local pull, start = -ball.pull * ny, -(ball.ux * nx + ball.uy * ny)
  if not (start > 0 or pull > 0) then return 0.0 end
  local distance = (ball.px - x) * nx + (ball.py - y) * ny
  distance = distance > 0 and distance or 0.0
  local under = start * start + 2 * pull * distance
  local into = sqrt(under > 0 and under or 0.0)
  local time = start > 0 and 2 * distance / (start + into) or (into - start) / pull
  return ball.left < time and ball.left or time
end

-- Whether a contact is with two mirror images at once, the piece and another one: then its normal is that of neither.
local function is_between_curves(contact, piece, at)
  return contact.nx == 0 and piece.form.normal_at(piece, clamp(at, piece.x0, piece.x1)) ~= 0
end

-- Frames, until a ball on its parabola is at the surface of a contact, and the normal there.
local function arrival(ball, contact)
  local x, nx, ny = contact.x, contact.nx, contact.ny
  local time = time_to(ball, x, contact.y, nx, ny)
  local piece = not contact.on_end and contact.edge
  if not piece or not piece.form.normal_at then return time, nx, ny end
  local offset = piece.form.offset(piece, ball.w, ball.centre)
  if is_between_curves(contact, piece, x + offset) then return time, nx, ny end
  for _ = 1, 8 do
    x = flight_at(ball, time)
    local at = x + offset
    if not (at >= piece.x0 and at <= piece.x1) then break end
    nx, ny = piece.form.normal_at(piece, at)
    local before = time
    time = time_to(ball, x, piece.form.rest(piece, x, ball.w, ball.h, ball.centre), nx, ny)
    if time == before then break end
  end
  return time, nx, ny
end

local function go_on(ball, time)
  local px, py = flight_at(ball, time)
  Bounce.begin_flight(ball, px, py, ball.ux + 0.0, ball.uy + ball.pull * time, ball.pull, ball.left - time)
end

-- Flies on to the surface of a contact. Returns the normal there.
local function reach(ball, contact)
  local time, nx, ny = arrival(ball, contact)
  go_on(ball, time)
  return nx, ny
end

-- What a ball meets on the straight way to where its flight is after a time: true, a contact or nil. Not true: there
-- is no answer, as `move` alone knows how deep a box on its centre may sink.
local function cast_flight(world, ball, others, time)
  local x, y = flight_at(ball, time)
  local met = cast_box(world.terrain, ball.from_x, ball.from_y, ball.w, ball.h, x - ball.from_x, y - ball.from_y,
                       ball.centre, others, nil, 0.0)
  return not (met and ball.centre and met.ny == 0), met
end

-- Finds what the parabola meets first, where its chord had a contact: returns that, or nil if it is nothing, or
-- false if there is no answer.
local function first_of_flight(world, ball, others, contact)
  local met, to, whole, sure = contact, ball.left, ball.left, nil
  for _ = 1, MOST_AIMS do
    local time = arrival(ball, met)
    if not (time > 0 and time < to) then time = met.t * to end
    local before, again = time - NEAR_HIT, false
    if before > 0 then
      local earlier
      sure, earlier = cast_flight(world, ball, others, before)
      if not sure then return false end
      to = before
      if earlier then
        met, again = earlier, true
      else
        go_on(ball, before)
        time = NEAR_HIT
      end
    end
    if not again then
      to = min(time + NEAR_HIT, ball.left)
      sure, met = cast_flight(world, ball, others, to)
      if not sure then return false end
      if met then
        met.t = min((whole - ball.left + met.t * to) / whole, 1.0)
        return met
      end
      if not (to < ball.left) then return nil end
      go_on(ball, to)
      to = ball.left
      sure, met = cast_flight(world, ball, others, to)
      if not sure then return false end
      if not met then return nil end
    end
  end
  return false
end

-- Makes a contact of the chord that of the flight. Returns false if the flight meets nothing; then the ball is at its
-- end.
local function aim(world, body, ball, contact, x, y)
  if ball.pull == 0 or contact.t == 0 or ball.centre and contact.ny == 0 then return true end
  local from_x, from_y, px, py, ux, uy, left = ball.from_x, ball.from_y, ball.px, ball.py, ball.ux, ball.uy, ball.left
  local met = first_of_flight(world, ball, world:others(body, ball, x, y), contact)
  if met == false then
    Bounce.begin_flight(ball, px, py, ux, uy, ball.pull, left)
    ball.from_x, ball.from_y = from_x, from_y
    return true
  end
  for key in pairs(contact) do contact[key] = nil end
  for key, value in pairs(met or {nx = 0.0, ny = 0.0}) do contact[key] = value end
  if met then
    ball.x, ball.y = met.x, met.y
  else
    ball.x, ball.y = flight_at(ball, ball.left)
  end
  return met ~= nil
end

local plain_bounce_off = bounce_off
function bounce_off(world, body, ball, contact, x, y)
  if flies(world.tuning) and not aim(world, body, ball, contact, x, y) then return 0.0, 0.0 end
  return plain_bounce_off(world, body, ball, contact, x, y)
end

-- Whether a ball with a velocity would be too slow to leave a side for longer than a step. Then it stays, and the side
-- bounces nothing.
local function holds(n, side, x, y)
  if Bounce.into(side, x, y) * side.bounce > -n.gravity * side.ny then return false end
  side.bounce = 0.0
  return true
end

-- Flies off the surface of a contact, or stays on it.
function Bounce.fly_off(world, ball, contact, slide_x, slide_y)
  local n, nx, ny = world.tuning, reach(ball, contact)
  local side, other = {nx = nx, ny = ny, bounce = contact.bounce, grip = contact.grip}, nil
  local into, x, y = Bounce.into(side, ball.ux, ball.uy), ball.ux, ball.uy
  if not (into > 0) then return slide_x, slide_y end
  ball.change = into + into * side.bounce
  if Bounce.with_other then side, other = Bounce.with_other(world, ball, contact, side, x, y) end
  local stays = holds(n, side, x, y)
  if other and holds(n, other, x, y) then stays = true end
  if stays then
    if ball.lift ~= 0 then ball.vy = ball.vy - ball.lift end
    ball.lift = 0.0
    if other then
      ball.vx, ball.vy = Bounce.reflect_between(side, other, x, y)
    else
      local kept = (ball.vx * -side.ny + ball.vy * side.nx) * side.grip
      ball.vx, ball.vy = -side.ny * kept, side.nx * kept
    end
    Bounce.begin_flight(ball, ball.x, ball.y, ball.vx, ball.vy, 0.0, ball.left)
    return ball.vx * ball.left, ball.vy * ball.left
  end
  if other then x, y = Bounce.reflect_between(side, other, x, y) else x, y = Bounce.reflect(side, x, y) end
  ball.ux, ball.uy, ball.from_x, ball.from_y = x, y, ball.x, ball.y
  x, y = flight_at(ball, ball.left)
  ball.vx, ball.vy = ball.ux + 0.0, ball.uy + ball.pull * (ball.left - ball.part / 2)
  return x - ball.x, y - ball.y
end

end
World.begin_flights()
