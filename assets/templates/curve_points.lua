-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- The points of a level's curve, for drawing it: {x, y, x, y, ...}, px, every half px or closer.
local function y_at(curve, x)
  local t = (x - curve.x0) / (curve.x1 - curve.x0)
  if curve.kind == "arc" then
    local height = math.sqrt(math.max(0, curve.radius ^ 2 - (x - curve.x) ^ 2))
    return curve.upper and curve.y - height or curve.y + height
  end
  if curve.kind == "parabola" then
    return curve.y0 * (1 - t) ^ 2 + 2 * curve.control_y * t * (1 - t) + curve.y1 * t ^ 2
  end
  if curve.kind == "cubic" then
    local width = curve.x1 - curve.x0
    local rise0, rise1 = curve.slope0 * width, curve.slope1 * width
    return (1 + 2 * t) * (1 - t) ^ 2 * curve.y0 + t * (1 - t) ^ 2 * rise0 + t ^ 2 * (3 - 2 * t) * curve.y1 +
           t ^ 2 * (t - 1) * rise1
  end
  if curve.kind == "sine" then
    return curve.middle + curve.amplitude * math.sin(2 * math.pi * (x - curve.origin) / curve.wavelength)
  end
  local at = t * (#curve.ys - 1)
  local i = math.min(math.floor(at), #curve.ys - 2)
  return curve.ys[i + 1] + (curve.ys[i + 2] - curve.ys[i + 1]) * (at - i)
end

return function(curve)
  if curve.kind == "segment" then return {curve.x0, curve.y0, curve.x1, curve.y1} end
  local points, count = {}, math.ceil((curve.x1 - curve.x0) * 2)
  if curve.kind == "polyline" then count = math.max(count, 2 * #curve.ys) end
  for i = 0, count do
    local x = curve.x0 + (curve.x1 - curve.x0) * i / count
    points[#points + 1] = x
    points[#points + 1] = y_at(curve, x)
  end
  return points
end
