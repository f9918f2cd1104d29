-- ---- The ground as circles meet it ----
-- A side is a line of the outline, or a stretch of a curve: ax, ay and bx, by, its ends; ux, uy, unit, of a line, along
-- it; nx, ny, unit, of a line, out of the ground; facing; stretch and piece, of a curve; is_thin: there is no ground
-- behind it, so what is inside of it goes through; is_hollow: it bends towards what it stops.

-- A function, as the names of a file of Lua are few. M: see meet.lua.
function World.begin_round_ground(M)

local STILL = 1e-11  -- px/frame
local THROUGH = 0.0625  -- px: a circle that is deeper in a side with no ground behind goes through it

-- ---- Sides ----

local function line(ax, ay, bx_, by_, ux, uy, nx, ny, facing)
  return {ax = ax, ay = ay, bx = bx_, by = by_, ux = ux, uy = uy, nx = nx, ny = ny, facing = facing}
end

-- The open sides of full tiles in a row: upper and lower ones reach over as many tiles as there are.
local function add_tiles(terrain, first, last, row, found)
  local top, bottom = row * TILE_H, (row + 1) * TILE_H
  for n = 1, 2 do
    local ny = n == 1 and -1.0 or 1.0
    local y, x = n == 1 and top or bottom, first
    while x <= last do
      local from = x
      while x <= last and terrain:is_open(x, row, 0, n == 1 and -1 or 1) do x = x + 1 end
      if x > from then
        local side = line(from * TILE_W, y, x * TILE_W, y, 1.0, 0.0, 0.0, ny, n == 1 and UP or DOWN)
        side.column, side.row = from, row
        found[#found + 1] = side
      end
      x = x + 1
    end
  end
  for n = 1, 2 do
    for column_ = first, last do
      if terrain:is_open(column_, row, n == 1 and -1 or 1, 0) then
        local x = (n == 1 and column_ or column_ + 1) * TILE_W
        local side = line(x, top, x, bottom, 0.0, 1.0, n == 1 and -1.0 or 1.0, 0.0, n == 1 and LEFT or RIGHT)
        side.column, side.row = column_, row
        found[#found + 1] = side
      end
    end
  end
end

local function side_of(piece)
  local side
  if piece.facing >= LEFT then
    side = line(piece.x0, piece.y0, piece.x1, piece.y1, 0.0, 1.0, piece.facing == LEFT and -1.0 or 1.0, 0.0,
                piece.facing)
  else
    local length, up = sqrt(1 + piece.slope * piece.slope), piece.facing == UP and 1.0 or -1.0
    side = line(piece.x0, piece.y0, piece.x1, piece.y1, 1 / length, piece.slope / length,
                up * piece.slope / length + 0.0, -up / length, piece.facing)
  end
  side.piece, side.stretch = piece, piece.stretch
  side.is_thin = not piece.solid or not piece.origin  -- curves have no origin
  side.is_hollow = side.stretch ~= nil and side.stretch.bends_down ~= (side.facing == UP)
  return side
end

-- The sides in an area, px. Tiles side by side are one, in 64 columns.
local function find_sides(terrain, x, y, w, h)
  local found = {}
  local left, right, top, bottom = block_of(terrain, x, y, w, h, 0.0)
  for first = left, right, 64 do
    local last = min(first + 63, right)
    for row_ = top, bottom do
      add_tiles(terrain, first, last, row_, found)
      for column_ = first, last do
        if terrain:is_detailed(column_, row_) then
          for _, piece in ipairs(terrain:detail(column_, row_).pieces) do found[#found + 1] = side_of(piece) end
        end
      end
    end
  end
  return found
end

M.side_of, M.find_sides = side_of, find_sides

-- ---- The nearest point of a curve ----

-- px: the x of the point of an arc that is nearest, or infinite if that is on the other half of the circle.
local function nearest_on_arc(arc, x, y)
  local way_x, way_y = x - arc.c1, y - arc.c2
  local far = sqrt(way_x * way_x + way_y * way_y)
  if not (far > 0) or way_y * arc.sign < 0 then return way_x < 0 and -huge or huge end
  return arc.c1 + way_x / far * arc.c3
end

-- 1/px, at least 0: one over the radius of the circle that fits the curve best.
local function curvature_at(s, x)
  if s.kind == "arc" then return 1 / s.c3 end
  local u = x - s.c1
  local second
  if s.kind == "sine" then
    second = s.c3 * (TAU / s.c4) * (TAU / s.c4) * sine_of_turns(u / s.c4)
  else
    second = 2 * s.c4 + 6 * s.c5 * u
  end
  local flat = tangent_at(s, x)
  return abs(second) * (flat * flat * flat)
end

-- The same for other curves, between two places on the side. Of several points that are nearer than those beside them,
-- the nearest of some samples leads to one. is_fine: the samples are close together.
local function nearest_by_halving(side, x0, x1, x, y, is_fine)
  local curve, best, least = side.stretch, 0, huge
  local function sample(i) return i == 8 and x1 or x0 + (x1 - x0) * i / 8 end
  for i = 0, 8 do
    local at = sample(i)
    local way_x, way_y = at - x, curve_y(curve, at) - y
    local far = way_x * way_x + way_y * way_y
    if far < least then least, best = far, i end
  end
  -- Over 0: the point is too far to the right.
  local function beyond(at)
    local along_x, along_y = tangent_at(curve, at)
    return (at - x) * along_x + (curve_y(curve, at) - y) * along_y
  end
  local left, right = sample(max(best - 1, 0)), sample(min(best + 1, 8))
  local at_left, at_right = beyond(left), beyond(right)
  if not (at_left < 0 and at_right > 0) then
    local is_first, is_last = best == 0 and at_left >= 0, best == 8 and at_right <= 0
    local at = sample(best)
    local bend = curvature_at(curve, at)
    -- In a hollow narrower than the circle its lowest point may be farther than those on either side.
    local is_narrow = side.is_hollow and least * bend * bend > 1
    if is_fine or ((is_first or is_last) and not is_narrow) then return is_first and -huge or is_last and huge or at end
    local fine = nearest_by_halving(side, left, right, x, y, true)
    if fine < left then return left == x0 and -huge or left end
    if fine > right then return right == x1 and huge or right end
    return fine
  end
  for i = 0, 59 do
    local at = left - at_left * (right - left) / (at_right - at_left)
    if i % 3 == 2 or not (at > left and at < right) then at = left + (right - left) / 2 end
    if not (at > left and at < right) then break end
    local off = beyond(at)
    if off == 0 then return at end
    if off < 0 then left, at_left = at, off else right, at_right = at, off end
  end
  return at_right < -at_left and right or left
end

-- ---- How near a circle is to a side, and whether it is in front of it; level with the end counts ----

-- nx, ny: out of the ground at the end.
local function near_end(at_x, at_y, nx, ny, x, y, radius)
  local way_x, way_y = x - at_x, y - at_y
  local far = sqrt(way_x * way_x + way_y * way_y)
  local near = {nx = 0.0, ny = -1.0, gap = far - radius, bend = 1 / radius, on_end = true}
  if far > 0 then
    local share = 1 / far
    near.nx, near.ny = way_x * share, way_y * share
  end
  return near, way_x * nx + way_y * ny >= 0
end

local function near_curve(side, x, y, radius)
  local curve, normal_at = side.stretch, side.piece.form.normal_at
  local at = curve.kind == "arc" and nearest_on_arc(curve, x, y) or nearest_by_halving(side, side.ax, side.bx, x, y)
  if at < side.ax then
    local nx, ny = normal_at(side.piece, side.ax)
    return near_end(side.ax, side.ay, nx, ny, x, y, radius)
  end
  if at > side.bx then
    local nx, ny = normal_at(side.piece, side.bx)
    return near_end(side.bx, side.by, nx, ny, x, y, radius)
  end
  local nx, ny = normal_at(side.piece, at)
  local far = (x - at) * nx + (y - curve_y(curve, at)) * ny
  local around = 1 / curvature_at(curve, at)  -- px
  local middles = side.is_hollow and radius - around or radius + around
  return {nx = nx, ny = ny, gap = far - radius, on_end = false,
          bend = around < huge and middles ~= 0 and 1 / middles or 0.0}, far >= 0
end

-- px: the x of the nearest point of another curve, of a point that is on it, or hardly beside it.
local function nearest_by_steps(side, x, y)
  local curve, at = side.stretch, x
  for _ = 1, 6 do
    if not (at > side.ax and at < side.bx) then break end
    local along_x, along_y = tangent_at(curve, at)
    local step = ((x - at) * along_x + (y - curve_y(curve, at)) * along_y) * along_x
    if at + step == at then break end
    at = at + step
  end
  return at
end

-- A corner of a box has no radius, and is on the curve, or hardly beside it.
local function near_corner(side, x, y)
  local curve = side.stretch
  local on_curve = curve.kind == "arc" and nearest_on_arc(curve, x, y) or nearest_by_steps(side, x, y)
  local at = clamp(on_curve, side.ax, side.bx)
  local nx, ny = side.piece.form.normal_at(side.piece, at)
  local gap = (x - at) * nx + (y - curve_y(curve, at)) * ny
  return {nx = nx, ny = ny, gap = gap, on_end = at ~= on_curve,
          bend = curvature_at(curve, at) * (side.is_hollow and -1 or 1)}, true
end

function M.near_side(side, x, y, radius)
  if side.stretch then
    if not (radius > 0) then return near_corner(side, x, y) end
    return near_curve(side, x, y, radius)
  end
  local way_x, way_y, back_x, back_y = x - side.ax, y - side.ay, x - side.bx, y - side.by
  local passed, left = way_x * side.ux + way_y * side.uy, -(back_x * side.ux + back_y * side.uy)
  if passed < 0 then return near_end(side.ax, side.ay, side.nx, side.ny, x, y, radius) end
  if left < 0 then return near_end(side.bx, side.by, side.nx, side.ny, x, y, radius) end
  if not (passed < left) then way_x, way_y = back_x, back_y end
  local far = way_x * side.nx + way_y * side.ny
  return {nx = side.nx, ny = side.ny, gap = far - radius, bend = 0.0, on_end = false}, far >= 0
end

-- Whether the first end of a side is nearer to a point than the second one, or as near.
function M.is_first_nearer(side, x, y)
  local ax, ay, bx_, by_ = x - side.ax, y - side.ay, x - side.bx, y - side.by
  return ax * ax + ay * ay <= bx_ * bx_ + by_ * by_
end

function M.nearer_end(side, x, y)
  if M.is_first_nearer(side, x, y) then return side.ax, side.ay end
  return side.bx, side.by
end

local function goes_through(side, near) return side.is_thin and near.gap < -THROUGH end

-- Another side that goes on from the end that a circle touches, so that it does not touch the end alone.
local function hides(sides, index, x, y, radius)
  local end_x, end_y = M.nearer_end(sides[index], x, y)
  for i, beside in ipairs(sides) do
    if i ~= index and (beside.ax == end_x and beside.ay == end_y or beside.bx == end_x and beside.by == end_y) then
      local near, in_front = M.near_side(beside, x, y, radius)
      if not near.on_end and in_front and not goes_through(beside, near) then return beside end
    end
  end
end

-- ---- What a circle touches, and when it meets it ----

local function own_slack(form) return M.slack(form.x, form.y, form.w, form.h, form.x, form.y, form.w, form.h) end

-- px: holds all that may touch a box, in part.
function M.touch_area(x, y, w, h)
  local more = 2 * M.slack(x, y, w, h, x, y, w, h)
  return x - more, y - more, w + 2 * more, h + 2 * more
end
-- The same for its way between two places.
function M.area_around(a, c)
  local x, y = min(a.x, c.x), min(a.y, c.y)
  return M.touch_area(x, y, max(a.x + a.w, c.x + c.w) - x, max(a.y + a.h, c.y + c.h) - y)
end

-- The normal across a gap as wide as a circle, out of the end of a side, if the circle touches that end and one on the
-- other side of the gap. The two hold nothing that goes along the gap. A circle touches both a little before its middle
-- is between them, and their own normals would be those of a wedge.
local function across_gap(sides, side, form)
  local x, y = M.middle(form)
  local end_x, end_y = M.nearer_end(side, x, y)
  local slack = own_slack(form)
  for i, other in ipairs(sides) do
    local way_x, way_y = M.nearer_end(other, x, y)
    way_x, way_y = way_x - end_x, way_y - end_y
    local wide = sqrt(way_x * way_x + way_y * way_y)
    if wide >= 2 * form.radius - slack then
      local near, in_front = M.near_side(other, x, y, form.radius)
      if near.on_end and in_front and not (near.gap > slack) and not hides(sides, i, x, y, form.radius) then
        local share = 1 / wide
        return way_x * share, way_y * share
      end
    end
  end
end

-- The sides that a circle touches in an area, px: {side, near, is_in_gap}. Tiles side by side in it are one side.
-- is_in_gap: its end, in a gap as wide as the circle; its normal leads across the gap.
function M.sides_touched(world, form, x, y, w, h)
  local sides, touched = find_sides(world.terrain, x, y, w, h), {}
  local middle_x, middle_y = M.middle(form)
  local most = own_slack(form)
  for i, side in ipairs(sides) do
    local near, in_front = M.near_side(side, middle_x, middle_y, form.radius)
    if in_front and not (near.gap > most) and not goes_through(side, near) and
        not (near.on_end and hides(sides, i, middle_x, middle_y, form.radius)) then
      local nx, ny
      if near.on_end then nx, ny = across_gap(sides, side, form) end
      if nx then near.nx, near.ny = nx, ny end
      touched[#touched + 1] = {side = side, near = near, is_in_gap = nx ~= nil}
    end
  end
  return touched
end
function M.all_touched(world, form)
  return M.sides_touched(world, form, M.touch_area(form.x, form.y, form.w, form.h))
end

local function time_to(side, m, from, to)
  local way, start = M.moving_at(m, from), M.form_at(m, from)
  local middle_x, middle_y = M.middle(start)
  local function at(s)
    local half = s * s / 2
    return M.near_side(side, middle_x + (way.vx * s + way.px * half), middle_y + (way.vy * s + way.py * half), m.radius)
  end
  if goes_through(side, at(0.0)) then return nil end
  local t, near = M.first_touch({vx = way.vx, vy = way.vy, px = way.px, py = way.py, most = to - from,
                                 slack = own_slack(start), still = STILL, is_hollow = side.is_hollow}, at)
  if not t then return nil end
  local _, in_front = at(t)
  if in_front then return t, near end
end

local function is_among(sides, side)
  for _, o in ipairs(sides) do
    if o.ax == side.ax and o.ay == side.ay and o.bx == side.bx and o.by == side.by and o.facing == side.facing then
      return true
    end
  end
  return false
end

-- Whether a circle on a path comes nearer to a straight side that it touches.
local function comes_nearer(m, nx, ny)
  local speed = -(m.vx * nx + m.vy * ny)
  return speed > STILL or speed >= -STILL and -(m.px * nx + m.py * ny) > STILL
end

-- What a circle meets where its path leads to a side, and the normal; nil if it does not stop there. near: of the side
-- then, there: the circle then.
local function met_with(sides, i, near, there, along)
  local side = sides[i]
  if not near.on_end then return side, near.nx, near.ny end
  local form = M.form_at(there, there.time)
  local x, y = M.middle(form)
  local beside = hides(sides, i, x, y, form.radius)
  if beside then
    -- It met this end before the hollow that goes on from there was looked at.
    near = M.near_side(beside, x, y, form.radius)
    local meets = near.gap <= own_slack(form) and -(there.vx * near.nx + there.vy * near.ny) > STILL
    if is_among(along, beside) or not beside.is_hollow or not meets or near.gap < -THROUGH then return nil end
    return beside, near.nx, near.ny
  end
  local nx, ny = across_gap(sides, side, form)
  if not nx then return side, near.nx, near.ny end
  if comes_nearer(there, nx, ny) then return side, nx, ny end
end

-- What a circle meets of these sides between two times, before `first`.
local function meet_side(sides, i, m, along, from, to, first)
  if is_among(along, sides[i]) then return first end
  local t, near = time_to(sides[i], m, from, to)
  if not t or first and from + t >= first.time then return first end
  t = from + t
  local there = M.moving_at(m, t)
  local side, nx, ny = met_with(sides, i, near, there, along)
  if not side then return first end
  M.put_on(side, there)
  local place = M.form_at(there, t)
  return {time = t, nx = nx, ny = ny, x = place.x, y = place.y, side = side}
end

-- The first time on its path, before `to`, at which a circle meets the ground. along: sides that stop nothing, as it
-- goes along them.
function M.meeting_of_circle(world, m, to, along)
  local slice = 32  -- px, of a path: the sides near a long one would be many
  local start, way_x, way_y = m.time, M.way_to(m, to)
  local slices = ceil(max(max(1.0, abs(way_x) / slice), abs(way_y) / slice))
  for i = 0, slices - 1 do
    local from = start + (to - start) * (i / slices)
    local stop = i + 1 == slices and to or start + (to - start) * ((i + 1) / slices)
    local sides = find_sides(world.terrain, M.area_around(M.form_at(m, from), M.form_at(m, stop)))
    local first
    for k = 1, #sides do first = meet_side(sides, k, m, along, from, stop, first) end
    if first then return first end
  end
end

-- Puts a circle that touches a side exactly on it.
function M.put_on(side, m)
  local form, radius = M.form_at(m, m.time), m.radius
  local x, y = M.middle(form)
  local near = M.near_side(side, x, y, radius)
  if abs(near.gap) <= 2.0 ^ -50 * (abs(m.x) + abs(m.y) + radius) then return end
  if near.nx == 0 then
    local on_top = side.ay - m.h
    m.y = near.ny < 0 and on_top or on_top + 2 * radius
    if near.on_end or side.stretch then m.y = form.y - near.ny * near.gap end
  elseif near.ny == 0 and not near.on_end and not side.stretch then
    m.x = side.ax + near.nx * radius - m.w / 2
  else
    m.x, m.y = m.x - near.nx * near.gap, m.y - near.ny * near.gap
  end
end

-- The way out of the ground; nil if the circle is not inside.
local function circle_way_out(world, m)
  local form = M.form_at(m, 0.0)
  local there = M.form_at(m, 0.0)
  local small = form.radius / 64
  local x, y = M.middle(form)
  local out_x, out_y = way_out(world.terrain, x - small, y - small, 2 * small, 2 * small, false)
  if out_x then there.x, there.y = there.x + out_x, there.y + out_y end
  for _ = 1, 8 do
    local deepest
    for _, touch in ipairs(M.all_touched(world, there)) do
      if not deepest or touch.near.gap < deepest.gap then deepest = touch.near end
    end
    if not deepest or deepest.gap >= -own_slack(there) then break end
    there.x, there.y = there.x + deepest.nx * -deepest.gap, there.y + deepest.ny * -deepest.gap
  end
  local way_x, way_y = there.x - form.x, there.y - form.y
  if way_x ~= 0 or way_y ~= 0 then return way_x, way_y end
end

local box_way_out = M.way_out
function M.way_out(world, m)
  if m.radius > 0 then return circle_way_out(world, m) end
  return box_way_out(world, m)
end

end

World.begin_round_ground(World.meeting)
