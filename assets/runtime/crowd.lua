-- ---- Crowds: circles in a pile touch many others, and roll on all of them. Such a pile is not solved to the end, but
-- once for the rest of a part of the step. ----

-- A function, as the names of a file of Lua are few. M: see meet.lua.
function World.begin_crowds(M)

local STILL = 1e-11  -- px/frame
local STILL_ON_GROUND = 1e-12  -- px/frame
local TOUCHING = 0.0009765625  -- px: two that are slow, one of them a circle, touch
local MOST_TURNS = 50  -- of M.stop_all()
local MOST_SLOW = 6  -- events of a body in a part of a step, after which it is to come to rest
local NEAR_CIRCLE = 0.0625  -- px: they may come to meet in a part of a step
M.NEAR_CIRCLE = NEAR_CIRCLE

-- Circles that are slow to part or to meet are in a set a little earlier: in a pile that comes to rest, each would go on
-- to meet the others again.
local touching_in_set = M.touching_in_set
function M.touching_in_set(m, n)
  local is_round = m.radius > 0 or n.radius > 0
  if not is_round and not m.track and not n.track then return touching_in_set(m, n) end
  local time, form, other = M.time, M.form_of(m), M.form_of(n)
  if not is_round then
    return M.touching(form.x, form.y, form.w, form.h, other.x, other.y, other.w, other.h, m.index < n.index)
  end
  local near = M.nearness(form, other, m.index < n.index)
  if near.gap > NEAR_CIRCLE then return nil end
  if near.gap <= M.slack(form.x, form.y, form.w, form.h, other.x, other.y, other.w, other.h) then
    return near.nx, near.ny
  end
  local vx = m.vx + m.px * (time - m.time) - (n.vx + n.px * (time - n.time))
  local vy = m.vy + m.py * (time - m.time) - (n.vy + n.py * (time - n.time))
  if abs(vx * near.nx + vy * near.ny) <= M.slowest then return near.nx, near.ny end
end

-- px/frame: how fast an event closes a gap; 0 for a turn.
function M.hit_of(event)
  local m, n = event.a, event.b
  if event.kind == "turn" then return 0.0 end
  local s = M.time - m.time
  local vx, vy, to = m.vx + m.px * s, m.vy + m.py * s, m.ground
  if n then
    s = M.time - n.time
    vx, vy, to = vx - (n.vx + n.px * s), vy - (n.vy + n.py * s), event
  end
  return abs(vx * to.nx + vy * to.ny)
end

-- Whether a circle meets something so slowly that the rest of a pile need not give way.
function M.is_gentle(event)
  local m, n = event.a, event.b
  if not (m.radius > 0) and not (n and n.radius > 0) then return false end
  return M.hit <= M.slowest
end

-- Whether circles touch so many others, or meet so often, that they are not solved to the end.
function M.is_crowd()
  local pairs_ = 0
  for _, touch in ipairs(M.touches) do
    if touch.b and touch.near and not touch.is_apart then pairs_ = pairs_ + 1 end
  end
  if pairs_ > 6 or M.reach < huge then return true end
  if pairs_ == 0 then return false end
  for _, m in ipairs(M.set) do
    if m.inner and m.radius > 0 and m.events > MOST_SLOW and M.slowest ~= 0 then return true end
  end
  return false
end

-- px/frame: a crowd is solved as soon as a turn changes nothing by more.
local function crowd_left() return max(STILL, M.slowest / 4096) end

-- Contacts to be stopped, so that what is known of the others stays.
local function copy_of(touch)
  return {a = touch.a, b = touch.b, nx = touch.nx, ny = touch.ny, friction = touch.friction, conveyor = touch.conveyor,
          of = touch, room = 0.0, pressure = 0.0, rubbing = 0.0}
end

-- Each contact bounces as if it were alone.
function M.bounce_crowd(world)
  for _, m in ipairs(M.set) do m.bvx, m.bvy = m.svx, m.svy end
  local chosen, bounces = {}, false
  for _, touch in ipairs(M.touches) do
    if not touch.is_apart then
      local copy = copy_of(touch)
      chosen[#chosen + 1] = copy
      local speed, bounce, up = -M.speed(touch, touch.nx, touch.ny), M.bounce_of(world.tuning, touch), -touch.ny
      local least = M.slowest * (touch.b and abs(up) or max(up, 0.0))
      if speed > M.slowest and not (speed * bounce <= least) then
        copy.room = -bounce * speed
        bounces = true
      end
    end
  end
  if not bounces then return end
  M.stop_all(chosen, crowd_left(), MOST_TURNS)
  for _, copy in ipairs(chosen) do copy.of.impulse = copy.pressure end
end

-- What has happened in a crowd since it was solved as a whole is looked at near by at first.
function M.first_reach(event)
  local is_spent = event.a.spent or (event.b and event.b.spent)
  return is_spent and M.slowest > 0 and 2 or huge
end

-- Whether a part of a crowd was solved that moves what is around it. Then more of it is to be solved.
function M.reaches_further()
  if M.reach == huge then return false end
  local most = max(max(STILL, M.slowest / 64), M.hit / 64)
  for _, m in ipairs(M.set) do
    local x, y = m.svx - m.bvx, m.svy - m.bvy
    if not m.inner and x * x + y * y > most * most then
      M.reach = M.reach < 8 and 2 * M.reach or huge
      return true
    end
  end
  return false
end

function M.spend_pulls(world)
  world.leaves_apart = false
  for _, m in ipairs(M.set) do
    if m.inner then m.spent = true end
  end
end

-- Bodies of a crowd that hardly moved, and would hardly move, come to rest, and stop the others. Returns whether there
-- are both. What is left of a load that has not come through a pile yet would move it for ever.
local function stick()
  local most, sticks = M.slowest / 8, false
  for _, m in ipairs(M.set) do
    if m.inner and m.inverse ~= 0 and not (m.bvx * m.bvx + m.bvy * m.bvy > most * most) and
        not (m.svx * m.svx + m.svy * m.svy > most * most or abs(m.sspin) > most) then
      m.svx, m.svy, m.sspin, m.inverse, m.yields = 0.0, 0.0, 0.0, 0.0, 0.0
      sticks = true
    end
  end
  if not sticks then return false end
  for _, m in ipairs(M.set) do
    if m.inner and m.inverse > 0 then return true end
  end
  return false
end

-- Adds the ground that a circle would come to at once by its pull, beside what it touches.
local function add_near_ground(world, m)
  local form = M.form_at(m, M.time)
  local around = {x = form.x - TOUCHING, y = form.y - TOUCHING, w = form.w + 2 * TOUCHING, h = form.h + 2 * TOUCHING,
                  radius = form.radius + TOUCHING}
  for _, touch in ipairs(M.all_touched(world, around)) do
    local near = touch.near
    if m.svx * near.nx + m.svy * near.ny <= 0 then M.add_side(m, touch.side, near.nx, near.ny, touch.is_in_gap) end
  end
end

-- Gives bodies what their pulls would give them in the rest of the part.
local function give_pulls(world, rest)
  for _, m in ipairs(M.set) do
    if not m.inner then
      if M.reach == huge then m.inverse, m.yields = 0.0, 0.0 end
    else
      if not m.spent then m.svx, m.svy = m.svx + m.pull_x * rest, m.svy + m.pull_y * rest end
      m.spx, m.spy, m.sspin_pull = 0.0, 0.0, 0.0
      if m.radius > 0 then add_near_ground(world, m) else M.probe(world, m, m.svx, m.svy, -STILL_ON_GROUND) end
    end
  end
end

-- Circles that press on one another, and roll, would meet again and again. They get what their pulls would give them
-- at once, and go straight on: two that do not come nearer then never do.
function M.move_on(world)
  local rest, margin, chosen = M.part - M.time, 1e-8, {}
  give_pulls(world, rest)
  for i, touch in ipairs(M.touches) do
    local copy, gap = copy_of(touch), touch.near and touch.near.gap or 0.0
    if gap > margin and rest > 0 then copy.room = (gap - margin) / rest end
    if gap < -margin then copy.room = 0.25 * gap end  -- the share of an overlap that a frame takes back
    chosen[i] = copy
  end
  M.stop_all(chosen, crowd_left(), MOST_TURNS)
  for _ = 1, 8 do
    if not stick() then break end
    M.stop_all(chosen, crowd_left(), 12)
  end
  for i, touch in ipairs(M.touches) do
    local m, copy = touch.a, chosen[i]
    touch.pressure = copy.pressure
    if not touch.b then  -- nothing of the ground gives way
      local into = min(0.0, m.svx * touch.nx + m.svy * touch.ny + copy.room)
      m.svx, m.svy = m.svx - touch.nx * into, m.svy - touch.ny * into
    end
  end
end

end

World.begin_crowds(World.meeting)
