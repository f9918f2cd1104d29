-- ---- Bodies that block one another ----

-- The cells of 16 px that a box meets.
local function block_cells(x, y, w, h)
  return floor(x / 16), floor(y / 16), floor((x + w) / 16), floor((y + h) / 16)
end

-- The other bodies that a motion, whichever way it turns, may meet; in order.
function others_near(world, body, box, x, y)
  local length = abs(x) + abs(y)
  local left, top, right, bottom = block_cells(box.x - length, box.y - length, box.w + 2 * length,
      box.h + 2 * length)
  local near = {}
  for _, other in ipairs(world.bodies) do
    if other ~= body then
      local l, t, r, b = block_cells(other.x, other.y, other.w, other.h)
      if r >= left and l <= right and b >= top and t <= bottom then near[#near + 1] = other end
    end
  end
  return near
end
