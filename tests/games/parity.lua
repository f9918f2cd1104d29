-- Runs levels with the runtime and prints each body after each frame: frame id x y vx vy spin turn grounded, with all
-- digits. Events come before them, if the runtime has that part: frame kind id other nx ny impulse.
--   lua5.3 parity.lua LIST
-- LIST: a file with a table of {name, runtime, level, input, frames}. The runtime is a file. Level and input
-- are functions: one returns a level, the other a table from frames to what world:step() takes. An input
-- holds until the next one.
local list = dofile(arg[1])

-- LuaJIT writes numbers below 2^-1022 in its own way: they are printed larger.
local function shown(v) return v ~= 0 and math.abs(v) < 2.0 ^ -1022 and v * 2.0 ^ 200 or v end

local runtimes = {}
setmetatable(_G, {__index = function(_, name) error("unknown name " .. name, 2) end})
for _, run in ipairs(list) do
  print("# " .. run.name)
  runtimes[run.runtime] = runtimes[run.runtime] or dofile(run.runtime)
  local world = runtimes[run.runtime].new(run.level())
  local inputs, input = run.input(), {}
  for frame = 1, run.frames do
    input = inputs[frame] or input
    world:step(input)
    for _, e in ipairs(world.events or {}) do
      print(string.format("%d %s %d %d %a %a %a", frame, e.kind, e.body.id, e.other and e.other.id or 0, e.nx or 0.0,
                          e.ny or 0.0, e.impulse or 0.0))
    end
    for _, b in ipairs(world.bodies) do
      print(string.format("%d %d %a %a %a %a %a %a %s", frame, b.id, b.x, b.y, shown(b.vx), shown(b.vy),
                          shown(b.spin or 0.0), shown(b.turn or 0.0), tostring(b.grounded)))
    end
  end
end
