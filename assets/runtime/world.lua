-- ---- The world: a level's ground and its bodies ----

local World = {}
World.__index = World

-- What carries a body away for ever is stopped.
local function limit(box)
  local fast, far = 4096.0, 1e9  -- px/frame; px
  if abs(box.vx) <= fast and abs(box.vy) <= fast and abs(box.x) <= far and abs(box.y) <= far then return end
  box.vx, box.vy = clamp(box.vx, -fast, fast), clamp(box.vy, -fast, fast)
  box.x, box.y = clamp(box.x, -far, far), clamp(box.y, -far, far)
end

local function step_body(world, body, input)
  local box = {x = body.x, y = body.y, w = body.w, h = body.h, vx = body.vx, vy = body.vy,
               centre = body.foot == "centre", landed = false}
  if not body.clear then
    local out_x, out_y = way_out(world.terrain, box.x, box.y, box.w, box.h, box.centre)
    if out_x then box.x, box.y = box.x + out_x, box.y + out_y end
  end
  if drag and body.id == world.grabbed then
    drag(world, body, box, input)
  elseif run and body.kind == "player" then
    run(world, body, box, input)
  else
    fall(world, body, box)
  end
  limit(box)
  body.x, body.y, body.vx, body.vy, body.clear = box.x, box.y, box.vx, box.vy, true
end

-- Takes every body one frame further. input: left, right, jump, of the players; mouse_x, mouse_y, mouse_down,
-- where the level drags bodies. All may be missing.
function World:step(input)
  input = input or {}
  if take_mouse then take_mouse(self, input) end
  for _, body in ipairs(self.bodies) do step_body(self, body, input) end
  self.frame = self.frame + 1
end

-- The first contact of a box that moves by dx, dy, or nil: t, the share of the motion; x, y, of the box then;
-- nx, ny, the ground's normal. foot: "box", or "centre" where its middle stands on slopes.
function World:cast(x, y, w, h, dx_, dy_, foot)
  return cast_box(self.terrain, x + 0.0, y + 0.0, w + 0.0, h + 0.0, dx_ + 0.0, dy_ + 0.0, foot == "centre")
end

-- The height of the floor below a box, at most `reach` px below, and its normal; nil: none, or the box is in
-- the ground.
function World:floor(x, y, w, h, reach, foot)
  local contact = self:cast(x, y, w, h, 0.0, reach, foot)
  if not contact or self:overlaps(x, y, w, h, foot) then return nil end
  return contact.y + h, contact.nx, contact.ny
end

-- Whether a box is inside of the ground.
function World:overlaps(x, y, w, h, foot)
  return overlaps_ground(self.terrain, x + 0.0, y + 0.0, w + 0.0, h + 0.0, foot == "centre")
end

-- Adds a body and returns it: a table of kind, "ball" or "player", x and y; and, where they are not so, w and h
-- (8), vx and vy (0), foot ("box", of players "centre").
function World:add(body)
  body.id = #self.bodies + 1
  body.x, body.y, body.w, body.h = body.x + 0.0, body.y + 0.0, (body.w or TILE) + 0.0, (body.h or TILE) + 0.0
  body.vx, body.vy = (body.vx or 0) + 0.0, (body.vy or 0) + 0.0
  body.foot = body.foot or body.kind == "player" and "centre" or "box"
  body.previous_x, body.previous_y = body.x, body.y
  body.grounded, body.jumping, body.jump_held, body.coyote, body.clear = false, false, false, 0, false
  self.bodies[body.id] = body
  return body
end

local talus = {}

-- A world from a level as exported: width, height, in cells; tiles, row by row; shapes and balls, by tile;
-- curves; spawns; tuning.
function talus.new(level)
  local world = setmetatable({frame = 0, bodies = {}, grabbed = 0, tuning = {}}, World)
  for key, value in pairs(level.tuning) do world.tuning[key] = value + 0.0 end
  world.terrain = new_terrain(level)
  for x = 0, level.width - 1 do
    for y = 0, level.height - 1 do
      local tile = level.tiles[y * level.width + x + 1]
      if level.balls[tile] then world:add {kind = "ball", x = x * TILE, y = y * TILE, tile = tile} end
    end
  end
  for _, spawn in ipairs(level.spawns) do
    local body = {}
    for key, value in pairs(spawn) do body[key] = value end
    world:add(body)
  end
  return world
end

return talus
