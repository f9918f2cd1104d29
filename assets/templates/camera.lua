-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- Where a game looks in its level. camera(level) gives the area that is used, {left, top, right, bottom} in px,
-- and a function: from the bodies and the size of the view in px, the view's top left corner. The first body
-- that takes keys, or else the first one, is in the middle as far as the area goes; an area smaller than the view is, too.
local COLUMNS, ROWS = 30, 17  -- cells of a screen of TIC-80: whole screens are shown

local function used_area(level)
  local tile_width, tile_height = level.tile_width or 8, level.tile_height or 8  -- px
  local left, top, right, bottom = level.width, level.height, 0, 0
  local function note(x, y)
    left, top = math.min(left, x), math.min(top, y)
    right, bottom = math.max(right, x + 1), math.max(bottom, y + 1)
  end
  for i, tile in ipairs(level.tiles) do
    if tile ~= 0 then note((i - 1) % level.width, math.floor((i - 1) / level.width)) end
  end
  for _, spawn in ipairs(level.spawns) do
    note(math.floor(spawn.x / tile_width), math.floor(spawn.y / tile_height))
  end
  local function whole(at, screen, most, tile) return math.max(0, math.min(at * screen, most)) * tile end
  return {left = whole(math.floor(left / COLUMNS), COLUMNS, level.width, tile_width),
          top = whole(math.floor(top / ROWS), ROWS, level.height, tile_height),
          right = whole(math.ceil(right / COLUMNS), COLUMNS, level.width, tile_width),
          bottom = whole(math.ceil(bottom / ROWS), ROWS, level.height, tile_height)}
end

local function within(at, shown, least, most)
  if most - least < shown then return (least + most - shown) / 2 end
  return math.max(least, math.min(at - shown / 2, most - shown))
end

return function(level)
  local area = used_area(level)
  return area, function(bodies, width, height)
    local seen = bodies[1] or {x = area.left, y = area.top, w = 0, h = 0}
    for i = #bodies, 1, -1 do
      local kind = level.kinds[bodies[i].kind]
      if kind and kind.takes_keys then seen = bodies[i] end
    end
    return within(seen.x + seen.w / 2, width, area.left, area.right),
           within(seen.y + seen.h / 2, height, area.top, area.bottom)
  end
end
