-- ---- Bodies that block one another ----
has.pairs = true

local BLOCK = 16  -- px, side of the cells in which bodies are kept

-- The cells that a box meets.
local function block_cells(x, y, w, h)
  return floor(x / BLOCK), floor(y / BLOCK), floor((x + w) / BLOCK), floor((y + h) / BLOCK)
end

-- The other bodies that a motion may meet, whichever way it turns; in order.
function World:others(body, box, x, y)
  if self.tuning.bodies == "pass" then return nil end
  local length = abs(x) + abs(y)
  local left, top, right, bottom = block_cells(box.x - length, box.y - length, box.w + 2 * length,
                                               box.h + 2 * length)
  local near = {}
  for _, other in ipairs(self.bodies) do
    if other ~= body then
      local l, t, r, b = block_cells(other.x, other.y, other.w, other.h)
      if r >= left and l <= right and b >= top and t <= bottom then near[#near + 1] = other end
    end
  end
  return near
end

-- They stop the box of a cast as tiles do.
function World.against_others(others)
  for _, body in ipairs(others) do
    other = body
    local x, y = other.x, other.y
    local right, bottom = x + other.w, y + other.h
    if dy > 0 then flat(true, y, x, right, true, true, nil) end
    if dy < 0 then flat(false, bottom, x, right, true, true, nil) end
    if dx > 0 then wall(LEFT, x, y, bottom, true, true, nil) end
    if dx < 0 then wall(RIGHT, right, y, bottom, true, true, nil) end
  end
end
