-- Writes random levels with all kinds of shapes, the same levels at each call: FOLDER/random-N.talus.json.
--   lua5.3 random_shapes.lua COUNT FOLDER
local function pick(list) return list[math.random(#list)] end
local function heights(count, most)
  local all = {}
  for i = 1, count do all[i] = math.random(0, most * 4) / 4 end
  return table.concat(all, ", ")
end
local function shape()
  local kind, tiles = pick {"solid", "slope", "profile"}, math.random(3)
  local text = ('"kind": "%s", "one_way": %s'):format(kind, tostring(math.random(4) == 1))
  if kind == "solid" then return ('{%s, "side": "%s"}'):format(text, pick {"floor", "ceiling"}) end
  local count = kind == "slope" and 2 or math.random(3, 9)
  return ('{%s, "side": "%s", "tiles": %d, "heights": [%s]}'):format(
    text, pick {"floor", "floor", "ceiling"}, tiles, heights(count, pick {8, 8, 20}))
end
for n = 1, tonumber(arg[1]) do
  math.randomseed(n)
  local shapes, rows = {}, {}
  for tile = 1, 12 do shapes[tile] = ('"%d": %s'):format(tile, shape()) end
  for y = 1, 12 do
    local cells = {}
    for x = 1, 20 do cells[x] = math.random(3) == 1 and ("%02x"):format(math.random(12)) or ".." end
    rows[y] = '"' .. table.concat(cells) .. '"'
  end
  local file = assert(io.open(("%s/random-%d.talus.json"):format(arg[2], n), "w"))
  file:write(('{"talus": 1, "tuning": {"solver": "bump"}, "tile_shapes": {%s},\n' ..
              '"map": {"width": 20, "height": 12, "rows": [\n%s]}}\n'):format(table.concat(shapes, ",\n"), table.concat(rows, ",\n")))
  file:close()
end
