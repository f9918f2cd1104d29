-- ---- The world: a level's ground and its bodies ----

local FAST = 4096.0  -- px a step, in x and y
local FAR = 1e9  -- px from the origin, in x and y

-- Stops bodies that would go away for ever.
local function limit(box)
  if abs(box.vx) <= FAST and abs(box.vy) <= FAST and abs(box.x) <= FAR and abs(box.y) <= FAR then return end
  box.vx, box.vy = clamp(box.vx, -FAST, FAST), clamp(box.vy, -FAST, FAST)
  box.x, box.y = clamp(box.x, -FAR, FAR), clamp(box.y, -FAR, FAR)
end

-- Parts add what the input does to the world, and what takes a body one frame further.
function World:take_input() end
function World:step_of(body) return rules[self.kinds[body.kind].rule] end

local function step_body(world, body, input)
  local box = {x = body.x, y = body.y, w = body.w, h = body.h, vx = body.vx, vy = body.vy,
               centre = body.foot == "centre", landed = false}
  if not body.clear then
    local out_x, out_y = way_out(world.terrain, box.x, box.y, box.w, box.h, box.centre)
    if out_x then box.x, box.y = box.x + out_x, box.y + out_y end
  end
  world:step_of(body)(world, body, box, input)
  limit(box)
  body.x, body.y, body.vx, body.vy, body.clear = box.x, box.y, box.vx, box.vy, true
end

-- Takes every body one frame further. input: the held keys, see the head; all of them may be missing.
function World:step(input)
  input = input or {}
  self.terrain:use()
  self:take_input(input)
  self:step_bodies(input)
  self.frame = self.frame + 1
end

function World:step_bodies(input)
  for _, body in ipairs(self.bodies) do step_body(self, body, input) end
end

-- The first contact of a box that moves by dx, dy, or nil: t, the share of the motion; x, y, of the box at that
-- time; nx, ny, the ground's normal. foot: "box", or "centre" if its middle stands on slopes.
function World:cast(x, y, w, h, dx_, dy_, foot)
  self.terrain:use()
  return cast_box(self.terrain, x + 0.0, y + 0.0, w + 0.0, h + 0.0, dx_ + 0.0, dy_ + 0.0, foot == "centre")
end

-- The height of the floor below a box, at most `reach` px below, and its normal. Returns nil if there is none,
-- or if the box is in the ground.
function World:floor(x, y, w, h, reach, foot)
  local contact = self:cast(x, y, w, h, 0.0, reach, foot)
  if not contact or self:overlaps(x, y, w, h, foot) then return nil end
  return contact.y + h, contact.nx, contact.ny
end

-- Whether a box is inside of the ground.
function World:overlaps(x, y, w, h, foot)
  self.terrain:use()
  return overlaps_ground(self.terrain, x + 0.0, y + 0.0, w + 0.0, h + 0.0, foot == "centre")
end

-- Adds a body and returns it. The table needs kind, x and y; it may have vx and vy (0), and w, h and foot ("box" or
-- "centre"; those of its kind). It is an error if the level has no such kind, or this module no part with its rule.
function World:add(body)
  local kind = self.kinds[body.kind]
  if not kind or not rules[kind.rule] then
    error(("no part of this module moves bodies of the kind %q: name it in the export"):format(tostring(body.kind)), 2)
  end
  if #self.bodies > 0 and self.tuning.bodies ~= "pass" and not has.pairs then
    error("a second body takes the part pairs, as bodies block one another here: name it in the export, or " ..
          "set bodies in the level's tuning to pass", 2)
  end
  body.id = #self.bodies + 1
  body.x, body.y, body.w, body.h = body.x + 0.0, body.y + 0.0, (body.w or kind.w) + 0.0, (body.h or kind.h) + 0.0
  body.vx, body.vy = (body.vx or 0) + 0.0, (body.vy or 0) + 0.0
  body.foot = body.foot or kind.foot
  local part = self.centre_part
  if part and body.foot == "centre" and not has[part] then
    error(("a body on its centre takes the part %s: name it in the export"):format(part), 2)
  end
  body.grounded, body.clear = false, false
  self.bodies[body.id] = body
  return body
end

-- Puts the bodies that are tiles of the map into a new world.
function World:place_tiles() end
