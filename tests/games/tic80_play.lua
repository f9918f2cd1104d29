-- A stand-in for the part of TIC-80's API that a playable cart uses. It runs the cart's TIC() with the keys
-- and the mouse of a script, and prints every body of its world after each frame: frame id x y vx vy. It
-- checks that TIC-80 would accept all that is drawn, and that the mouse is on its screen.
--   lua5.3 tic80_play.lua CART.lua FRAMES [SCRIPT.jsonl]
local held_in = dofile(arg[0]:gsub("[^/]*$", "") .. "script.lua")(arg[3])
local cells, in_map = {}, false
for line in io.lines(arg[1]) do
  if line:match("^%-%- <") then in_map = line == "-- <MAP>" end
  local row, digits = line:match("^%-%- (%d%d%d):(%x+)$")
  if in_map and row then
    for i = 1, #digits, 2 do  -- the low half of a byte comes first
      cells[tonumber(row) * 240 + i // 2] = tonumber(digits:sub(i + 1, i + 1) .. digits:sub(i, i), 16)
    end
  end
end

local drawn, held, left, top = 0, nil, 0, 0
function mget(x, y) return cells[y * 240 + x] or 0 end
function mouse()
  if not held.mouse_down then return 0, 0, false, false, false end
  local x, y = held.mouse_x - left, held.mouse_y - top
  assert(x >= 0 and x < 240 and y >= 0 and y < 136, "the script's mouse is not on the screen")
  return x, y, true, false, false
end
function btn(id) return id == 2 and held.left or id == 3 and held.right or id == 0 and held.jump or false end
function btnp() return false end
function cls(color) assert(color >= 0 and color < 16) end
function map(x, y, w, h, sx, sy, colorkey, scale, remap)
  for _, number in ipairs {x, y, w, h, sx, sy} do assert(math.type(number) == "integer") end
  assert(scale == 1 and colorkey == -1 and math.type(remap(mget(x, y))) == "integer")
  left, top = x * 8 - sx, y * 8 - sy  -- of what is shown until the next frame
end
function spr(id, x, y, colorkey)
  assert(id >= 0 and id < 512 and x == x and y == y and colorkey == 0)
  drawn = drawn + 1
end
function ttri(x1, y1, x2, y2, x3, y3, u1, v1, u2, v2, u3, v3, source, colorkey)  -- two of a body
  for _, number in ipairs {x1, y1, x2, y2, x3, y3} do assert(number == number) end
  for _, number in ipairs {u1, v1, u2, v2, u3, v3} do assert(number >= 0 and number <= 128) end
  assert(source == 0 and colorkey == 0)
  drawn = drawn + 1 / 2
end
function circ(x, y, radius, color)
  assert(x == x and y == y and radius > 0 and color >= 0 and color < 16)
  drawn = drawn + 1
end
function line(x0, y0, x1, y1, color) assert(x0 == x0 and y0 == y0 and x1 == x1 and y1 == y1 and color < 16) end
function rect(x, y, w, h, color)  -- of a player the first of four
  assert(x == x and y == y and w > 0 and h > 0 and color >= 0 and color < 16)
  drawn = drawn + 1 / 4
end

dofile(arg[1])
for frame = 1, tonumber(arg[2]) do
  held = held_in(frame)
  TIC()
  for _, b in ipairs(world.bodies) do
    print(string.format("%d %d %.17g %.17g %.17g %.17g", frame, b.id, b.x, b.y, b.vx, b.vy))
  end
end
assert(drawn == #world.bodies * tonumber(arg[2]), "not every body is drawn in every frame")
