-- ---- Cells that need more than a bit ----

-- Cells that are not full tiles, and those beside them, are compiled when they are first looked at.
function Terrain:begin()
  self.touched_top, self.touched_right, self.touched_bottom = -1, 1, 1
  for _, outline in pairs(self.outlines) do
    if outline.line then
      self.touched_top = min(self.touched_top, outline.top)
      self.touched_right = max(self.touched_right, outline.right)
      self.touched_bottom = max(self.touched_bottom, outline.bottom)
    end
  end
  self.details = {}  -- by cell: the number of things that touch it
  self.compiled = {}
  for y = 0, self.height - 1 do
    for x = 0, self.width - 1 do self:count_details(x, y, 1) end
  end
end

function Terrain:count_details(x, y, by)
  local outline = self:outline(x, y)
  if not outline or not outline.line then return end
  for cy = max(y + outline.top, 0), min(y + outline.bottom, self.height - 1) do
    for cx = max(x + outline.left, 0), min(x + outline.right, self.width - 1) do
      local cell = cy * self.width + cx
      local count = (self.details[cell] or 0) + by
      self.details[cell] = count > 0 and count or nil
    end
  end
end

function Terrain:is_detailed(x, y)
  return x >= 0 and y >= 0 and x < self.width and y < self.height and self.details[y * self.width + x] ~= nil
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

-- Forgets the cells that depend on a cell.
local function forget_around(self, x, y)
  self.some_pieces = nil
  for cy = max(y + self.touched_top, 0), min(y + self.touched_bottom, self.height - 1) do
    for cx = max(x - 1, 0), min(x + self.touched_right, self.width - 1) do
      self.compiled[cy * self.width + cx] = nil
    end
  end
end

local set_tile = Terrain.set_tile
function Terrain:set_tile(x, y, tile)
  self:count_details(x, y, -1)
  set_tile(self, x, y, tile)
  self:count_details(x, y, 1)
  forget_around(self, x, y)
end
