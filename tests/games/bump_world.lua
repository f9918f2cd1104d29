-- A stand-in for the parts of bump.lua that the companion and its test use: Talus's own World in Lua, written
-- from what bump.lua's public API does. bump.lua leaves the order of equal contacts to chance. Here the item
-- that was added first comes first, unless a test sets another order: see tie_key.
local DELTA = 1e-10
local floor, ceil, abs, min, max = math.floor, math.ceil, math.abs, math.min, math.max

local function sign(v) return v > 0 and 1 or v == 0 and 0 or -1 end
local function nearest(a, b) if abs(a) < abs(b) then return a end return b end

-- Returns the part of the line t * (dx, dy), from ti1 to ti2, that is inside a box, or nil if there is none.
local function clip(left, top, right, bottom, dx, dy, ti1, ti2)
  local nx, ny = 0, 0
  local function side(p, q, side_x, side_y)
    if p == 0 then return q > 0 end
    local r = q / p
    if p < 0 then
      if r > ti2 then return false end
      if r > ti1 then ti1, nx, ny = r, side_x, side_y end
      return true
    end
    if r < ti1 then return false end
    if r < ti2 then ti2 = r end
    return true
  end
  if side(-dx, 0 - left, -1, 0) and side(dx, right - 0, 1, 0) and side(-dy, 0 - top, 0, -1) and
      side(dy, bottom - 0, 0, 1) then
    return ti1, ti2, nx, ny
  end
end

-- tie_key(n) gives a number for the item that was added as the nth. Of two equal contacts the one with the
-- lower number comes first.
local bump = {rect = {}, tie_key = function(n) return n end}

function bump.rect.detectCollision(x1, y1, w1, h1, x2, y2, w2, h2, goal_x, goal_y)
  goal_x, goal_y = goal_x or x1, goal_y or y1
  local dx, dy = goal_x - x1, goal_y - y1
  local left, top = x2 - x1 - w1, y2 - y1 - h1
  local right, bottom = left + (w1 + w2), top + (h1 + h2)
  local overlaps = 0 - left > DELTA and 0 - top > DELTA and right - 0 > DELTA and bottom - 0 > DELTA
  local ti, nx, ny, touch_x, touch_y
  if not overlaps then
    local ti1, ti2
    ti1, ti2, nx, ny = clip(left, top, right, bottom, dx, dy, -math.huge, math.huge)
    if not (ti1 and ti1 < 1 and abs(ti1 - ti2) >= DELTA and (0 < ti1 + DELTA or (ti1 == 0 and ti2 > 0))) then
      return nil
    end
    ti, touch_x, touch_y = ti1, x1 + dx * ti1, y1 + dy * ti1
  else
    local px, py = nearest(left, right), nearest(top, bottom)
    ti = -min(w1, abs(px)) * min(h1, abs(py))
    if dx == 0 and dy == 0 then
      if abs(px) < abs(py) then py = 0 else px = 0 end
      nx, ny, touch_x, touch_y = sign(px), sign(py), x1 + px, y1 + py
    else
      local ti1
      ti1, _, nx, ny = clip(left, top, right, bottom, dx, dy, -math.huge, 1)
      if not ti1 then return nil end
      touch_x, touch_y = x1 + dx * ti1, y1 + dy * ti1
    end
  end
  return {overlaps = overlaps, ti = ti, move = {x = dx, y = dy}, normal = {x = nx, y = ny},
          touch = {x = touch_x, y = touch_y}, itemRect = {x = x1, y = y1, w = w1, h = h1},
          otherRect = {x = x2, y = y2, w = w2, h = h2}}
end

local function check_rect(x, y, w, h)
  for _, side in ipairs {{"x", x}, {"y", y}} do
    if type(side[2]) ~= "number" then
      error(side[1] .. " must be a number, but was " .. tostring(side[2]) .. "(a " .. type(side[2]) .. ")", 3)
    end
  end
  for _, side in ipairs {{"w", w}, {"h", h}} do
    if type(side[2]) ~= "number" or side[2] <= 0 then
      error(side[1] .. " must be a positive integer, but was " .. tostring(side[2]) .. "(" ..
            type(side[2]) .. ")", 3)
    end
  end
end

local World = {}
World.__index = World

function World:toCell(x, y)
  return floor(x / self.cellSize) + 1, floor(y / self.cellSize) + 1
end

-- Calls visit(row, column) for every cell that a box covers.
function World:eachCell(x, y, w, h, visit)
  local left, top = self:toCell(x, y)
  for row = top, max(top, ceil((y + h) / self.cellSize)) do
    for column = left, max(left, ceil((x + w) / self.cellSize)) do visit(row, column) end
  end
end

function World:put(item, is_there)
  local r = self.rects[item]
  self:eachCell(r.x, r.y, r.w, r.h, function(row, column)
    local cells = self.rows[row] or {}
    self.rows[row] = cells
    cells[column] = cells[column] or {}
    cells[column][item] = is_there
  end)
end

-- Returns the items in the cells of a box, in the order in which they were added.
function World:near(x, y, w, h)
  local found, seen = {}, {}
  self:eachCell(x, y, w, h, function(row, column)
    for item in pairs(self.rows[row] and self.rows[row][column] or {}) do
      if not seen[item] then found[#found + 1], seen[item] = item, true end
    end
  end)
  table.sort(found, function(a, b) return self.rects[a].serial < self.rects[b].serial end)
  return found
end

function World:hasItem(item) return self.rects[item] ~= nil end

function World:add(item, x, y, w, h)
  if self.rects[item] then error("Item " .. tostring(item) .. " added to the world twice.", 2) end
  check_rect(x, y, w, h)
  self.last = self.last + 1
  self.rects[item] = {x = x, y = y, w = w, h = h, serial = self.last}
  self:put(item, true)
  return item
end

function World:getRect(item)
  local r = self.rects[item]
  if not r then
    error("Item " .. tostring(item) .. " must be added to the world before getting its rect. Use " ..
          "world:add(item, x,y,w,h) to add it first.", 2)
  end
  return r.x, r.y, r.w, r.h
end

function World:remove(item)
  self:getRect(item)
  self:put(item, nil)
  self.rects[item] = nil
end

function World:update(item, x, y, w, h)
  local _, _, old_w, old_h = self:getRect(item)
  w, h = w or old_w, h or old_h
  check_rect(x, y, w, h)
  self:put(item, nil)
  self.rects[item] = {x = x, y = y, w = w, h = h, serial = self.rects[item].serial}
  self:put(item, true)
end

local function slide_filter() return "slide" end

local function square_distance(a, b)
  local dx, dy = a.x - b.x + (a.w - b.w) / 2, a.y - b.y + (a.h - b.h) / 2
  return dx * dx + dy * dy
end

function World:project(item, x, y, w, h, goal_x, goal_y, filter)
  check_rect(x, y, w, h)
  goal_x, goal_y, filter = goal_x or x, goal_y or y, filter or slide_filter
  local left, top = min(goal_x, x), min(goal_y, y)
  local right, bottom = max(goal_x + w, x + w), max(goal_y + h, y + h)
  local hits = {}
  for _, other in ipairs(self:near(left, top, right - left, bottom - top)) do
    local kind = other ~= item and filter(item, other)
    if kind then
      local r = self.rects[other]
      local hit = bump.rect.detectCollision(x, y, w, h, r.x, r.y, r.w, r.h, goal_x, goal_y)
      if hit then
        hit.item, hit.other, hit.type = item, other, kind
        hits[#hits + 1] = hit
      end
    end
  end
  table.sort(hits, function(a, b)
    if a.ti ~= b.ti then return a.ti < b.ti end
    local da, db = square_distance(a.itemRect, a.otherRect), square_distance(b.itemRect, b.otherRect)
    if da ~= db then return da < db end
    return bump.tie_key(self.rects[a.other].serial) < bump.tie_key(self.rects[b.other].serial)
  end)
  return hits, #hits
end

function World:check(item, goal_x, goal_y, filter)
  filter = filter or slide_filter
  local seen = {[item] = true}
  local function unseen(mover, other) return not seen[other] and filter(mover, other) end
  local x, y, w, h = self:getRect(item)
  local hits = {}
  local next_hits = self:project(item, x, y, w, h, goal_x, goal_y, unseen)
  while next_hits[1] do
    local hit = next_hits[1]
    hits[#hits + 1], seen[hit.other] = hit, true
    local respond = self.responses[hit.type]
    if not respond then
      error("Unknown collision type: " .. tostring(hit.type) .. " (" .. type(hit.type) .. ")", 2)
    end
    goal_x, goal_y, next_hits = respond(self, hit, x, y, w, h, goal_x, goal_y, unseen)
  end
  return goal_x, goal_y, hits, #hits
end

function World:move(item, goal_x, goal_y, filter)
  local x, y, hits, count = self:check(item, goal_x, goal_y, filter)
  self:update(item, x, y)
  return x, y, hits, count
end

function World:query(is_in, x, y, w, h, filter)
  local found = {}
  for _, item in ipairs(self:near(x, y, w, h)) do
    if (not filter or filter(item)) and is_in(self.rects[item]) then found[#found + 1] = item end
  end
  return found, #found
end

function World:queryRect(x, y, w, h, filter)
  check_rect(x, y, w, h)
  return self:query(function(r)
    return x < r.x + r.w and r.x < x + w and y < r.y + r.h and r.y < y + h
  end, x, y, w, h, filter)
end

function World:queryPoint(x, y, filter)
  return self:query(function(r)
    return x - r.x > DELTA and y - r.y > DELTA and r.x + r.w - x > DELTA and r.y + r.h - y > DELTA
  end, x, y, 0, 0, filter)
end

function World:addResponse(name, respond) self.responses[name] = respond end

local responses = {}
function responses.touch(_, hit) return hit.touch.x, hit.touch.y, {}, 0 end
function responses.cross(world, hit, x, y, w, h, goal_x, goal_y, filter)
  return goal_x, goal_y, world:project(hit.item, x, y, w, h, goal_x, goal_y, filter)
end
function responses.slide(world, hit, x, y, w, h, goal_x, goal_y, filter)
  goal_x, goal_y = goal_x or x, goal_y or y
  if hit.move.x ~= 0 or hit.move.y ~= 0 then
    if hit.normal.x ~= 0 then goal_x = hit.touch.x else goal_y = hit.touch.y end
  end
  hit.slide = {x = goal_x, y = goal_y}
  return goal_x, goal_y, world:project(hit.item, hit.touch.x, hit.touch.y, w, h, goal_x, goal_y, filter)
end
function responses.bounce(world, hit, x, y, w, h, goal_x, goal_y, filter)
  goal_x, goal_y = goal_x or x, goal_y or y
  if hit.move.x == 0 and hit.move.y == 0 then
    goal_x, goal_y = hit.touch.x, hit.touch.y
  else
    local rest_x, rest_y = goal_x - hit.touch.x, goal_y - hit.touch.y
    if hit.normal.x == 0 then rest_y = -rest_y else rest_x = -rest_x end
    goal_x, goal_y = hit.touch.x + rest_x, hit.touch.y + rest_y
  end
  hit.bounce = {x = goal_x, y = goal_y}
  return goal_x, goal_y, world:project(hit.item, hit.touch.x, hit.touch.y, w, h, goal_x, goal_y, filter)
end

function bump.newWorld(cell_size)
  local world = setmetatable({cellSize = cell_size or 64, rows = {}, rects = {}, responses = {}, last = 0},
                             World)
  for name, respond in pairs(responses) do world.responses[name] = respond end
  return world
end

return bump
