-- ---- Events of a step: which bodies hit something, landed, or left the ground ----
has.events = true

-- In a function, as a module has room for 200 local variables.
function World.begin_events()

local MASS_AREA = 64  -- px^2, of a body with the mass of its kind

-- px a step, by rule: a contact that changes a body's speed by no more is no hit.
local function quiet_speeds(n)
  local pull = n.gravity > 0 and n.gravity or abs(n.fall_speed * n.fall_blend)
  return {fall = 1e-9 + 2 * max(pull, abs(n.drift_speed * n.drift_blend)),
          run = 1e-9 + 2 * max(max(n.player_gravity, n.run_gain), n.air_gain)}
end

function World:note_hit(body, there, nx, ny, impulse)
  self.events[#self.events + 1] = {kind = "hit", body = body, other = there, nx = nx, ny = ny, impulse = impulse}
end

function World:note_standing(body, stood)
  if body.grounded ~= stood then self.events[#self.events + 1] = {kind = stood and "left" or "landed", body = body} end
end

-- body.touched: what touches a body in this step, by its side: floor, ceiling, left or right. It is another body, or
-- true for the ground.
function World:note_touch(body, other, nx, ny)
  local is_level = abs(nx) <= self.tuning.steepest * abs(ny)
  local side = is_level and (ny < 0 and "floor" or "ceiling") or nx > 0 and "left" or "right"
  if body.touched then body.touched[side] = other or true end
end

-- Calls respond(...), which may change the velocity of a body's box, and notes a hit.
local function heard(world, body, box, contact, respond, ...)
  local vx, vy, kind = box.vx, box.vy, world.kinds[body.kind]
  box.change = nil
  local x, y = respond(...)
  local nx, ny = contact.nx, contact.ny
  world:note_touch(body, contact.other, nx, ny)
  local change = box.change or (box.vx - vx) * nx + (box.vy - vy) * ny
  if change > world.quiet[kind.rule] then
    local w, h = body.w, body.h
    if kind.round then
      w = 2 * (min(w, h) / 2)
      h = w
    end
    world:note_hit(body, contact.other, nx, ny, (kind.mass or 1.0) * (w * h / MASS_AREA) * change)
  end
  return x, y
end

local plain_move, respond_of = move, nil
local function hear(world, body, box, contact, x, y)
  return heard(world, body, box, contact, respond_of, world, body, box, contact, x, y)
end
function move(world, body, box, x, y, respond)
  if respond == slide then return plain_move(world, body, box, x, y, slide) end  -- it changes no velocity
  respond_of = respond
  return plain_move(world, body, box, x, y, hear)
end

if has.walk then
  local plain_walk = go_along_floor
  function go_along_floor(world, body, box, reach, motion_on, stop_at)
    return plain_walk(world, body, box, reach, motion_on, function(there, contact)
      heard(world, body, there, contact, stop_at, there, contact)
    end)
  end
end

local plain_step_body = step_body
function step_body(world, body, input)
  local stood = body.grounded
  plain_step_body(world, body, input)
  world:note_standing(body, stood)
end

local plain_step = World.step
function World:step(input)
  self.events, self.quiet = {}, quiet_speeds(self.tuning)
  plain_step(self, input)
end

end

World.begin_events()
