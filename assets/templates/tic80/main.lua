-- Arrows run, up or A jumps; the mouse drags bodies; B starts anew.
local TILE, WIDTH, HEIGHT = 8, 240, 136

level.tiles = {}
for y = 0, level.height - 1 do
  for x = 0, level.width - 1 do level.tiles[#level.tiles + 1] = mget(x, y) end
end
world = talus.new(level)

-- The top left corner of what is shown: the first player, or the first body, is in the middle.
local function camera()
  local seen = world.bodies[1] or {x = 0, y = 0, w = 0, h = 0}
  for _, body in ipairs(world.bodies) do
    if body.kind == "player" then
      seen = body
      break
    end
  end
  local function within(at, shown, whole) return math.max(0, math.min(at - shown / 2, whole - shown)) // 1 end
  return within(seen.x + seen.w / 2, WIDTH, level.width * TILE),
         within(seen.y + seen.h / 2, HEIGHT, level.height * TILE)
end

local function without_balls(tile)
  return level.balls[tile] and 0 or tile
end

local function draw(left, top)
  cls(0)
  local x, y = left // TILE, top // TILE
  map(x // 1 | 0, y // 1 | 0, 31, 18, -(left % TILE) // 1 | 0, -(top % TILE) // 1 | 0, -1, 1, without_balls)
  for _, body in ipairs(world.bodies) do
    if body.tile then
      spr(body.tile, body.x - left, body.y - top, 0)
    else
      rect(body.x - left, body.y - top, body.w, body.h, body.kind == "player" and 11 or 3)
    end
  end
end

function TIC()
  local left, top = camera()
  local x, y, down = mouse()
  if btnp(5) then world = talus.new(level) end
  world:step {left = btn(2), right = btn(3), jump = btn(0) or btn(4), mouse_x = left + x, mouse_y = top + y,
              mouse_down = down}
  draw(camera())
end
