-- ---- Circles: how near they are to what they may touch, and when they come to it ----
-- A form is a box with `radius`, px, of a circle on the middle of its bottom, or 0: all of it is solid. How near a form
-- is to something: nx, ny, unit, from the nearest point of the other one towards the form's middle; gap, px; bend,
-- 1/px, of the middle's way along the other one, over 0 if it bends away; on_end: the nearest point is a corner, or an
-- end.

-- A function, as the names of a file of Lua are few. M: see meet.lua.
function World.begin_forms(M)

M.path_from = M.from
local STILL = 1e-11  -- px/frame, and px/frame^2
local BRINK = 1e-9  -- px/frame^2: a circle that goes round something is on the brink of leaving it below that
M.BRINK = BRINK

function M.middle(form)
  return form.x + form.w / 2, form.radius > 0 and form.y + form.h - form.radius or form.y + form.h / 2
end

-- The way out of a box around 0 that reaches half_x, half_y to each side, for a point inside.
local function out_of_middle(x, y, half_x, half_y, is_first)
  local function sign(at) return (at < 0 or at == 0 and is_first) and -1.0 or 1.0 end
  local depth_x, depth_y = half_x - abs(x), half_y - abs(y)
  if depth_x < depth_y then return {nx = sign(x), ny = 0.0, gap = -depth_x, bend = 0.0, on_end = false} end
  return {nx = 0.0, ny = sign(y), gap = -depth_y, bend = 0.0, on_end = false}
end

local function half_of(form)
  if form.radius > 0 then return 0.0, 0.0 end
  return form.w / 2, form.h / 2
end

-- px: the point of a form's box, or the middle of its circle, that is nearest to another point.
function M.nearest_point(form, x, y)
  local half_x, half_y = half_of(form)
  local there_x, there_y = M.middle(form)
  return there_x + clamp(x - there_x, -half_x, half_x), there_y + clamp(y - there_y, -half_y, half_y)
end

-- The first one shrinks to a point, and the other one grows by it: to a box with round corners. is_first: tells two in
-- one place apart.
function M.nearness(form, other, is_first)
  local ax, ay = half_of(form)
  local half_x, half_y = half_of(other)
  half_x, half_y = ax + half_x, ay + half_y
  local way_x, way_y = M.middle(form)
  local there_x, there_y = M.middle(other)
  way_x, way_y = way_x - there_x, way_y - there_y
  local radius = form.radius + other.radius
  local x, y = way_x - clamp(way_x, -half_x, half_x), way_y - clamp(way_y, -half_y, half_y)
  local distance = sqrt(x * x + y * y)
  if not (distance > 0) then
    local inside = out_of_middle(way_x, way_y, half_x, half_y, is_first)
    inside.gap = inside.gap - radius
    return inside
  end
  local share, on_end = 1 / distance, x ~= 0 and y ~= 0
  return {nx = x * share, ny = y * share, gap = distance - radius, on_end = on_end,
          bend = (on_end or half_x == 0 and half_y == 0) and 1 / radius or 0.0}
end

-- ---- The first touch on a parabola: a search has vx, vy, px, py from time 0 on; most, slack, still, is_hollow ----

-- px/frame^2: how fast the gap of a circle that touches something closes.
local function closing_gain(near, vx, vy, px, py)
  local across = vx * near.nx + vy * near.ny
  return -(px * near.nx + py * near.ny) - near.bend * (vx * vx + vy * vy - across * across)
end

-- px/frame^2: what closes the gap of two that touch faster than that keeps them together.
local function least_gain(near) return near.bend ~= 0 and BRINK or STILL end

-- For a way that may come back to what it touches, or meet it beside the nearest point, as in a hollow.
local function first_touch_by_samples(search, from, near_at)
  local most, start = search.most, near_at(from).gap
  local lift = start <= search.slack and search.slack + max(0.0, -start) or 0.0
  local function gap(t) return near_at(t).gap + lift end
  local clear = from
  for i = 1, 4 do
    local t = i == 4 and most or from + (most - from) * i / 4
    if gap(t) >= 0 then
      clear = t
    else
      local at = zero_between(clear, t, gap)
      local near = near_at(at)
      local vx, vy = search.vx + search.px * at, search.vy + search.py * at
      if -(vx * near.nx + vy * near.ny) > search.still then return at, near end
      return nil
    end
  end
end

-- A touch found to the slack, to rounding: what is left of the gap is gone soon, or was gone just before.
local function touch_to_rounding(search, t, near, near_at)
  for _ = 1, 3 do
    local vx, vy = search.vx + search.px * t, search.vy + search.py * t
    local left = near.gap / -(vx * near.nx + vy * near.ny)
    if not (abs(left) <= 1e-6) then break end
    t = max(0.0, t + left)
    near = near_at(t)
    if abs(left) <= 1e-12 then break end
  end
  return t, near
end

-- The first time at which two touch and come nearer, and how near they are then. The plane through the nearest point
-- parts them until it is reached; the next plane is nearer to what is met.
function M.first_touch(search, near_at)
  local most, slack, still, px, py = search.most, search.slack, search.still, search.px, search.py
  local t = 0.0
  for _ = 1, 64 do
    if not (t < most) then return nil end
    local near = near_at(t)
    local vx, vy = search.vx + px * t, search.vy + py * t
    local speed, gain = -(vx * near.nx + vy * near.ny), -(px * near.nx + py * near.ny)
    local opens = -closing_gain(near, vx, vy, px, py)
    if near.gap > slack then
      if search.is_hollow then return first_touch_by_samples(search, t, near_at) end
      t = t + M.time_to_close(near.gap, speed, gain)
    elseif speed > still and opens > 0 and speed * speed / (2 * opens) - near.gap <= slack then
      -- What bends away is only brushed by a circle that comes no deeper than that.
      t = t + 2 * speed / opens
    elseif speed < -still and not search.is_hollow then
      -- It leaves the plane, and is back on it when its pull has turned it round.
      if not (gain > 0) then return nil end
      t = t + -2 * speed / gain
    else
      local stays = speed >= -still and -opens > least_gain(near)
      if not (speed > still) and not stays then return first_touch_by_samples(search, t, near_at) end
      if t > 0 and speed > still then t, near = touch_to_rounding(search, t, near, near_at) end
      if t < most then return t, near end
      return nil
    end
  end
  -- Beside an end that it has just left it may come nearer to what follows by tiny steps alone.
  if t < most then return first_touch_by_samples(search, t, near_at) end
end

-- ---- Two bodies ----

-- A copy of a body's path, size and radius, seen from a time on.
function M.moving_at(m, t)
  local moving = {x = m.x, y = m.y, w = m.w, h = m.h, radius = m.radius, time = m.time, vx = m.vx, vy = m.vy, px = m.px,
                  py = m.py}
  M.path_from(moving, t)
  return moving
end

-- The form of a body on its path at a time.
function M.form_at(m, t)
  local x, y = M.place_at(m, t)
  return {x = x, y = y, w = m.w, h = m.h, radius = m.radius}
end

local next_meeting = M.next_meeting
function M.next_meeting(m, n, from, to, still)
  if not (m.radius > 0 or n.radius > 0) then return next_meeting(m, n, from, to, still) end
  local way, q = M.moving_at(m, from), M.moving_at(n, from)
  local form, there = M.form_at(m, from), M.form_at(n, from)
  local start_x, start_y = form.x, form.y
  local search = {vx = way.vx - q.vx, vy = way.vy - q.vy, px = way.px - q.px, py = way.py - q.py, most = to - from,
                  slack = M.slack(form.x, form.y, form.w, form.h, there.x, there.y, there.w, there.h), still = still}
  local t, touch = M.first_touch(search, function(s)
    local half = s * s / 2
    form.x, form.y = start_x + (search.vx * s + search.px * half), start_y + (search.vy * s + search.py * half)
    return M.nearness(form, there, true)
  end)
  if t then return from + t, touch.nx, touch.ny end
end

end

World.begin_forms(World.meeting)
