-- Plays levels with LuaJIT's ffi. Prints each body after each frame, "frame id x y vx vy", and the last hash:
--   luajit ffi_play.lua HEADER LIBRARY FILE FRAMES
local ffi = require "ffi"
local header, library, path, frames = arg[1], arg[2], arg[3], tonumber(arg[4])

local file = assert(io.open(header))
local declarations = file:read("*a"):gsub("\n#ifdef.-\n#endif", ""):gsub("\n#[^\n]*", "")
file:close()
ffi.cdef(declarations)
local talus = ffi.load(library)

local message = ffi.new("char[500]")
assert(talus.talus_open("/no/such/file", message, 500) == nil)
assert(ffi.string(message):find("^/no/such/file: error: "), ffi.string(message))

local game = talus.talus_open(path, message, 500)
assert(game ~= nil, ffi.string(message))
game = ffi.gc(game, talus.talus_close)
local body = ffi.new("talus_body")
for frame = 1, frames do
  assert(talus.talus_step(game, 0, 0, 0, 0) == 1)
  assert(talus.talus_frame(game) == frame)
  for i = 0, talus.talus_body_count(game) - 1 do
    assert(talus.talus_body_at(game, i, body) == 1)
    print(string.format("%d %d %.17g %.17g %.17g %.17g", frame, body.id, body.x, body.y, body.vx, body.vy))
  end
end
print(bit.tohex(talus.talus_hash(game)))
