-- ---- Walk: takes a body that stands along the floor, piece by piece ----
-- It turns into the next piece where the piece under its foot ends, so that it neither flies on over a crest nor
-- meets what lies below the floor that it walks on.
has.walk = true

local Walk = {}  -- of one body in one step
Walk.__index = Walk

local AHEAD = 0.001953125  -- px; how far ahead the next piece of floor is looked for

-- The column of the solid tile in a row that is nearest to the middle of the box; if there is none under the box,
-- another one.
function Walk:solid_column(box, y)
  local terrain, x, w = self.terrain, box.x, box.w
  local middle = x + w / 2
  local left = floor(middle / TILE_W)
  local right = left
  while not terrain:is_solid(left, y) and left * TILE_W > x do left = left - 1 end
  while not terrain:is_solid(right, y) and (right + 1) * TILE_W < x + w do right = right + 1 end
  if not terrain:is_solid(left, y) then return right end
  if not terrain:is_solid(right, y) then return left end
  local to_left, to_right = middle - (left + 1) * TILE_W, right * TILE_W - middle
  return (to_left < to_right or to_left == to_right and self.direction < 0) and left or right
end

-- The x of the box where it leaves a row of full tiles. Where another kind of ground may go on, only its middle
-- stands on the last tile.
function Walk:end_of_tiles(contact, box)
  local terrain, step, x, w, y = self.terrain, self.direction, box.x, box.w, contact.row
  local far = x + step * (w + SHORT)
  local at = self:solid_column(box, y)
  if not terrain:is_solid(at, y) then return x end  -- it met the last corner of the row
  while terrain:is_open(at + step, y, 0, -1) and ((at + step) * TILE_W - far) * step < 0 do at = at + step end
  local next_to = at + step
  local leads_on = box.centre and terrain:is_solid(next_to, y) and terrain:is_detailed(next_to, y)
  local rest = leads_on and w / 2 or 0.0
  return step > 0 and next_to * TILE_W - rest or at * TILE_W - w + rest
end

-- The x of the box where it leaves the floor that it has met.
function Walk:end_of(contact, on_line, box)
  local right, piece, other, x, w = self.direction > 0, contact.edge, contact.other, box.x, box.w
  if other then return right and other.x + other.w or other.x - w end
  if not piece then return self:end_of_tiles(contact, box) end
  if on_line then return (right and piece.x1 or piece.x0) - piece.form.offset(piece, w, box.centre) end
  -- The flat bottom stands on an end of the piece, or on a level piece.
  local half = w / 2
  if box.centre then
    if piece.x1 - (x + half) > (x + half) - piece.x0 then return right and piece.x0 - half or piece.x0 - w end
    return right and piece.x1 or piece.x1 - half
  end
  if piece.y0 == piece.y1 then return right and piece.x1 or piece.x0 - w end
  local corner = piece.y1 < piece.y0 and piece.x1 or piece.x0
  return right and corner or corner - w
end

-- A floor: the contact that met it, whether the foot is on the line of a piece, and where the floor ends.
function Walk:floor_of(contact, box)
  local on_line = contact.edge ~= nil and not contact.on_end
  return {met = contact, on_line = on_line, stop = self:end_of(contact, on_line, box)}
end

function Walk.at(x, y, box) return {x = x, y = y, w = box.w, h = box.h, centre = box.centre} end
-- What a box meets first on its way. sunk: as that of the walk, which it is by default.
function Walk:cast(box, way_x, way_y, without, sunk)
  return cast_box(self.terrain, box.x, box.y, box.w, box.h, way_x, way_y, box.centre, self.others, without,
                  sunk or self.sunk)
end
function Walk.slack(box, way_x, way_y)
  return rounding_slack(box.x, box.y, box.w, box.h, way_x or 0.0, way_y or 0.0)
end

-- Of a body whose flat bottom is on the end of a floor: the floor that goes on under its middle, if that begins
-- up to LIP lower. Else the same floor.
function Walk:beyond_end(ended, box, rise)
  local found = cast_box(self.terrain, box.x + box.w / 2, ended.met.y - AHEAD, 0.0, box.h, 0.0, AHEAD + rise)
  if not found or found.on_end or not is_level(found, self.steepest) then return ended end
  found.x = box.x
  return self:floor_of(found, box)
end

-- The floor a little further on, so that of two pieces that meet at the foot the next one is found. A foot that is a
-- point goes over a gap, of up to LIP if it is not given, as the flat bottom of a box does.
function Walk:look_ahead(box, reach, gap)
  local step = max(AHEAD, 2 * Walk.slack(box))
  local on = self:floor_at(box, reach, step)
  local is_point = box.centre or box.w == 0
  return (on or not is_point) and on or self:floor_at(box, reach, step + (gap or LIP))
end

-- The floor `step` px further on.
function Walk:floor_at(box, reach, step)
  local forgiven = Walk.slack(box)
  local rise = min(step * self.steepest, 1.0) + LIP + 2 * forgiven
  local there = Walk.at(moved_x(box.x, box.w, self.direction * step), box.y - rise, box)
  local sunk = self.sunk > 0 and min(self.sunk + rise, box.h) or 0.0
  local found = self:cast(there, 0.0, rise + reach, nil, sunk)
  -- The floor may go on to the foot of something too steep, which is met on the way then.
  if found and found.edge and found.nx * self.direction < 0 and not is_level(found, self.steepest) then
    found = self:cast(there, 0.0, rise + reach, found.edge.source or found.edge, sunk)
    if found and found.y - box.y > rise then return nil end
  end
  if not found or not is_level(found, self.steepest) then return nil end
  if found.nx == 0 and found.y - box.y > reach then return nil end
  local on = self:floor_of(found, there)
  if box.centre and found.on_end then on = self:beyond_end(on, there, rise) end
  if (on.stop - there.x) * self.direction < 0 then on.stop = there.x end  -- by rounding: each piece leads on
  return on
end

-- The level floor that the body has met, and goes on along; nil if it ends there.
function Walk:floor_met(box, contact)
  local met = self:floor_of(contact, box)
  return (met.stop - box.x) * self.direction > 0 and met or nil
end

-- The place of a box at x on that floor.
function Walk.place_on(on, box, x)
  if not on.on_line then return x, on.met.y end
  return x, on.met.edge.form.rest(on.met.edge, x, box.w, box.h, box.centre)
end
-- Where it is after it went `way` px to the side on that floor, or to the floor's end.
function Walk:goal_on(on, box, way)
  local there = moved_x(box.x, box.w, way)
  if (there - on.stop) * self.direction > 0 then there = on.stop end
  return Walk.place_on(on, box, there)
end

-- Ends a floor before a line; see walk_slopes.lua. Returns where the body goes on that floor.
function Walk:goal_before_line(_, _, goal_x, goal_y) return goal_x, goal_y end

-- Whether a way along it is the straight one that is cast.
function Walk.is_straight(on) return not on.on_line or on.met.edge.form.straight end

-- How far a place is from what the body has met, px; less than 0: it is in that.
function Walk.room_at(x, y, contact) return (x - contact.x) * contact.nx + (y - contact.y) * contact.ny end

-- px; a body so near to a floor is on it.
function Walk.settled(box, way_x, way_y) return SETTLED * Walk.slack(box, way_x, way_y) end

-- Where the body goes on past a straight ceiling that it has met too early, by rounding: to the goal, or to where it
-- leaves that piece of the ceiling, if it is in it there by a rounding of its height at most. nil: the ceiling, or
-- something else on that way, stops it.
function Walk:place_past(contact, box, x, y)
  local edge = contact.edge
  if contact.facing ~= DOWN or edge and not edge.form.straight then return nil end
  local share = edge and (self:end_of_ceiling(contact, box) - contact.x) / (x - contact.x) or 0
  local leaves = share > 0 and share < 1
  if leaves then x, y = contact.x + (x - contact.x) * share, contact.y + (y - contact.y) * share end
  local aside = x - contact.x
  if aside == 0 then return nil end
  -- Without its lowest part, as the floor would hide what else is there.
  local lip = min(LIP, box.h)
  local above = Walk.at(contact.x, contact.y, box)
  above.h = box.h - lip
  local slack = Walk.slack(above)
  local rounding = SETTLED * slack
  -- Where the ceiling goes on, the next cast must meet it.
  if Walk.room_at(x, y, contact) < -(leaves and rounding or slack / 2) then return nil end
  local met = self:cast(above, aside, edge and y - contact.y or 0.0, edge and (edge.source or edge),
                        max(self.sunk - lip, 0.0))
  if met and abs(met.x - x) > rounding then return nil end
  return x, y
end

-- The two of curves; see walk_curves.lua.
function Walk.leads_above() return false end

function Walk:lift_onto() end

-- Puts a body that has met something on that floor, which may be a little higher or lower than the one that it came
-- from. Returns whether that moved it, so that it may pass.
function Walk:joins(on, box)
  local before, slack = box.y, Walk.settled(box)
  local _, y = Walk.place_on(on, box, box.x)
  if abs(y - before) > slack then
    local met = self:cast(box, 0.0, y - before)
    if met and abs(met.y - y) > slack then
      if y > before then box.y = met.y end
      return box.y - before > slack
    end
  end
  box.y = y
  return y ~= before
end

-- Whether the body has come to the place that it was cast to, but for rounding, when it meets something.
function Walk.arrives(contact, box, x, y)
  local left_x, left_y = x - contact.x, y - contact.y
  local most = min(Walk.settled(box, left_x, left_y), AHEAD / 2)
  return abs(left_x) <= most and abs(left_y) <= most
end

-- Whether the body is behind what it met just before its place, by more than the next cast forgives, which would not
-- meet it then.
function Walk.is_behind(contact, box) return Walk.room_at(box.x, box.y, contact) < -Walk.slack(box) / 2 end

-- Calls cast(...), which has a piece that stops nothing, while another one stops nothing, too.
function Walk.without(piece, cast, ...)
  piece.is_ignored = true
  local contact = cast(...)
  piece.is_ignored = nil
  return contact
end

-- What the body meets first on its way to a place on the floor, and that place. Where the floor is a curve that goes
-- below another one on the way, it ends, and so does the way.
function Walk:cast_to(on, box, x, y)
  if not Walk.is_straight(on) then return self:cast_along_chord(on, box, x, y) end
  local line = on.on_line and on.met.edge or nil
  local way_x, way_y = x - box.x, y - box.y
  local slack = Walk.settled(box, way_x, way_y)
  -- A ceiling that is parallel to the floor must not come nearer by the rounding of the two places.
  local parallel = line and line.form.along(line, way_x) or 0.0
  if abs(way_y - parallel) <= slack then way_y = parallel end
  local contact = self:cast(box, way_x, way_y)
  local piece = contact and contact.t == 0 and contact.edge
  if piece and piece.form.falls_away and piece.form.falls_away(contact, way_x, way_y, slack) then
    return self:cast(box, way_x, way_y, piece.source or piece), x, y
  end
  return contact, x, y
end

-- Whether what the body met is below the floor under its foot, where slopes are.
function Walk:sinks() return false end

-- The floor on which the body goes on, up to `reach` px below it; nil if there is none, or if it is too steep. One that
-- begins up to LIP higher or lower is one with the floor before: the body is put on it.
function Walk:floor_ahead(box, reach)
  local on = self:look_ahead(box, reach)
  if on and not on.on_line and self:sinks(box, on.met, box.y) then
    on = self:look_ahead(box, reach)
  end
  if not on or not box.centre then return on end
  local _, y = Walk.place_on(on, box, box.x)
  local way, slack = abs(y - box.y), Walk.settled(box)
  if way <= slack or way > LIP + slack then return on end
  self.sunk = max(self.sunk, LIP + AHEAD)  -- the end that it leaves may be in its corners now
  -- A ceiling may hold it below an end that it leaves.
  return (self:joins(on, box) or y > box.y) and on or self:look_ahead(box, reach)
end

-- The floor under a body that a low ceiling has stopped on its way to another floor: that was looked for a little
-- further on, and the body goes straight to it from before the joint. nil: it is on that floor, or it has not moved
-- since this was asked, or it has met something else.
function Walk:floor_to_joint(on, box, contact)
  if contact.facing ~= DOWN then return nil end
  if self.joint_asked and not ((box.x - self.joint_asked) * self.direction > 0) then return nil end
  self.joint_asked = box.x
  local here = self:floor_at(box, LIP, 0.0)
  if not here then return nil end
  local under = (here.stop ~= on.stop or here.met.nx ~= on.met.nx) and self:floor_met(box, here.met)
  if under then return under end
  -- Or its flat bottom has gone on along the end of a floor, from just before that end.
  local next_on = self:look_ahead(box, LIP)
  if next_on and (next_on.stop ~= on.stop or next_on.met.nx ~= on.met.nx) then return next_on end
  return nil
end

-- What a walking body does that went from x to a goal and met something. Returns how it goes on, and the floor that
-- it goes on along, or nil if it has to look for it. reach: px, as for floor_ahead(). "shortens": along its curve, of
-- which it takes half of that part in one go; "leaves": the floor has ended.
function Walk:passes(on, box, reach, from, goal_x, goal_y, contact)
  local straight, y = Walk.is_straight(on), box.y
  self:lift_onto(on, box)
  if self:sinks(box, contact, goal_y) or self.terrain:climbs(box, contact, self.others) then return "goes on", nil end
  box.y = y
  if contact.ny <= 0 and Walk.leads_above(on, box, contact, from, goal_x) then
    self:lift_onto(on, box)
    return "shortens", on
  end
  if contact.ny < 0 and is_level(contact, self.steepest) then
    self:lift_onto(on, box)  -- its own curve may cross what it has met once more
    return "goes on", self:floor_met(box, contact)
  end
  local at_floor = straight or contact.t == 0
  if not at_floor then self:stop_on(on, box, from, contact) end
  local joins = at_floor and self:joins(on, box)
  local to_joint = self:floor_to_joint(on, box, contact)
  if to_joint then return "goes on", to_joint end
  if joins then return "goes on", on end
  -- From the foot of a low side, the floor ahead is the one that begins at its top.
  if at_floor and contact.ny == 0 and contact.t > 0 then
    local low, next_on = box.y, self:floor_ahead(box, reach)
    if next_on and self:joins(next_on, box) then return "goes on", next_on end
    box.y = low
  end
  if contact.ny < 0 and contact.nx * box.vx > 0 then return "leaves", on end
  -- It may pass the last corner of a ceiling, or go on along a curve that is not where its chord is.
  local has_room = contact.facing == DOWN
  if not straight then has_room = Walk.room_at(box.x, box.y, contact) > AHEAD end
  return has_room and contact.t > 0 and "goes on" or "stops", on
end

-- Takes a body along the floor that it stands on. motion_on(n, box, nx, ny): its motion in a whole step on a floor
-- with this normal. stop_at(box, contact): what happens where it cannot go on. Returns true if it is on a floor
-- afterwards; else false and the rest of its way.
local function go_along_floor(world, body, box, reach, motion_on, stop_at)
  local n, speed = world.tuning, box.vx
  if speed == 0 then return false, 0.0, 0.0 end
  local walk = setmetatable({terrain = world.terrain, direction = speed < 0 and -1 or 1, steepest = n.steepest,
                             sunk = 0.0, others = world:others(body, box, speed, abs(speed) * n.steepest + reach + 1)},
                            Walk)
  local on, rest, part, x, y = nil, 1.0, 1.0, speed, 0.0
  local contacts = 0
  while contacts < n.max_passes do
    on = on or walk:floor_ahead(box, reach)
    if not on then return false, x * rest, y * rest end
    x, y = motion_on(n, box, on.met.nx, on.met.ny)
    local goal_x, goal_y = walk:goal_on(on, box, x * rest * part)
    goal_x, goal_y = walk:goal_before_line(on, box, goal_x, goal_y)
    if goal_x - box.x == 0 then return true end
    local contact
    contact, goal_x, goal_y = walk:cast_to(on, box, goal_x, goal_y)
    local at_x, at_y, from, past_x, past_y = goal_x, goal_y, box.x
    -- What it has just come to does not stop it if the next piece leads past it.
    local arrives = not contact
    if contact then
      past_x, past_y = walk:place_past(contact, box, goal_x, goal_y)
      if past_x then
        at_x, at_y = past_x, past_y
        arrives = at_x == goal_x and at_y == goal_y
      else
        arrives = Walk.arrives(contact, box, goal_x, goal_y)
        if not arrives then at_x, at_y = contact.x, contact.y end
      end
    end
    rest = rest - (at_x - box.x) / x
    box.x, box.y = at_x, at_y
    if arrives then
      local at_end = goal_x == on.stop
      if contact and Walk.is_behind(contact, box) then box.x, box.y = contact.x, contact.y end
      if not (rest > 0) or (not at_end and part == 1) then return true end
      if at_end then on = nil end
      part = 1.0
    elseif past_x then
      contacts = contacts + 1
    else
      local after
      contacts = contacts + 1
      after, on = walk:passes(on, box, reach, from, goal_x, goal_y, contact)
      -- What it has met does not stop it, and does not count.
      if after == "shortens" then part, contacts = part / 2, contacts - 1 end
      if after == "leaves" then return false, x * rest, 0.0 end
      if after == "stops" then
        stop_at(box, contact)
        return true
      end
    end
  end
  return true
end
