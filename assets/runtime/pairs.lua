-- ---- Bodies that block one another ----
has.pairs = true

local BLOCK = 16  -- px, side of the cells in which bodies are kept

local function block_start(at) return floor(at / BLOCK) * BLOCK end

-- The other bodies that a motion may meet, whichever way it turns; in order. They are in cells that its way meets.
function World:others(body, box, x, y)
  if self.tuning.bodies == "pass" then return nil end
  local length = abs(x) + abs(y)
  local left, top = block_start(box.x - length), block_start(box.y - length)
  local right = block_start(box.x - length + (box.w + 2 * length)) + BLOCK
  local bottom = block_start(box.y - length + (box.h + 2 * length)) + BLOCK
  local near, bodies = {}, self.bodies
  for i = 1, #bodies do
    local other = bodies[i]
    if other.x + other.w >= left and other.x < right and other.y + other.h >= top and other.y < bottom and
        other ~= body then
      near[#near + 1] = other
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
