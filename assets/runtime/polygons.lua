-- ---- Polygons and groups: shapes of several parts ----
has.polygons = true

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

-- All sides but the vertical ones, from left to right.
local function sides_of(points)
  local sides = {}
  for i = 1, #points, 2 do
    local ax, ay = weld(points[i]), weld(points[i + 1])
    local next = i + 2 > #points and 1 or i + 2
    local bx, by = weld(points[next]), weld(points[next + 1])
    if ax < bx then sides[#sides + 1] = line_between(ax, ay, bx, by) end
    if ax > bx then sides[#sides + 1] = line_between(bx, by, ax, ay) end
  end
  return sides
end

-- The places where the parts may change: at points, and at the borders of columns.
local function cuts_of_polygon(points, first, last)
  local all, cuts = {}, {}
  for i = 1, #points, 2 do all[#all + 1] = weld(points[i]) end
  for column = first, last - 1 do all[#all + 1] = (column + 1) * TILE_W end
  table.sort(all)
  for _, x in ipairs(all) do
    if x ~= cuts[#cuts] then cuts[#cuts + 1] = x end
  end
  return cuts
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
  local sides, cuts = sides_of(shape.points), cuts_of_polygon(shape.points, first, last)
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

local outline_of = Terrain.outline_of

-- The parts of a polygon or a group, sorted into their columns.
local function cut_shape(shape)
  local out = {full = false, line = true, columns = {}, left = -1, right = 1, top = -1, bottom = 1}
  local polygons = 0
  local function add(part)
    local column = floor(part.left / TILE_W)
    local parts = out.columns[column] or {}
    parts[#parts + 1] = part
    out.columns[column] = parts
  end
  local begun = false
  for _, part in ipairs(shape.parts or {shape}) do
    local touched
    if part.points then
      touched = touched_by_polygon(part.points)
      cut_polygon(part, polygons, touched.left + 1, touched.right - 1, add)
      polygons = polygons + 1
    else
      touched = outline_of(part)
      for column = 0, touched.right - 1 do add(touched.columns[column][1]) end
    end
    for _, side in ipairs {"left", "top"} do
      out[side] = begun and min(out[side], touched[side]) or touched[side]
    end
    for _, side in ipairs {"right", "bottom"} do
      out[side] = begun and max(out[side], touched[side]) or touched[side]
    end
    begun = true
  end
  return out
end

-- shape: also kind "polygon" with the x and y of its points in turn, or "group" with parts.
function Terrain.outline_of(shape)
  if shape.parts and #shape.parts == 1 then shape = shape.parts[1] end  -- a group of one part is that part
  return (shape.points or shape.parts) and cut_shape(shape) or outline_of(shape)
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
  return begin(self, level)
end
