-- Appended to a game's main.lua: draws the first screen of its level at its start, 4 px for each pixel, and
-- compares it with shot.png.
--   love GAME
local ZOOM, WIDTH, HEIGHT = 4, 240, 136
local MOST = {color = 5, at_edges = 1200, elsewhere = 10}
local load_game = love.load

function love.load()
  load_game {}
  local canvas = love.graphics.newCanvas(WIDTH * ZOOM, HEIGHT * ZOOM, {dpiscale = 1})
  love.graphics.setCanvas(canvas)
  love.graphics.clear(love.graphics.getBackgroundColor())
  love.graphics.scale(ZOOM)
  drawing.draw_ground()
  for _, body in ipairs(world.bodies) do drawing.draw_body(body) end
  drawing.draw_front()
  love.graphics.setCanvas()
  local ours = canvas:newImageData()
  local is_good, verdict = require "same_picture"(ours, love.image.newImageData("shot.png"), MOST)
  print(verdict)
  if not is_good then ours:encode("png", "ours.png") end
  love.event.quit()
end
