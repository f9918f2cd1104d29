-- A stand-in for Simple Tiled Implementation 1.2.3, written from its documentation: what the lines of docs/engines.md use
-- of it. It needs of a map what STI needs, and draws the tiles of the layers that are shown.
return function(path, plugins)
  assert(plugins[1] == "bump")
  local map = assert(love.filesystem.load(path))()
  local images, quads, first = {}, {}, {}
  for _, set in ipairs(map.tilesets) do
    assert(set.image and not set.filename, "a tileset in the map")
    local image = love.graphics.newImage(set.image)
    assert(image:getWidth() == set.imagewidth and image:getHeight() == set.imageheight)
    for id = 0, set.tilecount - 1 do
      local x, y = id % set.columns * set.tilewidth, math.floor(id / set.columns) * set.tileheight
      images[set.firstgid + id] = image
      quads[set.firstgid + id] = love.graphics.newQuad(x, y, set.tilewidth, set.tileheight, image:getDimensions())
    end
  end
  for i = 1, #map.layers do map.layers[map.layers[i].name] = map.layers[i] end
  function map:bump_init(world) require "sti_plugin"(self, world) end
  function map:draw()
    for _, layer in ipairs(self.layers) do
      for i, gid in ipairs(layer.visible and layer.data or {}) do
        local x, y = (i - 1) % layer.width * self.tilewidth, math.floor((i - 1) / layer.width) * self.tileheight
        if gid > 0 then love.graphics.draw(images[gid], quads[gid], x, y) end
      end
    end
  end
  return map
end
