-- ---- Terrain: the cells of a level, and which of them are outline ----

-- What a tile of a shape adds to the outline. Here every shape is a full tile.
function Terrain.outline_of() return {full = true} end

-- Called when the tiles are known.
function Terrain:begin() end

-- Each question of the world begins with it: worlds may have cells of different sizes.
function Terrain:use() TILE_W, TILE_H = self.tile_w, self.tile_h end

local function new_terrain(level)
  local terrain = setmetatable({width = level.width, height = level.height, tiles = {}, outlines = {},
                                tile_w = (level.tile_width or 8) + 0.0,  -- px
                                tile_h = (level.tile_height or 8) + 0.0}, Terrain)
  terrain:use()
  for i = 1, level.width * level.height do terrain.tiles[i - 1] = level.tiles[i] end
  for tile, shape in pairs(level.shapes) do terrain.outlines[tile] = Terrain.outline_of(shape) end
  terrain:begin(level)
  return terrain
end

-- What a tile adds to the outline; nil: nothing is there.
function Terrain:outline(x, y)
  if x < 0 or y < 0 or x >= self.width or y >= self.height then return nil end
  return self.outlines[self.tiles[y * self.width + x]]
end
function Terrain:is_solid(x, y)
  local outline = self:outline(x, y)
  return outline ~= nil and outline.full
end

-- Whether the outline in a cell is more than the sides of a full tile.
function Terrain:is_detailed() return false end

-- Whether there is any such cell.
function Terrain:has_pieces() return false end

-- Gives a cell another tile.
function Terrain:set_tile(x, y, tile)
  local cell = y * self.width + x
  if x < 0 or x >= self.width or y % 1 ~= 0 or not self.tiles[cell] then
    error("the level has no cell " .. x .. ", " .. y, 2)
  end
  self.tiles[cell] = tile
end
