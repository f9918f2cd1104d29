-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- area(level) gives left, top, right and bottom, px, of what is used of a level, in whole screens of TIC-80.
local COLUMNS, ROWS = 30, 17  -- tiles of a screen

return function(level)
  local tile_width, tile_height = level.tile_width or 8, level.tile_height or 8  -- px
  local left, top, right, bottom = level.width, level.height, 0, 0
  local function use(column, row)
    left, top = math.min(left, math.max(0, column)), math.min(top, math.max(0, row))
    right, bottom = math.max(right, column + 1), math.max(bottom, row + 1)
  end
  for i, tile in ipairs(level.tiles) do
    if tile ~= 0 then use((i - 1) % level.width, math.floor((i - 1) / level.width)) end
  end
  for _, spawn in ipairs(level.spawns) do use(math.floor(spawn.x / tile_width), math.floor(spawn.y / tile_height)) end
  if right <= left then left, top, right, bottom = 0, 0, level.width, level.height end
  return math.floor(left / COLUMNS) * COLUMNS * tile_width, math.floor(top / ROWS) * ROWS * tile_height,
         math.min(math.ceil(right / COLUMNS) * COLUMNS, level.width) * tile_width,
         math.min(math.ceil(bottom / ROWS) * ROWS, level.height) * tile_height
end
