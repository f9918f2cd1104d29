-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- Which frame of its picture a body shows: frames(body, step) gives the tile at its top left, and whether it looks to
-- the left. A body with vx 0 looks where it went last. step: those made so far. Frames lie side by side on the sheet.
local function act_of(body)
  if body.grounded or body.vy == 0 then return math.abs(body.vx) < 1 / 16 and "stand" or "run" end
  return body.vy < 0 and "jump" or "fall"
end

return function(body, step)
  local picture = body.picture
  local act = act_of(body)
  local first, count = picture[act][1], picture[act][2]
  if body.vx ~= 0 then body.looks_left = body.vx < 0 end
  return first + math.floor(step / picture.steps) % count * picture.columns, body.looks_left
end
