-- ---- Bodies that fall, such as balls: the article's velocities, restitution and friction, with the true normal ----
has.balls = true

-- Of the part `flight`: sets out on a parabola, and leaves a surface on another one.
local begin_flight, fly_off

local function flies(n) return begin_flight and n.rebound ~= 0 and n.gravity > 0 end

-- Reverses the velocity, and returns the motion to go on with.
local function bounce_off(world, _, ball, contact, x, y)
  local n = world.tuning
  local nx, ny = contact.nx, contact.ny
  local level = is_level(contact, n.steepest)
  ball.landed = ball.landed or (level and ny < 0)
  local slide_x, slide_y = slide_along(nx, ny, x * (1 - contact.t), y * (1 - contact.t))
  if contact.t == 1 then return slide_x, slide_y end  -- it has just arrived: the next step bounces
  local bounce, grip = level and n.floor_bounce or n.wall_bounce, level and n.floor_grip or 1
  if flies(n) then return fly_off(n, ball, contact, slide_x, slide_y, bounce, grip) end
  local into = -(ball.vx * nx + ball.vy * ny)
  if not (into > 0) then return slide_x, slide_y end
  ball.change = into + into * bounce
  local along_x, along_y = -ny, nx
  local kept = (ball.vx * along_x + ball.vy * along_y) * grip
  ball.vx, ball.vy = along_x * kept + nx * (into * bounce), along_y * kept + ny * (into * bounce)
  if n.rebound == 0 then return slide_x, slide_y end
  ball.left = ball.left * (1 - contact.t)
  return ball.vx * ball.left, ball.vy * ball.left
end

local function fall(world, body, ball)
  local n = world.tuning
  if not (n.gravity > 0) then ball.vy = lerp(ball.vy, n.fall_speed, n.fall_blend) end
  ball.vx = lerp(ball.vx, n.drift_speed, n.drift_blend)
  local part = 1.0 / n.substeps
  -- Between frames a ball that flies has the velocity of the chord of its last frame; now that of a part.
  ball.part, ball.lift = part, flies(n) and n.gravity * (1 - part) / 2 or 0.0
  if ball.lift ~= 0 then ball.vy = ball.vy + ball.lift end
  for _ = 1, n.substeps do
    ball.left = part
    if n.gravity > 0 then ball.vy = ball.vy + n.gravity * part end
    if flies(n) then
      begin_flight(ball, ball.x, ball.y, ball.vx, ball.vy - n.gravity * part / 2, n.gravity, part)
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
