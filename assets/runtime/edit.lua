-- Gives a cell another tile.
function Terrain:set_tile(x, y, tile)
  if self.count_details then
    self:count_details(x, y, -1)
    self.tiles[y * self.width + x] = tile
    self:count_details(x, y, 1)
    self:forget_around(x, y)
  else
    self.tiles[y * self.width + x] = tile
  end
end
