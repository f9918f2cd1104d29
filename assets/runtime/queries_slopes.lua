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

-- Whether the box is in the body of a slope or profile that begins in the cell.
local function overlaps_shape(shape, column, row, x, y, w, h, is_centre, forgiven)
  local left, top = column * TILE_W, row * TILE_H
  local base = top + (shape.is_floor and TILE_H or 0.0)
  local from, to = x + forgiven, x + w - forgiven
  if is_centre and shape.is_floor then
    from = x + w / 2
    to = from
  end
  if shape.is_floor then
    if y >= base - forgiven then return false end
  elseif y + h <= base + forgiven then
    return false
  end
  for index = 0, shape.width - 1 do
    local lines = shape.is_floor and shape.columns[index].top or shape.columns[index].bottom
    for _, line in ipairs(lines) do
      local x0, x1 = max(from, left + line.x0), min(to, left + line.x1)
      if x0 <= x1 then
        -- Rounding puts a box that is on a steep line far off it. Casts forgive half of that.
        local off = 2.0 * forgiven * max(1.0, abs(line.slope))
        for n = 1, 2 do
          local height = top + line_at(line, (n == 1 and x0 or x1) - left)
          if height ~= base then
            if shape.is_floor then
              if y + h > height + off then return true end
            elseif y < height - off then
              return true
            end
          end
        end
      end
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
      if shape and shape.line and shape.solid and
          overlaps_shape(shape, column, row, x, y, w, h, is_centre, forgiven) then
        return true
      end
    end
  end
  return false
end
