-- Compares what a game printed, "frame id x y vx vy", with the trace of `talus sim`, number by number.
--   lua5.3 same_trace.lua PRINTED TRACE.jsonl
local printed = {}
for line in io.lines(arg[1]) do
  if line:match("^%d+ %d+ ") then printed[#printed + 1] = line end
end
local count = 0
for line in io.lines(arg[2]) do
  local frame = line:match('"frame":(%d+)')
  for id, x, y, vx, vy in line:gmatch('{"id":(%d+),"x":([^,]+),"y":([^,]+),"vx":([^,]+),"vy":([^,}]+)') do
    count = count + 1
    local at, number = printed[count] or "nothing", {}
    for word in at:gmatch("%S+") do number[#number + 1] = tonumber(word) end
    for i, wanted in ipairs {frame, id, x, y, vx, vy} do
      if number[i] ~= tonumber(wanted) then
        print("differs: " .. at .. "\ninstead of " .. table.concat({frame, id, x, y, vx, vy}, " "))
        os.exit(1)
      end
    end
  end
end
assert(count > 0 and count == #printed, count .. " bodies in the trace, " .. #printed .. " printed")
print(count .. " bodies compared, 0 differences")
