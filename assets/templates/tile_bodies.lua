-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- tile_bodies(world, level, name) takes the tiles that have the flag `name` out of the map, and adds a body of the kind
-- `name` in the place of each: a sensor as large as a cell. Gives the list of them.
return function(world, level, name)
  local width, height, bodies = level.tile_width or 8, level.tile_height or 8, {}
  local has_flag = level.flags and level.flags[name] or {}
  for number, layer in ipairs(level.layers or {level}) do
    for i, tile in ipairs(layer.tiles or {}) do
      if has_flag[tile] then
        local column, row = (i - 1) % level.width, math.floor((i - 1) / level.width)
        world:set_tile(column, row, 0, number)
        bodies[#bodies + 1] = world:add {kind = name, tile = tile, tile_turn = layer.turns and layer.turns[i],
                                         sensor = true, x = column * width, y = row * height, w = width, h = height}
      end
    end
  end
  return bodies
end
