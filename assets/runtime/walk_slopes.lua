-- ---- Walk on slopes: what begins or lies a little above or below the floor ----

local UNDER = 1024  -- the floor under a body is followed over so many pieces to a corner of the body

-- Ends a floor where this line begins, if that is up to LIP above it.
function Walk:end_below(on, box, line, foot, slack)
  local direction = self.direction
  local x, y = line.x0 - foot, line.y0
  if direction < 0 then x, y = line.x1 - foot, line.y1 end
  if not ((x - box.x) * direction > 0 and (on.stop - x) * direction > 0) then return end
  local _, top = Walk.place_on(on, box, x)
  local height = top + box.h - y
  if height > slack and height <= LIP + slack then on.stop = x end
end

-- Ends a floor where the foot of a body on its way to a goal comes below a one-way line that begins up to LIP
-- higher: such a line has no side that the body could meet. Returns the goal, or that end.
function Walk:goal_before_line(on, box, goal_x, goal_y)
  if not self.terrain:has_pieces() then return goal_x, goal_y end
  local slack, foot = Walk.settled(box), self.direction > 0 and box.w or 0.0
  if box.centre then foot = box.w / 2 end
  local bottom = box.h - slack
  for row = floor((min(box.y, goal_y) + (bottom - LIP)) / TILE_H), floor((max(box.y, goal_y) + bottom) / TILE_H) do
    for column = floor((min(box.x, goal_x) + foot) / TILE_W), floor((max(box.x, goal_x) + foot) / TILE_W) do
      if self.terrain:is_detailed(column, row) then
        for _, line in ipairs(self.terrain:detail(column, row).pieces) do
          if not line.solid and line.facing == UP then self:end_below(on, box, line, foot, slack) end
        end
      end
    end
  end
  if (goal_x - on.stop) * self.direction > 0 then return Walk.place_on(on, box, on.stop) end
  return goal_x, goal_y
end

-- The x of the box where it leaves the piece of a ceiling that it has met.
function Walk:end_of_ceiling(contact, box)
  local piece, right = contact.edge, self.direction > 0
  if not contact.on_end then return (right and piece.x1 or piece.x0) - piece.form.offset(piece, box.w, box.centre) end
  -- Its flat top is below the lower end, or below a level piece.
  if right then return piece.y0 > piece.y1 and piece.x0 or piece.x1 end
  return (piece.y1 > piece.y0 and piece.x1 or piece.x0) - box.w
end

-- Where a corner of the body has met a sloped ceiling at this y, which may be the underside of the line that it walks
-- on. Of one that falls away from the middle of the body, as the far side of a roof does, it is the upper end: there
-- the floor leads over it.
local function underside_met(piece, box, y)
  local middle = box.x + box.w / 2
  if piece.y0 < piece.y1 then  -- it falls to the right, where the corner is then
    if middle < piece.x0 then return piece.x0, piece.y0 end
    return min(box.x + box.w, piece.x1), y
  end
  if middle > piece.x1 then return piece.x1, piece.y1 end
  return max(box.x, piece.x0), y
end

-- The upper end of what a corner of the body met, or the nearer end of a ceiling that is level or falls from there;
-- nil if its middle met it.
function Walk:corner_met(box, contact)
  local piece = contact.edge
  if contact.facing >= LEFT then
    if piece then return piece.x0, piece.y0 end
    return (contact.column + (contact.facing == LEFT and 0 or 1)) * TILE_W, contact.row * TILE_H
  end
  local is_ceiling = contact.facing == DOWN
  if piece and not contact.on_end then
    if not is_ceiling then return nil end
    if piece.y0 ~= piece.y1 then return underside_met(piece, box, contact.y) end
  end
  local at = piece and 0 or self:solid_column(box, contact.row)
  local x0, x1 = at * TILE_W, (at + 1) * TILE_W
  if piece then x0, x1 = piece.x0, piece.x1 end
  local middle, y = box.x + box.w / 2, contact.y + (is_ceiling and 0.0 or box.h)
  -- The next floor is found so much further on, while the middle is still on this one.
  local beside = is_ceiling and 0.0 or AHEAD
  if middle < x0 - beside then return x0, y end
  if middle > x1 + beside then return x1, y end
  return nil
end

-- Whether a floor goes through a ceiling into the ground on the way of a box, so that not even its foot gets to the
-- goal. It meets the underside of the line that it walks on by rounding alone.
function Walk:leads_into_ground(on, box, goal_x, goal_y)
  goal_y = goal_y + box.h
  local met
  local under = {x = box.x, y = box.y + box.h, w = 0.0, h = 0.0, centre = false}
  met, goal_x, goal_y = self:cast_to(on, under, goal_x, goal_y)
  if not met or met.facing ~= DOWN or not (Walk.room_at(goal_x, goal_y, met) < -LIP) or
      abs(met.x - box.x) <= AHEAD then
    return false
  end
  return self:is_in_ground(met.x, met.y)
end

-- Whether what is just above a point is ground.
function Walk:is_in_ground(x, y) return overlaps_ground(self.terrain, x - LIP / 2, y - 2 * LIP, LIP, LIP) end

-- Whether the floor goes on from the middle of the body to a place, and is not below it there. fall: px; a floor up
-- to so far below the middle of a body in the air counts. beyond: px; so far behind the place it must not go into the
-- ground, either.
function Walk:floor_leads_over(box, spot_x, spot_y, fall, beyond)
  local point = {x = box.x + box.w / 2, y = box.y, w = 0.0, h = box.h, centre = false}
  local direction = spot_x < point.x and -1 or 1
  local under = setmetatable({terrain = self.terrain, direction = direction, steepest = self.steepest, sunk = 0.0},
                             Walk)
  for i = 1, UNDER do
    if point.x == spot_x then break end
    local falls = i == 1 and fall > 0
    -- A middle that is just before a floor is not on it.
    local on = under:look_ahead(point, falls and fall or 1.0, i == 1 and 0.0 or LIP)
    if not on then return false end
    if i == 1 then
      local x, y = Walk.place_on(on, point, point.x)
      if falls then point.y = y end
      -- The body may be far below a curve, on a chord of it.
      if not Walk.is_straight(on) and self:is_in_ground(x, y + point.h) then return false end
    end
    local goal_x, goal_y = under:goal_on(on, point, spot_x - point.x)
    if goal_x == point.x then return false end
    local ahead_x, ahead_y = goal_x, goal_y
    if beyond > 0 then ahead_x, ahead_y = under:goal_on(on, point, spot_x + direction * beyond - point.x) end
    if under:leads_into_ground(on, point, ahead_x, ahead_y) then return false end
    -- Another floor may cross it, further on or just here.
    local met
    met, goal_x, goal_y = under:cast_to(on, point, goal_x, goal_y)
    if met and met.facing == UP then
      local is_here = met.t == 0 and is_level(met, self.steepest)
      local crossing = is_here and under:floor_met(point, met) or nil
      if crossing then
        goal_x, goal_y = under:goal_on(crossing, point, spot_x - point.x)
      elseif met.x ~= point.x then
        goal_x, goal_y = met.x, met.y
      end
    end
    point.x = (goal_x - spot_x) * direction < 0 and goal_x or spot_x
    point.y = goal_y
  end
  return point.x == spot_x and point.y + box.h <= spot_y + LIP + 2 * Walk.slack(box)
end

-- Whether what the body met lies below the floor that its foot walks on. From then on the lowest part of its
-- corners meets nothing. goal_y: of the place to which it was going; fall: as for floor_leads_over, 0 if not given.
function Walk:sinks(box, contact, goal_y, fall)
  if not box.centre or contact.other or not self.terrain:has_pieces() then return false end
  local spot_x, spot_y = self:corner_met(box, contact)
  if not spot_x then return false end
  local by_px = max(max(box.y, goal_y) + box.h - spot_y, AHEAD)
  local is_ceiling = contact.facing == DOWN
  if is_ceiling or by_px > box.h then by_px = box.h end
  if not (by_px > self.sunk) then return false end
  -- A floor may begin to go into the ceiling just where a corner of the body has met that.
  if not self:floor_leads_over(box, spot_x, spot_y, fall or 0, is_ceiling and 128 * AHEAD or 0.0) then return false end
  self.sunk = by_px
  return true
end

-- A floor at most 8 widths of the box below its middle counts: that of a slope of 16 to 1.
function World:depth_below_floor(box, contact, y, sunk)
  local over = setmetatable({terrain = self.terrain, direction = 1, steepest = self.tuning.steepest, sunk = sunk},
                            Walk)
  return over:sinks(Walk.at(contact.x, contact.y, box), contact, contact.y + max(y, 0.0) * (1 - contact.t),
                    box.w * 8) and over.sunk or 0.0
end
