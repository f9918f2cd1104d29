-- ---- Segments and polylines: lines that are free of the grid ----
has.segments = true

local cutter = {}  -- by kind: cuts a curve of the level's list into pieces
local Free = {}    -- the form of their lines
for name, value in pairs(Line) do Free[name] = value end

-- From its nearer end, as it may be long.
function Free.y(piece, x)
  local other = piece.base_x == piece.x0 and piece.x1 or piece.x0
  if abs(x - piece.base_x) <= abs(x - other) then return piece.base_y + (x - piece.base_x) * piece.slope end
  local other_y = piece.base_x == piece.x0 and piece.y1 or piece.y0
  return other_y + (x - other) * piece.slope
end

-- upper, lower: the ways that the piece faces if its line faces up and down.
local function put_piece(cut, piece, upper, lower)
  piece.solid = cut.faces == "both"
  local upright = piece.x0 == piece.x1
  for n = 1, 2 do
    local up = n == 1
    if cut.faces ~= (up and "down" or "up") then
      local copy = {convex0 = upright, convex1 = upright, base_x = 0.0, base_y = 0.0, slope = 0.0,
                    slope_rest = 0.0, form = Free}
      for key, value in pairs(piece) do copy[key] = value end
      copy.facing = up and (upper or UP) or not up and (lower or DOWN)
      cut.pieces[#cut.pieces + 1] = copy
    end
  end
end

do

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
                                 slope_rest = 0.0, facing = facing, convex0 = true, convex1 = true, is_tip = true,
                                 solid = true, form = Free, conveyor = piece.conveyor}
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
    if piece.solid and piece.facing ~= DOWN and piece.facing ~= RIGHT then
      local wall = is_wall(piece)
      if wall or not ends_there(piece, true) then put_tip(cut, piece, true, wall and UP or LEFT) end
      if wall or not ends_there(piece, false) then put_tip(cut, piece, false, wall and DOWN or RIGHT) end
    end
  end
end

-- The pieces of all curves, in order.
local function cut_all(list)
  local cut = {pieces = {}}
  for _, entry in ipairs(list) do
    cut.faces = entry.faces or "up"
    cutter[entry.kind](cut, entry)
  end
  put_tips(cut)
  return cut.pieces
end

-- The pieces in each cell.
local function cells_of(pieces, width, height)
  local cells = {}
  local function between(a, b, side, count)
    return clamp(ceil(min(a, b) / side) - 1, 0, count - 1), clamp(floor(max(a, b) / side), 0, count - 1)
  end
  for _, piece in ipairs(pieces) do
    local left, right = between(piece.x0, piece.x1, TILE_W, width)
    for x = left, right do
      local top, bottom = between(y_at(piece, x * TILE_W), y_at(piece, (x + 1) * TILE_W), TILE_H, height)
      for y = top, bottom do
        local cell = y * width + x
        cells[cell] = cells[cell] or {}
        table.insert(cells[cell], piece)
      end
    end
  end
  return cells
end

local begin = Terrain.begin
function Terrain:begin(level)
  begin(self, level)
  self.free = cut_all(level.curves)
  self.free_in = cells_of(self.free, self.width, self.height)
  for cell in pairs(self.free_in) do self.details[cell] = (self.details[cell] or 0) + 1 end
end

function Terrain:note_free(piece, first, x, y, note)
  for _, other in ipairs(self.free) do
    if not other.is_tip and not is_wall(other) and other.facing == piece.facing then
      if first and other.x1 == x and other.y1 == y then note(other.y0 - other.y1, true) end
      if not first and other.x0 == x and other.y0 == y then note(other.y1 - other.y0, true) end
    end
  end
end

-- A long piece is in each cell that it meets. It is marked at its ends, in the cells of these ends.
function Terrain:add_free(strips, cx, cy, out)
  local function is_here(x, y)
    return x >= cx * TILE_W and x <= (cx + 1) * TILE_W and y >= cy * TILE_H and y <= (cy + 1) * TILE_H
  end
  for _, piece in ipairs(self.free_in[cy * self.width + cx] or {}) do
    local copy = {source = piece}
    for key, value in pairs(piece) do copy[key] = value end
    if not is_wall(copy) then
      copy.far0, copy.far1 = not is_here(copy.x0, copy.y0), not is_here(copy.x1, copy.y1)
      if not copy.far0 then mark_end(self, strips, copy, true) end
      if not copy.far1 then mark_end(self, strips, copy, false) end
    end
    out[#out + 1] = copy
  end
end

end
