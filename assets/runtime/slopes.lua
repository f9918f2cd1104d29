-- ---- Slopes: the outline of the ground in a cell that is not a plain tile ----
-- A piece is a part of the outline: x0, y0, x1, y1. A line is y = base_y + (x - base_x) * slope. A piece faces
-- up or down, or is a wall. form: the functions for pieces of its form. solid: it bounds a body of ground.
-- convex: the ground turns away at that end; last: no floor goes on there; far: the end is in another cell.
has.slopes = true
World.centre_part = "walk"  -- which bodies on their centre take

local WELD = 256  -- of a px, to which ends are rounded

local Line = {straight = true}  -- the form of lines

-- Rounds to 1/256 px, halves away from zero: ends that ought to meet do.
local function weld(at)
  local size = abs(at) * WELD
  local whole = floor(size)
  if size - whole >= 0.5 then whole = whole + 1 end
  return at < 0 and -(whole / WELD) or whole / WELD
end

function Line.y(piece, x) return piece.base_y + (x - piece.base_x) * piece.slope end

-- The height of a piece at x, clamped to it.
local function y_at(piece, x)
  if x <= piece.x0 then return piece.y0 end
  if x >= piece.x1 then return piece.y1 end
  return clamp(piece.form.y(piece, x), min(piece.y0, piece.y1), max(piece.y0, piece.y1))
end

local function is_wall(piece) return piece.facing >= LEFT end
-- Whether a rounding of x is worth more than one of y there.
local function is_steep(piece) return abs(piece.slope) > 1 end

-- How far right of a box's left side its part is that touches a sloped floor or ceiling.
local function foot_offset(piece, w, centre)
  local up = piece.facing == UP
  if up and centre then return w / 2 end
  return (piece.y1 < piece.y0) == up and w or 0.0
end
Line.offset = foot_offset

-- How far the line rises or falls over a way to the side.
function Line.along(piece, x) return x * piece.slope end

-- The top of a box at x that rests on the piece.
local function rest_on(piece, x, w, h, centre)
  return y_at(piece, x + foot_offset(piece, w, centre)) - (piece.facing == UP and h or 0.0)
end
Line.rest = rest_on

-- ---- What each kind of tile adds to the outline ----

local function line_between(x0, y0, x1, y1)
  local slope, rest = two_divide(y1 - y0, 0.0, x1 - x0, 0.0)
  local first = y0 <= y1
  return {x0 = x0, y0 = y0, x1 = x1, y1 = y1, base_x = first and x0 or x1, base_y = first and y0 or y1,
          slope = slope, slope_rest = rest}
end
local function line_at(line, x)
  if x <= line.x0 then return line.y0 end
  if x >= line.x1 then return line.y1 end
  return clamp(line.base_y + (x - line.base_x) * line.slope, min(line.y0, line.y1), max(line.y0, line.y1))
end
local function line_moved(line, x, y)
  return {x0 = line.x0 + x, y0 = line.y0 + y, x1 = line.x1 + x, y1 = line.y1 + y, base_x = line.base_x + x,
          base_y = line.base_y + y, slope = line.slope, slope_rest = line.slope_rest}
end

local function column_of(shape, tiles, column)
  local is_floor = shape.side ~= "ceiling"
  local base = is_floor and TILE_H or 0.0
  local left, right = column * TILE_W, (column + 1) * TILE_W
  local heights = shape.heights or {TILE_H, TILE_H}
  local width, parts = tiles * TILE_W, #heights - 1
  local line, joints = {}, {}
  local highest, lowest = base, base
  for i = 1, parts do
    local x0, x1 = weld(width * (i - 1) / parts), weld(width * i / parts)
    if x0 < right and x1 > left then
      local sign = is_floor and -1 or 1
      local y0, y1 = base + sign * weld(heights[i]), base + sign * weld(heights[i + 1])
      line[#line + 1] = line_between(x0, y0, x1, y1)
      if x1 < right then joints[#joints + 1] = x1 end
      highest, lowest = min(highest, min(y0, y1)), max(lowest, max(y0, y1))
    end
  end
  local side = {line_between(left, base, right, base)}
  return {top = is_floor and line or side, bottom = is_floor and side or line, joints = joints,
          highest = highest, lowest = lowest}
end

-- shape: kind "solid", "slope" or "profile".
function Terrain.outline_of(shape)
  local full = shape.kind == "solid"
  local out = {full = full, line = not full, solid = true, is_floor = shape.side ~= "ceiling", columns = {}}
  local tiles, extra = 1, 0
  if shape.kind ~= "solid" then
    tiles = shape.tiles or 1
    local most = 0.0
    for _, height in ipairs(shape.heights) do most = max(most, height) end
    extra = max(0, ceil(weld(most) / TILE_H) - 1)
  end
  for column = 0, tiles - 1 do out.columns[column] = column_of(shape, tiles, column) end
  out.width = tiles
  -- The cells whose outline it may change, relative to its own.
  out.left, out.right = -1, tiles
  out.top, out.bottom = -1 - (out.is_floor and extra or 0), 1 + (out.is_floor and 0 or extra)
  return out
end

-- ---- Bodies: what covers a strip one cell wide, from its top down to its bottom ----

local function height_at(body, top, x, to_the_right)
  local in_tile = x - body.corner_x
  local lines = top and body.column.top or body.column.bottom
  for _, line in ipairs(lines) do
    local beside
    if to_the_right then beside = line.x0 <= in_tile and in_tile < line.x1
    else beside = line.x0 < in_tile and in_tile <= line.x1 end
    if beside then return line_at(line_moved(line, body.corner_x, body.corner_y), x) end
  end
  local first, last = lines[1], lines[#lines]
  return body.corner_y + (in_tile <= first.x0 and first.y0 or last.y1)
end

local function range_at(body, x, to_the_right)
  return height_at(body, true, x, to_the_right), height_at(body, false, x, to_the_right)
end

-- Whether the body has any height right (or left) of x; a line has none.
local function is_thick(body, x, to_the_right)
  local in_tile = x - body.corner_x
  local far = to_the_right and huge or -huge
  for _, lines in ipairs {body.column.top, body.column.bottom} do
    for _, line in ipairs(lines) do
      if to_the_right and line.x0 <= in_tile and in_tile < line.x1 then far = min(far, line.x1) end
      if not to_the_right and line.x0 < in_tile and in_tile <= line.x1 then far = max(far, line.x0) end
    end
  end
  if abs(far) == huge then return false end
  local from, to = range_at(body, x, to_the_right)
  local there_from, there_to = range_at(body, body.corner_x + far, not to_the_right)
  return from ~= to or there_from ~= there_to
end

-- A body that is not solid stops with one side only.
local function has_side(body, top) return body.tile.solid or body.tile.is_floor == top end

-- Its y are from highest to lowest, a little more than needed, as these are rounded unlike its lines.
local function new_body(terrain, tile, x, y, strip)
  local column = tile.columns[strip - x]
  local body = {tile = tile, column = column, corner_x = x * TILE_W, corner_y = y * TILE_H,
      origin = y * terrain.width + x,
                highest = y * TILE_H + column.highest - 1 / WELD, lowest = y * TILE_H + column.lowest + 1 / WELD}
  local left, right = strip * TILE_W, (strip + 1) * TILE_W
  body.left_from, body.left_to = range_at(body, left, true)
  body.right_from, body.right_to = range_at(body, right, false)
  return body
end

-- The parts of one side of a strip that are ground, from the top.
local function covers_of(bodies, left)
  local covers = {}
  for _, body in ipairs(bodies) do
    if body.tile.solid then
      local cover = {from = left and body.left_from or body.right_from, to = left and body.left_to
          or body.right_to,
                     origin = body.origin}
      local at = #covers + 1
      while at > 1 and cover.from < covers[at - 1].from do at = at - 1 end
      table.insert(covers, at, cover)
    end
  end
  local last = 1
  for i = 2, #covers do
    if covers[i].from <= covers[last].to then
      covers[last].to = max(covers[last].to, covers[i].to)
    else
      last = last + 1
      covers[last] = covers[i]
    end
  end
  for i = #covers, last + 1, -1 do covers[i] = nil end
  return covers
end

local function strip_at(terrain, column, row)
  -- What reaches over the map's left or right side is no ground.
  if column < 0 or column >= terrain.width then
    return {column = column, bodies = {}, left = {}, right = {}}
  end
  local bodies = {}
  for y = row - 1, row + 1 do
    local tile = terrain:outline(column, y)
    if tile and tile.full then bodies[#bodies + 1] = new_body(terrain, tile, column, y, column) end
  end
  for y = row - terrain.touched_bottom, row - terrain.touched_top do
    for x = column - terrain.touched_right + 1, column do
      local tile = terrain:outline(x, y)
      if tile and tile.line and column - x < tile.width and row >= y + tile.top
          and row <= y + tile.bottom then
        bodies[#bodies + 1] = new_body(terrain, tile, x, y, column)
      end
    end
  end
  return {column = column, bodies = bodies, left = covers_of(bodies, true), right = covers_of(bodies, false)}
end

-- ---- Floors and ceilings ----

-- Where a is below b between x0 and x1; both are straight there. Rounded inwards to 1/256 px.
local function where_less(a0, a1, b0, b1, x0, x1, or_equal)
  local d0, d1 = b0 - a0, b1 - a1
  if d0 == 0 and d1 == 0 then return x0, or_equal and x1 or x0 end
  if d0 >= 0 and d1 >= 0 then return x0, x1 end
  if d0 <= 0 and d1 <= 0 then return x0, x0 end
  local crossing = x0 + (x1 - x0) * (d0 / (d0 - d1))
  if d0 > 0 then return x0, floor(crossing * WELD) / WELD end
  return ceil(crossing * WELD) / WELD, x1
end

local function take_out(parts, from, to)
  local i = 1
  while i <= #parts do
    local part = parts[i]
    if not (to <= part.from or from >= part.to) then
      local before, after = part.from < from, to < part.to
      if before and after then
        parts[i] = {from = part.from, to = from}
        i = i + 1
        table.insert(parts, i, {from = to, to = part.to})
      elseif before then
        parts[i] = {from = part.from, to = from}
      elseif after then
        parts[i] = {from = to, to = part.to}
      else
        table.remove(parts, i)
        i = i - 1
      end
    end
    i = i + 1
  end
end

-- Takes out the parts where the line of body number `index` is inside of other ones, or is the same as an
-- earlier one.
local function take_out_hidden(bodies, index, top, line, x0, x1, parts)
  local y0, y1 = line_at(line, x0), line_at(line, x1)
  local highest, lowest = min(y0, y1), max(y0, y1)
  for number, other in ipairs(bodies) do
    if #parts == 0 then return end
    if other.tile.solid and other.highest <= lowest and other.lowest >= highest then
      local top0, bottom0 = range_at(other, x0, true)
      local top1, bottom1 = range_at(other, x1, false)
      local is_flat = top0 == bottom0 and top1 == bottom1
      if number == index then
        if is_flat then take_out(parts, x0, x1) end
      elseif not is_flat then
        local later = number < index
        local from, to = where_less(top0, top1, y0, y1, x0, x1, not top or later)
        local from2, to2 = where_less(y0, y1, bottom0, bottom1, x0, x1, top or later)
        from, to = max(from, from2), min(to, to2)
        if from < to then take_out(parts, from, to) end
      end
    end
  end
end

local function open_parts(bodies, index, top, line, from, to)
  local ends = {from}
  for _, other in ipairs(bodies) do
    for _, joint in ipairs(other.column.joints) do
      local x = other.corner_x + joint
      if x > from and x < to then ends[#ends + 1] = x end
    end
  end
  ends[#ends + 1] = to
  table.sort(ends)
  local open = {}
  for i = 1, #ends - 1 do
    if ends[i] ~= ends[i + 1] then
      local parts = {{from = ends[i], to = ends[i + 1]}}
      take_out_hidden(bodies, index, top, line, ends[i], ends[i + 1], parts)
      for _, part in ipairs(parts) do
        if #open > 0 and open[#open].to == part.from then
          open[#open].to = part.to
        else
          open[#open + 1] = part
        end
      end
    end
  end
  return open
end

local function may_be_in_row(y0, y1, top, row0)
  if top then return min(y0, y1) < row0 + TILE_H and max(y0, y1) >= row0 end
  return max(y0, y1) > row0 and min(y0, y1) <= row0 + TILE_H
end

local function add_surface(bodies, index, top, x, y, out)
  local body = bodies[index]
  local left, row0 = x * TILE_W, y * TILE_H
  local right, row1 = left + TILE_W, row0 + TILE_H
  for _, in_tile in ipairs(top and body.column.top or body.column.bottom) do
    local line = line_moved(in_tile, body.corner_x, body.corner_y)
    local from, to = max(line.x0, left), min(line.x1, right)
    if may_be_in_row(line.y0, line.y1, top, row0) and
        may_be_in_row(line_at(line, from), line_at(line, to), top, row0) then
      for _, part in ipairs(open_parts(bodies, index, top, line, from, to)) do
        local y0, y1 = line_at(line, part.from), line_at(line, part.to)
        local high, low = min(y0, y1), max(y0, y1)
        local in_row
        if top then in_row = high < row1 and (low > row0 or (high == low and high == row0))
        else in_row = low > row0 and (high < row1 or (high == low and low == row1)) end
        if in_row then
          out[#out + 1] = {x0 = part.from, y0 = y0, x1 = part.to, y1 = y1, base_x = line.base_x,
              base_y = line.base_y,
                           slope = line.slope, slope_rest = line.slope_rest, origin = body.origin,
                           facing = top and UP or DOWN, solid = body.tile.solid, form = Line}
        end
      end
    end
  end
end

-- ---- Walls ----

local function wall_piece(x, y0, y1, left, origin, convex0, convex1)
  return {x0 = x, y0 = y0, x1 = x, y1 = y1, base_x = x, base_y = y0, slope = 0.0, slope_rest = 0.0,
      origin = origin,
          facing = left and LEFT or RIGHT, convex0 = convex0, convex1 = convex1, solid = true, form = Line}
end

local function add_wall(here, beside, left, x, y, out)
  local at, row0 = (left and x or x + 1) * TILE_W, y * TILE_H
  local row1 = row0 + TILE_H
  for _, whole in ipairs(left and here.left or here.right) do
    if whole.to > row0 and whole.from < row1 then
      local parts = {{from = whole.from, to = whole.to}}
      for _, other in ipairs(left and beside.right or beside.left) do take_out(parts, other.from,
          other.to) end
      for _, part in ipairs(parts) do
        local y0, y1 = max(part.from, row0), min(part.to, row1)
        if y0 < y1 then
          out[#out + 1] = wall_piece(at, y0, y1, left, whole.origin, y0 == whole.from, y1 == whole.to)
        end
      end
    end
  end
end

local function strip_beside(strips, x, to_the_right)
  local here = strips[2].column
  if to_the_right then return x == (here + 1) * TILE_W and strips[3] or strips[2] end
  return x == here * TILE_W and strips[1] or strips[2]
end

-- Whether there is ground right (or left) of a point.
local function goes_on_at(strips, x, y, to_the_right)
  for _, body in ipairs(strip_beside(strips, x, to_the_right).bodies) do
    if body.tile.solid and y >= body.highest and y <= body.lowest then
      local from, to = range_at(body, x, to_the_right)
      if from <= y and y <= to and is_thick(body, x, to_the_right) then return true end
    end
  end
  return false
end

-- The tips of wedges: a body's top and bottom meet there, and nothing goes on.
local function add_tips(strips, cx, cy, out)
  local left, row0 = cx * TILE_W, cy * TILE_H
  local right, row1 = left + TILE_W, row0 + TILE_H
  for _, body in ipairs(strips[2].bodies) do
    if body.tile.line and body.tile.solid and body.lowest >= row0 and body.highest <= row1 then
      for _, line in ipairs(body.tile.is_floor and body.column.top or body.column.bottom) do
        if line.y0 ~= line.y1 then
          for n = 1, 2 do
            local first = n == 1
            local x = body.corner_x + (first and line.x0 or line.x1)
            local y = body.corner_y + (first and line.y0 or line.y1)
            if x >= left and x <= right and y >= row0 and y <= row1 then
              local from, to = range_at(body, x, first)
              if y == from and y == to and not goes_on_at(strips, x, y, not first) then
                out[#out + 1] = wall_piece(x, y, y, first, body.origin, true, true)
              end
            end
          end
        end
      end
    end
  end
end

-- ---- Ends ----

-- The other lines that face the same way and begin where this one ends: whether there are any, and whether one
-- of them does not fall back from the open side; and whether lines alone that bodies from below pass rise from the
-- end of a solid floor, which do not count else.
local function goes_on(terrain, strips, piece, first)
  local x, y = first and piece.x0 or piece.x1, first and piece.y0 or piece.y1
  local up = piece.facing == UP
  local any, outward, covers = false, false, false
  local function note(fall, passed)
    if passed and fall < 0 and up and piece.solid and piece.form == Line then covers = true return end
    any = true
    if up then outward = outward or fall <= 0 else outward = outward or fall >= 0 end
  end
  for _, body in ipairs(strip_beside(strips, x, not first).bodies) do
    if y >= body.highest and y <= body.lowest and has_side(body, up) then
      for _, in_tile in ipairs(up and body.column.top or body.column.bottom) do
        local line = line_moved(in_tile, body.corner_x, body.corner_y)
        local reaches
        if first then reaches = line.x0 < x and x <= line.x1 else reaches = line.x0 <= x and x < line.x1 end
        if reaches and line_at(line, x) == y and (not body.tile.solid or is_thick(body, x, not first)) then
          note((first and line.y0 or line.y1) - y, not body.tile.solid)
        end
      end
    end
  end
  terrain:note_free(piece, first, x, y, note)
  return any, outward, covers and not outward
end

local function mark_end(terrain, strips, piece, first)
  -- A piece in several cells is marked at its ends, in the cells of these ends.
  local y = first and piece.y0 or piece.y1
  local far = y < strips.y * TILE_H or y > (strips.y + 1) * TILE_H
  local any, outward, covers = far, far, false
  if not far then any, outward, covers = goes_on(terrain, strips, piece, first) end
  local convex = not outward and not covers
  if first then
    piece.convex0, piece.last0, piece.far0, piece.covered0 = convex, not any, far, covers
  else
    piece.convex1, piece.last1, piece.far1, piece.covered1 = convex, not any, far, covers
  end
end

-- Curves: remembers what begins where a piece ends, and adds the pieces in a cell.
function Terrain:note_free() end
function Terrain:add_free() end

-- The pieces in a cell, and the directions that they face.
local function pieces_in(terrain, x, y)
  local strips = {strip_at(terrain, x - 1, y), strip_at(terrain, x, y), strip_at(terrain, x + 1, y), y = y}
  local out, bodies = {}, strips[2].bodies
  for index, body in ipairs(bodies) do
    if has_side(body, true) then add_surface(bodies, index, true, x, y, out) end
    if has_side(body, false) then add_surface(bodies, index, false, x, y, out) end
  end
  add_wall(strips[2], strips[1], true, x, y, out)
  add_wall(strips[2], strips[3], false, x, y, out)
  add_tips(strips, x, y, out)
  for _, piece in ipairs(out) do
    if not is_wall(piece) then
      mark_end(terrain, strips, piece, true)
      mark_end(terrain, strips, piece, false)
    end
  end
  terrain:add_free(strips, x, y, out)
  local faces = {}
  for _, piece in ipairs(out) do faces[piece.facing] = true end
  return {pieces = out, faces = faces}
end
