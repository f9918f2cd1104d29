-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- What is held for the players, on the keyboard and on all gamepads: controls() gives {left, right, jump}.
local DEAD_ZONE = 0.3  -- share of the left stick's way, up to which it is at rest

return function()
  local is_down = love.keyboard.isDown
  local held = {left = is_down("left", "a"), right = is_down("right", "d"), jump = is_down("up", "w", "space")}
  for _, pad in ipairs(love.joystick and love.joystick.getJoysticks() or {}) do  -- conf.lua may switch them off
    local x = pad:isGamepad() and pad:getGamepadAxis("leftx") or 0
    held.left = held.left or x < -DEAD_ZONE or pad:isGamepadDown("dpleft")
    held.right = held.right or x > DEAD_ZONE or pad:isGamepadDown("dpright")
    held.jump = held.jump or pad:isGamepadDown("a", "b")
  end
  return held
end
