-- ---- Casts against pieces of the outline ----

-- Whether there is any piece at all.
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

function line_time(up, piece)
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

local function sloped(first, last, first_y, last_y, open_first, open_last, up, piece)
  local rise = piece.slope * dx
  local closing
  if up then closing = dy - rise else closing = rise - dy end
  -- A box that slides along the line does not approach it, whatever rounding says.
  if not (closing > ROUNDING * (abs(dy) + abs(rise))) then return end
  local from, to, gap, last_gap = window_of(first, last, first_y, last_y, open_first, open_last, up, piece)
  local forgiven = slack * max(1.0, abs(piece.slope))  -- across a steep line, not down to it
  local t = straight_time(from, to, gap, last_gap, closing, forgiven, up, nil, piece)
  if t then offer(t, piece.facing, false, piece, 0.0, first, last) end
end

-- The end of a slope that the box stands on with its flat bottom: a crest, or where the floor ends.
local function piece_ends(up, piece, lift)
  if up and centre then
    local half = bw / 2
    if piece.last0 then flat_in_reach(piece.x0 - bw, piece.x0 - half, piece.y0 - lift, true, false, up,
        piece.y0, piece) end
    if piece.last1 then flat_in_reach(piece.x1 - half, piece.x1, piece.y1 - lift, false, true, up, piece.y1,
        piece) end
    return
  end
  -- Beyond a crest the ground goes on, and beside it, unlike beside a ledge, nothing may slip through.
  if (piece.y1 < piece.y0) == up then
    if piece.convex1 then
      flat_in_reach(piece.x1 - bw, piece.x1, piece.y1 - lift, false, piece.last1, up, piece.y1, piece)
    end
  elseif piece.convex0 then
    flat_in_reach(piece.x0 - bw, piece.x0, piece.y0 - lift, piece.last0, false, up, piece.y0, piece)
  end
end

-- Whether two pieces are one: a long piece is in each cell that it meets.
local function is_copy(a, b)
  return a.origin == b.origin and a.stretch == b.stretch and a.facing == b.facing and a.x0 == b.x0
      and a.y0 == b.y0
end

function against_piece(piece)
  if ignored and is_copy(piece, ignored) then return end
  origin = piece.origin
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
  if piece.y0 == piece.y1 and not piece.stretch and not centred then
    local comes
    if up then comes = dy > 0 else comes = dy < 0 end
    if comes then flat(up, piece.y0, piece.x0, piece.x1, open0, open1, piece) end
    return
  end
  local offset = foot_offset(piece, bw, centre)
  local first, last, first_y, last_y = piece.x0 - offset, piece.x1 - offset, piece.y0 - lift, piece.y1 - lift
  if centred then open0, open1 = piece.far0, piece.far1 end
  if not piece.stretch then
    sloped(first, last, first_y, last_y, open0, open1, up, piece)
  elseif with_curves then
    curved(first, last, first_y, last_y, open0, open1, up, piece, offset, lift)
  end
  piece_ends(up, piece, lift)
end
