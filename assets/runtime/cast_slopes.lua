-- ---- Slopes: casts against pieces of the outline ----

-- Whether the terrain has any piece.
function Terrain:has_pieces()
  if self.some_pieces == nil then
    self.some_pieces = false
    for cell in pairs(self.details) do
      local x = cell % self.width
      if #self:detail(x, floor((cell - x) / self.width)).pieces > 0 then
        self.some_pieces = true
        break
      end
    end
  end
  return self.some_pieces
end

function Line.time(up, piece)
  local x, x_low = two_add(bx, 0.0, foot_offset(piece, bw, centre), 0.0)
  x, x_low = two_add(x, x_low, -piece.base_x, -0.0)
  local slope, slope_low = two(piece.slope, piece.slope_rest)
  local high, low = two_multiply(x, x_low, slope, slope_low)
  high, low = two_add(high, low, piece.base_y, 0.0)
  high, low = two_add(high, low, up and -bh or -0.0, -0.0)
  high, low = two_add(high, low, -by, -0.0)
  local rise, rise_low = two_multiply(slope, slope_low, dx, 0.0)
  local closing, closing_low = two_add(dy, 0.0, -rise, -rise_low)
  return two_divide(high, low, closing, closing_low)
end

function Line.normal(piece, sign)
  local length = sqrt(1 + piece.slope * piece.slope)
  return sign * piece.slope / length, -sign / length
end

-- The place of a box at x on the piece.
function Line.place(piece, x, t, t_low)
  -- A box that falls straight down keeps its x. On a steep line, but for its ends, y gives the place.
  local by_y = dx ~= 0 and is_steep(piece)
  if by_y and best_t == 0 then
    x = moved_x(bx, bw, (by - rest_on(piece, x, bw, bh, centre)) / piece.slope)
  end
  x = clamp(x, best_first, best_last)
  if by_y and x ~= best_first and x ~= best_last then return x, rounded(along(by, t, t_low, dy)) end
  return x, rest_on(piece, x, bw, bh, centre)
end

function Line.meet(piece, up, first, last, first_y, last_y, open_first, open_last)
  local rise = piece.slope * dx
  local closing
  if up then closing = dy - rise else closing = rise - dy end
  -- A box that slides along the line does not approach it, even if rounding says so.
  if not (closing > ROUNDING * (abs(dy) + abs(rise))) then return end
  local from, to, gap, last_gap = window_of(first, last, first_y, last_y, open_first, open_last, up, piece)
  local forgiven = slack * max(1.0, abs(piece.slope))  -- across a steep line, not down to it
  if to < 1 and last_gap >= -forgiven then return end  -- at its very end the box meets what follows
  local t = straight_time(from, to, gap, last_gap, closing, forgiven, up, nil, piece)
  if t then offer(t, piece.facing, false, piece, 0.0, first, last) end
end

-- The end of a slope that the flat bottom of the box stands on: a crest, or the end of the floor.
local function piece_ends(up, piece, lift)
  if up and centre then
    if sunk > 0 then return end
    local half = bw / 2
    if piece.last0 then flat_in_reach(piece.x0 - bw, piece.x0 - half, piece.y0 - lift, true, piece.covered0, up,
        piece.y0, piece, piece.covered0) end
    if piece.last1 then flat_in_reach(piece.x1 - half, piece.x1, piece.y1 - lift, piece.covered1, true, up, piece.y1,
        piece, piece.covered1) end
    return
  end
  -- Beyond a crest the ground goes on. Unlike beside a ledge, nothing may slip through beside it.
  if (piece.y1 < piece.y0) == up then
    if piece.convex1 or piece.covered1 then
      flat_in_reach(piece.x1 - bw, piece.x1, piece.y1 - lift, piece.covered1, piece.last1, up, piece.y1, piece,
                    piece.covered1)
    end
  elseif piece.convex0 or piece.covered0 then
    flat_in_reach(piece.x0 - bw, piece.x0, piece.y0 - lift, piece.last0, piece.covered0, up, piece.y0, piece,
                  piece.covered0)
  end
end

local function against_piece(piece)
  if ignored then
    local source = piece.source or piece
    if source == ignored or source.is_ignored then return end
  end
  if piece.facing == LEFT then
    if dx > 0 then wall(LEFT, piece.x0, piece.y0, piece.y1, piece.convex0, piece.convex1, piece) end
    return
  elseif piece.facing == RIGHT then
    if dx < 0 then wall(RIGHT, piece.x0, piece.y0, piece.y1, piece.convex0, piece.convex1, piece) end
    return
  end
  local up = piece.facing == UP
  local centred = up and centre
  local lift = up and bh or 0.0
  local open0, open1 = piece.convex0 or piece.far0, piece.convex1 or piece.far1
  if piece.form.straight and piece.y0 == piece.y1 and not centred then
    local comes
    if up then comes = dy > 0 else comes = dy < 0 end
    if comes then flat(up, piece.y0, piece.x0, piece.x1, open0, open1, piece) end
    return
  end
  local offset = foot_offset(piece, bw, centre)
  local first, last, first_y, last_y = piece.x0 - offset, piece.x1 - offset, piece.y0 - lift, piece.y1 - lift
  if centred then open0, open1 = piece.far0, piece.far1 end
  piece.form.meet(piece, up, first, last, first_y, last_y, open0, open1, offset, lift)
  piece_ends(up, piece, lift)
end

function Terrain:against_pieces(y, first, last)
  local up = dy > 0
  local floor_side, other, side = up and UP or DOWN, up and DOWN or UP, dx > 0 and LEFT or RIGHT
  for x = first, last do
    if self:is_detailed(x, y) then
      local detail = self:detail(x, y)
      local faces = detail.faces
      if faces[floor_side] or (dx ~= 0 and (faces[other] or faces[side])) then
        for _, piece in ipairs(detail.pieces) do against_piece(piece) end
      end
    end
  end
end

-- Its corners may be in a slope, and behind the ends of walls and ceilings that the slope covers; its middle
-- may not.
local middle_alone = false
function Terrain:with_middle(contact, x, y, w, h, motion_x, motion_y, without)
  -- Straight down a box meets only floors, and what stops its middle stops the whole box as soon.
  if not self:has_pieces() or (dx == 0 and dy > 0) then return contact end
  local middle = x + w / 2
  middle_alone = true
  begin_cast(self, middle, y, 0.0, h, motion_x, motion_y, false, without)
  against_terrain()
  local hit = end_cast()
  middle_alone = false
  if hit and hit.t < (contact and contact.t or huge) then
    hit.x = moved_x(x, w, hit.x - middle)
    -- The middle is on the line of a level floor, where the flat bottom of a box would be on its end.
    hit.on_end = hit.on_end and hit.edge.y0 ~= hit.edge.y1
    return hit
  end
  return contact
end

-- ---- Bodies that move along slopes ----

function Line.is_level(piece, _, steepest)
  local slope = abs(piece.slope)
  if slope ~= steepest then return slope < steepest end
  return piece.slope * piece.slope_rest <= 0
end

-- A box that slid along a piece, and is not beyond its end, is on it exactly, without a rounding error.
function Line.settle(piece, box)
  if is_wall(piece) or is_steep(piece) then return end
  local x = box.x + foot_offset(piece, box.w, box.centre)
  if x < piece.x0 or x > piece.x1 then return end
  local y = rest_on(piece, box.x, box.w, box.h, box.centre)
  if abs(box.y - y) <= settled(box) then box.y = y end
end
