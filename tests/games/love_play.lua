-- Appended to a game's main.lua: plays a script with LÖVE's keyboard and mouse, and prints every body after
-- each frame: frame id x y vx vy. Writes the input of the game's world as lines of JSON, as `talus sim
-- --input` takes them. The mouse is on whole pixels of the screen; the game computes its place in the level.
--   love GAME script.lua SCRIPT.jsonl FRAMES GIVEN.jsonl
local load_game = love.load
local function record(file, frame, input)
  local keys = {}
  for _, key in ipairs {"left", "right", "jump"} do
    if input[key] then keys[#keys + 1] = '"' .. key .. '"' end
  end
  file:write(string.format('{"frame":%d,"mouse":[%.17g,%.17g],"down":%s,"keys":[%s]}\n', frame, input.mouse_x,
                           input.mouse_y, tostring(input.mouse_down), table.concat(keys, ",")))
end

function love.load(arguments)
  load_game {}
  local held_in, held = dofile(arguments[1])(arguments[2]), nil
  local names = {left = "left", right = "right", up = "jump"}
  function love.keyboard.isDown(...)
    for _, key in ipairs {...} do
      if held[names[key]] then return true end
    end
    return false
  end
  function love.mouse.isDown() return held.mouse_down end
  function love.mouse.getPosition()
    return math.floor((held.mouse_x - camera.left) * camera.zoom),
           math.floor((held.mouse_y - camera.top) * camera.zoom)
  end

  local given, step = io.open(arguments[4], "w"), world.step
  function world:step(input)
    record(given, self.frame + 1, input)
    step(self, input)
  end
  for frame = 1, tonumber(arguments[3]) do
    held = held_in(frame)
    love.update(STEP)
    assert(world.frame == frame)
    for _, b in ipairs(world.bodies) do
      print(string.format("%d %d %.17g %.17g %.17g %.17g", frame, b.id, b.x, b.y, b.vx, b.vy))
    end
  end
  given:close()
  love.event.quit()
end
