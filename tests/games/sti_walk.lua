-- Reads a Lua map as Simple Tiled Implementation 1.2.3 and its plugin for bump.lua do. Compares the boxes
-- that the plugin adds with those that the companion adds for the same level, number by number.
--   luajit sti_walk.lua MAP.lua FOLDER_FOR_BUMP
package.path = arg[2] .. "/?.lua;" .. arg[0]:match("^(.*/)[^/]*$") .. "?.lua"
local map = assert(loadfile(arg[1]))()
local level, slopes = require "level", require "bump_slopes"

local function number(value, what) assert(type(value) == "number", what) return value end

-- Tilesets: embedded, with a picture of whole tiles.
assert(map.orientation == "orthogonal" and map.renderorder:match "^%a+%-%a+$")
local folder = arg[1]:match("^(.*/)[^/]*$")
local function picture(name) assert(assert(io.open(folder .. name, "rb")):read(8):sub(2, 4) == "PNG", name) end
local tiles = {}
-- A collection of images: STI makes a tile of each, and wants its size.
local function collect(set, index)
  assert(set.tilecount == #set.tiles and set.tileoffset)
  for _, tile in ipairs(set.tiles) do
    picture(tile.image)
    number(tile.width, "width") number(tile.height, "height")
    tiles[set.firstgid + tile.id] = {properties = assert(tile.properties), tileset = index}
  end
end
for index, set in ipairs(map.tilesets) do
  if set.name == "pictures" then
    collect(set, index)
    break
  end
  assert(not set.filename and type(set.image) == "string")
  picture(set.image)
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
  elseif layer.type == "imagelayer" then
    picture(layer.image)
  else
    assert(layer.type == "objectgroup")
    assert(not layer.tintcolor or #layer.tintcolor == 3)
    assert(layer.name ~= "slopes" or not layer.visible, "what STI would draw over the tiles")
    local ids = {}
    for _, object in ipairs(layer.objects) do
      assert(not ids[object.id]) ids[object.id] = true
      number(object.x + object.y + object.width + object.height + math.rad(object.rotation), "object")
      assert(object.properties.collidable ~= true or object.shape == "rectangle")
      assert(not object.gid or tiles[object.gid], "a tile that no tileset has")
      for _, point in ipairs(object.polyline or {}) do number(point.x + point.y, "point") end
    end
  end
end
assert(ground.width == level.width and ground.height == level.height)
for _, gid in ipairs(ground.data) do assert(gid == 0 or tiles[gid], "no such tile") end

-- Returns what is added to a world, each box as a line of text, sorted: bump.lua gives them in no certain
-- order.
local function boxes_of(add_all)
  local lines = {}
  add_all {add = function(_, item, x, y, w, h)
    local properties = item.properties or {}
    local slope = item.slope or (properties.h0 and properties) or {}
    local is_ceiling = slope.ceiling or slope.slope == "ceiling" or false
    lines[#lines + 1] = ("%.17g %.17g %.17g %.17g: %s %s %s %s"):format(x, y, w, h, tostring(slope.h0),
      tostring(slope.h1), tostring(is_ceiling), tostring(slope.one_way or false))
  end}
  table.sort(lines)
  return lines
end
local found = boxes_of(function(world) require "sti_plugin"(map, world) end)
local expected = boxes_of(function(world) slopes.add_level(world, level) end)
for i = 1, math.max(#found, #expected) do
  if found[i] ~= expected[i] then
    error(("box %d of the map is %s instead of %s"):format(i, tostring(found[i]), tostring(expected[i])))
  end
end
print(#found .. " boxes")
