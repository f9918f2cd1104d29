-- ---- Mover: takes one box through the ground, contact by contact ----

-- What a surface leaves of a motion into it.
local function slide_along(nx, ny, x, y)
  local into = x * nx + y * ny
  return x - nx * into, y - ny * into
end

-- Whether a contact is with ground level enough to stand on: |dy/dx| is at most `steepest`.
local function is_level(contact, steepest)
  if contact.ny == 0 then return false end
  local piece = contact.piece
  if piece == nil or piece.stretch or contact.on_end or contact.nx == 0 then
    return abs(contact.nx) <= steepest * abs(contact.ny)
  end
  local slope = abs(piece.slope)
  if slope ~= steepest then return slope < steepest end
  return piece.slope * piece.slope_rest <= 0
end

local function tolerance(x, y) return (abs(x) + abs(y)) * ROUNDING end

-- A box that slid along a surface, and is not beyond its end, is on it and not a rounding error away from it.
local function settle(box, surface)
  if not surface or surface.facing >= LEFT or is_steep(surface) then return end
  local x = box.x + foot_offset(surface, box.w, box.centre)
  if x < surface.x0 or x > surface.x1 then return end
  local y = rest_on(surface, box.x, box.w, box.h, box.centre)
  if abs(box.y - y) <= 4 * rounding_slack(box.x, box.y, box.w, box.h, 0.0, 0.0) then box.y = y end
end

-- Moves the box of a body by x, y. respond(world, body, box, contact, x, y) gives the motion to go on with.
local function move(world, body, box, x, y, respond)
  local others = others_near and others_near(world, body, box, x, y)
  local passes, before_x, before_y = 0, nil, nil
  local followed, surface, goal_x, goal_y, after_x, after_y
  while box.x + x ~= box.x or box.y + y ~= box.y do
    if passes == world.tuning.max_passes then break end
    local contact = cast_box(world.terrain, box.x, box.y, box.w, box.h, x, y, box.centre, others, followed)
    passes = passes + 1
    if not contact then
      if not followed then
        box.x, box.y = moved_x(box.x, box.w, x), box.y + y
        break
      end
      box.x, box.y, x, y, followed = goal_x, goal_y, after_x, after_y, nil
    else
      box.x, box.y = contact.x, contact.y
      surface = not contact.on_end and contact.piece or nil
      x, y = respond(world, body, box, contact, x, y)
      -- Sliding along one plane into the one before, there is nowhere to go.
      local slides = x * contact.nx + y * contact.ny <= tolerance(x, y)
      if before_x and slides and x * before_x + y * before_y < -tolerance(x, y) then break end
      before_x, before_y, followed = contact.nx, contact.ny, nil
      if follow and slides and surface and is_hollow(surface) then
        followed = surface
        x, y, goal_x, goal_y, after_x, after_y = follow(box, surface, x, y)
      end
    end
  end
  settle(box, surface)
end
