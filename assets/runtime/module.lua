-- ---- The module ----

local talus = {parts = has}

-- Makes a world from an exported level: width, height, in cells; tile_width, tile_height, of a cell in px (8);
-- tiles, row by row; shapes, by tile; balls, the kinds of the tiles that are bodies; curves; spawns; kinds, by
-- name: rule, w, h, foot; tuning; parts, the names of the parts that it needs.
function talus.new(level)
  for _, part in ipairs(level.parts or {}) do
    if not has[part] then error("the level needs a part that is not in this module: " .. part, 2) end
  end
  local world = setmetatable({frame = 0, bodies = {}, tuning = {}, kinds = level.kinds}, World)
  for key, value in pairs(level.tuning) do
    world.tuning[key] = type(value) == "number" and value + 0.0 or value
  end
  world.terrain = new_terrain(level)
  world:place_tiles(level)
  for _, spawn in ipairs(level.spawns) do
    local body = {}
    for key, value in pairs(spawn) do body[key] = value end
    world:add(body)
  end
  return world
end

return talus
