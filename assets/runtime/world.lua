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

function World:grounded(body) return body.grounded end

local function add_body(world, kind, x, y, w, h, vx, vy, foot, name)
  local body = {id = #world.bodies + 1, kind = kind, name = name, x = x + 0.0, y = y + 0.0, w = w + 0.0,
      h = h + 0.0,
                vx = vx + 0.0, vy = vy + 0.0, foot = foot, grounded = false, jumping = false,
                    jump_held = false,
                coyote = 0, clear = false}
  body.previous_x, body.previous_y = body.x, body.y
  world.bodies[body.id] = body
  return body
end

-- Adds a body: kind "ball" or "player"; foot: "box" or "centre".
function World:add(kind, x, y, w, h, vx, vy, foot)
  return add_body(self, kind, x, y, w or 8, h or 8, vx or 0, vy or 0, foot or kind == "player"
      and "centre" or "box")
end

local talus = {}

-- A world from a level: width, height, in cells; tiles, row by row; shapes and balls, by tile; curves;
-- spawns; tuning. As exported.
function talus.new(level)
  local world = setmetatable({frame = 0, bodies = {}, grabbed = 0, tuning = {}}, World)
  for key, value in pairs(level.tuning) do world.tuning[key] = value end
  world.terrain = new_terrain(level)
  for x = 0, level.width - 1 do
    for y = 0, level.height - 1 do
      if level.balls[level.tiles[y * level.width + x + 1]] then
        add_body(world, "ball", x * TILE, y * TILE, TILE, TILE, 0, 0, "box")
      end
    end
  end
  for _, s in ipairs(level.spawns or {}) do
    add_body(world, s.kind, s.x, s.y, s.w, s.h, s.vx, s.vy, s.foot, s.name)
  end
  return world
end

return talus
