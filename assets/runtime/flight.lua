-- ---- Flights of balls that rebound under gravity ----
has.flight = true

do

-- Under constant gravity a ball flies along a parabola. Casts go along its chords, so a contact of a chord is
-- moved to where the parabola itself meets the surface. A flight is at (px, py), px of the body, with a velocity
-- there (ux, uy), px/frame, under `pull`, px/frame^2, for the `left` frames of a part of a step.
function begin_flight(ball, px, py, ux, uy, pull, left)
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

-- Flies on to the surface of a contact. Returns the normal there.
local function reach(ball, contact)
  local x, nx, ny = ball.x, contact.nx, contact.ny
  local time = time_to(ball, x, ball.y, nx, ny)
  local piece = not contact.on_end and contact.edge or nil
  for _ = 1, piece and piece.form.normal_at and 8 or 0 do
    x = flight_at(ball, time)
    local at = x + piece.form.offset(piece, ball.w, ball.centre)
    if not (at >= piece.x0 and at <= piece.x1) then break end
    nx, ny = piece.form.normal_at(piece, at)
    local before = time
    time = time_to(ball, x, piece.form.rest(piece, x, ball.w, ball.h, ball.centre), nx, ny)
    if time == before then break end
  end
  local px, py = flight_at(ball, time)
  begin_flight(ball, px, py, ball.ux + 0.0, ball.uy + ball.pull * time, ball.pull, ball.left - time)
  return nx, ny
end

-- Flies off the surface of a contact, or stays on it.
function fly_off(n, ball, contact, slide_x, slide_y, bounce, grip)
  local nx, ny = reach(ball, contact)
  local into = -(ball.ux * nx + ball.uy * ny)
  local away = into * bounce
  if not (into > 0) then return slide_x, slide_y end
  ball.change = into + away
  if not (away > -n.gravity * ny) then  -- too slow to leave the ground for longer than a step: it stays
    if ball.lift ~= 0 then ball.vy = ball.vy - ball.lift end
    ball.lift = 0.0
    local kept = (ball.vx * -ny + ball.vy * nx) * grip
    ball.vx, ball.vy = -ny * kept, nx * kept
    begin_flight(ball, ball.x, ball.y, ball.vx, ball.vy, 0.0, ball.left)
    return ball.vx * ball.left, ball.vy * ball.left
  end
  local kept = (ball.ux * -ny + ball.uy * nx) * grip
  ball.ux, ball.uy = -ny * kept + nx * away, nx * kept + ny * away
  local x, y = flight_at(ball, ball.left)
  ball.vx, ball.vy = ball.ux + 0.0, ball.uy + ball.pull * (ball.left - ball.part / 2)
  return x - ball.x, y - ball.y
end

end
