-- Appended to the main.lua of the game for LÖVE: plays it on coins.talus.json, with keys and a gamepad.
local load_game = love.load

function love.errorhandler(message) print(message) end  -- and the test ends

local function all(kind)
  local found = {}
  for _, body in ipairs(world.bodies) do
    if body.kind == kind then found[#found + 1] = body end
  end
  return found
end

function love.load()
  local now = 0  -- s
  function love.timer.getTime() return now end
  load_game {}
  local held, stick, buttons = {}, 0, {}
  local function any(names, ...)
    for _, name in ipairs {...} do
      if names[name] then return true end
    end
    return false
  end
  function love.keyboard.isDown(...) return any(held, ...) end
  local pad = {isGamepad = function() return true end, getGamepadAxis = function() return stick end,
               isGamepadDown = function(_, ...) return any(buttons, ...) end}
  local others = {isGamepad = function() return false end, isGamepadDown = function() return false end}
  function love.joystick.getJoysticks() return {others, pad} end
  local function play(frames, each)
    for _ = 1, frames do
      love.update(STEP)
      love.draw()
      if each then each() end
    end
  end

  -- Coins are in the world, and no longer in the map.
  assert(#all "coin" == 5 and #all "enemy" == 2 and game.text() == "0 of 5 coins")
  assert(world:tile_at(60, 108) == 0)

  -- How light a px of the level is.
  local function light(x, y, draw, ...)
    local canvas = love.graphics.newCanvas(1, 1, {dpiscale = 1})
    love.graphics.setCanvas(canvas)
    love.graphics.translate(-x, -y)
    draw(...)
    love.graphics.setCanvas()
    love.graphics.origin()
    local red, green, blue = canvas:newImageData():getPixel(0, 0)
    return red + green + blue
  end

  -- A coin with a picture of its own shows it, as high as it is.
  local large = all "coin"[5]
  assert(large.tile == 4 and light(large.x + 1, large.y - 7, drawing.draw_body, large) > 0.9)

  -- Others play the animation of their tile; the one at 56, 104 is turned: its top is at the bottom.
  local still, turned = all "coin"[1], all "coin"[3]
  local function coin_light(coin, y) return light(coin.x + 1, coin.y + y, drawing.draw_body, coin) end
  assert(turned.x == 56 and coin_light(still, 0) < 0.1 and coin_light(still, 7) < 0.1)
  now = 0.25
  assert(coin_light(still, 0) > 2.5 and coin_light(still, 7) < 0.1)
  assert(coin_light(turned, 0) < 0.1 and coin_light(turned, 7) > 2.5)
  now = 0
  assert(coin_light(turned, 7) < 0.1)
  still.tile = 1
  assert(coin_light(still, 0) > 0.9)
  still.tile = 2

  -- A layer called front is in front of the bodies, and no other one.
  assert(light(52, 109, drawing.draw_ground) < 0.1 and light(52, 109, drawing.draw_front) > 0.9)
  assert(light(12, 116, drawing.draw_ground) > 0.7 and light(12, 116, drawing.draw_front) < 0.1)

  -- The picture is of the world that is shown, whatever was changed in another one before.
  local one, other = talus.new(level), talus.new(level)
  one:set_tile(3, 3, 1)
  other:set_tile(5, 3, 1)
  local function ground(of, x) return light(x, 26, drawing.draw_ground, 0, 0, of) end
  assert(ground(one, 26) > 0.9 and ground(one, 42) < 0.1 and ground(other, 26) < 0.1 and ground(other, 42) > 0.9)

  -- The stick runs, a button jumps, and a pause holds the world.
  local hero, coin = world.bodies[1], all "coin"[1]
  stick = 1
  play(25)
  assert(hero.x > 50 and #all "coin" == 4 and game.text() == "1 of 5 coins")
  stick, buttons = 0, {a = true}
  play(3)
  assert(hero.vy < 0)
  local frame = world.frame
  love.gamepadpressed(pad, "start")
  play(10)
  assert(world.frame == frame)
  love.keypressed "p"
  play(1)
  assert(world.frame == frame + 1)
  buttons = {}

  -- An enemy stays on its platform, which is from 192 to 240 px.
  hero.x, hero.y, hero.clear = 300, 20, false
  local guard, left, right = all "enemy"[1], math.huge, 0
  play(400, function() left, right = math.min(left, guard.x), math.max(right, guard.x + guard.w) end)
  assert(left > 191 and left < 193 and right > 239 and right < 241, left .. " to " .. right)

  -- From above it is gone, and the player is thrown up.
  hero.x, hero.y, hero.vy, hero.clear = guard.x, guard.y - 30, 0, false
  play(15)
  assert(#all "enemy" == 1 and hero.vy < 0)

  -- By its side it ends the game, which starts again with all coins.
  local old, walker = world, all "enemy"[1]
  hero.x, hero.y, hero.vy, hero.clear = walker.x + 4, walker.y + walker.h - hero.h, 0, false
  play(1)
  assert(world ~= old and #all "coin" == 5 and #all "enemy" == 2 and game.text() == "0 of 5 coins")

  -- The view stays in the level, rests in its dead zone, and is on whole pixels.
  hero = world.bodies[1]
  assert(camera.left == 0 and camera.zoom == 4 and camera.width == 240 and camera.height == 136)
  local function look(x)
    hero.x = x - hero.w / 2
    camera.follow(world.bodies)
    return camera.left
  end
  assert(look(149) == 0 and look(151) == 1 and look(151.3) == 1.25 and look(130) == 1.25 and look(380) == 48 * 8 - 240)
  print "all is well"
  love.event.quit()
end
