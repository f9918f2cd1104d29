-- What plays and draws a level in TIC-80: `talus`, `level`, `camera` and `curve_points` are there.
local TILE, WIDTH, HEIGHT = 8, 240, 136

level.tiles = {}
for y = 0, level.height - 1 do
  for x = 0, level.width - 1 do level.tiles[#level.tiles + 1] = mget(x, y) end
end
world = talus.new(level)
local _, look = camera(level)
local curves = {}
for i, curve in ipairs(level.curves) do curves[i] = curve_points(curve) end

-- The top left corner of what is shown.
local function view()
  local left, top = look(world.bodies, WIDTH, HEIGHT)
  return left // 1, top // 1
end

local function without_balls(tile)
  return level.balls[tile] and 0 or tile
end

local function draw(left, top)
  cls(0)
  local x, y = left // TILE, top // TILE
  map(x // 1 | 0, y // 1 | 0, 31, 18, -(left % TILE) // 1 | 0, -(top % TILE) // 1 | 0, -1, 1, without_balls)
  for _, points in ipairs(curves) do
    for i = 1, #points - 3, 2 do
      line(points[i] - left, points[i + 1] - top, points[i + 2] - left, points[i + 3] - top, 12)
    end
  end
  for _, body in ipairs(world.bodies) do
    if body.tile then
      spr(body.tile, body.x - left, body.y - top, 0)
    else
      rect(body.x - left, body.y - top, body.w, body.h, body.kind == "player" and 11 or 3)
    end
  end
end

function TIC()
  local left, top = view()
  local x, y, down = mouse()
  if btnp(5) then world = talus.new(level) end
  world:step {left = btn(2), right = btn(3), jump = btn(0) or btn(4), mouse_x = left + x, mouse_y = top + y,
              mouse_down = down}
  draw(view())
end
