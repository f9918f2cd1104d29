-- ---- One-way ground: it stops only what comes from its open side ----
has.one_way = true

local outline_of = Terrain.outline_of
function Terrain.outline_of(shape)
  local out = outline_of(shape)
  if not shape.one_way then return out end
  out.full, out.line = false, true
  for _, parts in pairs(out.columns) do
    for _, part in ipairs(parts) do part.solid = false end
  end
  return out
end
