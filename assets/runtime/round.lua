-- ---- Circles among the bodies that meet: what is otherwise where some are round ----
has.round = true

-- A function, as the names of a file of Lua are few. M: see meet.lua.
function World.begin_round(M)

local STILL = 1e-11  -- px/frame, and px/frame^2
local STILL_ON_GROUND = 1e-12
local CELL = 16  -- px, side of the cells in which bodies are looked for
local MOST_INNER = 16  -- bodies of a pile that are solved at once
local MOST_CIRCLES = 1024  -- the same for circles, each of which lets four more boxes in
local MOST_SHAKEN = 32
local MOST_PAIRS = 256  -- contacts of two bodies in a set
local MOST_PAIRS_OF_CIRCLES = 4096
local TOUCHING = 0.0009765625  -- px: two that are slow, one of them a circle, touch
local TURN = 6.283185307179586476925286766559  -- radians

-- ---- A body in a step ----

local member = M.member
function M.member(world, body, index)
  local m = member(world, body, index)
  m.radius = world.kinds[body.kind].round and min(m.w, m.h) / 2 or 0.0
  m.spin, m.spin_pull, m.inverse_spin, m.turned = 0.0, 0.0, 0.0, 0.0
  return m
end

local mass_of = M.mass_of
function M.mass_of(kind, w, h)
  if not kind.round then return mass_of(kind, w, h) end
  local side = 2 * (min(w, h) / 2)
  return mass_of(kind, side, side)
end

local take = M.take
function M.take(world, body, index, input)
  local m = take(world, body, index, input)
  if m.radius > 0 then
    -- A disc of even density: half of its mass counts at its rim.
    m.inverse_spin = 2 * m.inverse_mass
    if not m.held then m.spin = lerp(body.spin, 0.0, world.tuning.drift_blend) end
  end
  return m
end

local stop = M.stop
function M.stop(m)
  stop(m)
  m.spin, m.spin_pull, m.inverse_spin, m.track, m.leaves = 0.0, 0.0, 0.0, nil, nil
end

local run_part = M.run_part
function M.run_part(world)
  for _, m in ipairs(M.members) do m.spent = false end
  run_part(world)
  for _, m in ipairs(M.members) do m.track, m.leaves, m.spin_pull = nil, nil, 0.0 end
end

-- by: radians
local function turn(body, spin, by)
  local angle, most = body.turn + by, 2.0 ^ 24
  body.spin = clamp(spin, -most, most) + 0.0
  body.turn = angle - TURN * floor(angle / TURN)
end

local step = M.step
function M.step(world, input)
  step(world, input)
  for i, m in ipairs(M.members) do
    local body = m.body
    if m.radius > 0 then turn(body, m.spin, m.turned / m.radius) end
    world.leaves_apart = world.leaves_apart and not m.capped
    world.rests[i] = {x = body.x, y = body.y, w = body.w, h = body.h, vx = body.vx, vy = body.vy}
  end
  world.rests.count = #M.members
end

local add = World.add
function World:add(body)
  add(self, body)
  if self.kinds[body.kind].round then body.spin, body.turn = 0.0, 0.0 end
  return body
end

-- ---- Overlaps ----

-- Whether nothing has changed the bodies that move since the last step.
local function is_as_left(world)
  if world.rests.count ~= #M.members then return false end
  for i, m in ipairs(M.members) do
    local body, rest = m.body, world.rests[i]
    if m.inverse_mass > 0 and not (body.clear and body.x == rest.x and body.y == rest.y and body.w == rest.w and
        body.h == rest.h and body.vx == rest.vx and body.vy == rest.vy) then return false end
  end
  return true
end

-- Whether a body has been in a cell that a box meets.
local function is_near(n, x, y, w, h)
  return floor(n.left / CELL) <= floor((x + w) / CELL) and floor(x / CELL) <= floor(n.right / CELL) and
      floor(n.top / CELL) <= floor((y + h) / CELL) and floor(y / CELL) <= floor(n.bottom / CELL)
end

local function may_overlap(m)
  for _, n in ipairs(M.members) do
    if n ~= m and n.inverse_mass == 0 and is_near(m, n.x, n.y, n.w, n.h) then return true end
  end
  return false
end

-- If the last step left all apart, only those that do not move may be inside of some.
local part_overlaps = M.part_overlaps
function M.part_overlaps(world)
  M.slow = 1e-3 * M.slowest
  world.rests = world.rests or {}
  local are_apart = world.leaves_apart and is_as_left(world)
  for _, m in ipairs(M.members) do
    m.px, m.py = m.pull_x, m.pull_y
    M.sweep(m)
  end
  for _, m in ipairs(M.members) do m.stays = are_apart and not may_overlap(m) end
  world.leaves_apart = true
  part_overlaps(world)
end

local led = M.led
function M.led(world, m, way_x, way_y)
  world.leaves_apart = false
  if not (m.radius > 0) then return led(world, m, way_x, way_y) end
  local straight = M.moving_at(m, m.time)
  straight.vx, straight.vy, straight.px, straight.py = way_x, way_y, 0.0, 0.0
  local met = M.meeting_of_circle(world, straight, 1.0, {})
  if met then return met.x, met.y end
  return m.x + way_x, m.y + way_y
end

local depth_of = M.depth_of
function M.depth_of(m, n, depth_x, depth_y)
  if not (m.radius > 0 or n.radius > 0) then return depth_of(m, n, depth_x, depth_y) end
  local near = M.nearness(m, n, m.index < n.index)
  if -near.gap <= M.NEAR_CIRCLE then return nil end  -- a crowd takes small overlaps back by itself
  return -near.gap, near.nx, near.ny
end

local way_apart = M.way_apart
function M.way_apart(m)
  if m.stays then return 0.0, 0.0 end
  return way_apart(m)
end

-- ---- Events ----

-- What holds all places of its path, to the bit, as cells depend on it.
function M.sweep(m)
  local x, y = M.place_at(m, m.time)
  local to_x, to_y = M.place_at(m, M.part)
  local left, top = min(x, to_x), min(y, to_y)
  local w, h = max(x, to_x) + m.w - left, max(y, to_y) + m.h - top
  local s = M.part - m.time
  local more = M.slack(left, top, w, h, left, top, w, h)
  local off_x, off_y = abs(m.px) * (s * s / 8), abs(m.py) * (s * s / 8)
  m.left, m.top = left - off_x - more, top - off_y - more
  m.right, m.bottom = m.left + (w + 2 * (off_x + more)), m.top + (h + 2 * (off_y + more))
end

-- Two bodies in the order in which their meeting is looked for. With a circle its last bit depends on it, and it must
-- not depend on who looks.
local function in_order(m, n, t)
  if not (m.radius > 0 or n.radius > 0) then return m, n end
  local ax, ay = M.place_at(m, t)
  local cx, cy = M.place_at(n, t)
  local is_later = m.index > n.index
  if ax ~= cx then is_later = ax > cx end
  if ay ~= cy then is_later = ay > cy end
  if m.w ~= n.w then is_later = m.w > n.w end
  if m.h ~= n.h then is_later = m.h > n.h end
  if m.radius ~= n.radius then is_later = m.radius > n.radius end
  if is_later then return n, m end
  return m, n
end

function M.look_for_pairs(m, only_later)
  for _, n in ipairs(M.members) do
    if n ~= m and not (only_later and n.index < m.index and n.inverse_mass > 0) and
        (m.inverse_mass > 0 or n.inverse_mass > 0) and not (M.goes_along(m, n) or M.goes_along(n, m)) and
        n.left <= m.right and m.left <= n.right and n.top <= m.bottom and m.top <= n.bottom then
      local from = max(m.time, n.time)
      -- Of a crowd what is left of an approach is not worth another event.
      local still = m.spent and n.spent and max(STILL, M.slowest / 64) or STILL
      local a, b = in_order(m, n, from)
      local t, nx, ny = M.next_meeting(a, b, from, M.part, still)
      if t then M.add_event {time = t, kind = "pair", a = a, b = b, nx = nx, ny = ny} end
    end
  end
end

-- ---- The set ----

function M.look_around(m, event)
  local place, form = m.place, M.form_of(m)
  local x, y, w, h = M.touch_area(form.x, form.y, form.w, form.h)
  local more, most = 2 * M.NEAR_CIRCLE, m.radius > 0 and MOST_PAIRS_OF_CIRCLES or MOST_PAIRS
  local found = {}
  for _, n in ipairs(M.members) do
    if n ~= m and is_near(n, x - more, y - more, w + 2 * more, h + 2 * more) then found[#found + 1] = n end
  end
  table.sort(found, M.by_place)
  for _, n in ipairs(found) do
    if not (n.place and n.place < place and n.inner) then
      if M.is_pair_of(event, m, n) or M.touching_in_set(m, n) then
        if #M.pairs == most then return end
        M.pairs[#M.pairs + 1] = {m, n}
        M.join(n, m.depth + 1)
      end
    end
  end
end

-- What the set knows of a body.
local function begin_in_set(m, is_wall)
  local s = M.time - m.time
  m.svx, m.svy, m.spx, m.spy = m.vx + m.px * s, m.vy + m.py * s, m.px, m.py
  if m.inner then
    m.spx, m.spy = m.spent and 0.0 or m.pull_x, m.spent and 0.0 or m.pull_y
  elseif m.events == 0 and m.vx == 0 and m.vy == 0 then
    m.spx, m.spy = 0.0, 0.0
  end
  m.sspin, m.sspin_pull = m.spin + m.spin_pull * s, m.inner and 0.0 or m.spin_pull
  m.inverse, m.yields = is_wall and 0.0 or m.inverse_mass, is_wall and 0.0 or m.inverse_spin
end

-- Joins what touches, and says which bodies are solved. Returns whether some are left out.
local function join_all(event)
  local given, inner, circles, is_cut, i = #M.set, 0, 0, false, 1
  while i <= #M.set do
    local m = M.set[i]
    local is_round = m.radius > 0
    local is_solved = m.cut and m.events > 0 and m.time == M.time
    local most = is_round and MOST_CIRCLES or MOST_INNER + 4 * circles
    local is_reached = i <= given or m.depth <= M.reach
    local has_room = i <= given or (is_reached and (is_round and circles or inner - circles) < most and not is_solved)
    m.inner = has_room and m.inverse_mass > 0
    is_cut = is_cut or (is_reached and not has_room)
    if m.inner then
      inner = inner + 1
      if is_round then circles = circles + 1 end
      M.look_around(m, event)
    end
    i = i + 1
  end
  return is_cut
end

function M.gather(event)
  for _, m in ipairs(M.set) do m.place = nil end
  M.set, M.touches, M.pairs = {}, {}, {}
  M.join(event.a, 0)
  if event.kind == "pair" then M.join(event.b, 0) end
  M.hit = M.hit_of(event)
  local is_gentle = M.is_gentle(event)
  table.sort(M.shaken, M.by_place)
  for _, m in ipairs(M.shaken) do M.join(m, 0) end
  local is_cut = join_all(event)
  for _, m in ipairs(M.set) do
    if m.inner then
      m.cut = is_cut
      M.from(m, M.time)
      m.track, m.leaves = nil, nil
    end
  end
  table.sort(M.set, M.by_place)
  for k, m in ipairs(M.set) do
    m.place = k
    begin_in_set(m, not m.inner and (#M.shaken >= MOST_SHAKEN or (is_gentle and M.reach == huge)))
  end
  M.add_pairs(event)
end

local add_pairs = M.add_pairs
function M.add_pairs(event)
  add_pairs(event)
  for _, touch in ipairs(M.touches) do
    local m, n = touch.a, touch.b
    if m.radius > 0 or n.radius > 0 then
      local near = M.nearness(M.form_of(m), M.form_of(n), m.index < n.index)
      touch.near, touch.slow, touch.is_apart = near, M.slow, near.gap > TOUCHING
    end
  end
end

-- ---- What they do to one another ----

-- Those that touch, while something looks at them alone.
local function without_apart(call, ...)
  local all, touching = M.touches, {}
  for _, touch in ipairs(all) do
    if not touch.is_apart then touching[#touching + 1] = touch end
  end
  M.touches = touching
  local approaches, chosen = call(...)
  M.touches = all
  return approaches, chosen
end

-- Where nothing bounces, all are solved at once: friction makes circles press on what they did not approach.
local choose = M.choose
function M.choose(n, is_late)
  local approaches, chosen = without_apart(choose, n, is_late)
  local bounces, is_round = false, false
  for _, touch in ipairs(chosen) do
    bounces, is_round = bounces or not touch.held, is_round or (touch.slow or 0.0) > 0
  end
  if not approaches or not is_round or bounces then return approaches, chosen end
  chosen = {}
  for _, touch in ipairs(M.touches) do
    if not touch.is_apart then
      if not touch.held then touch.bounce = 0.0 end
      chosen[#chosen + 1] = touch
    end
  end
  return approaches, chosen
end

local level_out = M.level_out
function M.level_out() without_apart(level_out) end

local is_dozing = M.is_dozing
function M.is_dozing()
  for _, m in ipairs(M.set) do
    if abs(m.sspin) > M.slowest then return false end
  end
  return is_dozing()
end

-- Finds the pulls of bodies that stay together.
function M.hold(world)
  for _, m in ipairs(M.set) do
    m.free_x, m.free_y = m.spx, m.spy
    if not m.inner then m.inverse, m.yields = 0.0, 0.0 end
  end
  local has_settled = false
  for _ = 1, 16 do
    local chosen, finds, is_slow = {}, false, false
    for _, m in ipairs(M.set) do
      m.spx, m.spy = m.free_x, m.free_y
      if m.inner then m.sspin_pull = 0.0 end
    end
    M.find_tracks(world)
    for _, touch in ipairs(M.touches) do
      local slow = touch.slow or 0.0
      if not touch.is_apart and not (M.speed(touch, touch.nx, touch.ny) > max(touch.still, slow)) then
        chosen[#chosen + 1], is_slow = touch, is_slow or slow > 0
      end
    end
    if #chosen > 0 then M.support(chosen) end
    for _, m in ipairs(M.set) do
      if M.probe(world, m, m.spx, m.spy, STILL_ON_GROUND) then finds = true end
    end
    if not finds then
      if not is_slow or has_settled then return end
      has_settled = true
      if not M.settle(chosen) then return end
    end
  end
end

function M.set_paths(world)
  for _, m in ipairs(M.set) do
    if m.inner then
      m.vx, m.vy, m.px, m.py = M.within(m.svx), M.within(m.svy), M.within(m.spx), M.within(m.spy)
      if M.is_still(m.vx, m.vy) and M.is_still(m.px, m.py) then m.vx, m.vy, m.px, m.py = 0.0, 0.0, 0.0, 0.0 end
      m.spin, m.spin_pull = m.sspin, m.sspin_pull
      if M.is_still(m.spin, m.spin_pull) then m.spin, m.spin_pull = 0.0, 0.0 end
    end
  end
  for _, touch in ipairs(M.touches) do
    if not touch.b and touch.a.inner then
      local stays = M.gain(touch, touch.nx, touch.ny) <= STILL_ON_GROUND
      if abs(M.speed(touch, touch.nx, touch.ny)) <= STILL_ON_GROUND then M.align_on(world, touch, stays) end
    end
    if touch.is_track then M.begin_track(world, touch) end
    if touch.impulse > 0 and touch.bounce ~= 0 then
      touch.a.bounced = M.time
      if touch.b then touch.b.bounced = M.time end
    end
  end
end

-- Friction stops a body that slides: then it is held.
function M.look_for_turn(touch)
  if not (touch.pressure > 0) or touch.friction == 0 then return end
  local m, n = touch.a, touch.b
  local vx, vy, px, py, spin, spin_pull = m.vx, m.vy, m.px, m.py, m.spin, m.spin_pull
  if n then
    vx, vy, px, py = vx - n.vx, vy - n.vy, px - n.px, py - n.py
    spin, spin_pull = spin + n.spin, spin_pull + n.spin_pull
  end
  local along_x, along_y = -touch.ny, touch.nx
  local speed, gain = vx * along_x + vy * along_y - spin - touch.conveyor, px * along_x + py * along_y - spin_pull
  if not (speed * gain < 0) or abs(speed) <= STILL then return end
  local at = M.time - speed / gain
  if at < M.part then M.add_event {time = at, kind = "turn", a = m.inner and m or n} end
end

-- Adds the ground that the first body of an event has met.
local function meet_ground(world, m)
  local vx, vy, met = m.svx, m.svy, m.ground
  if m.radius > 0 then
    M.add_side(m, met.contact, met.nx, met.ny)
  elseif not M.leaves_crest(world, m, met.contact) then
    M.add_ground(m, met.nx, met.ny, met.contact)
  end
  M.probe(world, m, vx, 0.0, -STILL_ON_GROUND)
  M.probe(world, m, 0.0, vy, -STILL_ON_GROUND)
end

function M.meet(world, event)
  local first, is_crowd, goes_on = event.a, false, false
  local is_ground = event.kind == "ground"
  if is_ground then
    local had_track = first.track
    M.from(first, M.time)
    first.track, first.leaves = nil, nil
    if not had_track then first.x, first.y = first.ground.x, first.ground.y end
  end
  M.shaken, M.reach = {}, M.first_reach(event)
  repeat
    M.gather(event)
    M.add_ground_of_circles(world)
    if is_ground then meet_ground(world, first) end
    is_crowd = M.is_crowd()
    if is_crowd then
      M.bounce_crowd(world)
      M.move_on(world)
      goes_on = M.reaches_further()
    else
      M.bounce(world)
      goes_on = M.shakes_more()
    end
  until not goes_on
  if is_crowd then return M.spend_pulls(world) end
  M.hold(world)
  if not M.is_dozing() then return end
  for _, m in ipairs(M.set) do
    m.svx, m.svy, m.spx, m.spy, m.sspin, m.sspin_pull = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
  end
end

end

World.begin_round(World.meeting)
