-- ---- Cast: when does a moving box first meet the ground? ----
-- The box is swept against the outline grown by the box, so that its corner is a point on a straight way.

local COLUMNS = 62  -- cells looked at together; which of two equal contacts counts depends on it
local SLOW = 16  -- a gap that closes more slowly than this share of the motion needs twice the precision

-- The current cast: the terrain, the box, its motion, whether only its centre stands on floors, 1 / dx, the
-- pixels in the motion, the slack of rounding; a piece that stops nothing; and the height of the part of its
-- corners that meets no ground.
local ground, bx, by, bw, bh, dx, dy, centre, inverse, speed, slack, ignored, sunk
-- The tile, or the body, that is tested.
local column, row, other
-- The first contact so far: see offer().
local best_t, best_facing, best_flat_end, best_mirrored
local best_piece, best_at, best_first, best_last
local best_column, best_row, best_other

-- A box's x moved by dx, and rounded so that both its sides are exact.
local function moved_x(x, w, by_x)
  if by_x == 0 then return x end
  local middle = x + w / 2 + by_x
  local left, right = middle - w / 2, middle + w / 2
  return abs(right) > abs(left) and right - w or left
end

local function rounding_slack(x, y, w, h, motion_x, motion_y)
  local half_w, half_h = w / 2, h / 2
  return ((abs(x + half_w) + half_w) + (abs(y + half_h) + half_h) + max(abs(motion_x) + abs(motion_y),
      SHORT)) *
             ROUNDING
end

local function normal_of(t, facing, flat_end, piece)
  if facing == LEFT then return -1.0, 0.0 end
  if facing == RIGHT then return 1.0, 0.0 end
  local sign = facing == UP and 1.0 or -1.0
  if flat_end or piece == nil then return 0.0, -sign end
  return piece.form.normal(piece, sign, t)
end

-- Whether the box only just comes to the end of a floor or ceiling. A wall that it meets at the same time keeps it
-- from getting over it, or under it. A corner of a box on its centre may be behind that wall.
local function is_at_border(t, facing, first, last)
  if facing >= LEFT or dx == 0 or bw == 0 or centre then return false end
  local x = bx + t * dx
  if dx > 0 then return x <= first + slack end
  return x >= last - slack
end

-- Whether a time is after that of the first contact, and not by rounding alone.
local function is_later(t) return (t - best_t) * speed > SLOW * slack end

-- Between contacts at about the same time, of which rounding alone would choose, the most opposing one counts, then
-- the one more level; two mirror images count as one that faces straight up or down. flat_end: a flat side of the box
-- met the end of a piece; at: a wall's x, a flat one's y; first, last: where the box may be.
local function offer(t, facing, flat_end, piece, at, first, last)
  -- Where no part of the corners meets ground, floors alone stop the box, on its centre.
  if is_later(t) or sunk > 0 and sunk >= bh and facing ~= UP then return end
  if (best_t - t) * speed <= SLOW * slack then
    local x, y = normal_of(t, facing, flat_end, piece)
    local best_x, best_y = normal_of(best_t, best_facing, best_flat_end, best_piece)
    local a, b, begin = x * dx + y * dy, best_x * dx + best_y * dy, min(t, best_t)
    local level, best_level = flat_end or piece == nil, best_flat_end or best_piece == nil
    if level and best_level and facing == best_facing or max((begin - t) * a, (begin - best_t) * b) > slack / 2 then
      if t >= best_t then return end
    else
      local is_wall, is_corner, is_first = facing >= LEFT, false, a < b or (a == b and abs(y) > abs(best_y))
      if is_wall then
        is_corner = is_at_border(best_t, best_facing, best_first, best_last)
      elseif best_facing >= LEFT then
        is_corner = is_at_border(t, facing, first, last)
      end
      if is_corner then is_first = is_wall end
      t = begin
      if not is_first then
        if a == b and x == -best_x and x ~= 0 and facing == best_facing then best_mirrored = true end
        best_t = begin
        return
      end
    end
  end
  best_t, best_facing, best_flat_end, best_mirrored, best_piece = t, facing, flat_end, false, piece
  best_at, best_first, best_last = at, first, last
  best_column, best_row, best_other = column, row, other
end

-- Whether the box approaches so slowly that a rounding of the gap is worth many roundings of its way.
local function is_slow(closing) return SLOW * closing < speed end

-- The same times to twice the precision.
local function wall_time(facing, at)
  local high, low = two_add(at, 0.0, facing == LEFT and -bw or -0.0, -0.0)
  high, low = two_add(high, low, -bx, -0.0)
  return two_divide(high, low, dx, 0.0)
end
local function level_time(up, at)
  local high, low = two_add(at, 0.0, up and -bh or -0.0, -0.0)
  high, low = two_add(high, low, -by, -0.0)
  return two_divide(high, low, dy, 0.0)
end

local function limit_of(facing, at)
  if facing == LEFT then return at - bw end
  return facing == UP and at - bh or at
end

-- The part of the motion during which the box's x is between first and last: from, to (from > to: never), and
-- the gap at both. open: the outline ends there. piece: the one that the box rests on; nil: it rests at
-- first_y.
local function window_of(first, last, first_y, last_y, open_first, open_last, up, piece)
  local sign = up and 1 or -1
  if dx == 0 then
    local in_first, in_last
    if open_first then in_first = bx > first + slack else in_first = bx >= first - slack end
    if open_last then in_last = bx < last - slack else in_last = bx <= last + slack end
    if not in_first or not in_last then return 1, 0, 0, 0 end
    local rest = piece and piece.form.rest(piece, bx, bw, bh, centre) or first_y
    return 0.0, 1.0, sign * (rest - (by + 0.0 * dy)), sign * (rest - (by + 1.0 * dy))
  end
  local right = dx > 0
  local enter, leave, open_leave
  if right then
    enter, leave, open_leave = first, last, open_last
  else
    enter, leave, open_leave = last, first, open_first
  end
  local to_leave = (leave - bx) * inverse
  -- At the end of a piece, on the way out: where the outline goes on, the next piece has the contact.
  if to_leave * speed <= slack and (open_leave or to_leave <= 1) then return 1, 0, 0, 0 end
  local from, to, gap, last_gap = 0.0, 1.0, nil, nil
  local before
  if right then before = bx < enter else before = bx > enter end
  if before then
    from = (enter - bx) * inverse
    if from > 1 then return 1, 0, 0, 0 end
    gap = sign * ((right and first_y or last_y) - (by + from * dy))
    -- A box that comes along a steep line may be off it by a rounding of its x, here as on that line. Hardly any
    -- line is steeper than 16384 px down for each px to the right.
    if gap < 0 and gap >= -slack * min(abs(dy * inverse), 16384.0) then gap = 0.0 end
  else
    local rest = piece and piece.form.rest(piece, bx, bw, bh, centre) or first_y
    gap = sign * (rest - (by + 0.0 * dy))
  end
  if to_leave < 1 then
    to = to_leave
    last_gap = sign * ((right and last_y or first_y) - (by + to * dy))
  else
    local rest = piece and piece.form.rest(piece, bx + dx, bw, bh, centre) or first_y
    last_gap = sign * (rest - (by + 1.0 * dy))
  end
  return from, to, gap, last_gap
end

-- The time at which the gap to a line, or without a piece to a level side at y, closes at a constant rate; nil
-- if it does not.
local function straight_time(from, to, gap, last_gap, closing, forgiven, up, y, piece)
  if from > to or gap < -forgiven then return nil end
  if gap <= 0 then return from end
  if last_gap >= 0 and not (to == 1 and last_gap == 0) then return nil end
  local t
  if is_slow(closing) then
    local high, low
    if piece then high, low = piece.form.time(up, piece) else high, low = level_time(up, y) end
    t = high + low
  else
    t = from + gap / closing
  end
  return clamp(t, from, to)
end

-- covered: a box that comes along the line that covers the end touches the end by rounding alone.
local function flat_in_reach(first, last, rest, open_first, open_last, up, y, piece, covered)
  local closing = up and dy or -dy
  if not (closing > 0) then return end
  local from, to, gap, last_gap = window_of(first, last, rest, rest, open_first, open_last, up, nil)
  if covered and last_gap >= -slack then return end
  local t = straight_time(from, to, gap, last_gap, closing, slack, up, y, nil)
  if t then offer(t, up and UP or DOWN, piece ~= nil, piece, y, first, last) end
end

local function flat(up, y, x0, x1, open0, open1, piece)
  local limit, first = limit_of(up and UP or DOWN, y), x0 - bw
  -- Most pieces are out of reach, or are met well between their ends.
  local gap, closing
  if up then gap, closing = limit - by, dy else gap, closing = by - limit, -dy end
  if gap > closing or gap < -slack then return end
  local t = 0.0
  if gap > 0 then
    if is_slow(closing) then
      local high, low = level_time(up, y)
      t = max(high + low, 0.0)
    else
      t = gap / closing
    end
  end
  local x = bx + t * dx
  if min(bx, x) > first + slack and max(bx, x) < x1 - slack then
    offer(t, up and UP or DOWN, piece ~= nil, piece, y, first, x1)
  else
    flat_in_reach(first, x1, limit, open0, open1, up, y, piece)
  end
end

local function wall(facing, at, y0, y1, open0, open1, piece)
  local limit = limit_of(facing, at)
  local gap
  if facing == LEFT then gap = limit - bx else gap = bx - limit end
  if gap < -slack then return end
  local t = 0.0
  if gap > 0 then
    if is_slow(abs(dx)) then
      local high, low = wall_time(facing, at)
      t = max(high + low, 0.0)
    else
      t = gap * abs(inverse)
    end
  end
  if t > 1 or is_later(t) then return end
  local y = by + t * dy
  -- Rounded as the gaps to the floor and the ceiling at its ends, so that the box meets one of the two. A corner of a
  -- box on its centre, in the floor, does not touch what is below it.
  if y0 - (bh - sunk) - y < ((open0 or centre) and -slack or slack) and y - y1 < (open1 and -slack or slack) then
    offer(t, facing, false, piece, at, 0.0, 0.0)
  end
end

-- ---- Which cells ----

-- Full tiles side by side with an open top, or an open bottom, are tested as one.
local function row_of_tiles(up, y, first, last, left, right)
  local x = first
  while x <= last do
    local x1 = x
    while x1 <= last and ground:is_open(x1, y, 0, up and -1 or 1) do x1 = x1 + 1 end
    if x1 > x then
      local from, to = x * TILE_W, x1 * TILE_W
      if centre and up then
        -- Beside a detailed cell only the centre counts; over a ledge the whole bottom does.
        if sunk > 0 or ground:is_solid(x - 1, y) and ground:is_detailed(x - 1, y) then from = from + bw / 2 end
        if sunk > 0 or ground:is_solid(x1, y) and ground:is_detailed(x1, y) then to = to - bw / 2 end
      end
      column, row = x, y
      flat(up, (up and y or y + 1) * TILE_H, from, to, not ground:is_solid(x - 1, y), not ground:is_solid(x1,
          y), nil)
    end
    x = x1 + 1
  end
end

-- Whether a full tile without details has no full tile beside it on that side.
function Terrain:is_open(x, y, beside_x, beside_y)
  if not self:is_solid(x, y) or self:is_solid(x + beside_x, y + beside_y) then return false end
  return not self:is_detailed(x, y)
end

-- Meets the pieces of detailed cells in a row.
function Terrain:against_pieces() end

local function cells_of_row(y, first, last)
  ground:against_pieces(y, first, last)
  if dy ~= 0 then row_of_tiles(dy > 0, y, first, last) end
  if dx ~= 0 then
    local side, step = LEFT, -1
    if dx < 0 then side, step = RIGHT, 1 end
    for x = first, last do
      if ground:is_open(x, y, step, 0) then
        column, row = x, y
        wall(side, (x + (side == LEFT and 0 or 1)) * TILE_W, y * TILE_H, (y + 1) * TILE_H, not ground:is_solid(x,
            y - 1),
             not ground:is_solid(x, y + 1), nil)
      end
    end
  end
end

-- side: px, of each.
local function cells_between(first, last, side, count)
  return floor(max(first, 0.0) / side), min(floor(max(last, 0.0) / side), count - 1)
end

-- A box meets the ground only with its leading sides, or with the centre of its bottom.
local function slice(from, to)
  local x0, x1, y0, y1 = bx + from * dx, bx + to * dx, by + from * dy, by + to * dy
  local left, right, top, bottom = min(x0, x1) - slack, max(x0, x1) + slack, min(y0, y1) - slack, max(y0,
      y1) + slack
  local lead_x, lead_y = dx > 0 and bw or 0.0, dy < 0 and 0.0 or bh
  local first_column, last_column = cells_between(left, right + bw, TILE_W, ground.width)
  local lead_top, lead_bottom = cells_between(top + lead_y, bottom + lead_y, TILE_H, ground.height)
  local first_row, last_row, lead_left, lead_right = lead_top, lead_bottom, first_column, last_column
  if dx ~= 0 then
    first_row, last_row = cells_between(top, bottom + bh, TILE_H, ground.height)
    if not centre then
      lead_left, lead_right = cells_between(left + lead_x, right + lead_x, TILE_W, ground.width)
    end
  end
  for first = first_column, last_column, COLUMNS do
    local last = min(first + (COLUMNS - 1), last_column)
    for y = first_row, last_row do
      if y >= lead_top and y <= lead_bottom then
        cells_of_row(y, first, last)
      else
        cells_of_row(y, max(first, lead_left), min(last, lead_right))
      end
    end
  end
end

-- px; longer motions are cut, so that only cells near the way are looked at.
local function slice_length() return SLICE_TILES * min(TILE_W, TILE_H) end

-- Shortens from..to to the time during which one axis of the box is on the map.
local function clip_to_map(at, size, motion, most, from, to)
  if motion == 0 then
    if at > most or at + size < 0 then return from, -1 end
    return from, to
  end
  local a, b = (0 - (at + size)) / motion, (most - at) / motion
  local margin = slice_length() / abs(motion)
  return max(from, min(a, b) - margin), min(to, max(a, b) + margin)
end

local function against_terrain()
  local length = max(abs(dx), abs(dy))
  if length <= slice_length() then return slice(0.0, 1.0) end
  local from, to = clip_to_map(bx, bw, dx, ground.width * TILE_W, 0.0, 1.0)
  from, to = clip_to_map(by, bh, dy, ground.height * TILE_H, from, to)
  if from > to then return end
  local slices = ceil((to - from) * length / slice_length()) + 1
  for i = 0, slices - 1 do
    local stop = from + (to - from) * ((i + 1) / slices)
    slice(from + (to - from) * (i / slices), stop)
    if best_t <= stop then return end
  end
end

-- ---- The contact ----

-- The time at which the box meets what it hit, to twice the precision if a rounding decides.
local function time_of_best()
  -- The x of a box that goes straight up or down does not depend on the time.
  if best_t == 0 or dx == 0 then return best_t, 0.0 end
  local high, low
  if best_facing >= LEFT then
    high, low = wall_time(best_facing, best_at)
  elseif best_flat_end or best_piece == nil then
    high, low = level_time(best_facing == UP, best_at)
  else
    high, low = best_piece.form.time(best_facing == UP, best_piece)
  end
  if abs((high + low) - best_t) * speed <= slack then return high, low end
  return best_t, 0.0
end

-- A coordinate after a time.
local function along(at, t, t_low, motion)
  local high, low = two_multiply(t, t_low, motion, 0.0)
  high, low = two_add(at, 0.0, high, low)
  return high, low
end
local function rounded(high, low) return high + low end

-- The same as moved_x, rounded once.
local function exact_x(t, t_low)
  local left, left_low = along(bx, t, t_low, dx)
  local right, right_low = two_add(left, left_low, bw, 0.0)
  if abs(right + right_low) > abs(left + left_low) then return (right + right_low) - bw end
  return left + left_low
end

-- The place of the box at that time: on what it hit.
local function position_of_best()
  local t, t_low = time_of_best()
  if best_facing >= LEFT then return limit_of(best_facing, best_at), rounded(along(by, t, t_low, dy)) end
  local x = best_t == 0 and bx or exact_x(t, t_low)
  if best_piece and not best_flat_end then return best_piece.form.place(best_piece, x, t, t_low) end
  return clamp(x, best_first, best_last), limit_of(best_facing, best_at)
end

local function begin_cast(terrain, x, y, w, h, motion_x, motion_y, is_centre, without)
  ground, bx, by, bw, bh, centre, ignored = terrain, x, y, w, h, is_centre, without
  dx, dy = moved_x(x, w, motion_x) ~= x and motion_x or 0.0, motion_y
  inverse = dx == 0 and 0.0 or 1 / dx
  speed = abs(dx) + abs(dy)
  slack = rounding_slack(x, y, w, h, motion_x, motion_y)
  best_t, best_facing, best_flat_end, best_mirrored = huge, UP, false, false
  best_piece, best_at, best_first, best_last = nil, 0.0, 0.0, 0.0
  sunk, other = 0.0, nil
end

local function end_cast()
  if not (best_t <= 1) then return nil end
  local contact = {t = best_t, facing = best_facing, edge = best_piece, on_end = best_flat_end,
                   column = best_column, row = best_row, other = best_other}
  contact.x, contact.y = position_of_best()
  if best_mirrored then
    contact.nx, contact.ny = 0.0, best_facing == UP and -1.0 or 1.0
  else
    contact.nx, contact.ny = normal_of(best_t, best_facing, best_flat_end, best_piece)
  end
  return contact
end

-- The first contact of a box that stands on its centre, given that of the whole box.
function Terrain:with_middle(contact) return contact end

-- The first contact of a box at x, y that moves by motion_x, motion_y; nil if there is none. A contact has t,
-- the share of the motion; x, y, of the box at that time; nx, ny, the ground's normal; facing; and edge, the piece
-- that it met, unless that is a plain tile, whose column and row it has then, or another body. others: the result of
-- World:others(). without: a piece that stops nothing this time. sunk_by: px, the height of the part of the
-- corners of a box on its centre that meets no ground; may be nil.
local function cast_box(terrain, x, y, w, h, motion_x, motion_y, is_centre, others, without, sunk_by)
  begin_cast(terrain, x, y, w, h, motion_x, motion_y, is_centre, without)
  if others then World.against_others(others) end
  sunk, other = sunk_by or 0.0, nil
  against_terrain()
  local contact = end_cast()
  if not is_centre then return contact end
  return terrain:with_middle(contact, x, y, w, h, motion_x, motion_y, without)
end
