-- ---- Polygons and groups: shapes of several parts ----
-- Ground may begin and end between the sides of a cell here, and heights of lines are rounded once. So functions of
-- slopes.lua have other forms in this file, which take their place in games that have polygons.
has.polygons = true

do

-- The height of a line at x, rounded once.
local function precise_at(line, x)
  local high, low = two_multiply(x - line.base_x, 0.0, line.slope, line.slope_rest)
  high, low = two_add(high, low, line.base_y, 0.0)
  return high + low
end
local function line_at(line, x)
  if x <= line.x0 then return line.y0 end
  if x >= line.x1 then return line.y1 end
  local y = line.precise and precise_at(line, x) or line.base_y + (x - line.base_x) * line.slope
  return clamp(y, min(line.y0, line.y1), max(line.y0, line.y1))
end
local function line_moved(line, x, y)
  return {x0 = line.x0 + x, y0 = line.y0 + y, x1 = line.x1 + x, y1 = line.y1 + y, base_x = line.base_x + x,
          base_y = line.base_y + y, slope = line.slope, slope_rest = line.slope_rest, precise = line.precise}
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
          highest = highest, lowest = lowest, left = left, right = right, solid = true, is_floor = is_floor}
end

-- A full tile, a slope or a profile.
local function outline_of_line(shape)
  local is_floor = shape.side ~= "ceiling"
  local full = shape.kind == "solid" and not shape.one_way
  local out = {full = full, line = not full, columns = {}}
  local tiles, extra = 1, 0
  if shape.kind ~= "solid" then
    tiles = shape.tiles or 1
    local most = 0.0
    for _, height in ipairs(shape.heights) do most = max(most, height) end
    extra = max(0, ceil(weld(most) / TILE_H) - 1)
  end
  for column = 0, tiles - 1 do
    local part = column_of(shape, tiles, column)
    part.solid = not shape.one_way
    out.columns[column] = {part}
  end
  -- The cells whose outline it may change, relative to its own.
  out.left, out.right = -1, tiles
  out.top, out.bottom = -1 - (is_floor and extra or 0), 1 + (is_floor and 0 or extra)
  return out
end

-- Whether a line is above another at an x that both have.
local function is_above(a, b, x)
  local function scaled(line, other)
    local height = line.y0 * (line.x1 - line.x0) + (line.y1 - line.y0) * (x - line.x0)
    return two_multiply(height, 0.0, other.x1 - other.x0, 0.0)
  end
  local ours, ours_low = scaled(a, b)
  local theirs, theirs_low = scaled(b, a)
  if ours ~= theirs then return ours < theirs end
  return ours_low < theirs_low
end

-- The i-th number of a polygon's points. Points on the lines of a larger area are not welded.
local function coordinate_of(shape, i) return shape.lines and shape.points[i] or weld(shape.points[i]) end

-- All sides but the vertical ones, from left to right.
local function sides_of(shape)
  local sides, count, lines = {}, #shape.points, shape.lines
  for i = 1, count, 2 do
    local next = i + 2 > count and 1 or i + 2
    local ax, ay = coordinate_of(shape, i), coordinate_of(shape, i + 1)
    local bx, by = coordinate_of(shape, next), coordinate_of(shape, next + 1)
    if ax > bx then ax, ay, bx, by = bx, by, ax, ay end
    if ax < bx then
      local side = line_between(ax, ay, bx, by)
      if lines then
        side = line_between(lines[2 * i - 1], lines[2 * i], lines[2 * i + 1], lines[2 * i + 2])
        side.x0, side.y0, side.x1, side.y1 = ax, ay, bx, by
      end
      sides[#sides + 1] = side
    end
  end
  return sides
end

-- Sorts numbers, and returns each of them once.
local function each_once(all)
  local once = {}
  table.sort(all)
  for _, x in ipairs(all) do
    if x ~= once[#once] then once[#once + 1] = x end
  end
  return once
end

-- The places where the parts may change: at points, and at the borders of columns.
local function cuts_of_polygon(shape, first, last)
  local all = {}
  for i = 1, #shape.points, 2 do all[#all + 1] = coordinate_of(shape, i) end
  for column = first, last - 1 do all[#all + 1] = (column + 1) * TILE_W end
  return each_once(all)
end

-- The ground between two cuts, from the top: pairs of sides.
local function pairs_between(sides, x0, x1)
  local met, found = {}, {}
  for _, side in ipairs(sides) do
    if side.x0 <= x0 and side.x1 >= x1 then met[#met + 1] = side end
  end
  local middle = (x0 + x1) / 2
  table.sort(met, function(a, b) return is_above(a, b, middle) end)
  for i = 1, #met - 1, 2 do found[#found + 1] = {top = met[i], bottom = met[i + 1]} end
  return found
end

local function part_between(pair, x0, x1, shape, number)
  local top, bottom = pair.top, pair.bottom
  return {top = {top}, bottom = {bottom}, joints = {}, left = x0, right = x1,
          highest = min(line_at(top, x0), line_at(top, x1)), lowest = max(line_at(bottom, x0), line_at(bottom, x1)),
          solid = not shape.one_way, is_floor = shape.side ~= "ceiling", polygon = number}
end

-- Adds the parts of a polygon, column by column, and in each from the left.
local function cut_polygon(shape, number, first, last, add)
  local sides, cuts = sides_of(shape), cuts_of_polygon(shape, first, last)
  local open = {}
  for i = 1, #cuts do
    local new = {}
    local is_border = cuts[i] % TILE_W == 0
    for _, pair in ipairs(i < #cuts and pairs_between(sides, cuts[i], cuts[i + 1]) or {}) do
      pair.left = cuts[i]
      for n, other in ipairs(is_border and {} or open) do
        if other.top == pair.top and other.bottom == pair.bottom then
          pair.left = other.left
          table.remove(open, n)
          break
        end
      end
      new[#new + 1] = pair
    end
    for _, pair in ipairs(open) do add(part_between(pair, pair.left, cuts[i], shape, number)) end
    open = new
  end
end

-- The cells whose outline it may change, relative to its own.
local function touched_by_polygon(points)
  local left, right, top, bottom = huge, -huge, huge, -huge
  for i = 1, #points, 2 do
    left, right = min(left, weld(points[i])), max(right, weld(points[i]))
    top, bottom = min(top, weld(points[i + 1])), max(bottom, weld(points[i + 1]))
  end
  return {left = floor(left / TILE_W) - 1, right = ceil(right / TILE_W),
          top = floor(top / TILE_H) - 1, bottom = ceil(bottom / TILE_H)}
end

-- The parts of a polygon or a group, sorted into their columns.
local function cut_shape(shape)
  local out = {full = false, line = true, columns = {}}
  local polygons = 0
  local function add(part)
    local column = floor(part.left / TILE_W)
    local parts = out.columns[column] or {}
    parts[#parts + 1] = part
    out.columns[column] = parts
  end
  for _, part in ipairs(shape.parts or {shape}) do
    local touched
    if part.points then
      touched = touched_by_polygon(part.points)
      cut_polygon(part, polygons, touched.left + 1, touched.right - 1, add)
      polygons = polygons + 1
    else
      touched = outline_of_line(part)
      for column = 0, touched.right - 1 do add(touched.columns[column][1]) end
    end
    for _, side in ipairs {"left", "top"} do out[side] = min(out[side] or touched[side], touched[side]) end
    for _, side in ipairs {"right", "bottom"} do out[side] = max(out[side] or touched[side], touched[side]) end
  end
  return out
end

-- shape: also kind "polygon" with the x and y of its points in turn, or "group" with parts. A polygon that is a part of
-- a larger area has lines: for each point, the ends of the line that the side to the next point is a part of.
function Terrain.outline_of(shape)
  if shape.parts and #shape.parts == 1 then shape = shape.parts[1] end  -- a group of one part is that part
  return (shape.points or shape.parts) and cut_shape(shape) or outline_of_line(shape)
end

-- Sides of polygons may lie on any other line.
local function make_precise(outlines)
  for _, outline in pairs(outlines) do
    for _, parts in pairs(outline.columns) do
      for _, part in ipairs(parts) do
        for _, line in ipairs(part.top) do line.precise = true end
        for _, line in ipairs(part.bottom) do line.precise = true end
      end
    end
  end
end

local begin = Terrain.begin
function Terrain:begin(level)
  for _, shape in pairs(level.shapes) do
    if shape.points or shape.parts then
      make_precise(self.outlines)
      break
    end
  end
  self.touched_left = -1
  for _, outline in pairs(self.outlines) do
    if outline.line then self.touched_left = min(self.touched_left, outline.left) end
  end
  return begin(self, level)
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
  if to_the_right then far = min(far, body.column.right) else far = max(far, body.column.left) end
  local from, to = range_at(body, x, to_the_right)
  local there_from, there_to = range_at(body, body.corner_x + far, not to_the_right)
  return from ~= to or there_from ~= there_to
end

-- A body that is not solid stops with one side only.
local function has_side(body, top) return body.column.solid or body.column.is_floor == top end

-- Whether it is of the same polygon: no side of a polygon is inside of it.
local function is_same_polygon(a, b)
  return a.column.polygon and a.column.polygon == b.column.polygon and a.origin == b.origin
end

-- Whether it covers a place just right (or left) of x.
local function is_beside(body, x, to_the_right)
  if to_the_right then return body.left <= x and x < body.right end
  return body.left < x and x <= body.right
end

-- Its y are from highest to lowest, a little more than needed, as these are rounded unlike its lines.
local function new_body(terrain, column, x, y, full)
  return {column = column, full = full, corner_x = x * TILE_W, corner_y = y * TILE_H,
          origin = y * terrain.width + x, left = x * TILE_W + column.left, right = x * TILE_W + column.right,
          highest = y * TILE_H + column.highest - 1 / WELD, lowest = y * TILE_H + column.lowest + 1 / WELD}
end

-- The parts of a vertical line that have ground just right (or left) of it, from the top.
local function covers_of(bodies, x, to_the_right)
  local covers = {}
  for _, body in ipairs(bodies) do
    if body.column.solid and is_beside(body, x, to_the_right) then
      local from, to = range_at(body, x, to_the_right)
      if not body.column.polygon or from ~= to then
        local at = #covers + 1
        while at > 1 and from < covers[at - 1].from do at = at - 1 end
        table.insert(covers, at, {from = from, to = to, origin = body.origin})
      end
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

-- The places between the sides of a strip where a body begins or ends; of polygons alone.
local function cuts_of(bodies, left, right)
  local all = {}
  for _, body in ipairs(bodies) do
    if body.left > left then all[#all + 1] = body.left end
    if body.right < right then all[#all + 1] = body.right end
  end
  return each_once(all)
end

local function strip_at(terrain, column, row)
  -- What reaches over the map's left or right side is no ground.
  if column < 0 or column >= terrain.width then
    return {column = column, bodies = {}, cuts = {}, left = {}, right = {}}
  end
  local bodies = {}
  for y = row - 1, row + 1 do
    local tile = terrain:outline(column, y)
    if tile and tile.full then bodies[#bodies + 1] = new_body(terrain, tile.columns[0][1], column, y, true) end
  end
  for y = row - terrain.touched_bottom, row - terrain.touched_top do
    for x = column - terrain.touched_right + 1, column - terrain.touched_left - 1 do
      local tile = terrain:outline(x, y)
      if tile and tile.line and row >= y + tile.top and row <= y + tile.bottom then
        for _, part in ipairs(tile.columns[column - x] or {}) do
          bodies[#bodies + 1] = new_body(terrain, part, x, y, false)
        end
      end
    end
  end
  local left, right = column * TILE_W, (column + 1) * TILE_W
  return {column = column, bodies = bodies, cuts = cuts_of(bodies, left, right),
          left = covers_of(bodies, left, true), right = covers_of(bodies, right, false)}
end

-- Takes out the parts where the line of body number `index` is inside of other ones, or is the same as an
-- earlier one.
local function take_out_hidden(bodies, index, top, line, x0, x1, parts)
  local y0, y1 = line_at(line, x0), line_at(line, x1)
  local highest, lowest = min(y0, y1), max(y0, y1)
  for number, other in ipairs(bodies) do
    if #parts == 0 then return end
    if other.column.solid and other.highest <= lowest and other.lowest >= highest and other.left < x1
        and other.right > x0 and not is_same_polygon(other, bodies[index]) then
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
  local function add(x)
    if x > from and x < to then ends[#ends + 1] = x end
  end
  for _, other in ipairs(bodies) do
    for _, joint in ipairs(other.column.joints) do add(other.corner_x + joint) end
    if other.column.polygon and not is_same_polygon(other, bodies[index]) then
      add(other.left)
      add(other.right)
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

local function add_surface(bodies, index, top, x, y, out)
  local body = bodies[index]
  local left, row0 = x * TILE_W, y * TILE_H
  local right, row1 = left + TILE_W, row0 + TILE_H
  for _, in_tile in ipairs(top and body.column.top or body.column.bottom) do
    local line = line_moved(in_tile, body.corner_x, body.corner_y)
    local from, to = max(line.x0, left), min(line.x1, right)
    -- A side of a polygon counts once, with its first part.
    if from >= body.left and may_be_in_row(line.y0, line.y1, top, row0) and
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
                           facing = top and UP or DOWN, solid = body.column.solid, form = Line}
        end
      end
    end
  end
end

-- The part of a vertical line in a cell with ground on one hand and none on the other.
local function add_wall(at, left, y, ground, beside, out)
  local row0 = y * TILE_H
  local row1 = row0 + TILE_H
  for _, whole in ipairs(ground) do
    if whole.to > row0 and whole.from < row1 then
      local parts = {{from = whole.from, to = whole.to}}
      for _, other in ipairs(beside) do take_out(parts, other.from, other.to) end
      for _, part in ipairs(parts) do
        local y0, y1 = max(part.from, row0), min(part.to, row1)
        if y0 < y1 then
          out[#out + 1] = wall_piece(at, y0, y1, left, whole.origin, y0 == whole.from, y1 == whole.to)
        end
      end
    end
  end
end

local function add_walls(strips, x, y, out)
  local here = strips[2]
  add_wall(x * TILE_W, true, y, here.left, strips[1].right, out)
  add_wall((x + 1) * TILE_W, false, y, here.right, strips[3].left, out)
  for _, at in ipairs(here.cuts) do
    local before, after = covers_of(here.bodies, at, false), covers_of(here.bodies, at, true)
    add_wall(at, true, y, after, before, out)
    add_wall(at, false, y, before, after, out)
  end
end

-- Whether there is ground right (or left) of a point.
local function goes_on_at(strips, x, y, to_the_right)
  for _, body in ipairs(strip_beside(strips, x, to_the_right).bodies) do
    if body.column.solid and y >= body.highest and y <= body.lowest and is_beside(body, x, to_the_right) then
      local from, to = range_at(body, x, to_the_right)
      if from <= y and y <= to and is_thick(body, x, to_the_right) then return true end
    end
  end
  return false
end

-- The tip at the first, or the last, end of a line.
local function add_tip(strips, body, x, y, first, cx, cy, out)
  local left, row0 = cx * TILE_W, cy * TILE_H
  if x < left or x > left + TILE_W or y < row0 or y > row0 + TILE_H then return end
  local from, to = range_at(body, x, first)
  if y == from and y == to and not goes_on_at(strips, x, y, not first) then
    out[#out + 1] = wall_piece(x, y, y, first, body.origin, true, true)
  end
end

-- The tips of wedges: a body's top and bottom meet there, and nothing goes on.
local function add_tips(strips, cx, cy, out)
  local row0 = cy * TILE_H
  local row1 = row0 + TILE_H
  for _, body in ipairs(strips[2].bodies) do
    local column = body.column
    if not body.full and column.solid and body.lowest >= row0 and body.highest <= row1 then
      if column.polygon then
        add_tip(strips, body, body.left, height_at(body, true, body.left, true), true, cx, cy, out)
        add_tip(strips, body, body.right, height_at(body, true, body.right, false), false, cx, cy, out)
      else
        for _, line in ipairs(column.is_floor and column.top or column.bottom) do
          if line.y0 ~= line.y1 then
            add_tip(strips, body, body.corner_x + line.x0, body.corner_y + line.y0, true, cx, cy, out)
            add_tip(strips, body, body.corner_x + line.x1, body.corner_y + line.y1, false, cx, cy, out)
          end
        end
      end
    end
  end
end

-- ---- Ends ----

-- The other lines that face the same way and begin where this one ends: whether there are any, and whether one
-- of them does not fall back from the open side; and whether lines alone that bodies from below pass rise from the
-- end of a solid floor, which do not count else. Replaces that of slopes.lua, which mark_end() calls.
function goes_on(terrain, strips, piece, first)
  local x, y = first and piece.x0 or piece.x1, first and piece.y0 or piece.y1
  local up = piece.facing == UP
  local any, outward, covers = false, false, false
  local function note(fall, passed)
    if passed and fall < 0 and up and piece.solid and piece.form == Line then covers = true return end
    any = true
    if up then outward = outward or fall <= 0 else outward = outward or fall >= 0 end
  end
  for _, body in ipairs(strip_beside(strips, x, not first).bodies) do
    if y >= body.highest and y <= body.lowest and has_side(body, up) and is_beside(body, x, not first) then
      for _, in_tile in ipairs(up and body.column.top or body.column.bottom) do
        local line = line_moved(in_tile, body.corner_x, body.corner_y)
        local reaches
        if first then reaches = line.x0 < x and x <= line.x1 else reaches = line.x0 <= x and x < line.x1 end
        if reaches and line_at(line, x) == y and (not body.column.solid or is_thick(body, x, not first)) then
          note((first and line.y0 or line.y1) - y, not body.column.solid)
        end
      end
    end
  end
  terrain:note_free(piece, first, x, y, note)
  return any, outward, covers and not outward
end

-- The pieces in a cell, and the directions that they face.
local function pieces_in(terrain, x, y)
  local strips = {strip_at(terrain, x - 1, y), strip_at(terrain, x, y), strip_at(terrain, x + 1, y), y = y}
  local out, bodies = {}, strips[2].bodies
  for index, body in ipairs(bodies) do
    if has_side(body, true) then add_surface(bodies, index, true, x, y, out) end
    if has_side(body, false) then add_surface(bodies, index, false, x, y, out) end
  end
  add_walls(strips, x, y, out)
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

-- The pieces in a detailed cell, and the directions that they face.
function Terrain:detail(x, y)
  local cell = y * self.width + x
  local found = self.compiled[cell]
  if not found then
    found = pieces_in(self, x, y)
    self.compiled[cell] = found
  end
  return found
end

local set_tile = Terrain.set_tile
function Terrain:set_tile(x, y, tile)
  set_tile(self, x, y, tile)
  for cy = max(y + self.touched_top, 0), min(y + self.touched_bottom, self.height - 1) do
    for cx = max(x + self.touched_left, 0), x do self.compiled[cy * self.width + cx] = nil end
  end
end

-- ---- Questions about the ground ----

-- The range of x in which a box stands on ground: the middle of its bottom, or the whole of it.
local function probe_of(x, w, on_middle, forgiven)
  if on_middle then return x + w / 2, x + w / 2 end
  return x + forgiven, x + w - forgiven
end

-- Rounding puts a box that is on a steep line far off it. Casts forgive half of that: a box that is deeper
-- would fall into the ground.
local function forgiven_by(line, forgiven) return 2.0 * forgiven * max(1.0, abs(line.slope)) end

-- Whether the box is in the part of a slope, of a profile or of a full tile in a column.
local function overlaps_column(column, left, top, x, y, w, h, is_centre, forgiven)
  local is_floor = column.is_floor
  local base = top + (is_floor and TILE_H or 0.0)
  if is_floor then
    if y >= base - forgiven then return false end
  elseif y + h <= base + forgiven then
    return false
  end
  local from, to = probe_of(x, w, is_centre and is_floor, forgiven)
  for _, line in ipairs(is_floor and column.top or column.bottom) do
    local x0, x1 = max(from, left + line.x0), min(to, left + line.x1)
    if x0 <= x1 then
      local off = forgiven_by(line, forgiven)
      for n = 1, 2 do
        local height = top + line_at(line, (n == 1 and x0 or x1) - left)
        if height ~= base then
          if is_floor then
            if y + h > height + off then return true end
          elseif y < height - off then
            return true
          end
        end
      end
    end
  end
  return false
end

-- Whether the box is in a part of a polygon: at some x it reaches below the top and above the bottom there.
-- How far it does so changes evenly with x, so the best x is an end, or where both are equal.
local function overlaps_part(part, left, top, x, y, w, h, is_centre, forgiven)
  local from, to = probe_of(x, w, is_centre, forgiven)
  local x0, x1 = max(from, left + part.left), min(to, left + part.right)
  if not (x0 <= x1) then return false end
  local a0 = y + h - (top + line_at(part.top[1], x0 - left))
  local a1 = y + h - (top + line_at(part.top[1], x1 - left))
  local b0 = top + line_at(part.bottom[1], x0 - left) - y
  local b1 = top + line_at(part.bottom[1], x1 - left) - y
  local most = max(min(a0, b0), min(a1, b1))
  if (a0 < b0) ~= (a1 < b1) then
    local share = (a0 - b0) / ((a0 - b0) - (a1 - b1))
    most = max(most, a0 + share * (a1 - a0))
  end
  return most > max(forgiven_by(part.top[1], forgiven), forgiven_by(part.bottom[1], forgiven))
end

-- Whether the box is in the ground of a slope, a profile, a polygon or a group in the cell.
local function overlaps_shape(shape, column, row, x, y, w, h, is_centre, forgiven)
  local left, top = column * TILE_W, row * TILE_H
  for _, parts in pairs(shape.columns) do
    for _, part in ipairs(parts) do
      local overlaps = part.polygon and overlaps_part or overlaps_column
      if part.solid and overlaps(part, left, top, x, y, w, h, is_centre, forgiven) then return true end
    end
  end
  return false
end

function Terrain:overlaps_shapes(x, y, w, h, is_centre, forgiven)
  if not self:has_pieces() then return false end
  local left, right, top, bottom = block_of(self, x, y, w, h, SPAN * TILE_W, SPAN * TILE_H)
  for row = top, bottom do
    for column = left, right do
      local shape = self:outline(column, row)
      if shape and shape.line and
          overlaps_shape(shape, column, row, x, y, w, h, is_centre, forgiven) then
        return true
      end
    end
  end
  return false
end

end
