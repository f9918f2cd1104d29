-- ---- Curves: what is free of the grid ----

local cutter = {}

-- upper, lower: the ways that the piece faces if its curve faces up and down.
local function put_piece(cut, piece, upper, lower)
  piece.origin = -1 - cut.number
  piece.one_way = cut.faces ~= "both"
  local upright = piece.x0 == piece.x1
  for n = 1, 2 do
    local up = n == 1
    if cut.faces ~= (up and "down" or "up") then
      local copy = {convex0 = upright, convex1 = upright, base_x = 0.0, base_y = 0.0, slope = 0.0,
          slope_rest = 0.0}
      for key, value in pairs(piece) do copy[key] = value end
      copy.facing = up and (upper or UP) or not up and (lower or DOWN)
      cut.pieces[#cut.pieces + 1] = copy
    end
  end
end

local function put_wall(cut, x, y0, y1, faces_left)
  put_piece(cut, {x0 = x, y0 = y0, x1 = x, y1 = y1, base_x = x, base_y = y0}, faces_left and LEFT or RIGHT,
            faces_left and RIGHT or LEFT)
end

local function put_line(cut, ax, ay, bx, by)
  if ax == bx and ay == by then return end
  if ax == bx then return put_wall(cut, ax, min(ay, by), max(ay, by), by < ay) end
  put_piece(cut, line_between(ax, ay, bx, by))
end

function cutter.segment(cut, s)
  local ax, ay, bx, by = weld(s.x0), weld(s.y0), weld(s.x1), weld(s.y1)
  if s.x0 == s.x1 then return put_wall(cut, ax, ay, by, true) end
  put_line(cut, ax, ay, bx, by)
end

function cutter.polyline(cut, p)
  local x0, x1, parts = weld(p.x0), weld(p.x1), #p.ys - 1
  local function x_of(i) return weld(x0 + (x1 - x0) * (i / parts)) end
  for i = 0, parts - 1 do put_line(cut, x_of(i), weld(p.ys[i + 1]), x_of(i + 1), weld(p.ys[i + 2])) end
end

-- A line that stops bodies on both sides also stops them at its ends.
local function put_tip(cut, piece, first, facing)
  local x, y = first and piece.x0 or piece.x1, first and piece.y0 or piece.y1
  cut.pieces[#cut.pieces + 1] = {x0 = x, y0 = y, x1 = x, y1 = y, base_x = x, base_y = y, slope = 0.0,
      slope_rest = 0.0,
                                 origin = piece.origin, facing = facing, convex0 = true, convex1 = true,
                                     is_tip = true}
end
local function put_tips(cut)
  local count = #cut.pieces
  local function ends_there(piece, first)
    for i = 1, count do
      local other = cut.pieces[i]
      if not is_wall(other) then
        if first and other.x1 == piece.x0 and other.y1 == piece.y0 then return true end
        if not first and other.x0 == piece.x1 and other.y0 == piece.y1 then return true end
      end
    end
    return false
  end
  for i = 1, count do
    local piece = cut.pieces[i]
    if not piece.one_way and piece.facing ~= DOWN and piece.facing ~= RIGHT then
      local wall = is_wall(piece)
      if wall or not ends_there(piece, true) then put_tip(cut, piece, true, wall and UP or LEFT) end
      if wall or not ends_there(piece, false) then put_tip(cut, piece, false, wall and DOWN or RIGHT) end
    end
  end
end

-- The pieces of curves, in order.
function cut_curves(curves)
  local cut = {pieces = {}}
  for number, curve in ipairs(curves) do
    cut.number, cut.faces = number - 1, curve.faces or "up"
    cutter[curve.kind](cut, curve)
  end
  put_tips(cut)
  return cut.pieces
end

-- By cell, the pieces of curves in it.
function cells_of_curves(pieces, width, height)
  local cells = {}
  local function between(a, b, count)
    return clamp(ceil(min(a, b) / TILE) - 1, 0, count - 1), clamp(floor(max(a, b) / TILE), 0, count - 1)
  end
  for _, piece in ipairs(pieces) do
    local left, right = between(piece.x0, piece.x1, width)
    for x = left, right do
      local top, bottom = between(y_at(piece, x * TILE), y_at(piece, x * TILE + TILE), height)
      for y = top, bottom do
        local cell = y * width + x
        cells[cell] = cells[cell] or {}
        table.insert(cells[cell], piece)
      end
    end
  end
  return cells
end

