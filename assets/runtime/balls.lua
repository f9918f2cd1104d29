-- ---- Bodies that fall, such as balls: the article's velocities, restitution and friction, with the true normal ----
has.balls = true

-- Under constant gravity a ball flies along a parabola through the ends of the parts. It bounces from level
-- ground where the parabola meets the ground, so that it neither gains nor loses energy.
local function rebound(n, ball, contact, x, y, kept_x, kept_y, into, bounce)
  local nx, ny = contact.nx, contact.ny
  local pull = -n.gravity * ny
  pull = pull > 0 and pull or 0.0
  local on_parabola = pull > 0 and nx == 0
  local left = ball.time_left
  local after = left * (1 - contact.t)
  if on_parabola then
    local way = -(x * nx + y * ny)
    local distance = way * contact.t
    local start = way / left - pull * left / 2
    local under = start * start + 2 * pull * distance
    into = sqrt(under > 0 and under or 0.0)
    if start + into > 0 then
      after = left - 2 * distance / (start + into)
      after = after > 0 and after or 0.0
    end
  end
  ball.time_left = after
  local away = into * bounce
  if not (away > pull * ball.part) then  -- too slow to leave the ground for longer than a step: it stays
    ball.vx, ball.vy = kept_x, kept_y
    return kept_x * after, kept_y * after
  end
  if not on_parabola then
    ball.vx, ball.vy = kept_x + nx * away, kept_y + ny * away
    return ball.vx * after, ball.vy * after
  end
  local speed_now = away - pull * after + pull * ball.part / 2
  ball.vx, ball.vy = kept_x + nx * speed_now, kept_y + ny * speed_now
  local way = away * after - pull * after * after / 2
  return kept_x * after + nx * way, kept_y * after + ny * way
end

-- Reverses the velocity, and returns the motion to go on with.
local function bounce_off(world, _, ball, contact, x, y)
  local n = world.tuning
  local nx, ny = contact.nx, contact.ny
  local level = is_level(contact, n.steepest)
  ball.landed = ball.landed or (level and ny < 0)
  local slide_x, slide_y = slide_along(nx, ny, x * (1 - contact.t), y * (1 - contact.t))
  if contact.t == 1 then return slide_x, slide_y end  -- it has just arrived: the next step bounces
  local into = -(ball.vx * nx + ball.vy * ny)
  if not (into > 0) then return slide_x, slide_y end
  local bounce = level and n.floor_bounce or n.wall_bounce
  local along_x, along_y = -ny, nx
  local kept = (ball.vx * along_x + ball.vy * along_y) * (level and n.floor_grip or 1)
  local kept_x, kept_y = along_x * kept, along_y * kept
  if n.rebound ~= 0 then return rebound(n, ball, contact, x, y, kept_x, kept_y, into, bounce) end
  ball.vx, ball.vy = kept_x + nx * (into * bounce), kept_y + ny * (into * bounce)
  return slide_x, slide_y
end

local function fall(world, body, ball)
  local n = world.tuning
  if not (n.gravity > 0) then ball.vy = lerp(ball.vy, n.fall_speed, n.fall_blend) end
  ball.vx = lerp(ball.vx, n.drift_speed, n.drift_blend)
  local part = 1.0 / n.substeps
  for _ = 1, n.substeps do
    ball.part, ball.time_left = part, part
    if n.gravity > 0 then ball.vy = ball.vy + n.gravity * part end
    move(world, body, ball, ball.vx * part, ball.vy * part, bounce_off)
  end
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
