-- ---- What the level says beside its ground: tiles, flags and objects ----
has.data = true

-- In a function, as a module has room for 200 local variables.
function World.begin_data()

-- Tells a name that is wrong, and those that there are. depth: of the function that the game called.
local function no_name(what, name, names, depth)
  for i, one in ipairs(names) do names[i] = ("%q"):format(one) end
  local all = #names > 0 and table.concat(names, ", ") or "none"
  error(("no %s %q; this level names %s"):format(what, tostring(name), all), depth + 1)
end

-- The layers of tiles, from the back to the front. Without a list of them the ground is the only one.
local function tile_layers(level)
  if not level.layers then return {{name = level.layer_name, number = 1, ground = true}} end
  local layers = {}
  for number, layer in ipairs(level.layers) do
    if layer.tiles then
      layers[#layers + 1] = {name = layer.name, number = number, ground = layer.ground, tiles = layer.tiles,
                             turns = layer.turns}
    end
  end
  return layers
end

-- depth: of the function that the game called; left out: 3
local function layer_of(world, layer, depth)
  for _, one in ipairs(world.layers) do
    if one.name == layer or one.number == layer then return one end
  end
  local names = {}
  for _, one in ipairs(world.layers) do names[#names + 1] = one.name end
  no_name("layer of tiles", layer, names, depth or 3)
end

-- The number of the cell at a point, from 0; nil beside the map.
local function cell_at(world, x, y)
  if type(x) ~= "number" or type(y) ~= "number" then
    error(("a point is two numbers, x and y in px, not %s and %s"):format(tostring(x), tostring(y)), 3)
  end
  local terrain = world.terrain
  local column, row = floor(x / terrain.tile_w), floor(y / terrain.tile_h)
  if not (column >= 0 and row >= 0 and column < terrain.width and row < terrain.height) then return nil end
  return row * terrain.width + column
end

-- A tile of the ground that is a body leaves its cell.
local function tile_in(world, layer, cell)
  local tile = layer.tiles and layer.tiles[cell + 1] or world.terrain.tiles[cell]
  return layer.ground and world.level.balls[tile] and 0 or tile
end

-- The number of the tile at a point, in a layer, by its name or its number in level.layers; without one the foremost
-- tile there that is not 0. Beside the map it is nil.
function World:tile_at(x, y, layer)
  local cell = cell_at(self, x, y)
  local one = layer ~= nil and layer_of(self, layer)
  if not cell then return nil end
  if one then return tile_in(self, one, cell) end
  for i = #self.layers, 1, -1 do
    local tile = tile_in(self, self.layers[i], cell)
    if tile ~= 0 then return tile end
  end
  return 0
end

-- ---- Tiles that the game changes ----

local function is_same(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b end
  for key, value in pairs(a) do
    if not is_same(value, b[key]) then return false end
  end
  for key in pairs(b) do
    if a[key] == nil then return false end
  end
  return true
end

-- What is ground in a cell, of all layers of ground from the back to the front: a list of tile, turn and shape. Of
-- tiles with the same shape the one in front stays. last: the tile of the layer of ground in front. new, new_tile: a
-- layer, and what it shall have there; may be missing
local function stack_in(level, layers, cell, new, new_tile)
  local stack = {}
  for _, layer in ipairs(layers) do
    local tile, turn = layer.tiles[cell + 1], layer.turns and layer.turns[cell + 1] or 0
    if layer == new then tile, turn = new_tile, 0 end
    local shape = layer.ground and level.shapes[tile]
    if layer.ground then stack.last = tile end
    if shape then
      for i = #stack, 1, -1 do
        local behind = stack[i]
        local is_hidden = behind.turn == turn and (behind.tile == tile or turn == 0 and is_same(behind.shape, shape))
        if is_hidden then table.remove(stack, i) end
      end
      stack[#stack + 1] = {tile = tile, turn = turn, shape = shape}
    end
  end
  return stack
end

local function name_of(stack)
  local names = {}
  for i, one in ipairs(stack) do names[i] = one.turn == 0 and one.tile or one.tile .. " turned by " .. one.turn end
  return table.concat(names, ", ")
end

-- Whether objects of the level are ground, too.
local function has_object_ground(level)
  for _, object in ipairs(level.objects or {}) do
    if object.ground then return true end
  end
  return false
end

-- The tiles of the ground that stand for the stacks of a level, by their names: those that a cell of it has.
local function known_stacks(level)
  local known, layers = {}, tile_layers(level)
  for cell = 0, level.width * level.height - 1 do
    known[name_of(stack_in(level, layers, cell))] = level.tiles[cell + 1]
  end
  return known
end

-- The tile of the ground that stands for a stack; nil if the level has no such tile.
local function tile_of(world, stack)
  if #stack == 0 then return stack.last end
  if #stack == 1 and stack[1].turn == 0 then return stack[1].tile end
  if has_object_ground(world.level) then return nil end  -- objects may be in any of the level's stacks
  world.stacks = world.stacks or known_stacks(world.level)
  return world.stacks[name_of(stack)]
end

-- The tile of the ground in a cell where a layer gets another tile.
local function composed(world, column, row, layer, tile)
  local level, cell = world.level, row * world.terrain.width + column
  local function fail(reason)
    error(("the ground of cell %d, %d cannot be changed: %s"):format(column, row, reason), 4)
  end
  if has_object_ground(level) then
    local was, shown = tile_of(world, stack_in(level, world.layers, cell)), world.terrain.tiles[cell]
    local is_empty = was and not level.shapes[was] and not level.shapes[shown]
    if was ~= shown and not is_empty then fail "an object of the level may be ground there" end
  end
  local stack = stack_in(level, world.layers, cell, layer, tile)
  return tile_of(world, stack) or
         fail("it would be the tiles " .. name_of(stack) .. " at once, which no cell of the level is")
end

local function is_whole(number) return type(number) == "number" and number >= 0 and number % 1 == 0 end

local function copy_of(list)
  local copy = {}
  for i, value in ipairs(list) do copy[i] = value end
  return copy
end

-- The layer that the game changes: the one that it names, or the only one of ground.
local function layer_to_change(world, layer)
  if layer ~= nil then return layer_of(world, layer, 4) end
  local found
  for _, one in ipairs(world.layers) do
    if one.ground and found then error("the level has several layers of ground: name the layer", 3) end
    if one.ground then found = one end
  end
  if not found then error("the level has no layer of ground: name the layer", 3) end
  return found
end

-- Puts a tile, not turned, into a cell, column and row from 0, of a layer; without one, of the only layer of ground.
-- The level itself keeps its tiles. world.changes counts the calls.
function World:set_tile(column, row, tile, layer)
  local one, terrain = layer_to_change(self, layer), self.terrain
  if not (is_whole(column) and is_whole(row) and column < terrain.width and row < terrain.height) then
    error(("the level has no cell %s, %s"):format(tostring(column), tostring(row)), 2)
  end
  if not is_whole(tile) then error("a tile is a number from 0, not " .. tostring(tile), 2) end
  local cell = row * terrain.width + column
  if one.ground then terrain:set_tile(column, row, one.tiles and composed(self, column, row, one, tile) or tile) end
  if one.tiles then
    if not one.is_own then
      one.tiles, one.turns, one.is_own = copy_of(one.tiles), one.turns and copy_of(one.turns), true
    end
    one.tiles[cell + 1] = tile
    if one.turns then one.turns[cell + 1] = 0 end
  end
  self.changes = self.changes + 1
end

-- The tiles of a layer, and how they are turned, or nil: lists, row by row, which must not be changed.
function World:tiles_of(layer)
  local one, tiles = layer_of(self, layer), {}
  if one.tiles then return one.tiles, one.turns end
  for cell = 0, self.terrain.width * self.terrain.height - 1 do tiles[cell + 1] = self.terrain.tiles[cell] end
  return tiles
end

local function has_flag(flags, flag) return floor(flags / 2 ^ flag) % 2 == 1 end

-- The flags of both numbers. Each sum is made once, as games ask for the same ones again and again.
local sums = {}
local function both(a, b)
  if a == 0 or a == b then return b end
  local of_a = sums[a] or {}
  sums[a] = of_a
  if not of_a[b] then
    local sum = 0
    for flag = 0, 31 do
      if has_flag(a, flag) or has_flag(b, flag) then sum = sum + 2 ^ flag end
    end
    of_a[b] = sum
  end
  return of_a[b]
end

local function flag_names(level)
  local names, is_there = {}, {}
  for _, name in pairs(level.flag_names or {}) do
    if not is_there[name] then names[#names + 1] = name end
    is_there[name] = true
  end
  table.sort(names)
  return names
end

-- A set of flags: true or false by number and by name. To ask it for another name is an error.
local function new_set(world, flags)
  local set = {}
  for flag = 0, 31 do
    local name = world.level.flag_names and world.level.flag_names[flag]
    set[flag] = has_flag(flags, flag)
    if name then set[name] = set[name] or set[flag] end
  end
  return setmetatable(set, world.no_flag)
end

local function set_of(world, flags)
  local set = world.flag_sets[flags]
  if not set then
    set = new_set(world, flags)
    world.flag_sets[flags] = set
  end
  return set
end

-- The flags of the tile at a point, in a layer or, without one, of the tiles of all layers: flags_at(x, y).ladder, or
-- flags_at(x, y)[3] by number. The same flags are the same table, which must not be changed.
function World:flags_at(x, y, layer)
  local cell = cell_at(self, x, y)
  local one = layer ~= nil and layer_of(self, layer)
  local flags, of_tiles = 0, self.level.tile_flags or {}
  if cell and one then
    flags = of_tiles[tile_in(self, one, cell)] or 0
  elseif cell then
    for _, each in ipairs(self.layers) do flags = both(flags, of_tiles[tile_in(self, each, cell)] or 0) end
  end
  return set_of(self, flags)
end

-- Whether the level has a flag of this name.
function World:has_flag(name) return rawget(set_of(self, 0), name) ~= nil end

-- A list of the cells of all layers whose tile has a flag, from the back to the front and row by row: column and row,
-- from 0; the number of their layer; tile, and how it is turned; x, y, w and h, px, of the cell.
function World:tiles_with(flag)
  if not self:has_flag(flag) then no_name("flag", flag, flag_names(self.level), 2) end
  local found, terrain, of_tiles = {}, self.terrain, self.level.tile_flags or {}
  local w, h = terrain.tile_w, terrain.tile_h
  for _, layer in ipairs(self.layers) do
    for cell = 0, terrain.width * terrain.height - 1 do
      local tile = tile_in(self, layer, cell)
      if set_of(self, of_tiles[tile] or 0)[flag] then
        local column, row = cell % terrain.width, floor(cell / terrain.width)
        found[#found + 1] = {column = column, row = row, layer = layer.number, tile = tile,
                             turn = layer.turns and layer.turns[cell + 1] or 0,
                             x = column * w, y = row * h, w = w, h = h}
      end
    end
  end
  return found
end

-- The objects of the level that have this class, name and layer, from the back to the front; all may be missing. They
-- are tables of level.objects.
function World:objects(like)
  local found = {}
  if type(like or found) ~= "table" then
    error(("objects are found by a table, such as {class = %q}"):format(tostring(like)), 2)
  end
  for key in pairs(like or found) do
    if key ~= "class" and key ~= "name" and key ~= "layer" then
      error(("objects have no %q to be found by, but class, name and layer"):format(tostring(key)), 2)
    end
  end
  for _, object in ipairs(self.level.objects or {}) do
    local is_like = true
    for key, value in pairs(like or {}) do is_like = is_like and object[key] == value end
    if is_like then found[#found + 1] = object end
  end
  return found
end

local place_tiles = World.place_tiles
function World:place_tiles(level)
  self.level, self.layers, self.flag_sets, self.changes = level, tile_layers(level), {}, 0
  self.no_flag = {__index = function(_, flag) no_name("flag", flag, flag_names(level), 2) end}
  place_tiles(self, level)
end

end

World.begin_data()
