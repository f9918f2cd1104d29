-- ---- Bodies that fall, such as balls: the article's velocities, restitution and friction, with the true normal ----
has.balls = true

local NEAR_END = 0.999  -- of a motion

-- What contacts do to balls. A contact is a side, with its normal nx, ny and the shares of the speed into it and along
-- it that are left: `bounce` and `grip`.
local Bounce = {}

-- Of the part `flight`: Bounce.begin_flight() sets out on a parabola, and Bounce.fly_off() leaves a surface on another one.
local function flies(n) return Bounce.fly_off and n.rebound ~= 0 and n.gravity > 0 end

function Bounce.into(side, x, y) return -(x * side.nx + y * side.ny) end

-- The velocity after a side, of one that leads into it.
function Bounce.reflect(side, x, y)
  local nx, ny = side.nx, side.ny
  local kept, away = (x * -ny + y * nx) * side.grip, Bounce.into(side, x, y) * side.bounce
  return -ny * kept + nx * away, nx * kept + ny * away
end

-- The velocity of a ball after a side; the part `sides` replaces it.
function Bounce.after(_, ball, side)
  if not (Bounce.into(side, ball.vx, ball.vy) > 0) then return ball.vx, ball.vy end
  return Bounce.reflect(side, ball.vx, ball.vy)
end

function Bounce.make(n, contact)
  local level = is_level(contact, n.steepest)
  contact.bounce, contact.grip = level and n.floor_bounce or n.wall_bounce, level and n.floor_grip or 1
  return level
end

-- Reverses the velocity, and returns the motion to go on with.
local function bounce_off(world, _, ball, contact, x, y)
  local n = world.tuning
  local nx, ny = contact.nx, contact.ny
  ball.landed = Bounce.make(n, contact) and ny < 0 or ball.landed
  local slide_x, slide_y = slide_along(nx, ny, x * (1 - contact.t), y * (1 - contact.t))
  if contact.t >= NEAR_END and (abs(x) + abs(y)) * (1 - contact.t) <= settled(ball) then
    return slide_x, slide_y  -- it has just arrived: the next step bounces
  end
  if flies(n) then return Bounce.fly_off(world, ball, contact, slide_x, slide_y) end
  local stays = n.rebound == 0 or not (Bounce.into(contact, ball.vx, ball.vy) > 0)
  ball.vx, ball.vy = Bounce.after(world, ball, contact)
  if stays then return slide_x, slide_y end
  ball.left = ball.left * (1 - contact.t)
  return ball.vx * ball.left, ball.vy * ball.left
end

local function fall(world, body, ball)
  local n = world.tuning
  if not (n.gravity > 0) then ball.vy = lerp(ball.vy, n.fall_speed, n.fall_blend) end
  ball.vx = lerp(ball.vx, n.drift_speed, n.drift_blend)
  local part = 1.0 / n.substeps
  -- Between frames a ball that flies has the velocity of the chord of its last frame; now that of a part.
  ball.met, ball.part, ball.lift = nil, part, flies(n) and n.gravity * (1 - part) / 2 or 0.0
  if ball.lift ~= 0 then ball.vy = ball.vy + ball.lift end
  for _ = 1, n.substeps do
    ball.left = part
    if n.gravity > 0 then ball.vy = ball.vy + n.gravity * part end
    if flies(n) then
      Bounce.begin_flight(ball, ball.x, ball.y, ball.vx, ball.vy - n.gravity * part / 2, n.gravity, part)
    end
    move(world, body, ball, ball.vx * part, ball.vy * part, bounce_off)
  end
  if ball.lift ~= 0 then ball.vy = ball.vy - ball.lift end
  body.grounded = ball.landed
end
rules.fall = fall

-- Tiles of the map that are bodies, such as balls.
function World:place_tiles(level)
  for x = 0, level.width - 1 do
    for y = 0, level.height - 1 do
      local tile = level.tiles[y * level.width + x + 1]
      local kind = level.balls[tile]
      if kind then self:add {kind = kind, x = x * TILE_W, y = y * TILE_H, w = TILE_W, h = TILE_H, tile = tile} end
    end
  end
end
