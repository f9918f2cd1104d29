-- Appended to the small game of docs/runtime.md: plays it on coins.talus.json, a step an update.
local load_game = love.load

function love.errorhandler(message) print(message) end  -- and the test ends

local function count(kind)
  local found = 0
  for _, body in ipairs(world.bodies) do found = found + (body.kind == kind and 1 or 0) end
  return found
end

function love.load()
  load_game()
  local held, sounds = {}, 0
  function love.keyboard.isDown(...)
    for _, key in ipairs {...} do
      if held[key] then return true end
    end
    return false
  end
  thud = {play = function() sounds = sounds + 1 end}
  local function play(frames, key)
    held = {[key or ""] = true}
    for _ = 1, frames do
      love.update(1 / 60)
      love.draw()
    end
  end

  assert(count "coin" == 5 and count "enemy" == 2)
  play(30)
  assert(sounds == 1, "the player and nobody else has landed")
  play(20, "right")
  assert(count "coin" == 4, "the first coin is collected")
  local enemy = enemies[2]
  assert(enemy.vx < 0 and enemy.y + enemy.h == 112, "the enemy on the ground goes to the left")
  play(120)
  assert(enemy.vx > 0, "the enemy has turned at the wall")
  held = {}
  play(1, "up")
  play(60)
  assert(sounds == 2 and camera.left == 0)
  play(200, "right")
  assert(camera.left > 20, "the camera has followed")
  print "all is well"
  love.event.quit()
end
