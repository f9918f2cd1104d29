-- ---- Tracks: what circles roll or slide along in a part of a step, and boxes on curves with one of their corners ----
-- Paths are parabolas. One that has the bend of the track stays near it; at its end the circle is put back on it, and
-- gets the speed that its way down or up gives it. A track has sides of the ground, which the circle touches and which
-- stop nothing, of which it follows the first ones, by number `followed`; or other, a body that stands still, version,
-- form, and gap, px, which it keeps; on_end: it goes round a corner, or the end of a side; is_alone: nothing else
-- touches the circle; rolls: the share of a pull along it that moves the circle; pull_x, pull_y, without the track;
-- drive, px/frame^2, along it, beside that share; conveyor, px/frame, of its surface.

-- A function, as the names of a file of Lua are few. M: see meet.lua.
function World.begin_tracks(M)

local STILL = 1e-11  -- px/frame, and px/frame^2
local STILL_ON_GROUND = 1e-12
local SHORT = 1e-5  -- px: over so little, a curve is a part of a circle
local PAST = 1e-9  -- px: only what is further past an end has left it

-- px: how far a middle is past the nearer end of a side, or before it, along the side there.
local function past_end(side, x, y)
  local from_x, from_y, to_x, to_y = x - side.ax, y - side.ay, x - side.bx, y - side.by
  local is_first = M.is_first_nearer(side, x, y)
  local onward_x, onward_y = side.ux, side.uy
  if side.stretch then onward_x, onward_y = tangent_at(side.stretch, is_first and side.ax or side.bx) end
  if is_first then to_x, to_y = from_x, from_y end
  return abs(to_x * onward_x + to_y * onward_y)
end

-- ---- Along a track ----

local function near_track(track, form)
  if track.other then return M.nearness(form, track.form, true) end
  local x, y = M.middle(form)
  return (M.near_side(track.sides[1], x, y, form.radius))
end

-- Whether a circle touches the same part of it still: not one behind an end.
local function goes_on(track, form)
  if track.other then return M.nearness(form, track.form, true).on_end == track.on_end end
  local x, y = M.middle(form)
  for i = 1, track.followed do
    local side = track.sides[i]
    local near = M.near_side(side, x, y, form.radius)
    if near.on_end ~= track.on_end and not (past_end(side, x, y) <= PAST) then return false end
  end
  return true
end

-- A parabola may lead a little higher than the energy does. missing: px^2/frame^2, of the square of the speed.
local function go_down(track, m, onward_x, onward_y, missing)
  local steep = 2 * track.rolls * (track.pull_x * onward_x + track.pull_y * onward_y)
  if not (abs(steep) > missing) then return end
  local share = missing / steep
  m.x, m.y = m.x + onward_x * share, m.y + onward_y * share
  local near = near_track(track, M.form_at(m, m.time))
  local off = near.gap - track.gap
  m.x, m.y = m.x - near.nx * off, m.y - near.ny * off
end

local function centre_for(track, form)
  local x, y = M.middle(form)
  if track.other then
    if near_track(track, form).bend == 0 then return nil end
    return M.nearest_point(track.form, x, y)
  end
  local side = track.sides[1]
  if track.on_end then return M.nearer_end(side, x, y) end
  if side.stretch and side.stretch.kind == "arc" then return side.stretch.c1, side.stretch.c2 end
end

-- px: the way of a circle until a time, and on to the track. Of places, or of gaps, the rounding would be all that is
-- left of a speed that is about to turn back. m: before the way, there: how near it is after it.
local function way_along(track, m, t, there)
  local s = t - m.time
  local half = s * s / 2
  local x, y = m.vx * s + m.px * half, m.vy * s + m.py * half
  local begin = M.form_at(m, m.time)
  local from_x, from_y
  if track.centre_x then
    from_x, from_y = M.middle(begin)
    from_x, from_y = from_x - track.centre_x, from_y - track.centre_y
  else
    if not (x * x + y * y <= SHORT * SHORT) then
      local off = there.gap - track.gap
      return x - there.nx * off, y - there.ny * off
    end
    local here = near_track(track, begin)
    if here.bend == 0 then
      local off = x * here.nx + y * here.ny
      return x - here.nx * off, y - here.ny * off
    end
    from_x, from_y = here.nx * (1 / here.bend), here.ny * (1 / here.bend)
  end
  local to_x, to_y = from_x + x, from_y + y
  local before, after = sqrt(from_x * from_x + from_y * from_y), sqrt(to_x * to_x + to_y * to_y)
  local share = (2 * (from_x * x + from_y * y) + (x * x + y * y)) / ((before + after) * after)
  return x - to_x * share, y - to_y * share
end

-- Takes a circle on it to a time, and returns the direction of the track there. The square of the speed follows from
-- the way along gravity, as energy is kept.
local function take(track, m, t)
  local before = M.moving_at(m, m.time)
  M.path_from(m, t)
  local near = near_track(track, M.form_at(m, t))
  local onward_x, onward_y = -near.ny, near.nx
  -- At the end of an end or a corner rounding may call the place the flat beyond: the speed is due there, too.
  local is_curve = track.sides and track.sides[1].stretch  -- it may be straight in one place
  if near.bend == 0 and not track.on_end and not is_curve then
    if not track.other then M.put_on(track.sides[1], m) end
    return onward_x, onward_y
  end
  local off = near.gap - track.gap
  m.x, m.y = m.x - near.nx * off, m.y - near.ny * off
  local way_x, way_y = way_along(track, before, t, near)
  local straight = m.vx * onward_x + m.vy * onward_y
  local driven = track.drive * (way_x * onward_x + way_y * onward_y < 0 and -1 or 1) *
      sqrt(way_x * way_x + way_y * way_y)
  local kept = before.vx * before.vx + before.vy * before.vy
  local square = kept + 2 * (track.rolls * (track.pull_x * way_x + track.pull_y * way_y) + driven)
  -- Where the path turns back, the energy may lead a little higher.
  if straight * straight < square / 16 then straight = before.vx * onward_x + before.vy * onward_y end
  local speed = (straight < 0 and -1 or 1) * sqrt(max(square, 0.0))
  m.vx, m.vy = onward_x * speed, onward_y * speed
  if square < 0 then go_down(track, m, onward_x, onward_y, -square) end
  return onward_x, onward_y
end

-- Radians: a path that turns no more is near to its track.
local function most_turn(is_round) return is_round and 0.125 or 0.03125 end

-- frames, for a path that turns by so many radians a frame.
local function longest(turn, is_round) return most_turn(is_round) / abs(turn) end

-- The time before `most` at which a circle comes to another part of it, or leaves it; `most` if it does not.
local function end_of(track, m, most)
  local begin, is_round = near_track(track, M.form_at(m, m.time)), m.radius > 0
  local turn = abs(begin.bend) * sqrt(m.vx * m.vx + m.vy * m.vy)
  if turn > 0 then most = min(most, m.time + longest(turn, is_round)) end
  local function holds(t)
    local form = M.form_at(m, t)
    if not goes_on(track, form) then return false end
    local near = near_track(track, form)
    -- A curve may bend much more further on.
    local cosine, sine = begin.nx * near.nx + begin.ny * near.ny, begin.nx * near.ny - begin.ny * near.nx
    if not (cosine > 0 and abs(sine) <= 2 * most_turn(is_round)) then return false end
    if near.bend <= 0 or not track.is_alone or near.on_end ~= track.on_end then return true end
    local there = M.moving_at(m, m.time)
    take(track, there, t)
    local square = there.vx * there.vx + there.vy * there.vy
    return track.pull_x * near.nx + track.pull_y * near.ny + near.bend * square <= 0
  end
  if holds(most) then return most end
  local from, to = m.time, most
  for _ = 1, 48 do
    local middle = from + (to - from) / 2
    if holds(middle) then from = middle else to = middle end
  end
  return to
end

-- ---- Where they are ----

-- The corner of a box with which it goes along a curve: a circle without a radius.
local function corner_of(track, m)
  local corner = M.moving_at(m, m.time)
  corner.x, corner.y, corner.w, corner.h = m.x + track.corner_x, m.y + track.corner_y, 0.0, 0.0
  return corner
end

-- The track of a box leads a little beside the path for which the ground was looked at: it must not lead into what is
-- there.
local function take_along(track, m, t)
  if m.radius > 0 then return take(track, m, t) end
  local x, y, corner, piece = m.x, m.y, corner_of(track, m), track.sides[1].piece
  local onward_x, onward_y = take(track, corner, t)
  m.time, m.x, m.y = corner.time, corner.x - track.corner_x, corner.y - track.corner_y
  m.vx, m.vy, m.px, m.py = corner.vx, corner.vy, corner.px, corner.py
  local met = cast_box(M.terrain, x, y, m.w, m.h, m.x - x, m.y - y, false, nil, piece.source or piece)
  if met then
    -- The way is straight, and may be beside the curve where it ends.
    local rest = piece.form.rest(piece, met.x, m.w, m.h, false)
    m.x, m.y = met.x, piece.facing == UP and min(met.y, rest) or max(met.y, rest)
  end
  return onward_x, onward_y
end

function M.from(m, t)
  if not (m.radius > 0) then
    if m.track then take_along(m.track, m, t) else M.path_from(m, t) end
    return
  end
  local s = t - m.time
  local spin = m.spin + m.spin_pull * s
  if not m.track then
    M.path_from(m, t)
  else
    local onward_x, onward_y = take(m.track, m, t)
    if m.track.rolls < 1 then spin = m.vx * onward_x + m.vy * onward_y - m.track.conveyor end
  end
  m.turned = m.turned + (m.spin + spin) / 2 * s
  m.spin = spin
end

-- What of a body is solid at the time of the set.
function M.form_of(m)
  if not m.track then return M.form_at(m, M.time) end
  local moving = M.moving_at(m, m.time)
  take_along(m.track, moving, M.time)
  return M.form_at(moving, M.time)
end

-- The path of a circle leads a little beside its track. Returns the time of a meeting, and the normal, of the circle on
-- the track.
local function meet_on_track(m, to, met)
  local t, nx, ny = met.time, met.nx, met.ny
  for _ = 1, 3 do
    local there = M.moving_at(m, m.time)
    take(m.track, there, t)
    local x, y = M.middle(M.form_at(there, t))
    local near = M.near_side(met.side, x, y, m.radius)
    local time = t + near.gap / -(there.vx * near.nx + there.vy * near.ny)
    if not (time >= m.time and time <= to) then break end
    if not near.on_end then nx, ny = near.nx, near.ny end
    local is_same = abs(time - t) <= 1e-12
    t = time
    if is_same then break end
  end
  return t, nx, ny
end

local next_ground = M.next_ground
function M.next_ground(world, m, to)
  if not (m.radius > 0) then
    local along = m.track and m.track.sides[1].piece or m.leaves
    return next_ground(world, m, to, along and (along.source or along))
  end
  local met = M.meeting_of_circle(world, m, to, m.track and m.track.sides or {})
  if not met then return end
  local time, nx, ny = met.time, met.nx, met.ny
  if m.track then time, nx, ny = meet_on_track(m, to, met) end
  return time, met.x, met.y, nx, ny, met.side
end

local set_off = M.set_off
function M.set_off(world, m)
  set_off(world, m)
  if not m.track or m.time >= M.part then return end
  local at = end_of(m.track, m.radius > 0 and m or corner_of(m.track, m), M.part)
  if at < M.part then M.add_event {time = at, kind = "turn", a = m} end
end

-- Whether a circle rolls on a body.
function M.goes_along(m, other)
  return m.track ~= nil and m.track.other == other and m.track.version == other.version
end

-- Puts a circle exactly on the ground that it stays on.
local function align(touch, stays)
  local m, nx, ny = touch.a, touch.nx, touch.ny
  M.put_on(touch.contact, m)
  local into = m.vx * nx + m.vy * ny
  m.vx, m.vy = m.vx - nx * into, m.vy - ny * into
  if not stays or touch.is_track then return end
  into = m.px * nx + m.py * ny
  m.px, m.py = m.px - nx * into, m.py - ny * into
end

function M.align_on(world, touch, stays)
  if touch.a.radius > 0 then return align(touch, stays) end
  return M.align(world, touch.a, touch.contact, stays)
end

-- ---- The ground that they touch ----

-- Adds the contact of a circle with a side. is_in_gap: see M.sides_touched. Returns whether it is new.
function M.add_side(m, side, nx, ny, is_in_gap)
  if not M.is_new(m, nx, ny) then return false end
  local x, y = M.middle(M.form_at(m, M.time))
  local touch = M.add_ground(m, nx, ny, side)
  touch.near, touch.slow, touch.is_in_gap = M.near_side(side, x, y, m.radius), M.slow, is_in_gap
  return true
end

-- Circles in a pile press on all ground that they touch.
function M.add_ground_of_circles(world)
  for _, m in ipairs(M.set) do
    if m.inner and m.radius > 0 then
      for _, touch in ipairs(M.all_touched(world, M.form_at(m, M.time))) do
        local near = touch.near
        if m.svx * near.nx + m.svy * near.ny <= M.slow then
          M.add_side(m, touch.side, near.nx, near.ny, touch.is_in_gap)
        end
      end
    end
  end
end

local probe = M.probe
function M.probe(world, m, way_x, way_y, fastest)
  if not m.inner or not (m.radius > 0) then return probe(world, m, way_x, way_y, fastest) end
  if M.is_still(way_x, way_y) then return false end
  local finds = false
  for _, touch in ipairs(M.all_touched(world, M.form_at(m, M.time))) do
    local nx, ny = touch.near.nx, touch.near.ny
    if -(way_x * nx + way_y * ny) > STILL_ON_GROUND and not (m.svx * nx + m.svy * ny > fastest) and
        M.add_side(m, touch.side, nx, ny, touch.is_in_gap) then
      finds = true
    end
  end
  return finds
end

-- ---- Which tracks ----

-- Of the contacts that a circle keeps, the one with the ground that bends towards it most, or with a body that stands
-- still.
local function best_track(m)
  local best, is_on_ground = nil, false
  for _, touch in ipairs(M.touches) do
    -- Through a gap a circle goes, not round its end.
    if touch.near and not touch.is_apart and not touch.is_in_gap and (touch.a == m or touch.b == m) and
        not (abs(M.speed(touch, touch.nx, touch.ny)) > touch.still) then
      local other = touch.a == m and touch.b or touch.a
      local is_ground = not touch.b
      if is_ground or not is_on_ground and other.svx == 0 and other.svy == 0 then
        if not best or is_ground and not is_on_ground or touch.near.bend < best.near.bend then best = touch end
        is_on_ground = is_on_ground or is_ground
      end
    end
  end
  return best
end

-- Whether a circle would turn so much in a hollow hardly wider than itself that parabolas cannot follow.
local function is_too_narrow(near, m)
  return -near.bend * sqrt(m.svx * m.svx + m.svy * m.svy) * M.part > 4
end

-- Whether a way along x, from a corner that touches a curve, does not leave it at once.
local function leads_along(side, x, way)
  if way < 0 then return x > side.ax + PAST end
  return x < side.bx - PAST
end

local function corner_on(piece, m) return piece.form.offset(piece, m.w, false), piece.facing == UP and m.h or 0.0 end

-- The curve that goes on where another one ends at a corner, and which the same corner of a box touches. way: px, along
-- x.
local function next_curve(world, last, x, y, way, m)
  for _, side in ipairs(M.find_sides(world.terrain, x - PAST, y - PAST, 2 * PAST, 2 * PAST)) do
    local end_x, end_y = side.ax, side.ay
    if way < 0 then end_x, end_y = side.bx, side.by end
    if side.stretch and side.facing == last.facing and leads_along(side, x, way) and abs(end_x - x) <= PAST and
        abs(end_y - y) <= PAST and corner_on(side.piece, m) == corner_on(last.piece, m) then
      return side
    end
  end
end

-- The curve along which a box goes that touches one with a corner, and how near it is.
local function curve_of(world, touch)
  local m, piece = touch.a, touch.contact and not touch.contact.on_end and touch.contact.edge
  if not piece or not piece.stretch then return nil end
  local x, y = M.place_at(m, M.time)
  local corner_x, corner_y = corner_on(piece, m)
  x, y = x + corner_x, y + corner_y
  local way = m.svx ~= 0 and m.svx or m.spx
  local side = M.side_of(piece)
  if not leads_along(side, x, way) then side = next_curve(world, side, x, y, way, m) end
  if side then return side, (M.near_side(side, x, y, 0.0)) end
end

-- A box goes along the one that bends towards it most of the curves that it keeps touching with a corner.
local function best_curve(world, m)
  local best, least = nil, 0.0
  for _, touch in ipairs(M.touches) do
    if touch.a == m and not touch.b and not (abs(M.speed(touch, touch.nx, touch.ny)) > touch.still) then
      local side, near = curve_of(world, touch)
      if side and not (best and near.bend >= least) then best, least = touch, near.bend end
    end
  end
  return best, least
end

function M.find_tracks(world)
  for _, touch in ipairs(M.touches) do touch.is_track, touch.parts = false, 0.0 end
  for _, m in ipairs(M.set) do
    local best, bend
    if m.inner and m.radius > 0 then
      best = best_track(m)
      if best and is_too_narrow(best.near, m) then best = nil end
      bend = best and best.near.bend
    elseif m.inner then
      best, bend = best_curve(world, m)
    end
    if best then best.is_track, best.parts = true, bend * (m.svx * m.svx + m.svy * m.svy) end
  end
end

-- Of the sides that a circle touches, and keeps touching, it follows the one with this normal, or those that meet in
-- the end that it goes round. Returns whether there are some.
local function follow_ground(world, track, m, nx, ny)
  track.sides, track.followed = {}, 0
  local form = M.form_at(m, M.time)
  -- All of the way: else the seams of tiles would be ends.
  for _, touch in ipairs(M.sides_touched(world, form, M.area_around(form, M.form_at(m, M.part)))) do
    local near = touch.near
    if not (abs(m.vx * near.nx + m.vy * near.ny) > STILL_ON_GROUND) then
      local is_followed = near.on_end == track.on_end and M.is_still(near.nx - nx, near.ny - ny)
      table.insert(track.sides, is_followed and 1 or #track.sides + 1, touch.side)
      if is_followed then track.followed = track.followed + 1 end
    end
  end
  return track.followed > 0
end

-- Returns whether the other body stands still.
local function follow_body(track, near, other)
  track.other, track.version, track.form, track.gap = other, other.version, M.form_of(other), near.gap
  return other.vx == 0 and other.vy == 0 and other.px == 0 and other.py == 0
end

local function is_alone(met, m)
  for _, touch in ipairs(M.touches) do
    if touch ~= met and (touch.a == m or touch.b == m) and touch.pressure > 0 then return false end
  end
  return true
end

local function is_moving(m) return m.inner and not (m.vx == 0 and m.vy == 0 and m.px == 0 and m.py == 0) end

-- Says what moves a body along its track. nx, ny: out of what it follows.
local function drive(track, met, m, nx, ny)
  local onward_x, onward_y = -ny, nx
  track.is_alone = is_alone(met, m)
  track.pull_x, track.pull_y = m.pull_x, m.pull_y
  track.drive = m.spx * onward_x + m.spy * onward_y - track.rolls * (m.pull_x * onward_x + m.pull_y * onward_y)
end

-- Changes the pull along the track of a circle, so that the path ends, with this piece of the track, where the circle
-- would be. A parabola goes further along than what it is bent to, and the pull changes as the track turns.
local function keep_pace(track, m, bend, nx, ny)
  local onward_x, onward_y = -ny, nx
  local speed = m.vx * onward_x + m.vy * onward_y
  local turn = bend * speed
  if turn == 0 then return end
  local t = min(M.part - M.time, longest(turn, true))
  local change = -turn * (track.rolls * (track.pull_x * nx + track.pull_y * ny) + turn * speed)
  local more = change * t / 3
  m.px, m.py = m.px + onward_x * more, m.py + onward_y * more
end

-- A box that a curve holds goes along it with a corner.
local function begin_track_of_box(world, met)
  local m, side, near = met.a, curve_of(world, met)
  if not side or not is_moving(m) then return end
  m.track, m.leaves = nil, nil
  if near.bend > 0 and not (met.pressure * m.inverse > M.BRINK) then
    m.leaves = side.piece
  elseif met.pressure > 0 then
    local track = {on_end = false, gap = 0.0, sides = {side}, followed = 1, rolls = 1.0, conveyor = 0.0}
    track.corner_x, track.corner_y = corner_on(side.piece, m)
    track.centre_x, track.centre_y = centre_for(track, M.form_at(corner_of(track, m), M.time))
    drive(track, met, m, met.nx, met.ny)
    m.track = track
    world.leaves_apart = false  -- it leaves its path a little, to stay on the curve
  end
end

-- A body that something holds on a track goes along it from now on.
function M.begin_track(world, met)
  if not met.near then return begin_track_of_box(world, met) end
  local function goes(m) return m and m.radius > 0 and is_moving(m) end
  local is_first, near = goes(met.a), met.near
  if not (met.pressure > 0) or not (is_first or goes(met.b)) then return end
  local m, other, nx, ny = met.a, met.b, met.nx, met.ny
  if not is_first then m, other, nx, ny = met.b, met.a, 0 - nx, 0 - ny end
  if near.bend > 0 and not (met.pressure * m.inverse > M.BRINK) then return end  -- it is about to leave
  local track = {on_end = near.on_end, gap = 0.0}
  m.track = nil
  if other then
    if not follow_body(track, near, other) then return end
  elseif not follow_ground(world, track, m, nx, ny) then
    return
  end
  track.centre_x, track.centre_y = centre_for(track, M.form_at(m, M.time))
  local onward_x, onward_y = -ny, nx
  local drawn = m.spx * onward_x + m.spy * onward_y
  local slip = m.svx * onward_x + m.svy * onward_y - m.sspin - met.conveyor
  local rolls = met.friction > 0 and abs(slip) <= STILL and abs(drawn - m.sspin_pull) <= STILL
  track.conveyor = met.conveyor
  track.rolls = rolls and 1 / (1 + m.inverse / m.yields) or 1.0
  drive(track, met, m, nx, ny)
  keep_pace(track, m, near.bend, nx, ny)
  m.track = track
end

end

World.begin_tracks(World.meeting)
