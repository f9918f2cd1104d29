-- ---- Terrain: the cells of a level, and what of them is outline ----

local Terrain = {}
Terrain.__index = Terrain

local function new_terrain(level)
  local terrain = setmetatable({width = level.width, height = level.height, tiles = {}, outlines = {}},
      Terrain)
  for i = 1, level.width * level.height do terrain.tiles[i - 1] = level.tiles[i] end
  for tile, shape in pairs(level.shapes) do
    terrain.outlines[tile] = outline_of and outline_of(shape) or {full = true}
  end
  if terrain.begin_outline then terrain:begin_outline(level) end
  return terrain
end

-- What a tile is to the outline; nil: nothing is there.
function Terrain:outline(x, y)
  if x < 0 or y < 0 or x >= self.width or y >= self.height then return nil end
  return self.outlines[self.tiles[y * self.width + x]]
end
function Terrain:is_solid(x, y)
  local outline = self:outline(x, y)
  return outline ~= nil and outline.full
end
