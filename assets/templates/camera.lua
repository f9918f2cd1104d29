-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- What a game shows of its level. local camera = require "camera"(level) has
--   camera.follow(bodies)  once a frame: looks at the first body that takes keys, or else the first one. The view rests
--                          while the body is in its dead zone, and stays in the level; a smaller level is in its middle
--   camera.begin()         from here on the game draws in px of the level, until love.graphics.pop()
--   left, top, width, height  px of the level that are seen; zoom: the window's pixels for each, a whole number
local area = require "area"
local COLUMNS, ROWS = 30, 17  -- about so many tiles fill the window; fewer of a smaller level
local DEAD_ZONE = 1 / 4       -- share of the view, in its middle

-- Where the view begins. at: what it follows; from: where it began before; it stays between least and most
local function follow(at, from, shown, least, most)
  if most - least < shown then return (least + most - shown) / 2 end
  local middle, slack = at - shown / 2, shown * DEAD_ZONE / 2
  from = math.max(middle - slack, math.min(from or middle, middle + slack))
  return math.max(least, math.min(from, most - shown))
end

return function(level)
  local camera, left, top, right, bottom = {}, area(level)

  function camera.follow(bodies)
    local seen = bodies[1] or {x = left, y = top, w = 0, h = 0}
    for i = #bodies, 1, -1 do
      if level.kinds[bodies[i].kind].takes_keys then seen = bodies[i] end
    end
    local width, height = love.graphics.getDimensions()
    local screen = math.min(width / COLUMNS / (level.tile_width or 8), height / ROWS / (level.tile_height or 8))
    local whole = math.min(width / (right - left), height / (bottom - top))
    local zoom = math.max(1, math.floor(screen + 0.5), math.floor(whole))
    local function sharp(at) return math.floor(at * zoom + 0.5) / zoom end
    camera.zoom, camera.width, camera.height = zoom, width / zoom, height / zoom
    camera.left = sharp(follow(seen.x + seen.w / 2, camera.left, camera.width, left, right))
    camera.top = sharp(follow(seen.y + seen.h / 2, camera.top, camera.height, top, bottom))
  end

  function camera.begin()
    love.graphics.push()
    love.graphics.scale(camera.zoom)
    love.graphics.translate(-camera.left, -camera.top)
  end
  return camera
end
