-- ---- Bodies that meet: all move at the same time, from one contact to the next ----
has.meet = true

-- A function, as the names of a file of Lua are few.
function World.begin_meeting()

-- px/frame, and px/frame^2: slower than this is rounding, between bodies and on the ground.
local STILL = 1e-11
local STILL_ON_GROUND = 1e-12
local MASS_AREA = 64  -- px^2, of a body with the mass of its kind
local HELD_WEIGHT = 1e6  -- a body that the mouse holds is so many times as heavy
-- Events of a body in a part of a step, after which it is to come to rest, and after which it stops.
local MOST_SLOW = 6
local MOST_EVENTS = 64
local MOST_INNER = 16  -- bodies of a pile that are solved at once
local MOST_SHAKEN = 32  -- bodies that an impact goes on through, beyond those
local MOST_PAIRS = 256  -- contacts of two bodies in a set
local events, event_count  -- of a part of the step
-- What other files of the module may replace or use. Of the step: part, frames; slowest, px/frame, that a bounce must
-- have on level ground; members. Of the set that is resolved: set, touches, pairs, shaken and time.
local M = {}
World.meeting = M

-- ---- The smallest value of x'Ax/2 + b'x with each number between two bounds ----

local size, A, b, low, high, x, slope = 0, {}, {}, {}, {}, {}, {}
local free, is_free, is_barred, lower, factored, goal = {}, {}, {}, {}, 0, {}

function M.begin(count)
  size, factored = count, 0
  for i = 1, count * count do A[i], lower[i] = 0.0, 0.0 end
  for i = 1, count do
    b[i], low[i], high[i], x[i], slope[i], is_free[i], is_barred[i] = 0.0, 0.0, 0.0, 0.0, 0.0, false, false
  end
end

function M.bound(row, least, most)
  low[row], high[row] = least, most
  x[row] = clamp(x[row], least, most)
end

-- How far from its best a number is that rests; 0 if a bound or rounding keeps it there.
function M.pull_on(row)
  local sum, scale, at = b[row], abs(b[row]), (row - 1) * size
  for k = 1, size do
    local share = A[at + k] * x[k]
    sum = sum + share
    scale = scale + abs(share)
  end
  slope[row] = sum
  if abs(sum) <= 1e-14 * scale then return 0.0 end
  local can_go
  if sum < 0 then can_go = x[row] < high[row] else can_go = x[row] > low[row] end
  return can_go and abs(sum) or 0.0
end

function M.release(row)
  is_free[row] = true
  free[#free + 1] = row
end

function M.hold_number(at)
  is_free[free[at]] = false
  table.remove(free, at)
  factored = min(factored, at - 1)
end

-- Factors the rows of the free numbers that are new; false at the first of which less than this share is left, as
-- it is no new direction.
function M.extend(least)
  while factored < #free do
    local i, row = free[factored + 1], factored * size
    local rest = A[(i - 1) * size + i]
    for k = 1, factored do
      local sum, other = A[(i - 1) * size + free[k]], (k - 1) * size
      for j = 1, k - 1 do sum = sum - lower[row + j] * lower[other + j] end
      local value = sum / lower[other + k]
      lower[row + k] = value
      rest = rest - value * value
    end
    if not (rest > least * A[(i - 1) * size + i]) then return false end
    lower[row + factored + 1] = sqrt(rest)
    factored = factored + 1
  end
  return true
end

-- Where the free numbers want to be.
function M.aim()
  local count = #free
  for k = 1, count do
    local sum, at = -b[free[k]], (free[k] - 1) * size
    for j = 1, size do
      if not is_free[j] then sum = sum - A[at + j] * x[j] end
    end
    local row = (k - 1) * size
    for j = 1, k - 1 do sum = sum - lower[row + j] * goal[j] end
    goal[k] = sum / lower[row + k]
  end
  for k = count, 1, -1 do
    local row = (k - 1) * size
    local value = goal[k] / lower[row + k]
    goal[k] = value
    for j = 1, k - 1 do goal[j] = goal[j] - lower[row + j] * value end
  end
end

-- Takes the free numbers to where they want to be; one that comes to a bound rests there.
function M.go(is_one)
  local newest = free[#free]
  local wanted, has_moved = slope[newest] < 0 and 1 or -1, false
  while #free > 0 do
    if not M.extend(1e-13) then
      is_barred[free[factored + 1]] = true
      M.hold_number(factored + 1)
    else
      M.aim()
      local count = #free
      if is_one and not has_moved and free[count] == newest and not ((goal[count] - x[newest]) * wanted > 0) then
        is_barred[newest] = true
        M.hold_number(count)
        return false
      end
      local share, first = 1.0, 0
      for k = 1, count do
        local i = free[k]
        if not (goal[k] >= low[i] and goal[k] <= high[i]) then
          local limit_at = goal[k] < low[i] and low[i] or high[i]
          local way = max(0.0, (limit_at - x[i]) / (goal[k] - x[i]))
          if not (first > 0 and way >= share) then
            share = min(way, 1.0)
            first = k
          end
        end
      end
      for k = 1, count do
        local i = free[k]
        local before = x[i]
        x[i] = first == 0 and goal[k] or clamp(before + share * (goal[k] - before), low[i], high[i])
        has_moved = has_moved or x[i] ~= before
      end
      if first == 0 then return has_moved end
      local i = free[first]
      x[i] = goal[first] < low[i] and low[i] or high[i]
      M.hold_number(first)
    end
  end
  return has_moved
end

function M.solve()
  for i = #free, 1, -1 do free[i] = nil end
  for i = 1, size do is_free[i] = false end
  factored = 0
  return M.solve_on()
end

-- Goes on with the numbers that are free, which is quicker where only b has changed a little.
function M.solve_on()
  for i = 1, size do is_barred[i] = false end
  for i = 1, size do
    if not is_free[i] and M.pull_on(i) > 0 then M.release(i) end
  end
  local function lift_bars()
    for i = 1, size do is_barred[i] = false end
  end
  if #free > 0 and M.go(false) then lift_bars() end
  for _ = 1, 16 * size + 16 do
    local worst, most = nil, 0.0
    for i = 1, size do
      if not is_free[i] and not is_barred[i] then
        local pull = M.pull_on(i)
        if pull > most then worst, most = i, pull end
      end
    end
    if not worst then return true end
    M.release(worst)
    if M.go(true) then lift_bars() end
  end
  return false
end

-- Whether the rows of A are directions of their own, not nearly sums of others.
function M.has_one_answer()
  for i = #free, size + 1, -1 do free[i] = nil end
  for i = 1, size do free[i] = i end
  factored = 0
  return M.extend(1e-6)
end

-- Of several answers, finds the one that shares the load most evenly.
function M.solve_evenly()
  if M.has_one_answer() then return M.solve() end
  local largest = 0.0
  for i = 1, size do largest = max(largest, A[(i - 1) * size + i]) end
  local more, whole, diagonal = 1e-5 * largest, {}, {}
  for i = 1, size do
    local at = (i - 1) * size + i
    whole[i], diagonal[i] = b[i], A[at]
    A[at] = A[at] + more
  end
  for turn = 1, 8 do
    local last = {}
    for i = 1, size do
      last[i] = x[i]
      b[i] = whole[i] - more * x[i]
    end
    if turn == 1 then M.solve() else M.solve_on() end
    local change, scale = 0.0, 0.0
    for i = 1, size do
      change, scale = max(change, abs(x[i] - last[i])), max(scale, abs(x[i]))
    end
    if change <= 1e-14 * scale then break end
  end
  for i = 1, size do A[(i - 1) * size + i], b[i] = diagonal[i], whole[i] end
  return M.solve()
end

-- ---- Contacts at one time. In a set, a body has (vx, vy), its velocity, (px, py), its pull, and `inverse`. ----

-- How fast the other one goes away from the body along a direction.
function M.speed(touch, nx, ny)
  local vx, vy, other = touch.a.svx, touch.a.svy, touch.b
  if other then vx, vy = vx - other.svx, vy - other.svy end
  return vx * nx + vy * ny
end
-- The same along the contact: how fast the surface of the body slides on that of the other one.
function M.slip(touch, nx, ny) return M.speed(touch, nx, ny) - touch.conveyor end
function M.gain(touch, nx, ny)
  local px, py, other = touch.a.spx, touch.a.spy, touch.b
  if other then px, py = px - other.spx, py - other.spy end
  return px * nx + py * ny
end

-- The system of rows: each has a touch and a direction.
function M.set_up(rows, value)
  M.begin(#rows)
  for i, row in ipairs(rows) do
    local one = row.touch
    b[i] = value(one, row.x, row.y)
    for k = 1, i do
      local other = rows[k].touch
      local turned = row.x * rows[k].x + row.y * rows[k].y
      local share = 0.0
      if one.a == other.a then share = share + one.a.inverse end
      if one.b == other.b then share = share + (one.b and one.b.inverse or 0.0) end
      if one.a == other.b then share = share - one.a.inverse end
      if one.b == other.a then share = share - (one.b and one.b.inverse or 0.0) end
      A[(i - 1) * size + k] = share * turned
      A[(k - 1) * size + i] = share * turned
    end
  end
end

function M.push(touch, ix, iy)
  local one, other = touch.a, touch.b
  one.svx, one.svy = one.svx + ix * one.inverse, one.svy + iy * one.inverse
  if other then other.svx, other.svy = other.svx - ix * other.inverse, other.svy - iy * other.inverse end
end
function M.press(touch, ix, iy)
  local one, other = touch.a, touch.b
  one.spx, one.spy = one.spx + ix * one.inverse, one.spy + iy * one.inverse
  if other then other.spx, other.spy = other.spx - ix * other.inverse, other.spy - iy * other.inverse end
end

local function row_of(touch, x_, y_) return {touch = touch, x = x_, y = y_} end

-- Reflects the velocities over all these contacts at once.
function M.reflect(chosen)
  local rows = {}
  for i, touch in ipairs(chosen) do rows[i] = row_of(touch, touch.nx, touch.ny) end
  M.set_up(rows, M.speed)
  local rubs = false
  for i, touch in ipairs(chosen) do
    M.bound(i, touch.caught and -huge or 0.0, huge)
    rubs = rubs or touch.friction > 0
  end
  if rubs then M.solve_evenly() else M.solve() end
  local given = {}
  for i, touch in ipairs(chosen) do
    given[i] = x[i] * (1 + touch.bounce)
    touch.impulse = touch.impulse + given[i]
    M.push(touch, touch.nx * given[i], touch.ny * given[i])
  end
  rows = {}
  local most = {}
  for i, touch in ipairs(chosen) do
    if touch.friction > 0 and given[i] > 0 then
      rows[#rows + 1] = row_of(touch, -touch.ny, touch.nx)
      most[#rows] = touch.friction * given[i]
    end
  end
  if #rows == 0 then return end
  M.set_up(rows, M.slip)
  for i = 1, #rows do M.bound(i, -most[i], most[i]) end
  M.solve_evenly()
  for i, row in ipairs(rows) do M.push(row.touch, row.x * x[i], row.y * x[i]) end
end

-- Changes the pulls of bodies that touch and neither approach nor part.
function M.support(chosen)
  local rows = {}
  for i, touch in ipairs(chosen) do rows[i] = row_of(touch, touch.nx, touch.ny) end
  local normals, of = #rows, {}
  for i, touch in ipairs(chosen) do
    if touch.friction > 0 then
      rows[#rows + 1] = row_of(touch, -touch.ny, touch.nx)
      of[#rows] = i
    end
  end
  M.set_up(rows, M.gain)
  for i = 1, normals do M.bound(i, 0.0, huge) end
  local before, unrubbed, ends, turn, first, largest = {}, {}, false, 0, 0.0, 0.0
  for i = 1, normals do before[i] = 0.0 end
  local function bound_friction()
    for i = normals + 1, #rows do
      local row = rows[i]
      local most = row.touch.friction * before[of[i]]
      local slip = M.slip(row.touch, row.x, row.y)
      local slides = abs(slip) > STILL
      M.bound(i, slides and slip < 0 and most or -most, slides and slip > 0 and -most or most)
    end
  end
  -- Where sliding would press a body ever more into what it slides on, no answer is finite.
  while turn < 200 and not ends and not (largest > 100 * first) do
    bound_friction()
    local is_solved
    if #rows > normals then is_solved = M.solve_evenly() else is_solved = M.solve() end
    ends, largest = true, 0.0
    for i = 1, normals do
      ends = ends and abs(x[i] - before[i]) <= 1e-13 * x[i]
      before[i], largest = x[i], max(largest, x[i])
    end
    ends = ends and is_solved
    if #rows == normals then break end
    if turn == 0 then
      first = largest
      for i = 1, normals do unrubbed[i] = before[i] end
    end
    turn = turn + 1
  end
  if #rows > normals and not ends and largest > 2 * first then
    before = unrubbed
    bound_friction()
    M.solve_evenly()
  end
  for _, m in ipairs(M.set) do m.strain = 0.0 end
  for i, row in ipairs(rows) do
    local one, other = row.touch.a, row.touch.b
    if i <= normals then row.touch.pressure = x[i] end
    M.press(row.touch, row.x * x[i], row.y * x[i])
    one.strain = max(one.strain, abs(x[i]) * one.inverse)
    if other then other.strain = max(other.strain, abs(x[i]) * other.inverse) end
  end
  -- What is left between large pressures is rounding.
  for _, m in ipairs(M.set) do
    if abs(m.spx) <= 1e-13 * m.strain then m.spx = 0.0 end
    if abs(m.spy) <= 1e-13 * m.strain then m.spy = 0.0 end
  end
end

-- ---- Paths: a body is at (x, y) at `time`, with a velocity (vx, vy), under a pull (px, py) ----

local function way_to(m, t)
  local s = t - m.time
  local half = s * s / 2
  return m.vx * s + m.px * half, m.vy * s + m.py * half
end
local function place_at(m, t)
  local way_x, way_y = way_to(m, t)
  return m.x + way_x, m.y + way_y
end
function M.from(m, t)
  if t == m.time then return end
  local s = t - m.time
  local x_, y_ = place_at(m, t)
  m.x, m.y, m.vx, m.vy, m.time = x_, y_, m.vx + m.px * s, m.vy + m.py * s, t
end

-- The time until a gap closes.
local function time_to_close(gap, speed, gain)
  local inside = speed * speed + 2 * gain * gap
  if not (inside >= 0) then return huge end
  local then_speed = sqrt(inside)
  if speed > 0 then return 2 * gap / (speed + then_speed) end
  return gain > 0 and (then_speed - speed) / gain or huge
end

local function reach_of(x_, y_, w, h) return abs(x_) + abs(y_) + w + h end
-- px; boxes that are so near to each other touch. In levels up to 8192 px, a mirrored place has the same.
function M.slack(ax, ay, aw, ah, bx_, by_, bw_, bh_)
  return 1e-9 + max(max(reach_of(ax, ay, aw, ah), reach_of(bx_, by_, bw_, bh_)), 8192.0) * (64 * 2.0 ^ -52)
end

-- The normal of two boxes that touch, or overlap; nil: they are apart, or only their corners touch.
function M.touching(ax, ay, aw, ah, bx_, by_, bw_, bh_, is_first)
  local gap_x = max(ax - (bx_ + bw_), bx_ - (ax + aw))
  local gap_y = max(ay - (by_ + bh_), by_ - (ay + ah))
  local near = M.slack(ax, ay, aw, ah, bx_, by_, bw_, bh_)
  if gap_x > near or gap_y > near or (gap_x > -near and gap_y > -near) then return nil end
  local ours, theirs = ay + ah / 2, by_ + bh_ / 2
  if gap_x > gap_y then ours, theirs = ax + aw / 2, bx_ + bw_ / 2 end
  local sign = (ours < theirs or ours == theirs and is_first) and -1.0 or 1.0
  if gap_x > gap_y then return sign, 0.0 end
  return 0.0, sign
end

local function time_from(place, speed, gain, own, other, side, near, still)
  local gap = side > 0 and place - other or -own - place
  speed, gain = -side * speed, -side * gain
  if gap < -near then return huge end
  if gap <= near then
    if speed > still then return 0.0 end
    if not (gain > STILL) then return huge end
    return speed < -still and -2 * speed / gain or 0.0
  end
  return time_to_close(gap, speed, gain)
end

-- The first time, from `from` on and before `to`, at which two bodies touch and come nearer, and the normal out of
-- the second one; nil: they do not. still: px/frame; two that touch and approach no faster do not meet.
function M.next_meeting(m, n, from, to, still)
  local s = from - m.time
  local mx, my, mvx, mvy = m.x, m.y, m.vx, m.vy
  if s ~= 0 then
    mx, my = place_at(m, from)
    mvx, mvy = m.vx + m.px * s, m.vy + m.py * s
  end
  s = from - n.time
  local nx, ny, nvx, nvy = n.x, n.y, n.vx, n.vy
  if s ~= 0 then
    nx, ny = place_at(n, from)
    nvx, nvy = n.vx + n.px * s, n.vy + n.py * s
  end
  local near = M.slack(mx, my, m.w, m.h, nx, ny, n.w, n.h)
  local x_, vx, px, y_, vy, py = mx - nx, mvx - nvx, m.px - n.px, my - ny, mvy - nvy, m.py - n.py
  local first, first_x, first_y
  local function offer(place, speed, gain, own, other, c_place, c_speed, c_gain, c_own, c_other, side, normal_x, normal_y)
    local t = time_from(place, speed, gain, own, other, side, near, still)
    if not (from + t < to) or (first and from + t >= first) then return end
    local at = c_place + c_speed * t + c_gain * (t * t / 2)
    local beside = max(at - c_other, -c_own - at)
    if beside > near then return end
    if beside > -near then  -- two corners meet only if the boxes come nearer on both axes
      local centre_at = at + (c_own - c_other) / 2
      local rate, more = c_speed + c_gain * t, c_gain
      if not (centre_at < 0) then rate, more = -rate, -more end
      if not (rate > STILL or (rate >= -STILL and more > STILL)) then return end
      -- Rounding may say which axis is first: it is always the upper or lower side that counts.
      if normal_y == 0 then normal_x, normal_y = 0.0, centre_at < 0 and -1.0 or 1.0 end
    end
    first, first_x, first_y = from + t, normal_x, normal_y
  end
  offer(y_, vy, py, m.h, n.h, x_, vx, px, m.w, n.w, 1, 0.0, 1.0)
  offer(y_, vy, py, m.h, n.h, x_, vx, px, m.w, n.w, -1, 0.0, -1.0)
  offer(x_, vx, px, m.w, n.w, y_, vy, py, m.h, n.h, 1, 1.0, 0.0)
  offer(x_, vx, px, m.w, n.w, y_, vy, py, m.h, n.h, -1, -1.0, 0.0)
  return first, first_x, first_y
end

-- ---- The ground ----

-- Puts a body on what it has met.
local function put_on(contact, x_, y_, w, h)
  if contact.nx == 0 or contact.on_end then return x_, contact.y end
  if contact.ny == 0 then return contact.x, y_ end
  local piece = contact.edge
  if piece.form.normal_at or abs(piece.slope) <= 1 then
    local at = x_ + piece.form.offset(piece, w, false)
    if at >= piece.x0 and at <= piece.x1 then y_ = piece.form.rest(piece, x_, w, h, false) end
  end
  return x_, y_
end

-- What a body touches at a place that would go along a way. along: a piece that stops nothing; may be nil.
local function touched_there(world, x_, y_, w, h, way_x, way_y, along)
  local longest = max(abs(way_x), abs(way_y))
  local step_x, step_y = way_x * (1 / longest), way_y * (1 / longest)
  local contact = cast_box(world.terrain, x_, y_, w, h, step_x, step_y, false, nil, along)
  if not contact or -(contact.nx * step_x + contact.ny * step_y) * contact.t > M.slack(x_, y_, w, h, x_, y_, w, h) then
    return nil
  end
  return contact
end

-- What a body touches that would go along a way. It is lifted over the edge of a curve's end.
function M.touched(world, m, way_x, way_y)
  local box = {x = m.x, y = m.y, w = m.w, h = m.h, centre = false}
  for _ = 1, 2 do
    local contact = touched_there(world, box.x, box.y, box.w, box.h, way_x, way_y)
    if not contact then return nil end
    if not world.terrain:climbs(box, contact) then
      m.y = box.y
      return contact
    end
  end
end

-- Whether a way along what a body touches is so short that rounding alone would lead it into that: such bodies would
-- meet it again and again.
local function is_rounding(m, way_x, way_y, nx, ny)
  if -(m.vx * nx + m.vy * ny) > STILL_ON_GROUND or -(m.px * nx + m.py * ny) > STILL_ON_GROUND then return false end
  return max(abs(way_x), abs(way_y)) <= M.slack(m.x, m.y, m.w, m.h, m.x, m.y, m.w, m.h)
end

local function is_same_line(contact, other)
  local p, q = contact.edge, other.edge
  if not p or not q or contact.on_end or other.on_end or p.form.normal_at then return false end
  return p.x0 == q.x0 and p.y0 == q.y0 and p.x1 == q.x1 and p.y1 == q.y1
end

-- Whether a path is off its chord until a time by more than so many px.
local function bends(m, t, px)
  local s = t - m.time
  return max(abs(m.px), abs(m.py)) * (s * s / 8) > px
end

-- The first time on its path, before `to`, at which a body meets the ground: the time, the place, the normal and the
-- contact; nil: it does not. A chord may meet another piece first than the path does: each is cut where the last one
-- led to.
-- along: a piece that stops nothing; may be nil.
local function next_ground(world, m, to, along)
  local found, found_x, found_y, found_nx, found_ny, last
  local without, finish, is_sure = along, to, true
  local slack = M.slack(m.x, m.y, m.w, m.h, m.x, m.y, m.w, m.h)
  for _ = 1, 8 do
    local way_x, way_y = way_to(m, to)
    if way_x == 0 and way_y == 0 then break end
    local contact = cast_box(world.terrain, m.x, m.y, m.w, m.h, way_x, way_y, false, nil, without)
    if not contact or is_rounding(m, way_x, way_y, contact.nx, contact.ny) then break end
    -- A path that ends on a line meets it there, wherever rounding lets the chord meet it.
    is_sure = not last
    if last and is_same_line(contact, last) then break end
    local t, nx, ny = M.arrival(m, contact, to - m.time)
    t = m.time + t
    if not (t < to) then break end  -- what it comes to at the end of a part belongs to the next one
    local x_, y_ = place_at(m, t)
    x_, y_ = put_on(contact, x_, y_, m.w, m.h)
    found, found_x, found_y, found_nx, found_ny, last = t, x_, y_, nx, ny, contact
    is_sure = max(abs(x_ - contact.x), abs(y_ - contact.y)) <= slack
    if is_sure then break end
    local piece = not along and not contact.on_end and contact.edge
    if piece and not piece.form.normal_at then without = piece.source or piece end
    to = t
  end
  -- The path may pass the end of what a chord meets. Shorter chords are nearer to the path.
  if is_sure or not bends(m, finish, slack) or
      touched_there(world, found_x, found_y, m.w, m.h, -found_nx, -found_ny, along) then
    return found, found_x, found_y, found_nx, found_ny, last
  end
  local middle = (m.time + finish) / 2
  found, found_x, found_y, found_nx, found_ny, last = next_ground(world, m, middle, along)
  if found then return found, found_x, found_y, found_nx, found_ny, last end
  local rest = {w = m.w, h = m.h, radius = 0.0, time = m.time, x = m.x, y = m.y, vx = m.vx, vy = m.vy, px = m.px, py = m.py}
  M.from(rest, middle)
  return next_ground(world, rest, finish, along)
end
M.next_ground = next_ground

-- The time until a path meets the surface of a contact, and the normal there.
function M.arrival(m, contact, most)
  local slack = M.slack(m.x, m.y, m.w, m.h, m.x, m.y, m.w, m.h)
  local function time_to(at_x, at_y, nx, ny)
    local gap = max(0.0, (m.x - at_x) * nx + (m.y - at_y) * ny)
    local speed, gain = -(m.vx * nx + m.vy * ny), -(m.px * nx + m.py * ny)
    -- A body at rest above rounding would fall for much longer than rounding.
    if gap <= slack and abs(speed) <= STILL_ON_GROUND and gain > STILL_ON_GROUND then return 0.0 end
    local t = time_to_close(gap, speed, gain)
    if t < most then return t end
    return most * contact.t
  end
  local nx, ny = contact.nx, contact.ny
  local t = time_to(contact.x, contact.y, nx, ny)
  local piece = not contact.on_end and contact.edge or nil
  for _ = 1, piece and piece.form.normal_at and 8 or 0 do
    local there = place_at(m, m.time + t)
    local at = there + piece.form.offset(piece, m.w, false)
    if not (at >= piece.x0 and at <= piece.x1) then break end
    nx, ny = piece.form.normal_at(piece, at)
    local before = t
    t = time_to(there, piece.form.rest(piece, there, m.w, m.h, false), nx, ny)
    if t == before then break end
  end
  return t, nx, ny
end

-- Puts a body that neither approaches nor leaves a straight piece of the ground exactly on it, and its velocity along
-- it. stays: its pull, too.
function M.align(world, m, contact, stays)
  local piece = contact.edge
  if piece and piece.form.normal_at and not contact.on_end then return end
  local function turn(way_x, way_y)
    if contact.nx == 0 then return way_x, 0.0 end
    if contact.ny == 0 then return 0.0, way_y end
    if abs(piece.slope) > 1 then return way_y / piece.slope, way_y end
    return way_x, way_x * piece.slope
  end
  m.vx, m.vy = turn(m.vx, m.vy)
  if stays then m.px, m.py = turn(m.px, m.py) end
  local x_, y_ = put_on(contact, m.x, m.y, m.w, m.h)
  local way_x, way_y = x_ - m.x, y_ - m.y
  if way_x == 0 and way_y == 0 then return end
  if not (way_x * contact.nx + way_y * contact.ny > 0) then
    local met = cast_box(world.terrain, m.x, m.y, m.w, m.h, way_x, way_y, false)
    if met then
      m.x, m.y = met.x, met.y
      return
    end
  end
  m.x, m.y = x_, y_
end

-- ---- Events ----

local KINDS = {ground = 0, turn = 1, pair = 2}

local function is_before(e, f)
  if e.time ~= f.time then return e.time < f.time end
  if e.kind ~= f.kind then return KINDS[e.kind] < KINDS[f.kind] end
  if e.y ~= f.y then return e.y < f.y end
  if e.x ~= f.x then return e.x < f.x end
  if e.a.index ~= f.a.index then return e.a.index < f.a.index end
  return (e.b and e.b.index or 0) < (f.b and f.b.index or 0)
end

-- A heap, the earliest event first.
function M.add_event(event)
  event.x, event.y = event.a.x, event.a.y
  event.version_a, event.version_b = event.a.version, event.b and event.b.version
  event_count = event_count + 1
  local i = event_count
  events[i] = event
  while i > 1 do
    local parent = floor(i / 2)
    if not is_before(events[i], events[parent]) then break end
    events[i], events[parent] = events[parent], events[i]
    i = parent
  end
end
function M.next_event()
  local first, last = events[1], events[event_count]
  events[event_count] = nil
  event_count = event_count - 1
  if event_count == 0 then return first end
  events[1] = last
  local i, count = 1, event_count
  while true do
    local least = i
    if 2 * i <= count and is_before(events[2 * i], events[least]) then least = 2 * i end
    if 2 * i + 1 <= count and is_before(events[2 * i + 1], events[least]) then least = 2 * i + 1 end
    if least == i then return first end
    events[i], events[least] = events[least], events[i]
    i = least
  end
end

function M.look_for_ground(world, m)
  local to = M.part
  local function turn(speed, pull)
    local after = -speed / pull
    if speed * pull < 0 and after > 1e-9 and m.time + after < to then to = m.time + after end
  end
  turn(m.vx, m.px)
  turn(m.vy, m.py)
  local t, x_, y_, nx, ny, contact = M.next_ground(world, m, to)
  if t then
    m.ground = {x = x_, y = y_, nx = nx, ny = ny, contact = contact}
    M.add_event {time = t, kind = "ground", a = m}
  elseif to < M.part and to > m.time then
    M.add_event {time = to, kind = "turn", a = m}
  end
end

-- What holds all places of its path.
function M.sweep(m)
  local x_, y_ = place_at(m, M.part)
  local s = M.part - m.time
  local off_x, off_y = abs(m.px) * (s * s / 8) + 1e-6, abs(m.py) * (s * s / 8) + 1e-6
  m.left, m.right = min(m.x, x_) - off_x, max(m.x, x_) + m.w + off_x
  m.top, m.bottom = min(m.y, y_) - off_y, max(m.y, y_) + m.h + off_y
end

function M.look_for_pairs(m, only_later)
  for _, n in ipairs(M.members) do
    if n ~= m and not (only_later and n.index < m.index and n.inverse_mass > 0) and
        (m.inverse_mass > 0 or n.inverse_mass > 0) and n.left <= m.right and m.left <= n.right and
        n.top <= m.bottom and m.top <= n.bottom then
      local t, nx, ny = M.next_meeting(m, n, max(m.time, n.time), M.part, STILL)
      if t then M.add_event {time = t, kind = "pair", a = m, b = n, nx = nx, ny = ny} end
    end
  end
end

function M.set_off(world, m)
  m.version, m.events = m.version + 1, m.events + 1
  M.sweep(m)
  if m.inverse_mass > 0 then M.look_for_ground(world, m) end
  M.look_for_pairs(m, false)
end

-- ---- The set: all that touch at the time of an event ----

local function by_place(m, n)
  if m.y ~= n.y then return m.y < n.y end
  if m.x ~= n.x then return m.x < n.x end
  if m.h ~= n.h then return m.h < n.h end
  if m.w ~= n.w then return m.w < n.w end
  return m.index < n.index
end

function M.join(m, depth)
  if m.place then return end
  M.set[#M.set + 1] = m
  m.place, m.depth = #M.set, depth
end

-- The normal of two that touch at the time of the set; nil: they do not.
function M.touching_in_set(m, n)
  local ax, ay = place_at(m, M.time)
  local cx, cy = place_at(n, M.time)
  return M.touching(ax, ay, m.w, m.h, cx, cy, n.w, n.h, m.index < n.index)
end

function M.is_pair_of(event, m, n)
  return event.kind == "pair" and (m == event.a and n == event.b or m == event.b and n == event.a)
end

function M.look_around(m, event)
  local place, found = m.place, {}
  for _, n in ipairs(M.members) do
    if n ~= m and n.left <= m.right and m.left <= n.right and n.top <= m.bottom and m.top <= n.bottom then
      found[#found + 1] = n
    end
  end
  table.sort(found, by_place)
  for _, n in ipairs(found) do
    if not (n.place and n.place < place and n.inner) then
      if M.is_pair_of(event, m, n) or M.touching_in_set(m, n) then
        if #M.pairs == MOST_PAIRS then return end
        M.pairs[#M.pairs + 1] = {m, n}
        M.join(n)
      end
    end
  end
end

function M.gather(event)
  for _, m in ipairs(M.set) do m.place = nil end
  M.set, M.touches, M.pairs = {}, {}, {}
  M.join(event.a)
  if event.kind == "pair" then M.join(event.b) end
  table.sort(M.shaken, by_place)
  for _, m in ipairs(M.shaken) do M.join(m) end
  local given, inner, is_cut, i = #M.set, 0, false, 1
  while i <= #M.set do
    local m = M.set[i]
    local is_solved = m.cut and m.events > 0 and m.time == M.time
    local has_room = i <= given or (inner < MOST_INNER and not is_solved)
    m.inner = has_room and m.inverse_mass > 0
    is_cut = is_cut or not has_room
    if m.inner then
      inner = inner + 1
      M.look_around(m, event)
    end
    i = i + 1
  end
  for _, m in ipairs(M.set) do
    if m.inner then
      m.cut = is_cut
      M.from(m, M.time)
    end
  end
  table.sort(M.set, by_place)
  for k, m in ipairs(M.set) do
    m.place = k
    local s = M.time - m.time
    m.svx, m.svy = m.vx + m.px * s, m.vy + m.py * s
    if m.inner then
      m.spx, m.spy = m.pull_x, m.pull_y
    elseif m.events == 0 and m.vx == 0 and m.vy == 0 then
      m.spx, m.spy = 0.0, 0.0
    else
      m.spx, m.spy = m.px, m.py
    end
    m.inverse = not m.inner and #M.shaken >= MOST_SHAKEN and 0.0 or m.inverse_mass
  end
  M.add_pairs(event)
end

function M.add_pairs(event)
  for _, pair in ipairs(M.pairs) do
    if pair[1].place > pair[2].place then pair[1], pair[2] = pair[2], pair[1] end
  end
  table.sort(M.pairs, function(p, q)
    if p[1] ~= q[1] then return p[1].place < q[1].place end
    return p[2].place < q[2].place
  end)
  for _, pair in ipairs(M.pairs) do
    local m, n = pair[1], pair[2]
    local nx, ny = M.touching_in_set(m, n)
    if not nx and M.is_pair_of(event, m, n) then
      nx, ny = event.nx, event.ny
      if m ~= event.a then nx, ny = nx * -1, ny * -1 end
    end
    if nx then
      M.touches[#M.touches + 1] = {a = m, b = n, nx = nx, ny = ny, bounce = 0.0, impulse = 0.0, pressure = 0.0,
                                   friction = sqrt(m.friction * n.friction), conveyor = 0.0, still = STILL}
    end
  end
end

-- ---- What they do to one another ----

function M.add_ground(m, nx, ny, contact)
  local touch = {a = m, nx = nx, ny = ny, bounce = 0.0, friction = m.friction, impulse = 0.0, pressure = 0.0,
                 conveyor = 0.0, still = STILL_ON_GROUND, contact = contact}
  M.touches[#M.touches + 1] = touch
  table.sort(M.touches, function(t, u)
    if t.a ~= u.a then return t.a.place < u.a.place end
    local other, there = t.b and t.b.place or 0, u.b and u.b.place or 0
    if other ~= there then return other < there end
    if t.ny ~= u.ny then return t.ny < u.ny end
    return t.nx < u.nx
  end)
  return touch
end

local function is_still(vx, vy) return abs(vx) <= STILL and abs(vy) <= STILL end

function M.is_new(m, nx, ny)
  for _, touch in ipairs(M.touches) do
    if touch.a == m and not touch.b and is_still(touch.nx - nx, touch.ny - ny) then return false end
  end
  return true
end

-- Whether a body that has no speed is moved off a crest that only its very corner is on. One that slides over it goes on
-- by itself.
function M.leaves_crest(world, m, contact)
  if not is_still(m.svx, m.svy) or not contact.on_end or contact.ny >= 0 or contact.nx ~= 0 then return false end
  local piece, slack = contact.edge, M.slack(m.x, m.y, m.w, m.h, m.x, m.y, m.w, m.h)
  local crest, off = piece.y1 < piece.y0 and piece.x1 or piece.x0, 0.0
  if abs(m.x - crest) <= slack then off = crest + 2 * slack - m.x end
  if abs(m.x + m.w - crest) <= slack then off = crest - 2 * slack - (m.x + m.w) end
  if off == 0 or cast_box(world.terrain, m.x, m.y, m.w, m.h, off, 0.0, false) then return false end
  m.x = m.x + off
  return true
end

-- Looks for ground that a body touches, that it would go into, and that it leaves no faster than `fastest`.
function M.probe(world, m, way_x, way_y, fastest)
  if not m.inner then return false end
  for _ = 1, 3 do
    if is_still(way_x, way_y) then return false end
    M.from(m, M.time)
    local contact = M.touched(world, m, way_x, way_y)
    if not contact then return false end
    if not M.leaves_crest(world, m, contact) then
      local nx, ny = contact.nx, contact.ny
      if not (-(way_x * nx + way_y * ny) > STILL_ON_GROUND) then return false end
      if m.svx * nx + m.svy * ny <= fastest then
        return M.is_new(m, nx, ny) and M.add_ground(m, nx, ny, contact) ~= nil
      end
      way_x, way_y = slide_along(nx, ny, way_x, way_y)
    end
  end
  return false
end

-- What the mouse presses on others would tremble if they bounced.
local function is_dragged()
  if M.drags then
    for _, m in ipairs(M.set) do
      if m.held then return true end
    end
  end
  return false
end

function M.bounce_of(n, touch)
  if is_dragged() then return 0.0 end
  local is_floor = abs(touch.nx) <= n.steepest * abs(touch.ny)
  local own = is_floor and touch.a.floor_bounce or touch.a.wall_bounce
  if not touch.b then return own end
  return min(1.0, max(own, is_floor and touch.b.floor_bounce or touch.b.wall_bounce))
end

local function bounced_lately(m) return m.bounced >= 0 and m.bounced < M.time and M.time - m.bounced < 0.25 end
local function is_restless(m) return m ~= nil and m.events > MOST_SLOW end

-- Chooses what is reflected at once. Returns whether anything approaches. Circles alone have `slow`.
function M.choose(n, is_late)
  local chosen, approaches = {}, false
  for _, touch in ipairs(M.touches) do
    local speed = -M.speed(touch, touch.nx, touch.ny)
    local still = touch.still
    touch.caught = touch.caught or not touch.slow and speed < -still and -speed <= M.slowest and
        (is_restless(touch.a) or is_restless(touch.b))
    approaches = approaches or speed > still or touch.caught and speed < -still
    if speed > still and not touch.held then
      local bounce, up = M.bounce_of(n, touch), -touch.ny
      local least = M.slowest * (touch.b and abs(up) or max(up, 0.0))
      touch.held = is_late or speed * bounce <= least or
          (speed <= M.slowest and bounced_lately(touch.a) and (not touch.b or bounced_lately(touch.b)))
      touch.bounce = touch.held and 0.0 or bounce
    end
    if speed > still or touch.held or touch.caught then chosen[#chosen + 1] = touch end
  end
  return approaches, chosen
end

-- What is left of an approach that is too slow to bounce would add up over the frames.
function M.level_out()
  local chosen, approaches = {}, false
  for _, touch in ipairs(M.touches) do
    local is_own = touch.a.inner and (not touch.b or touch.b.inner)
    local speed = M.speed(touch, touch.nx, touch.ny)
    approaches = approaches or is_own and speed < -1e-14
    if is_own and not (speed > touch.still) then
      chosen[#chosen + 1] = {a = touch.a, b = touch.b, nx = touch.nx, ny = touch.ny, bounce = 0.0, friction = 0.0,
                             impulse = 0.0, still = touch.still}
    end
  end
  if approaches then M.reflect(chosen) end
end

-- Reflects what approaches, again until nothing does.
function M.bounce(world)
  local changed = {}
  for _, m in ipairs(M.set) do m.bvx, m.bvy, changed[m] = m.svx, m.svy, true end
  local most = 32 + 4 * #M.set
  for turn = 0, 2 * most - 1 do
    for _, m in ipairs(M.set) do
      if changed[m] then M.probe(world, m, m.svx, m.svy, -STILL_ON_GROUND) end
      changed[m] = nil
    end
    local approaches, chosen = M.choose(world.tuning, turn >= most)
    if not approaches then return M.level_out() end
    M.reflect(chosen)
    for _, touch in ipairs(chosen) do
      changed[touch.a] = true
      if touch.b then changed[touch.b] = true end
    end
  end
end

-- Whether an impact has moved bodies whose own neighbours are not in the set.
function M.shakes_more()
  local before = #M.shaken
  if before >= MOST_SHAKEN then return false end
  for _, m in ipairs(M.set) do
    if not m.inner and m.inverse_mass > 0 and (m.svx ~= m.bvx or m.svy ~= m.bvy) then M.shaken[#M.shaken + 1] = m end
  end
  return #M.shaken > before
end

function M.is_dozing()
  local found = false
  for _, m in ipairs(M.set) do
    if abs(m.svx) > M.slowest or abs(m.svy) > M.slowest then return false end
    found = found or is_restless(m)
  end
  return found
end

-- Finds the pulls of bodies that stay together.
function M.hold(world)
  for _, m in ipairs(M.set) do
    m.free_x, m.free_y = m.spx, m.spy
    if not m.inner then m.inverse = 0.0 end
  end
  for _ = 1, 16 do
    local chosen = {}
    for _, m in ipairs(M.set) do m.spx, m.spy = m.free_x, m.free_y end
    for _, touch in ipairs(M.touches) do
      if not (M.speed(touch, touch.nx, touch.ny) > touch.still) then chosen[#chosen + 1] = touch end
    end
    if #chosen > 0 then M.support(chosen) end
    local finds = false
    for _, m in ipairs(M.set) do
      if M.probe(world, m, m.spx, m.spy, STILL_ON_GROUND) then finds = true end
    end
    if not finds then return end
  end
end

function M.note_hit(world, touch)
  local m, n, nx, ny = touch.a, touch.b, touch.nx, touch.ny
  local yields, quiet = m.inverse_mass + (n and n.inverse_mass or 0.0), world.quiet.fall
  -- An impulse that only holds what rests above changes the speed of none of the two.
  local function change(of) return abs((of.svx - of.bvx) * nx + (of.svy - of.bvy) * ny) end
  local changed = max(change(m), n and change(n) or 0.0)
  local there = n and n.body or nil
  if touch.impulse > 0 or touch.pressure > 0 then
    world:note_touch(m.body, there, nx, ny)
    if n then world:note_touch(there, m.body, 0.0 - nx, 0.0 - ny) end
  end
  if not (touch.impulse * yields > quiet and changed > quiet) then return end
  if m.inner then world:note_hit(m.body, there, nx, ny, touch.impulse) end
  if n and n.inner then world:note_hit(there, m.body, 0.0 - nx, 0.0 - ny, touch.impulse) end
end

function M.note(world)
  local n = world.tuning
  for _, touch in ipairs(M.touches) do
    if has.events then M.note_hit(world, touch) end
    if touch.impulse > 0 or touch.pressure > 0 then
      local is_floor = abs(touch.nx) <= n.steepest * abs(touch.ny)
      if touch.ny < 0 and is_floor and touch.a.inner then touch.a.grounded = true end
      if touch.b and -touch.ny < 0 and is_floor and touch.b.inner then touch.b.grounded = true end
    end
  end
end

local function within(value) return clamp(clamp(value, -FAST, FAST), -FAR, FAR) end

function M.set_paths(world)
  for _, m in ipairs(M.set) do
    if m.inner then
      m.vx, m.vy, m.px, m.py = within(m.svx), within(m.svy), within(m.spx), within(m.spy)
      if is_still(m.vx, m.vy) and is_still(m.px, m.py) then m.vx, m.vy, m.px, m.py = 0.0, 0.0, 0.0, 0.0 end
    end
  end
  for _, touch in ipairs(M.touches) do
    if not touch.b and touch.a.inner then
      local stays = M.gain(touch, touch.nx, touch.ny) <= STILL_ON_GROUND
      if abs(M.speed(touch, touch.nx, touch.ny)) <= STILL_ON_GROUND then
        M.align(world, touch.a, touch.contact, stays)
      end
    end
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
  local vx, vy, px, py = m.vx, m.vy, m.px, m.py
  if n then vx, vy, px, py = vx - n.vx, vy - n.vy, px - n.px, py - n.py end
  local along_x, along_y = -touch.ny, touch.nx
  local speed, gain = vx * along_x + vy * along_y - touch.conveyor, px * along_x + py * along_y
  if not (speed * gain < 0) or abs(speed) <= STILL then return end
  local at = M.time - speed / gain
  if at < M.part then M.add_event {time = at, kind = "turn", a = m.inner and m or n} end
end

function M.stop(m)
  m.capped, m.inverse_mass = true, 0.0
  m.vx, m.vy, m.px, m.py = 0.0, 0.0, 0.0, 0.0
end

-- What those that touch at the time of an event do to one another.
function M.meet(world, event)
  local first = event.a
  local is_ground = event.kind == "ground"
  if is_ground then
    M.from(first, M.time)
    first.x, first.y = first.ground.x, first.ground.y
  end
  M.shaken = {}
  repeat
    M.gather(event)
    if is_ground then
      local vx, vy, met = first.svx, first.svy, first.ground
      if not M.leaves_crest(world, first, met.contact) then M.add_ground(first, met.nx, met.ny, met.contact) end
      M.probe(world, first, vx, 0.0, -STILL_ON_GROUND)
      M.probe(world, first, 0.0, vy, -STILL_ON_GROUND)
    end
    M.bounce(world)
  until not M.shakes_more()
  M.hold(world)
  if M.is_dozing() then
    for _, m in ipairs(M.set) do m.svx, m.svy, m.spx, m.spy = 0.0, 0.0, 0.0, 0.0 end
  end
end

function M.resolve(world, event)
  M.time = event.time
  M.meet(world, event)
  M.note(world)
  M.set_paths(world)
  local is_capped = false
  for _, m in ipairs(M.set) do is_capped = is_capped or m.events >= MOST_EVENTS end
  for _, m in ipairs(M.set) do
    if is_capped and m.inner then M.stop(m) end
  end
  for _, m in ipairs(M.set) do
    m.place = nil
    if m.inner then M.set_off(world, m) end
  end
  for _, touch in ipairs(M.touches) do M.look_for_turn(touch) end
end

-- ---- The step ----

function M.moves(world, body)
  return world.kinds[body.kind].rule == "fall" or body.id == world.grabbed
end

local function reachable(at, to) return clamp(clamp(to, at - FAST, at + FAST), -FAR, FAR) end

function M.member(_, body, index)
  return {body = body, index = index, time = 0.0, x = body.x, y = body.y, w = body.w, h = body.h, vx = 0.0, vy = 0.0,
          px = 0.0, py = 0.0, pull_x = 0.0, pull_y = 0.0, inverse_mass = 0.0, friction = 0.0, floor_bounce = 0.0,
          wall_bounce = 0.0, version = 0, events = 0, bounced = -1.0}
end
function M.way_out(world, m) return way_out(world.terrain, m.x, m.y, m.w, m.h, false) end

-- w, h: px, of a box with the same area.
function M.mass_of(kind, w, h) return (kind.mass or 1.0) * (w * h / MASS_AREA) end

function M.take(world, body, index, input)
  local n, kind = world.tuning, world.kinds[body.kind]
  local m = M.member(world, body, index)
  if not M.moves(world, body) then return m end
  if not body.clear then
    local out_x, out_y = M.way_out(world, m)
    if out_x then m.x, m.y = m.x + out_x, m.y + out_y end
  end
  m.inverse_mass = 1 / M.mass_of(kind, m.w, m.h)
  m.friction = kind.friction or 0.0
  m.floor_bounce, m.wall_bounce = kind.bounce or n.floor_bounce, kind.bounce or n.wall_bounce
  if body.id == world.grabbed then
    m.held, m.inverse_mass, m.floor_bounce, m.wall_bounce = true, m.inverse_mass / HELD_WEIGHT, 0.0, 0.0
    body.previous_x, body.previous_y = body.x, body.y
    m.vx = reachable(body.x, lerp(body.x, input.mouse_x - n.drag_offset, n.drag_blend)) - body.x
    m.vy = reachable(body.y, lerp(body.y, input.mouse_y - n.drag_offset, n.drag_blend)) - body.y
  else
    m.vx, m.vy = lerp(body.vx, n.drift_speed, n.drift_blend), body.vy
    m.pull_y = n.gravity > 0 and n.gravity or (n.fall_speed - m.vy) * n.fall_blend
  end
  return m
end

-- Bodies that begin inside of one another are moved apart.
function M.part_overlaps(world)
  local ways = {}
  for _, m in ipairs(M.members) do
    if m.inverse_mass > 0 then
      local way_x, way_y = M.way_apart(m)
      if way_x ~= 0 or way_y ~= 0 then ways[#ways + 1] = {m, way_x, way_y} end
    end
  end
  for _, way in ipairs(ways) do
    local m = way[1]
    m.x, m.y = M.led(world, m, way[2], way[3])
  end
end

-- The place to which the ground lets a body go.
function M.led(world, m, way_x, way_y)
  local contact = cast_box(world.terrain, m.x, m.y, m.w, m.h, way_x, way_y, false)
  if contact then return contact.x, contact.y end
  return m.x + way_x, m.y + way_y
end

-- How deep two are in one another, and the normal out of the second one; nil: they are not.
function M.overlap(m, n)
  local depth_x, depth_y = min(m.x + m.w - n.x, n.x + n.w - m.x), min(m.y + m.h - n.y, n.y + n.h - m.y)
  local least = min(depth_x, depth_y)
  if not (least > 0) or least <= M.slack(m.x, m.y, m.w, m.h, n.x, n.y, n.w, n.h) then return nil end
  return M.depth_of(m, n, depth_x, depth_y)
end

-- The same of two whose boxes overlap.
function M.depth_of(m, n, depth_x, depth_y)
  local nx, ny = M.touching(m.x, m.y, m.w, m.h, n.x, n.y, n.w, n.h, m.index < n.index)
  if nx then return nx ~= 0 and depth_x or depth_y, nx, ny end
end

function M.way_apart(m)
  local least_x, least_y, most_x, most_y, pile_x, pile_y = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
  for _, n in ipairs(M.members) do
    local deep, nx, ny
    if n ~= m then deep, nx, ny = M.overlap(m, n) end
    if deep then
      -- The upper one goes up all the way, as the lower one may stand on something.
      local share = m.inverse_mass / (m.inverse_mass + n.inverse_mass)
      if abs(ny) > abs(nx) and n.inverse_mass > 0 then share = ny < 0 and 1.0 or 0.0 end
      local way_x, way_y = nx * (share * deep), ny * (share * deep)
      if m.x + m.w / 2 == n.x + n.w / 2 and m.y + m.h / 2 == n.y + n.h / 2 then
        pile_x, pile_y = pile_x + way_x, pile_y + way_y
      end
      least_x, least_y = min(least_x, way_x), min(least_y, way_y)
      most_x, most_y = max(most_x, way_x), max(most_y, way_y)
    end
  end
  if pile_x ~= 0 or pile_y ~= 0 then return pile_x, pile_y end
  return least_x + most_x, least_y + most_y
end

function M.run_part(world)
  events, event_count, M.set = {}, 0, {}
  for _, m in ipairs(M.members) do
    m.time, m.px, m.py, m.events, m.bounced = 0.0, m.pull_x, m.pull_y, 0, -1.0
    if m.capped then m.px, m.py = 0.0, 0.0 end
    M.sweep(m)
  end
  for _, m in ipairs(M.members) do
    if m.inverse_mass > 0 then
      M.look_for_ground(world, m)
      M.look_for_pairs(m, true)
    end
  end
  while event_count > 0 do
    local event = M.next_event()
    if event.a.version == event.version_a and (not event.b or event.b.version == event.version_b) then
      M.resolve(world, event)
    end
  end
  for _, m in ipairs(M.members) do
    M.from(m, M.part)
    m.time = 0.0
  end
end

function M.step(world, input)
  local n = world.tuning
  M.slowest = n.gravity > 0 and n.gravity or abs(n.fall_speed * n.fall_blend)
  M.part, M.terrain = 1.0 / n.substeps, world.terrain
  M.members, M.drags = {}, (world.grabbed or 0) ~= 0
  for i, body in ipairs(world.bodies) do M.members[i] = M.take(world, body, i, input) end
  M.part_overlaps(world)
  for _ = 1, n.substeps do M.run_part(world) end
  for _, m in ipairs(M.members) do
    if m.inverse_mass > 0 or m.capped then
      local body = m.body
      body.x, body.y = clamp(m.x, -FAR, FAR), clamp(m.y, -FAR, FAR)
      -- Adding 0 leaves no -0, whose bits are others.
      if not m.held then body.vx, body.vy = clamp(m.vx, -FAST, FAST) + 0.0, clamp(m.vy, -FAST, FAST) + 0.0 end
      local stood = body.grounded
      body.grounded, body.clear = m.grounded or false, true
      if has.events then world:note_standing(body, stood) end
    end
  end
end

-- Players move first, and then all others together.
local step_bodies = World.step_bodies
function World:step_bodies(input)
  if self.tuning.bodies ~= "meet" then return step_bodies(self, input) end
  for _, body in ipairs(self.bodies) do
    if not M.moves(self, body) then step_body(self, body, input) end
  end
  M.step(self, input)
end

local add = World.add
function World:add(body)
  if (self.kinds[body.kind] or {}).round and not has.round then
    error("a circle takes the part round: name it in the export", 2)
  end
  return add(self, body)
end

-- What the part `round` uses.
M.A, M.b, M.x, M.way_to, M.place_at, M.time_to_close = A, b, x, way_to, place_at, time_to_close
M.by_place, M.is_still, M.within = by_place, is_still, within

end

World.begin_meeting()
