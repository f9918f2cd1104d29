-- ---- Slopes: questions about the ground ----

local SPAN = 8  -- tiles that a slope spans at most, in width and in height

local plain_sides = Terrain.sides
function Terrain:sides(column, row)
  if not self:is_detailed(column, row) then return plain_sides(self, column, row) end
  local sides = {}
  for _, piece in ipairs(self:detail(column, row).pieces) do
    if piece.solid then sides[#sides + 1] = piece end
  end
  return sides
end

-- The range of x in which a box stands on ground: the middle of its bottom, or the whole of it.
local function probe_of(x, w, on_middle, forgiven)
  if on_middle then return x + w / 2, x + w / 2 end
  return x + forgiven, x + w - forgiven
end

-- Rounding puts a box that is on a steep line far off it.
local function forgiven_by(forgiven) return forgiven + 1.0 / WELD end

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
  local off = forgiven_by(forgiven)
  for _, line in ipairs(is_floor and column.top or column.bottom) do
    local x0, x1 = max(from, left + line.x0), min(to, left + line.x1)
    if x0 <= x1 then
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
  return most > forgiven_by(forgiven)
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
