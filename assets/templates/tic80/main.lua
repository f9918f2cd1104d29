-- What plays and draws a level in TIC-80. `talus`, `level` and `area` are there; and `curve_points`, `draw_picture`,
-- `draw_figure` and `take_mouse`, if the level uses them.
local TILE, WIDTH, HEIGHT = 8, 240, 136

level.tiles = {}
for y = 0, level.height - 1 do
  for x = 0, level.width - 1 do level.tiles[#level.tiles + 1] = mget(x, y) end
end
world = talus.new(level)
local area_left, area_top, area_right, area_bottom = area(level)
local curves, first_ball = {}, nil
for tile = 255, 0, -1 do
  if level.balls[tile] then first_ball = tile end
end
for i, curve in ipairs(level.curves) do curves[i] = curve_points(curve) end

local function within(at, shown, least, most)
  if most - least < shown then return (least + most - shown) // 2 end
  return math.max(least, math.min(at - shown / 2, most - shown)) // 1
end

-- The top left corner of what is shown. The first body that takes keys, or else the first one, is in the middle as
-- far as the area goes; an area smaller than the screen is, too.
local function view()
  local bodies = world.bodies
  local seen = bodies[1] or {x = area_left, y = area_top, w = 0, h = 0}
  for i = #bodies, 1, -1 do
    if level.kinds[bodies[i].kind].takes_keys then seen = bodies[i] end
  end
  return within(seen.x + seen.w / 2, WIDTH, area_left, area_right),
         within(seen.y + seen.h / 2, HEIGHT, area_top, area_bottom)
end

local function without_balls(tile)
  return level.balls[tile] and 0 or tile
end

-- As Talus's editor does it: a ball without a tile has the picture of the first ball tile, or is a disc.
local function draw_body(body, left, top)
  local x, y, w, h, tile = (body.x - left) // 1, (body.y - top) // 1, body.w, body.h, body.tile or first_ball
  local drawn_as = level.kinds[body.kind].look
  if body.picture then
    draw_picture(body, x, y, w, h)
  elseif drawn_as == "figure" and draw_figure then
    draw_figure(body, x, y, w, h)
  elseif drawn_as == "crate" then
    rect(x, y, w, h, 3)
    rectb(x, y, w, h, 2)
  elseif drawn_as == "marble" then
    local radius = math.min(w, h) / 2
    circ(x + w / 2, y + h - radius, radius, 11)
  elseif not tile then
    circ(x + w / 2, y + h / 2, w / 2, 12)
  elseif w == TILE and h == TILE then
    spr(tile, x, y, 0)
  else  -- stretched, in two triangles
    local u, v = tile % 16 * TILE, tile // 16 * TILE
    ttri(x, y, x + w, y, x, y + h, u, v, u + TILE, v, u, v + TILE, 0, 0)
    ttri(x + w, y, x, y + h, x + w, y + h, u + TILE, v, u, v + TILE, u + TILE, v + TILE, 0, 0)
  end
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
  for _, body in ipairs(world.bodies) do draw_body(body, left, top) end
end

function TIC()
  local input = {left = btn(2), right = btn(3), jump = btn(0) or btn(4)}
  if take_mouse then take_mouse(input, view()) end
  if btnp(5) then world = talus.new(level) end
  world:step(input)
  draw(view())
end
