-- ---- Curves: stretches that only rise or only fall, and bend to one side ----
-- A stretch has kind; c1 to c5, which are an arc's centre and radius, a polynomial's middle and coefficients,
-- or a sine's zero crossing, middle, amplitude and wavelength; and bends_down: y grows to both sides, as a
-- hill's does.
has.curves = true

local Stretch = {straight = false}  -- their form
for name, value in pairs(Free) do
  if name ~= "straight" then Stretch[name] = value end
end

local TAU = 6.283185307179586476925286766559
local FINE = 8  -- iterations end when the gap is this share of the slack
local STRAIGHT_END = 0.25  -- px; the length of the straight end of a curve

-- Taylor series, since sine and cosine of the C library differ between machines.
local SINES = {1 / (16 * 17.), 1 / (14 * 15.), 1 / (12 * 13.), 1 / (10 * 11.), 1 / (8 * 9.), 1 / (6 * 7.),
               1 / (4 * 5.), 1 / (2 * 3.)}
local COSINES = {1 / (15 * 16.), 1 / (13 * 14.), 1 / (11 * 12.), 1 / (9 * 10.), 1 / (7 * 8.), 1 / (5 * 6.),
                 1 / (3 * 4.), 1 / (1 * 2.)}
local function series(z, terms)
  local q, sum = z * z, 0.0
  for _, share in ipairs(terms) do sum = (1 - sum) * q * share end
  return 1 - sum
end

-- sin(2 pi turns), for |turns| <= 1/4.
local function sine_of_turns(turns)
  local size = abs(turns)
  local value
  if size <= 0.125 then
    local z = TAU * size
    value = z * series(z, SINES)
  else
    value = series(TAU * (0.25 - size), COSINES)
  end
  if turns < 0 or 1 / turns < 0 then return -value end
  return value
end
local function cosine_of_turns(turns) return sine_of_turns(0.25 - abs(turns)) end

local function curve_y(s, x)
  local u = x - s.c1
  if s.kind == "arc" then
    local under = (s.c3 - u) * (s.c3 + u)
    return s.c2 + s.sign * sqrt(under > 0 and under or 0.0)
  end
  if s.kind == "polynomial" then return (s.c2 + u * u * s.c4) + u * (s.c3 + u * u * s.c5) end
  return s.c2 + s.c3 * sine_of_turns(u / s.c4)
end

-- Unit tangent, from left to right.
local function tangent_at(s, x)
  local u = x - s.c1
  if s.kind == "arc" then
    local under = (s.c3 - u) * (s.c3 + u)
    return sqrt(under > 0 and under or 0.0) / s.c3, -s.sign * u / s.c3
  end
  local slope
  if s.kind == "sine" then
    slope = s.c3 * (TAU / s.c4) * cosine_of_turns(u / s.c4)
  else
    slope = s.c3 + u * (2 * s.c4) + u * u * (3 * s.c5)
  end
  local length = sqrt(1 + slope * slope)
  return 1 / length, slope / length
end

function Stretch.y(piece, x) return curve_y(piece.stretch, x) end
function Stretch.normal(piece, sign, t)
  local x = clamp(bx + t * dx + foot_offset(piece, bw, centre), piece.x0, piece.x1)
  local along_x, along_y = tangent_at(piece.stretch, x)
  return sign * along_y, -sign * along_x
end
function Stretch.normal_at(piece, x)
  local along_x, along_y = tangent_at(piece.stretch, x)
  if piece.facing == UP then return along_y, -along_x end
  return -along_y, along_x
end
-- The straight end of a curve may be so much steeper.
local function steepest_on_curve(steepest) return steepest + (1 + steepest) * (1 + steepest) / 128 end
function Stretch.is_level(_, contact, steepest)
  return abs(contact.nx) <= steepest_on_curve(steepest) * abs(contact.ny)
end
-- Whether a box only touches a hill, at its top, which is in its way by rounding alone.
function Stretch.falls_away(contact, x, y, slack)
  return contact.facing == UP and contact.edge.stretch.bends_down and -(contact.nx * x + contact.ny * y) <= slack
end
function Stretch.time() return best_t, 0.0 end  -- as exact as it gets

-- If a stretch bends towards the box, a box that slides along it meets it again at once. Turns a motion along
-- its tangent into the chord to its end on the stretch. Returns the chord, that end, and the motion from there.
local function follow(piece, box, x, y)
  local offset = foot_offset(piece, box.w, box.centre)
  local there = clamp(moved_x(box.x, box.w, x), min(box.x, piece.x0 - offset), max(box.x, piece.x1 - offset))
  local rest = rest_on(piece, there, box.w, box.h, box.centre)
  local chord_x, chord_y = there - box.x, rest - box.y
  local used = x == 0 and 1.0 or min(1.0, chord_x / x)
  local along_x, along_y = tangent_at(piece.stretch, there + offset)
  local length = sqrt(x * x + y * y) * (1 - used)
  local signed = (x < 0 and -1 or 1) * length
  if not (used > 0) then return along_x * signed, along_y * signed end
  if used < 1 then return chord_x, chord_y, there, rest, along_x * signed, along_y * signed, 1 / used end
  return chord_x, chord_y, there, rest, 0.0, 0.0, 1.0
end

-- ---- Cutting ----

do

local function put_stretch(cut, stretch, ax, ay, bx, by)
  local before = #cut.pieces
  put_piece(cut, {x0 = ax, y0 = ay, x1 = bx, y1 = by, form = Stretch, stretch = stretch})
  for i = before + 1, #cut.pieces do
    local piece = cut.pieces[i]
    if stretch.bends_down ~= (piece.facing == UP) then piece.follow = follow end
  end
end

-- A straight end is a stretch, so that steepest_on_curve() holds for it.
local function put_end(cut, ax, ay, bx, by)
  local stretch = {kind = "polynomial", c1 = (ax + bx) * 0.5, c2 = (ay + by) * 0.5, c3 = (by - ay) / (bx - ax),
                   c4 = 0.0, c5 = 0.0, bends_down = false}
  put_stretch(cut, stretch, ax, ay, bx, by)
end

local function width_of_end(part, x)
  local along_x = tangent_at(part.stretch, x)
  return max(weld(STRAIGHT_END * along_x), 1 / WELD)
end

-- The point at x of a curve of these parts.
local function point_at(parts, x)
  for _, part in ipairs(parts) do
    if x <= part.bx then return x, curve_y(part.stretch, x) end
  end
end

-- Puts the parts of a whole curve between its welded ends, with straight ends where they are off the curve.
local function put_parts(cut, parts, ax, ay, bx, by)
  local outer, other = parts[1], parts[#parts]
  local half = (bx - ax) / 2
  local from_x, from_y, to_x, to_y = ax, ay, bx, by
  if outer.ax ~= ax or outer.ay ~= ay then
    from_x, from_y = point_at(parts, ax + min(width_of_end(outer, outer.ax), half))
  end
  if other.bx ~= bx or other.by ~= by then
    to_x, to_y = point_at(parts, bx - min(width_of_end(other, other.bx), half))
  end
  if from_x > ax then put_end(cut, ax, ay, from_x, from_y) end
  for _, part in ipairs(parts) do
    local x0, y0, x1, y1 = part.ax, part.ay, part.bx, part.by
    if from_x > x0 then x0, y0 = from_x, from_y end
    if to_x < x1 then x1, y1 = to_x, to_y end
    if x0 < x1 then put_stretch(cut, part.stretch, x0, y0, x1, y1) end
  end
  if to_x < bx then put_end(cut, to_x, to_y, bx, by) end
end

-- The parts of a stretch between its cuts: each is a stretch from ax, ay to bx, by.
local function cut_stretch(stretch, ax, ay, bx, by, cuts)
  local inside, parts = {}, {}
  for _, x in ipairs(cuts) do
    if x > ax and x < bx then inside[#inside + 1] = x end
  end
  table.sort(inside)
  local x, y = ax, ay
  for i = 1, #inside + 1 do
    local to_x, to_y = bx, by
    if inside[i] then to_x, to_y = inside[i], curve_y(stretch, inside[i]) end
    if to_x > x then
      local copy = {}
      for key, value in pairs(stretch) do copy[key] = value end
      if stretch.kind == "polynomial" then
        local u = (x + to_x) / 2 - stretch.c1
        copy.bends_down = stretch.c4 + 3 * stretch.c5 * u > 0
      end
      parts[#parts + 1] = {stretch = copy, ax = x, ay = y, bx = to_x, by = to_y}
    end
    x, y = to_x, to_y
  end
  return parts
end

-- The polynomial is written about the middle, so that a mirrored curve has the same coefficients but for signs.
local function put_polynomial(cut, ax, ay, bx, by, c0, c1, c2, c3)
  local middle = (ax + bx) / 2
  local cuts = {}
  if c3 ~= 0 then cuts[#cuts + 1] = middle - c2 / (3 * c3) end
  local root = c2 * c2 - 3 * c3 * c1
  if root >= 0 then
    local part = sqrt(root)
    if c2 < 0 or 1 / c2 < 0 then part = -part end
    local q = -(c2 + part)
    if c3 ~= 0 then cuts[#cuts + 1] = middle + q / (3 * c3) end
    if q ~= 0 then cuts[#cuts + 1] = middle + c1 / q end
  end
  local s = {kind = "polynomial", c1 = middle, c2 = c0, c3 = c1, c4 = c2, c5 = c3}
  put_parts(cut, cut_stretch(s, ax, ay, bx, by, cuts), ax, ay, bx, by)
end

function cutter.arc(cut, a)
  local s = {kind = "arc", sign = a.upper and -1.0 or 1.0, c1 = a.x + 0.0, c2 = a.y + 0.0, c3 = a.radius + 0.0,
             bends_down = a.upper == true}
  local x0, x1 = max(weld(a.x0), s.c1 - s.c3), min(weld(a.x1), s.c1 + s.c3)
  local parts = cut_stretch(s, x0, curve_y(s, x0), x1, curve_y(s, x1), {s.c1})
  put_parts(cut, parts, weld(a.x0), weld(curve_y(s, a.x0)), weld(a.x1), weld(curve_y(s, a.x1)))
end

function cutter.parabola(cut, p)
  local ax, ay, bx, by, control = weld(p.x0), weld(p.y0), weld(p.x1), weld(p.y1), weld(p.control_y)
  local half = (bx - ax) / 2
  put_polynomial(cut, ax, ay, bx, by, ((ay + by) / 2 + control) / 2, (by - ay) / (bx - ax),
                 ((ay + by) / 2 - control) / 2 / (half * half), 0.0)
end

function cutter.cubic(cut, p)
  local ax, ay, bx, by = weld(p.x0), weld(p.y0), weld(p.x1), weld(p.y1)
  local half = (bx - ax) / 2
  local rise = (by - ay) / 2 / half
  local c2 = (p.slope1 - p.slope0) / (4 * half)
  local c3 = ((p.slope0 + p.slope1) / 2 - rise) / (2 * half * half)
  put_polynomial(cut, ax, ay, bx, by, (ay + by) / 2 - c2 * half * half, rise - c3 * half * half, c2, c3)
end

-- The stretch of a sine from `number` to `number` + 1 quarters of a wave right of its origin.
local function quarter_of(w, number)
  local crossing = number % 2 == 0 and number or number + 1
  local amplitude = crossing % 4 ~= 0 and -w.amplitude or w.amplitude  -- the half wave is upside down
  local s = {kind = "sine", c1 = w.origin + crossing * (w.wavelength / 4), c2 = w.middle + 0.0,
             c3 = amplitude + 0.0, c4 = w.wavelength + 0.0}
  s.bends_down = (crossing == number and 1 or -1) * s.c3 < 0
  return s
end

function cutter.sine(cut, w)
  local first, last, quarter = weld(w.x0), weld(w.x1), w.wavelength / 4
  local function number_at(x) return floor((x - w.origin) / quarter) end
  local function height_at(x) return curve_y(quarter_of(w, number_at(x)), x) end
  local parts, x, k = {}, first, number_at(first)
  while x < last do
    local to = min(last, w.origin + (k + 1) * quarter)
    if to > x then
      local s = quarter_of(w, k)
      parts[#parts + 1] = {stretch = s, ax = x, ay = curve_y(s, x), bx = to, by = curve_y(s, to)}
      x = to
    end
    k = k + 1
  end
  put_parts(cut, parts, first, weld(height_at(w.x0)), last, weld(height_at(w.x1)))
end

end

-- ---- When a box meets a stretch ----

local function circle_time(x, y, dx, dy, radius, from_outside)
  local a, b = dx * dx + dy * dy, x * dx + y * dy
  local c = (x - radius) * (x + radius) + y * y
  local under = b * b - a * c
  local root = sqrt(under < 0 and 0.0 or under)
  -- A root can be written in two ways. This is the one that does not subtract nearly equal numbers.
  if from_outside then
    if b < 0 then return c / (root - b) end
    return (-b - root) / a
  end
  if b < 0 then return (root - b) / a end
  return -c / (root + b)
end

local function parabola_time(gap, rate, bend)
  local under = rate * rate - 4 * bend * gap
  local root = sqrt(under < 0 and 0.0 or under)
  if rate <= 0 then return 2 * gap / (root - rate) end
  return (-rate - root) / (2 * bend)
end

-- The place where f falls through zero. Newton's method; a step that would leave the bracket halves it instead.
local function newton_between(a, b, f, derivative, rounding)
  local t = b
  for _ = 1, TRIES do
    local ft = f(t)
    if ft >= 0 then a = t else b = t end
    local next_t = t - ft / derivative(t)
    if not (next_t >= a and next_t <= b) then next_t = a + (b - a) / 2 end
    if abs(ft) <= rounding or next_t == t then return next_t end
    t = next_t
  end
  return t
end

-- from, to: the part of the motion during which the box is over or under the stretch; gap, last_gap: its
-- distance at both. x, y: of the box; offset, lift: to its point that meets the curve. Returns nil if it does
-- not meet the curve.
local function curve_time(piece, x, y, dx, dy, offset, lift, slack, from, to, gap, last_gap)
  if from > to or gap < -slack then return nil end
  local stretch, up = piece.stretch, piece.facing == UP
  local sign = up and 1 or -1
  local dips = stretch.bends_down == up  -- the gap may close and open again
  local function corner_x(t) return clamp(x + t * dx + offset, piece.x0, piece.x1) end
  local function gap_at(t) return sign * (y_at(piece, corner_x(t)) - lift - (y + t * dy)) end
  -- The rate at which the gap grows, times a positive factor.
  local function opening(t)
    local along_x, along_y = tangent_at(stretch, corner_x(t))
    return sign * (along_y * dx - along_x * dy)
  end

  local last = to
  if gap <= slack then
    local rate, wrong = opening(from), ROUNDING * (abs(dx) + abs(dy))
    if rate < -wrong or (rate <= wrong and not dips) then return from end
    if dips then return nil end
  end
  if not (last_gap < 0) then
    if not dips or not (opening(from) < 0) or not (opening(to) > 0) then return nil end
    last = zero_between(from, to, function(t) return -opening(t) end)
    if not (gap_at(last) < 0) then return nil end
  end

  local u = x + from * dx + offset - stretch.c1
  local t
  if stretch.kind == "arc" then
    local v = y + from * dy + lift - stretch.c2
    t = circle_time(u, v, dx, dy, stretch.c3, up == (stretch.sign < 0))
  elseif stretch.kind == "polynomial" and stretch.c5 == 0 then
    t = parabola_time(gap, sign * ((stretch.c3 + 2 * stretch.c4 * u) * dx - dy), sign * stretch.c4 * dx * dx)
  else
    local function rate(at)
      local along_x, along_y = tangent_at(stretch, corner_x(at))
      return sign * (along_y / along_x * dx - dy)
    end
    t = newton_between(from, last, gap_at, rate, slack / FINE) - from
  end
  return clamp(from + t, from, last)
end

function Stretch.meet(piece, up, first, last, first_y, last_y, open_first, open_last, offset, lift)
  if middle_alone then return end
  local from, to, gap, last_gap = window_of(first, last, first_y, last_y, open_first, open_last, up, piece)
  local t = curve_time(piece, bx, by, dx, dy, offset, lift, slack, from, to, gap, last_gap)
  if t then offer(t, piece.facing, false, piece, 0.0, first, last) end
end
