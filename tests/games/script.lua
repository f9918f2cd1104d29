-- Reads from lines of JSON, as `talus sim --input` takes them, what is held in which frame. script(file)
-- returns a function that takes the number of a frame, from 1, and returns {mouse_x, mouse_y, mouse_down,
-- left, right, jump}.
return function(file)
  local entries = {}
  if file then
    for line in io.lines(file) do entries[#entries + 1] = line end
  end
  local now, at = {mouse_x = 0, mouse_y = 0, mouse_down = false}, 1
  local function take(line)
    local x, y = line:match('"mouse":%[([^,]+),([^%]]+)%]')
    if x then now.mouse_x, now.mouse_y = tonumber(x), tonumber(y) end
    local down, keys = line:match('"down":(%a+)'), line:match('"keys":(%[[^%]]*%])')
    if down then now.mouse_down = down == "true" end
    for _, key in ipairs {"left", "right", "jump"} do
      if keys then now[key] = keys:find('"' .. key .. '"', 1, true) ~= nil end
    end
  end
  return function(frame)
    while entries[at] and tonumber(entries[at]:match('"frame":(%d+)')) <= frame do
      take(entries[at])
      at = at + 1
    end
    return now
  end
end
