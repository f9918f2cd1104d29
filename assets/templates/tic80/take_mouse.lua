-- Adds the mouse to what a step takes, as a point of the level. left, top: px, the corner of what is shown.
local function take_mouse(input, left, top)
  local x, y, down = mouse()
  input.mouse_x, input.mouse_y, input.mouse_down = left + x, top + y, down
end
