-- ---- Mover: takes one box through the ground, contact by contact ----

local SETTLED = 4  -- a box within so many roundings of a piece is put on it
local LIP = 0.00390625  -- px; the end of a curve may be so far off the end that it ought to meet

-- px; a box so near to a surface is on it.
local function settled(box) return SETTLED * rounding_slack(box.x, box.y, box.w, box.h, 0.0, 0.0) end

-- The part of a motion that a surface leaves.
local function slide_along(nx, ny, x, y)
  local into = x * nx + y * ny
  return x - nx * into, y - ny * into
end

-- The rest of a motion goes on along what it met.
local function slide(_, _, _, contact, x, y)
  return slide_along(contact.nx, contact.ny, x * (1 - contact.t), y * (1 - contact.t))
end

-- Whether a contact is with ground level enough to stand on: |dy/dx| is at most `steepest`.
local function is_level(contact, steepest)
  if contact.ny == 0 then return false end
  local piece = contact.edge
  if piece and not contact.on_end and contact.nx ~= 0 then
    return piece.form.is_level(piece, contact, steepest)
  end
  return abs(contact.nx) <= steepest * abs(contact.ny)
end

local function tolerance(x, y) return (abs(x) + abs(y)) * ROUNDING end

-- The other bodies that a motion may meet; nil: they do not count.
function World:others() end

-- Of the part `walk`: how deep the corners of a box on its centre are to be below the floor, as in a cast, if that
-- floor leads over the side that a corner has met on its way, which ends y px lower; 0: the side stops it.
function World:depth_below_floor() return 0.0 end

-- The y of the upper end of a side that a body has met.
function Terrain.top_of_side(contact) return contact.edge and contact.edge.y0 or contact.row * TILE_H end

-- Whether what a box has met is the side of a floor that begins up to LIP higher. It is put on that floor.
function Terrain:climbs(box, contact, others)
  if contact.other or contact.ny ~= 0 or not self:has_pieces() then return false end
  local top = Terrain.top_of_side(contact)
  local rise = box.y + box.h - top
  if not (rise > 0) or rise > LIP + settled(box) then return false end
  if cast_box(self, box.x, box.y, box.w, box.h, 0.0, -rise, box.centre, others, nil, 0.0) then return false end
  box.y = top - box.h
  return true
end

-- Moves the box of a body by x, y. respond(world, body, box, contact, x, y) returns the motion to go on with.
-- A surface that leads back to itself also returns follow values: the way to go without meeting it, its end,
-- the motion from there, and that way and what is left then in lengths of that way; nil: the box is at the end of the
-- piece, and goes on along the tangent there. Returns whether two sides that it met hold it up.
local function move(world, body, box, x, y, respond)
  local others = world:others(body, box, x, y)
  local passes, sunk, before_x, before_y = 0, 0.0
  local followed, surface, goal_x, goal_y, after_x, after_y, whole, held
  while box.x + x ~= box.x or box.y + y ~= box.y do
    if passes == world.tuning.max_passes then break end
    local contact = cast_box(world.terrain, box.x, box.y, box.w, box.h, x, y, box.centre, others, followed, sunk)
    passes = passes + 1
    local depth = contact and box.centre and contact.ny == 0 and world:depth_below_floor(box, contact, y, sunk) or 0.0
    if depth > 0 then
      sunk = depth
    elseif not contact then
      if not followed then
        box.x, box.y = moved_x(box.x, box.w, x), box.y + y
        break
      end
      box.x, box.y, x, y, followed = goal_x, goal_y, after_x, after_y, nil
    else
      local from_x, from_y = box.x, box.y
      box.x, box.y = contact.x, contact.y
      if world.terrain:climbs(box, contact, others) then
        local left = (followed and whole or 1) - contact.t
        x, y, followed = x * left, y * left, nil
      else
        -- The way that was left at the chord's end is left here, too.
        if followed then x, y, contact.t, followed = x * whole, y * whole, contact.t / whole, nil end
        local off = tolerance(x, y)
        x, y = respond(world, body, box, contact, x, y)
        off = max(off, tolerance(x, y))
        surface = not contact.on_end and contact.edge or nil
        -- Sliding along one plane leads into the one before: there is nowhere to go.
        local slides = x * contact.nx + y * contact.ny <= off
        if before_x and slides and x * before_x + y * before_y < -off then
          held = abs(box.x - from_x) + abs(box.y - from_y) <= settled(box) and
              contact.nx * before_x < 0 and abs(before_x) * contact.ny + abs(contact.nx) * before_y < 0
          break
        end
        before_x, before_y = contact.nx, contact.ny
        if slides and surface and surface.follow then
          x, y, goal_x, goal_y, after_x, after_y, whole = surface.follow(surface, box, x, y)
          followed = whole and surface.source
        end
      end
    end
  end
  if surface then surface.form.settle(surface, box) end
  return held
end
