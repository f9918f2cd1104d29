-- The frame stands on the bottom of the box, in its middle.
local function draw_picture(body, x, y, w, h)
  local picture, frame, looks_left = body.picture, frames(body, world.frame)
  local number = frame + (picture.sheet and 256 or 0)  -- sprites come behind the tiles
  spr(number, x + (w - picture.columns * 8) // 2, y + h - picture.rows * 8, 0, 1, looks_left and 1 or 0, 0,
      picture.columns, picture.rows)
end
