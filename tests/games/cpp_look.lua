-- The main.lua of a folder with ours.bmp, which a game in C++ has drawn by SDL's software renderer, and shot.png: compares
-- them. That renderer rounds the parts of half clear colours down, and edges of bodies to the left and up.
--   love FOLDER
function love.load()
  local _, verdict = require "same_picture"(love.image.newImageData "ours.bmp", love.image.newImageData "shot.png",
                                            {color = 8, at_edges = 1600, elsewhere = 40})
  print(verdict)
  love.event.quit()
end
