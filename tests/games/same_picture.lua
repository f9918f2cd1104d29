-- Compares the picture of a game with that of the program, both as LÖVE's ImageData. Edges may differ by a pixel of the
-- screen, and discs in a few corners. Nothing else may differ. Gives whether they are the same, and says it in a line.
-- most: what may differ: `color`, the three parts of a pixel together, of 255; pixels `at_edges` and `elsewhere`.
local function is_same(a, b, x, y, other_x, other_y, color)
  local red, green, blue = a:getPixel(x, y)
  local other_red, other_green, other_blue = b:getPixel(other_x, other_y)
  return math.abs(red - other_red) + math.abs(green - other_green) + math.abs(blue - other_blue) < color / 255
end

-- Whether a pixel is one of those around it in the other picture.
local function is_near(a, b, x, y, color)
  for beside_y = math.max(0, y - 1), math.min(a:getHeight() - 1, y + 1) do
    for beside_x = math.max(0, x - 1), math.min(a:getWidth() - 1, x + 1) do
      if is_same(a, b, x, y, beside_x, beside_y, color) then return true end
    end
  end
  return false
end

return function(ours, wanted, most)
  local others, far = 0, 0
  for y = 0, ours:getHeight() - 1 do
    for x = 0, ours:getWidth() - 1 do
      if not is_same(ours, wanted, x, y, x, y, most.color) then
        others = others + 1
        if not is_near(ours, wanted, x, y, most.color) then far = far + 1 end
      end
    end
  end
  local is_good = far < most.elsewhere and others < most.at_edges
  local verdict = is_good and "the same" or "another"
  return is_good, ("%s picture: %d pixels at edges are others, %d elsewhere"):format(verdict, others, far)
end
