-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- Slopes for bump.lua (https://github.com/kikito/bump.lua), as one more response. Made by Talus; one file,
-- for Lua 5.1 to 5.4 and LuaJIT. Pixels, y down, velocities in px a step.
--
--   local bump, slopes, level = require "bump", require "bump_slopes", require "level"
--   local world = bump.newWorld(level.tuning.cell_size)
--   slopes.install(world)                    -- adds the response "slope"; before any item
--   slopes.add_level(world, level)           -- adds the ground of an exported level
--
--   local hits, count                        -- each step of a body that is in the world: one move()
--   body.x, body.y, hits, count = world:move(body, body.x + body.vx, body.y + body.vy, slopes.filter)
--   body.vx, body.vy = slopes.bounce(body.vx, body.vy, hits, count, level.tuning)
--   if slopes.grounded(world, body) then body.vy = -3 end
--
-- An item of the world with a field `slope` is a slope: {h0 = 0, h1 = 8} is ground within its box, whose surface is 0
-- px above the box's bottom at the left side and 8 px at the right side. The boxes that STI's plugin for bump adds
-- for a map from Talus (--to sti) are slopes, too. Optional fields:
--   ceiling = true    ground hangs from the box's top, and the heights are measured down from there
--   one_way = true    stops only what comes from the open side
-- A moving box stands on the higher of its two lower corners. In a hit of type "slope", normal is the slope's own,
-- and touch lies on it. A slope that was passed in the air is a hit of type "cross" without a normal.
local slopes = {}

local SLACK = 1e-6        -- px under the floor that still count as on it: more than rounding, less than a pixel
local REACH = 1 / 64      -- px below a body in which it looks for ground

local function min(a, b) if b < a then return b end return a end
local function max(a, b) if a < b then return b end return a end
local function clamp(v, least, most)
  if v < least then return least end
  if most < v then return most end
  return v
end

local one_way_tiles = {}  -- slopes of full tiles, by their height

local function one_way_tile(height)
  local tile = one_way_tiles[height] or {h0 = height, h1 = height, one_way = true}
  one_way_tiles[height] = tile
  return tile
end

-- The field `slope` of an item, or nil.
local function slope_of(item)
  if type(item) ~= "table" then return nil end
  if item.slope then return item.slope end
  local properties = item.properties
  if type(properties) ~= "table" then return nil end
  if properties.h0 and properties.h1 then return properties end
  return properties.one_way and one_way_tile(item.height or 8) or nil
end

-- The way of a box to a goal, over the slope h0..h1 in `box`. t is the share of the way.
local Passage = {}
Passage.__index = Passage

local function new_passage(h0, h1, box, mover, goal_x, goal_y)
  return setmetatable({
    low = box.y + box.h - min(h0, h1), rise = max(h0, h1) - min(h0, h1), rises_right = h1 > h0,
    left = box.x, right = box.x + box.w, width = box.w, bottom = box.y + box.h,
    x = mover.x, y = mover.y, w = mover.w, h = mover.h, dx = goal_x - mover.x, dy = goal_y - mover.y,
  }, Passage)
end

-- The part of the way on which the box is above, in or under the slope; there is none if the first is not less.
function Passage:times()
  if self.dx == 0 then
    local is_beside = self.x + self.w <= self.left or self.x >= self.right
    return is_beside and 1 or 0, 1
  end
  local to_left, to_right = (self.left - (self.x + self.w)) / self.dx, (self.right - self.x) / self.dx
  return clamp(min(to_left, to_right), 0, 1), clamp(max(to_left, to_right), 0, 1)
end

-- The x of the corner that stands on the slope.
function Passage:corner(x) return self.rises_right and x + self.w or x end
function Passage:high_end() return self.rises_right and self.right or self.left end

function Passage:line(x)
  local run = self.rises_right and x - self.left or self.right - x
  return self.low - self.rise * run / self.width
end

function Passage:floor_at(x) return self:line(clamp(self:corner(x), self.left, self.right)) end
function Passage:depth(t) return self.y + self.h + t * self.dy - self:floor_at(self.x + t * self.dx) end

function Passage:is_on_high_end(t)
  local past = self:corner(self.x + t * self.dx) - self:high_end()
  if self.rises_right then return past >= 0 end
  return past <= 0
end

-- Whether a corner under the floor is lifted onto it. It is if that is the shortest way out, as after rounding, or a
-- moving slope, has sunk it a little.
function Passage:lifts()
  local side = self.rises_right and self.right - self.x or self.x + self.w - self.left
  return self.y + self.h <= self.bottom + SLACK and self:depth(0) <= side
end

function Passage:normal()
  local length = math.sqrt(self.width * self.width + self.rise * self.rise)
  return (self.rises_right and -self.rise or self.rise) / length, -self.width / length
end

-- The contact at t: where the box is at that time, the normal, and where the rest of the way leads.
function Passage:surface(t, is_on_high_end)
  local x = self.x + t * self.dx
  local y = self:floor_at(x) - self.h
  local nx, ny = 0, -1
  if not is_on_high_end then nx, ny = self:normal() end
  local rest_x, rest_y = self.dx * (1 - t), self.dy * (1 - t)
  local into = rest_x * nx + rest_y * ny
  local goal_x, goal_y = x + rest_x, y + rest_y
  if into < 0 then
    local along_x, along_y = -ny, nx
    local along = rest_x * along_x + rest_y * along_y
    goal_x, goal_y = x + along_x * along, y + along_y * along
    -- Along the slope the slope gives the height, not the sum.
    if not is_on_high_end then goal_y = self:line(self:corner(goal_x)) - self.h end
  end
  return {t = t, x = x, y = y, nx = nx, ny = ny, goal_x = goal_x, goal_y = goal_y}
end

-- Returns nil if the box passes above the floor, or beside the slope; "solid" if it comes from below or from a side,
-- and meets the slope's box; else a contact with the surface.
function Passage:meet(one_way)
  local enter, leave = self:times()
  if enter >= leave then return nil end
  if self:depth(enter) > SLACK then
    if one_way then return nil end
    if enter == 0 and self:lifts() then return self:surface(0, self:is_on_high_end(0)) end
    return "solid"
  end
  -- The depth is linear on both sides of the bend, where the corner passes the slope's high end.
  local bend = self.dx == 0 and 0 or (self:high_end() - self:corner(self.x)) / self.dx
  local from = enter
  for _, to in ipairs {clamp(bend, enter, leave), leave} do
    local before, after = self:depth(from), self:depth(to)
    if from < to and after > SLACK then
      local t = from
      if before < 0 then t = from + (to - from) * (-before / (after - before)) end
      return self:surface(t, self:is_on_high_end((from + to) / 2))
    end
    from = to
  end
  return nil
end

-- A ceiling is a floor mirrored at y = 0.
local function mirrored(box) return {x = box.x, y = -(box.y + box.h), w = box.w, h = box.h} end

local function is_ceiling(slope) return slope.ceiling or slope.slope == "ceiling" end

local function meet(slope, box, mover, goal_x, goal_y)
  local h0, h1 = slope.h0, slope.h1
  if not is_ceiling(slope) then
    return new_passage(h0, h1, box, mover, goal_x, goal_y):meet(slope.one_way)
  end
  local passage = new_passage(h0, h1, mirrored(box), mirrored(mover), goal_x, -(goal_y + mover.h))
  local found = passage:meet(slope.one_way)
  if type(found) == "table" then
    found.y, found.ny, found.goal_y = -(found.y + mover.h), -found.ny, -(found.goal_y + mover.h)
  end
  return found
end

-- Whether a box over or in a slope's columns is past its line by more than rounding: below a floor, above a ceiling.
local function is_past_line(slope, box, mover)
  if mover.x + mover.w <= box.x or mover.x >= box.x + box.w then return false end
  if is_ceiling(slope) then box, mover = mirrored(box), mirrored(mover) end
  return new_passage(slope.h0, slope.h1, box, mover, mover.x, mover.y):depth(0) > SLACK
end

-- The slope of a hit that stops from one side alone.
local function line_of(hit)
  local slope = hit.type == "slope" and slope_of(hit.other) or nil
  return slope and slope.one_way and slope or nil
end

-- bump meets boxes that the item is in by how far it is in them, and each once in a move. Solid ground lifts an item
-- out again; below a one-way line it would be lost. So a line that the item would be below at this contact comes
-- first, and the way after the contact ends at a line that was met before. Returns the contact to go on from.
local function keep_above_lines(world, hit, found, goal_x, goal_y, filter)
  local from = hit.itemRect
  local slope, box = slope_of(hit.other), hit.otherRect
  local function at(x, y) return {x = x, y = y, w = from.w, h = from.h} end
  local on_the_way, count = world:project(hit.item, from.x, from.y, from.w, from.h, goal_x, goal_y, filter)
  for i = 1, count do
    local other = on_the_way[i]
    local line = line_of(other)
    if line and is_past_line(line, other.otherRect, at(found.x, found.y)) then
      local first = meet(line, other.otherRect, from, goal_x, goal_y)
      if type(first) == "table" and first.t < found.t then
        found = meet(slope, box, at(first.x, first.y), first.goal_x, first.goal_y)
        if type(found) ~= "table" then
          found = first
          hit.other, hit.otherRect = other.other, other.otherRect
        end
      end
    end
  end
  for _, met in ipairs(world.lines_met) do
    local again = meet(met.line, met.box, at(found.x, found.y), found.goal_x, found.goal_y)
    if type(again) == "table" then found.goal_x, found.goal_y = again.x, again.y end
  end
  return found
end

-- The response. The way goes on from where this leg began, not from where the whole move did: an earlier hit may have
-- turned it.
function slopes.response(world, hit, x, y, w, h, goal_x, goal_y, filter)
  goal_x, goal_y = goal_x or x, goal_y or y
  local from = hit.itemRect
  local found = meet(slope_of(hit.other), hit.otherRect, from, goal_x, goal_y)
  if not found then
    hit.type, hit.normal = "cross", {x = 0, y = 0}
    return goal_x, goal_y, world:project(hit.item, from.x, from.y, w, h, goal_x, goal_y, filter)
  end
  if found == "solid" then
    hit.type = "slide"
    if hit.move.x ~= 0 or hit.move.y ~= 0 then
      if hit.normal.x ~= 0 then goal_x = hit.touch.x else goal_y = hit.touch.y end
    end
  else
    if world.has_lines then found = keep_above_lines(world, hit, found, goal_x, goal_y, filter) end
    goal_x, goal_y = found.goal_x, found.goal_y
    hit.overlaps, hit.ti = false, found.t
    hit.normal, hit.touch = {x = found.nx, y = found.ny}, {x = found.x, y = found.y}
  end
  hit[hit.type] = {x = goal_x, y = goal_y}
  local line = line_of(hit)
  if line and world.lines_met then table.insert(world.lines_met, {line = line, box = hit.otherRect}) end
  return goal_x, goal_y, world:project(hit.item, hit.touch.x, hit.touch.y, w, h, goal_x, goal_y, filter)
end

-- As bump measures it: squared, between the centres.
local function distance(a, b)
  local dx, dy = a.x - b.x + (a.w - b.w) / 2, a.y - b.y + (a.h - b.h) / 2
  return dx * dx + dy * dy
end

-- Adds the response "slope" to a world, and an order for contacts at the same time and distance: the item that was
-- added first comes first, as in Talus. bump leaves the order to chance, so it may differ from run to run. Items that
-- were in the world before come before all others.
function slopes.install(world)
  world:addResponse("slope", slopes.response)
  local ages, last = setmetatable({}, {__mode = "k"}), 0
  local add, project, check = world.add, world.project, world.check
  function world:add(item, ...)
    local added = add(self, item, ...)
    last = last + 1
    ages[item] = last
    local slope = slope_of(item)
    self.has_lines = self.has_lines or slope ~= nil and slope.one_way
    return added
  end
  function world:check(...)
    self.lines_met = {}  -- the one-way slopes that this move has met
    return check(self, ...)
  end
  function world:project(...)
    local hits, count = project(self, ...)
    table.sort(hits, function(a, b)
      if a.ti ~= b.ti then return a.ti < b.ti end
      local from_a, from_b = distance(a.itemRect, a.otherRect), distance(b.itemRect, b.otherRect)
      if from_a ~= from_b then return from_a < from_b end
      return (ages[a.other] or 0) < (ages[b.other] or 0)
    end)
    return hits, count
  end
end

-- A filter for world:move() and world:check(): slopes are slopes, and bodies slide along all else. Yours can call it:
--   function(item, other) if other.is_coin then return "cross" end return slopes.filter(item, other) end
function slopes.filter(_, other) return slope_of(other) and "slope" or "slide" end

-- The floor at most `reach` px below an item of the world, by one check(): the y at which it would stand there, and
-- the floor's normal. Returns nil if there is none. filter: as for its moves.
function slopes.floor(world, item, reach, filter)
  local x, y = world:getRect(item)
  local _, _, hits, count = world:check(item, x, y + reach, filter or slopes.filter)
  for i = 1, count do
    local hit = hits[i]
    if hit.type ~= "cross" and hit.normal.y < 0 then return hit.touch.y, hit.normal.x, hit.normal.y end
  end
  return nil
end

-- Whether an item stands on something, and the normal of that.
function slopes.grounded(world, item, filter)
  local y, nx, ny = slopes.floor(world, item, REACH, filter)
  return y ~= nil, nx, ny
end

-- The velocity of a ball after the hits of a move(). On level floors and at walls it keeps the shares floor_bounce,
-- floor_grip and wall_bounce of the tuning. On a slope it keeps the part along the slope, and the share slope_bounce
-- of the part into it. For a player: {floor_bounce = 0, floor_grip = 1, wall_bounce = 0, slope_bounce = 0}.
function slopes.bounce(vx, vy, hits, count, tuning)
  for i = 1, count do
    local n = hits[i].normal
    local out = vx * n.x + vy * n.y
    if hits[i].type ~= "cross" and out < 0 then
      if n.x == 0 then
        vx, vy = vx * tuning.floor_grip, -(vy * tuning.floor_bounce)
      elseif n.y == 0 then
        vx = -(vx * tuning.wall_bounce)
      else
        local turned = (1 + tuning.slope_bounce) * out
        vx, vy = vx - n.x * turned, vy - n.y * turned
      end
    end
  end
  return vx, vy
end

local function add_box(world, x, y, w, h, slope)
  if w > 0 and h > 0 then world:add({x = x, y = y, w = w, h = h, slope = slope}, x, y, w, h) end
end

-- The box between two heights over y, upwards, or downwards for a ceiling; `heights` are h0 and h1 of a slope in it.
-- The sums are in the program's order, for the same doubles.
local function add_layer(world, x, y, w, from, to, kind, heights)
  local slope = heights and {h0 = heights[1] - from, h1 = heights[2] - from, ceiling = kind.ceiling,
                             one_way = kind.one_way}
  local tile = kind.tile_height or 8
  add_box(world, x, kind.ceiling and y + from or (tile - to) + (y - tile), w, to - from, slope)
end

-- One straight part of a line of ground. A part of a longer line becomes one box down to y: a seam in it could become
-- a step by rounding. A single straight line becomes a slope on a full box, as in the program.
local function add_part(world, x, y, w, h0, h1, kind, is_alone)
  local low, high = min(h0, h1), max(h0, h1)
  if kind.one_way then
    add_layer(world, x, y, w, low - 1, high, kind, {h0, h1})  -- a level line's box needs a height
  elseif is_alone then
    add_layer(world, x, y, w, low, high, kind, {h0, h1})
    add_layer(world, x, y, w, 0, low, kind)
  else
    add_layer(world, x, y, w, 0, high, kind, {h0, h1})
  end
end

-- Adds ground below a line of two or more heights at equal distances. x: its left end; y: the base of the heights,
-- which go upwards; w: its width. kind, optional: {ceiling = true}: ground above the line, heights go downwards;
-- {one_way = true}: only the line; {tile_height = 16}: px, of the tiles that it is made of, 8 without it.
function slopes.add_ground(world, x, y, w, heights, kind)
  local count = #heights - 1
  local from = 1
  for i = 2, count + 1 do
    local goes_on = i <= count and heights[i + 1] - heights[i] == heights[i] - heights[i - 1]
    if not goes_on then
      add_part(world, x + w * (from - 1) / count, y, w * (i - from) / count, heights[from], heights[i],
               kind or {}, count == 1)
      from = i
    end
  end
end

-- Full tiles as few boxes: columns of them, widened over the next columns that have the same.
local function add_merged(world, is_full, level, tile_width, tile_height)
  local width, height = level.width, level.height
  local open = {}  -- by top and bottom: the x where boxes that may still grow begin
  for x = 0, width do
    local runs = {}
    local y = 0
    while x < width and y < height do
      local top = y
      while y < height and is_full(x, y) do y = y + 1 end
      if y > top then runs[top * (height + 1) + y] = {x = x, top = top, bottom = y} end
      y = max(y, top + 1)
    end
    local ended = {}
    for key, run in pairs(open) do
      if runs[key] then runs[key].x = run.x else ended[#ended + 1] = run end
    end
    table.sort(ended, function(a, b) return a.top < b.top end)
    for _, run in ipairs(ended) do
      add_box(world, run.x * tile_width, run.top * tile_height, (x - run.x) * tile_width,
              (run.bottom - run.top) * tile_height)
    end
    open = runs
  end
end

-- Adds the boxes of a tile whose shape is a polygon or a group. Talus cut it into them.
local function add_parts(world, x, y, boxes)
  for _, b in ipairs(boxes) do
    local slope = b.h0 and {h0 = b.h0, h1 = b.h1, ceiling = b.ceiling, one_way = b.one_way}
    add_box(world, x + b.x, y + b.y, b.w, b.h, slope)
  end
end

-- Adds the tiles of an exported level, but no bodies. options, all optional:
--   merge      true: full tiles become as few boxes as they can, so that less snags at seams. Without, bodies
--              move to the last bit as in Talus with the solver "bump"
--   on_ball    function(x, y, tile, kind), called where a tile is a body, such as a ball, in the order in which
--              tiles are added
-- Curves are not ground here: Talus's own runtime (--to lua-runtime) has them.
function slopes.add_level(world, level, options)
  options = options or {}
  local tile_width, tile_height = level.tile_width or 8, level.tile_height or 8  -- px
  local function tile_at(x, y) return level.tiles[y * level.width + x + 1] end
  local function is_full(x, y)
    local shape = level.shapes[tile_at(x, y)]
    return shape ~= nil and shape.kind == "solid" and not shape.one_way
  end
  if options.merge then add_merged(world, is_full, level, tile_width, tile_height) end
  for x = 0, level.width - 1 do
    for y = 0, level.height - 1 do
      local tile = tile_at(x, y)
      local shape = level.shapes[tile]
      if shape and shape.boxes then
        add_parts(world, x * tile_width, y * tile_height, shape.boxes)
      elseif shape and not (options.merge and is_full(x, y)) then
        local is_ceiling = shape.side == "ceiling" and shape.kind ~= "solid"
        slopes.add_ground(world, x * tile_width, (is_ceiling and y or y + 1) * tile_height,
                          (shape.tiles or 1) * tile_width, shape.heights or {tile_height, tile_height},
                          {ceiling = is_ceiling, one_way = shape.one_way, tile_height = tile_height})
      elseif level.balls[tile] and options.on_ball then
        options.on_ball(x * tile_width, y * tile_height, tile, level.balls[tile])
      end
    end
  end
end

return slopes
