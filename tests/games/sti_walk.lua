-- Goes through a Lua map as Simple Tiled Implementation 1.2.3 and its plugin for bump.lua do, and compares what its
-- tiles say of slopes with the level of the Lua runtime, pixel by pixel.
--   luajit sti_walk.lua MAP.lua FOLDER_OF_THE_RUNTIME
local map = assert(loadfile(arg[1]))()
local level = assert(loadfile(arg[2] .. "/level.lua"))()

local function number(value, what) assert(type(value) == "number", what) return value end

-- Tilesets: embedded, with a picture of whole tiles.
assert(map.orientation == "orthogonal" and map.renderorder == "right-down")
local tiles = {}
for index, set in ipairs(map.tilesets) do
  assert(not set.filename and type(set.image) == "string")
  number(set.spacing, "spacing") number(set.margin, "margin")
  assert(set.imagewidth % set.tilewidth == 0 and set.imageheight % set.tileheight == 0)
  local count = set.imagewidth / set.tilewidth * (set.imageheight / set.tileheight)
  assert(count == set.tilecount)
  for id = 0, count - 1 do
    local tile = {properties = {}, offset = assert(set.tileoffset, "tileoffset"), tileset = index}
    number(tile.offset.x, "offset") number(tile.offset.y, "offset")
    tiles[set.firstgid + id] = tile
  end
  for _, tile in pairs(set.tiles) do
    tiles[set.firstgid + tile.id].properties = assert(tile.properties, "properties of a tile")
    for _, object in ipairs(tile.objectGroup and tile.objectGroup.objects or {}) do
      assert(object.properties.collidable == nil, "outlines would be bodies too")
      assert(object.shape == "rectangle" or (object.shape == "polygon" and #object.polygon >= 3))
    end
  end
end

-- Layers.
local ground
for _, layer in ipairs(map.layers) do
  assert(layer.properties.collidable == nil, "the layer would be a body too")
  number(layer.x + layer.offsetx + layer.y + layer.offsety + layer.opacity, "place")
  if layer.type == "tilelayer" then
    assert(layer.encoding == "lua" and not layer.chunks and #layer.data == layer.width * layer.height)
    ground = layer
  else
    assert(layer.type == "objectgroup")
    local ids = {}
    for _, object in ipairs(layer.objects) do
      assert(not ids[object.id]) ids[object.id] = true
      number(object.x + object.y + object.width + object.height + math.rad(object.rotation), "object")
      assert(object.properties.collidable ~= true)
      for _, point in ipairs(object.polyline or {}) do number(point.x + point.y, "point") end
    end
  end
end
assert(ground.width == level.width and ground.height == level.height)

-- Which pixels of a cell a shape covers: its height at a column, from the cell's bottom or top.
local function cover(grid, cx, cy, side, height)
  for px = 0, 7 do
    local h = height(px + 0.5)
    for py = 0, 7 do
      local from_base = side == "ceiling" and py + 0.5 or 7.5 - py
      if from_base < h then grid[(cy * 8 + py) * level.width * 8 + cx * 8 + px] = true end
    end
  end
end
local function between(heights, width, x)
  local at = x / width * (#heights - 1)
  local i = math.min(math.floor(at), #heights - 2)
  return heights[i + 1] + (heights[i + 2] - heights[i + 1]) * (at - i)
end

local expected, found = {}, {}
for cell = 0, level.width * level.height - 1 do
  local cx, cy = cell % level.width, math.floor(cell / level.width)
  local shape = level.shapes[level.tiles[cell + 1]]
  if shape and not shape.one_way then
    local tiles_wide, up = shape.tiles or 1, shape.side == "ceiling" and 1 or -1
    for column = 0, tiles_wide - 1 do
      for row = 0, 8 do
        local x, y = cx + column, cy + up * row
        if x < level.width and y >= 0 and y < level.height then
          cover(expected, x, y, shape.side, function(px)
            if shape.kind == "solid" then return row == 0 and 8 or 0 end
            return between(shape.heights, tiles_wide * 8, column * 8 + px) - row * 8
          end)
        end
      end
    end
  end
  local gid = ground.data[cell + 1]
  local properties = gid > 0 and assert(tiles[gid], "no tile").properties or {}
  if properties.collidable and not properties.one_way then
    local heights = {properties.h0 or 8, properties.h1 or 8}
    if properties.heights then
      heights = {}
      for word in properties.heights:gmatch("%S+") do heights[#heights + 1] = assert(tonumber(word)) end
    end
    cover(found, cx, cy, properties.slope, function(px) return between(heights, 8, px) end)
  end
end
for pixel = 0, level.width * level.height * 64 - 1 do
  if expected[pixel] ~= found[pixel] then
    error(("pixel %d, %d: ground %s, and in the map %s"):format(pixel % (level.width * 8),
      math.floor(pixel / (level.width * 8)), tostring(expected[pixel]), tostring(found[pixel])))
  end
end
