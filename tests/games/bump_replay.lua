-- Runs a collision scenario with the stand-in for bump.lua and compares its answers with those of `talus
-- replay`, number by number and sign by sign. Segments are left out: bump.lua has none.
--   lua5.3 bump_replay.lua SCENARIO.json ANSWERS
package.path = arg[0]:match("^(.*/)[^/]*$") .. "?.lua"
local bump = require "bump_world"

-- Returns a scenario's JSON as a table of Lua, with false for null. Its texts must have no brackets.
local function read_scenario(path)
  local file = assert(io.open(path))
  local text = file:read("*a"):gsub("%[", "{"):gsub("%]", "}")
  text = text:gsub('"([%w_]+)"%s*:', '["%1"]='):gsub("null", "false")
  file:close()
  return assert((loadstring or load)("return " .. text))()
end

local scenario = read_scenario(arg[1])
local world = bump.newWorld(scenario.cell_size)

local function filter_of(op)
  if not op.filter then return nil end
  return function(_, other)
    local named = op.filter[tostring(other)]
    if named == nil then return op.filter.default end
    return named
  end
end

local function number(v) return v == nil and "null" or string.format("%.17g", v) end
local function pair(p) return "[" .. number(p.x) .. "," .. number(p.y) .. "]" end

local function hits_text(hits)
  local texts = {}
  for i, hit in ipairs(hits) do
    texts[i] = '{"other":' .. hit.other .. ',"type":"' .. hit.type .. '","overlaps":' ..
               tostring(hit.overlaps) .. ',"ti":' .. number(hit.ti) .. ',"move":' .. pair(hit.move) ..
               ',"normal":' .. pair(hit.normal) .. ',"touch":' .. pair(hit.touch)
    local aim = hit.slide or hit.bounce
    texts[i] = texts[i] .. (aim and ',"' .. hit.type .. '":' .. pair(aim) or "") .. "}"
  end
  return "[" .. table.concat(texts, ",") .. "]"
end

local function arrival(x, y, hits)
  return '{"x":' .. number(x) .. ',"y":' .. number(y) .. ',"cols":' .. hits_text(hits) .. "}"
end

local function items_text(items)
  table.sort(items)
  return '{"items":[' .. table.concat(items, ",") .. "]}"
end

local run = {}
function run.add(op)
  world:add(op.item, op.rect[1], op.rect[2], op.rect[3], op.rect[4])
  return '{"ok":true}'
end
function run.update(op)
  world:update(op.item, op.rect[1], op.rect[2], op.rect[3], op.rect[4])
  return '{"ok":true}'
end
function run.remove(op)
  world:remove(op.item)
  return '{"ok":true}'
end
function run.getRect(op)
  local x, y, w, h = world:getRect(op.item)
  return '{"rect":[' .. table.concat({number(x), number(y), number(w), number(h)}, ",") .. "]}"
end
function run.move(op) return arrival(world:move(op.item, op.goal[1], op.goal[2], filter_of(op))) end
function run.check(op) return arrival(world:check(op.item, op.goal[1], op.goal[2], filter_of(op))) end
function run.queryRect(op)
  local items = world:queryRect(op.rect[1], op.rect[2], op.rect[3], op.rect[4])
  return items_text(items)
end
function run.queryPoint(op)
  local items = world:queryPoint(op.point[1], op.point[2])
  return items_text(items)
end
function run.toCell(op)
  local column, row = world:toCell(op.point[1], op.point[2])
  return string.format('{"cell":[%d,%d]}', column, row)
end

-- Returns the text without its numbers, and the numbers: they may be written in more than one way.
local function parts(text)
  local numbers = {}
  local rest = text:gsub("%-?%d[%d%.eE+-]*", function(digits)
    numbers[#numbers + 1] = digits
    return "#"
  end)
  return rest, numbers
end

local function is_same(got, wanted)
  local got_rest, got_numbers = parts(got)
  local wanted_rest, wanted_numbers = parts(wanted)
  if got_rest ~= wanted_rest or #got_numbers ~= #wanted_numbers then return false end
  for i, digits in ipairs(wanted_numbers) do
    local is_minus, was_minus = digits:sub(1, 1) == "-", got_numbers[i]:sub(1, 1) == "-"
    if tonumber(digits) ~= tonumber(got_numbers[i]) or is_minus ~= was_minus then return false end
  end
  return true
end

local at, compared = 0, 0
for wanted in io.lines(arg[2]) do
  at = at + 1
  local op = scenario.ops[at]
  if run[op.op] then
    local is_good, got = pcall(run[op.op], op)
    if not is_good then got = '{"error":"' .. got:gsub("^[^:]*:%d+: ", "") .. '"}' end
    if not is_same(got, wanted) then
      print(arg[1] .. ": operation " .. at .. " gives\n" .. got .. "\ninstead of\n" .. wanted)
      os.exit(1)
    end
    compared = compared + 1
  end
end
assert(at == #scenario.ops, at .. " answers to " .. #scenario.ops .. " operations")
print(compared)
