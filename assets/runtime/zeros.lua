-- ---- Where a function is zero ----
local TRIES = 100  -- limit for iterations

-- The place where f falls through zero: regula falsi (Illinois). It ends at a place where f is still >= 0.
local function zero_between(a, b, f)
  local fa, fb = f(a), f(b)
  for _ = 1, TRIES do
    if not (fa > 0) then break end
    local t = (a * fb - b * fa) / (fb - fa)
    if not (t > a and t < b) then t = a + (b - a) / 2 end
    if not (t > a and t < b) then break end
    local ft = f(t)
    if ft >= 0 then
      a, fa, fb = t, ft, fb / 2
    else
      b, fb, fa = t, ft, fa / 2
    end
  end
  return a
end
