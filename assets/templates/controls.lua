-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- What is held for the players, on the keyboard and on gamepads: controls() gives {left, right, jump}.
local KEYS = {left = {"left", "a"}, right = {"right", "d"}, jump = {"up", "w", "space"}}
local BUTTONS = {left = {"dpleft"}, right = {"dpright"}, jump = {"a", "b"}}
local SIDES = {left = -1, right = 1, jump = 0}  -- of the left stick
local DEAD_ZONE = 0.3  -- share of the stick's way, up to which it is at rest

local function is_held(what)
  if love.keyboard.isDown(unpack(KEYS[what])) then return true end
  for _, pad in ipairs(love.joystick and love.joystick.getJoysticks() or {}) do  -- conf.lua may switch them off
    if pad:isGamepad() and (pad:isGamepadDown(unpack(BUTTONS[what]))
                            or SIDES[what] * pad:getGamepadAxis("leftx") > DEAD_ZONE) then
      return true
    end
  end
  return false
end

return function() return {left = is_held "left", right = is_held "right", jump = is_held "jump"} end
