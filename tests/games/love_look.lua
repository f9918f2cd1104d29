-- Appended to a game's main.lua: draws the first screen of its level at its start, 4 px for each pixel, and
-- compares it with shot.png. Edges may differ by a pixel of the screen, and discs in a few corners. Nothing
-- else may differ.
--   love GAME
local ZOOM, WIDTH, HEIGHT = 4, 240, 136
local load_game = love.load

local function is_same(a, b, x, y)
  local r, g, blue = a:getPixel(x, y)
  local other_r, other_g, other_b = b:getPixel(x, y)
  return math.abs(r - other_r) + math.abs(g - other_g) + math.abs(blue - other_b) < 5 / 255
end

-- Whether a pixel is the same in the other picture at the same place, or one pixel beside it.
local function is_near(a, b, x, y)
  for beside_y = math.max(0, y - 1), math.min(HEIGHT * ZOOM - 1, y + 1) do
    for beside_x = math.max(0, x - 1), math.min(WIDTH * ZOOM - 1, x + 1) do
      local r, g, blue = a:getPixel(x, y)
      local other_r, other_g, other_b = b:getPixel(beside_x, beside_y)
      if math.abs(r - other_r) + math.abs(g - other_g) + math.abs(blue - other_b) < 5 / 255 then return true end
    end
  end
  return false
end

function love.load()
  load_game {}
  local canvas = love.graphics.newCanvas(WIDTH * ZOOM, HEIGHT * ZOOM, {dpiscale = 1})
  love.graphics.setCanvas(canvas)
  love.graphics.clear(love.graphics.getBackgroundColor())
  love.graphics.scale(ZOOM)
  drawing.draw_ground()
  for _, body in ipairs(world.bodies) do drawing.draw_body(body) end
  love.graphics.setCanvas()
  local ours, wanted = canvas:newImageData(), love.image.newImageData("shot.png")
  local others, far = 0, 0
  for y = 0, HEIGHT * ZOOM - 1 do
    for x = 0, WIDTH * ZOOM - 1 do
      if not is_same(ours, wanted, x, y) then
        others = others + 1
        if not is_near(ours, wanted, x, y) then far = far + 1 end
      end
    end
  end
  local is_good = far < 10 and others < 1200
  local verdict = is_good and "the same" or "another"
  print(("%s picture: %d pixels at edges are others, %d elsewhere"):format(verdict, others, far))
  if not is_good then ours:encode("png", "ours.png") end
  love.event.quit()
end
