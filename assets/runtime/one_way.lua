-- ---- One-way ground: it stops only what comes from its open side ----
has.one_way = true

local outline_of = Terrain.outline_of
function Terrain.outline_of(shape)
  local out = outline_of(shape)
  if shape.one_way then out.full, out.line, out.solid = false, true, false end
  return out
end
