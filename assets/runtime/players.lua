-- ---- Bodies that run, such as players: they go along the ground at the speed asked for, and jump off it ----
has.players = true

local function take_keys(n, body, box, input)
  local direction = (input.right and 1 or 0) - (input.left and 1 or 0)
  local target = n.run_speed * direction + (box.carried or 0)
  local gain = direction == 0 and n.run_loss or body.grounded and n.run_gain or n.air_gain
  if box.vx < target then box.vx = min(box.vx + gain, target) else box.vx = max(box.vx - gain, target) end
  if input.jump and not body.jump_held and (body.grounded or body.coyote > 0) then
    box.vy = -n.jump_speed
    body.grounded, body.coyote, body.jumping = false, 0, true
  elseif body.jumping and not input.jump and box.vy < 0 then
    box.vy = box.vy * n.jump_cut
    body.jumping = false
  end
  body.jump_held = input.jump and true or false
  if not body.grounded then box.vy = min(box.vy + n.player_gravity, n.fall_limit) end
  if box.vy >= 0 then body.jumping = false end
end

local function stand(body, box)
  body.grounded, body.jumping, body.coyote = true, false, 0
  box.vy = 0.0
end

-- Ends a walk at what the player cannot walk on.
local function stop_at(box, contact)
  if contact.t ~= 1 and contact.nx * box.vx < 0 then box.vx = 0.0 end
end

-- In the air a player follows level ground and keeps its horizontal motion. Along anything else it slides, until
-- it has landed.
local function meet(world, body, box, contact, x, y)
  local n = world.tuning
  local nx, ny = contact.nx, contact.ny
  local rest_x, rest_y = x * (1 - contact.t), y * (1 - contact.t)
  if ny < 0 and is_level(contact, n.steepest) then
    box.landed = true
    box.vy = 0.0
    return rest_x, rest_x * (-nx / ny)
  end
  if contact.t == 1 then return 0.0, 0.0 end
  if body.grounded or box.landed then
    -- A ceiling that does not come down holds it from rising alone.
    if ny > 0 and nx * rest_x >= 0 then return rest_x, 0.0 end
    stop_at(box, contact)
    return 0.0, 0.0
  end
  local into = box.vx * nx + box.vy * ny
  if into < 0 then box.vx, box.vy = box.vx - nx * into, box.vy - ny * into end
  return slide_along(nx, ny, rest_x, rest_y)
end

-- The y on the level ground straight below, within `reach`, or at the foot of something too steep; and the contact.
local function floor_under(world, body, box, reach)
  local others, steepest = world:others(body, box, 0.0, reach), world.tuning.steepest
  local function cast(without)
    return cast_box(world.terrain, box.x, box.y, box.w, box.h, 0.0, reach, box.centre, others, without)
  end
  local found = cast()
  if not found or is_level(found, steepest) then return found and found.y, found end
  local side = found.edge.source or found.edge
  local on = cast(side)
  if on and on.edge and not is_level(on, steepest) then  -- the same side once more, or another one behind it
    on = Walk.without(on.edge.source or on.edge, cast, side)
  end
  return on and is_level(on, steepest) and on.y - found.y <= LIP and found.y, on
end

-- Whether a body lies on two sides that are too steep to stand on, but hold it up together. Puts it on them.
function World:stands_between(body, box)
  local there = Walk.at(box.x, box.y, box)
  if not move(self, body, there, 0.0, LIP, slide) then return false end
  box.x, box.y = there.x, there.y
  return true
end

-- How far below a grounded player its floor may be after a step that moved it by x.
local function reach_down(n, x) return n.snap > 0 and n.snap or abs(x) * n.steepest + 1 end

-- The motion of a step on a floor with this normal.
local function motion_on(n, box, nx, ny)
  local x = n.surface_speed ~= 0 and box.vx * -ny or box.vx
  return x, x * (-nx / ny)
end

local function run(world, body, box, input)
  local n = world.tuning
  body.coyote = body.coyote or 0  -- frames in which it may still jump after leaving its floor
  take_keys(n, body, box, input)
  if body.coyote > 0 then body.coyote = body.coyote - 1 end
  local start, walked = box.x, body.grounded
  local x, y = box.vx, box.vy
  if walked then
    local stands
    stands, x, y = go_along_floor(world, body, box, reach_down(n, 0.0), motion_on, stop_at)
    if stands then return stand(body, box) end
  end
  local held = move(world, body, box, x, y, meet)
  if held and y > 0 then return stand(body, box) end
  if box.landed then stand(body, box) end
  if not body.grounded then return end
  local floor_y = floor_under(world, body, box, reach_down(n, box.x - start))
  if floor_y then
    box.y = floor_y
    stand(body, box)
  elseif walked and world:stands_between(body, box) then
    stand(body, box)
  else
    body.grounded = false
    if walked then body.coyote = n.coyote_frames end
  end
end
rules.run = run
