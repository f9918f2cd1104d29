-- The bar below is what it stands on: all of its bottom side, or the middle of it.
local function draw_figure(body, x, y, w, h)
  rect(x, y, w, h, 10)
  for _, eye in ipairs {0.3, 0.6} do rect(x + w * eye, y + h * 0.2, math.max(1, w * 0.12), math.max(1, h * 0.25), 0) end
  local inset, foot = body.foot == "centre" and w * 0.38 or 0, math.max(1, h * 0.15)
  rect(x + inset, y + h - foot, math.max(1, w - 2 * inset), foot, 12)
end
