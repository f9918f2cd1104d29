-- A stand-in for STI's plugin for bump.lua, written from its documentation. It adds to a world each tile of a
-- map, and each rectangle of the map's object layers, that has the property `collidable`.
return function(map, world)
  local set = map.tilesets[1]
  local properties = {}
  for _, tile in ipairs(set.tiles) do properties[set.firstgid + tile.id] = tile.properties end
  for _, layer in ipairs(map.layers) do
    for i, gid in ipairs(layer.data or {}) do
      local of_tile = properties[gid]
      if of_tile and of_tile.collidable == true then
        local x, y = (i - 1) % layer.width * map.tilewidth, math.floor((i - 1) / layer.width) * map.tileheight
        world:add({properties = of_tile}, x, y, map.tilewidth, map.tileheight)
      end
    end
    for _, object in ipairs(layer.objects or {}) do
      if object.properties.collidable == true and object.shape == "rectangle" then
        world:add({properties = object.properties}, object.x, object.y, object.width, object.height)
      end
    end
  end
end
