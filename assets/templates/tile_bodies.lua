-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- tile_bodies(world, name) takes the tiles that have the flag `name` out of the map, and adds a body of the kind `name`
-- in the place of each: a sensor as large as a cell. Gives the list of them, which is empty without such a flag.
return function(world, name)
  local bodies = {}
  for i, cell in ipairs(world:has_flag(name) and world:tiles_with(name) or bodies) do
    world:set_tile(cell.column, cell.row, 0, cell.layer)
    bodies[i] = world:add {kind = name, tile = cell.tile, tile_turn = cell.turn, sensor = true, x = cell.x, y = cell.y,
                           w = cell.w, h = cell.h}
  end
  return bodies
end
