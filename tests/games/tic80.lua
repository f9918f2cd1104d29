-- A stand-in for the part of TIC-80's API that a cart of Talus uses. It loads a cart's code, runs it for a
-- number of frames with a key held, and prints the place that its last map() call showed.
--   lua5.3 tic80.lua CART.lua FRAMES KEY
local path, frames, key = arg[1], tonumber(arg[2]), tonumber(arg[3])
local shown

function cls(color) assert(color == nil or (color >= 0 and color < 16)) end
function btn(id) return id == key end
function map(x, y, w, h, sx, sy)
  assert(math.type(x) == "integer" and x >= 0 and x + w <= 241, "map() beyond the right side")
  assert(math.type(y) == "integer" and y >= 0 and y + h <= 137, "map() beyond the bottom")
  shown = string.format("%d,%d %d,%d", x, y, sx, sy)
end

dofile(path)
for _ = 1, frames do TIC() end
print(shown)
