-- ---- Walk on curves: the way of a body is the chord of its curve ----

Walk.MOST_SAG = 2.0 ^ -20  -- px; where a curve leads over an end, its chord may be so much below it
Walk.PARTS_OF_WAY = 16  -- two curves are compared between so many equal parts of a way
Walk.MOST_PASSED = 8  -- on its chord a body passes so many floors that its curve is above

local HALVINGS = 16  -- how often the way along a curve to what stops the body is halved: to less than 1/1000 px

-- Puts a body that something has stopped on its way from x along the chord of that curve on the curve itself, where it
-- may meet that sooner, or as near to it as what else is there lets it.
function Walk:stop_on(on, box, from, contact)
  local free, blocked = from, contact.x
  local x, y = Walk.place_on(on, box, blocked)
  if Walk.room_at(x, y, contact) < 0 then
    for _ = 1, HALVINGS do
      local middle = (free + blocked) / 2
      local _, middle_y = Walk.place_on(on, box, middle)
      if Walk.room_at(middle, middle_y, contact) >= 0 then free = middle else blocked = middle end
    end
    x, y = Walk.place_on(on, box, free)
    box.x, box.y = Walk.place_on(on, box, from)  -- on its way back it would meet what it has passed
  end
  local met
  local stop = on.stop
  met, x, y = self:cast_to(on, box, x, y)
  if met and self:sinks(Walk.at(met.x, met.y, box), met, y) then met, x, y = self:cast_to(on, box, x, y) end
  on.stop = stop
  box.x, box.y = met and met.x or x, met and met.y or y
end

-- Whether the floor is a curve that goes on above what the body has met below it, on the chord of its way from x to
-- the goal: another floor, or the upper end of a side.
function Walk.leads_above(on, box, contact, from, goal_x)
  if Walk.is_straight(on) then return false end
  local at, slack = contact.x, Walk.settled(box)
  if contact.ny == 0 then
    local _, y = Walk.place_on(on, box, at)
    return not contact.other and y < contact.y and y + box.h <= Terrain.top_of_side(contact)
  end
  local function room(x)
    local place_x, place_y = Walk.place_on(on, box, x)
    return Walk.room_at(place_x, place_y, contact)
  end
  if abs(at - from) > slack then return room(at) > max(Walk.MOST_SAG, slack) end
  local way = (goal_x - at) / 2
  while room(at + way) <= slack and abs(way) > AHEAD do way = way / 2 end
  return room(at + way) > slack
end

-- Puts a body that has come below a curve, on the chord of its way, on the curve, or as near to it as a ceiling lets
-- it.
function Walk:lift_onto(on, box)
  if Walk.is_straight(on) then return end
  local _, y = Walk.place_on(on, box, box.x)
  if y >= box.y then return end
  local met = self:cast(box, 0.0, y - box.y)
  box.y = met and met.y or y
end

-- Up to where a curve that is the floor is above the other floor that the body has met on its chord, or the same as
-- that, px, x of the box; nil: up to the goal. If what it met is no line of a floor, that is where it is.
function Walk:end_above(on, box, contact, goal_x)
  local from = contact.x
  if contact.facing ~= UP or not contact.edge or contact.on_end then return from end
  local met, slack, direction = self:floor_of(contact, box), Walk.settled(box), self.direction
  local function is_below(x)
    local _, y = Walk.place_on(on, box, x)
    local _, met_y = Walk.place_on(met, box, x)
    return y > met_y + slack
  end
  local ends = (goal_x - met.stop) * direction > 0
  local to = ends and met.stop or goal_x
  local part = (to - from) / Walk.PARTS_OF_WAY
  for i = 0, Walk.PARTS_OF_WAY do
    local below = from + part * i
    if is_below(below) then
      local above = i == 0 and below or below - part
      for _ = 1, i > 0 and HALVINGS or 0 do
        local x = (above + below) / 2
        if is_below(x) then below = x else above = x end
      end
      return above
    end
  end
  -- Behind the end another piece of that floor may go on.
  local beyond = from + direction * 2 * AHEAD
  if (to - beyond) * direction > 0 then beyond = to end
  return ends and (goal_x - beyond) * direction > 0 and beyond or nil
end

-- Along the chord of a curve; see cast_to. It passes floors that the curve is above.
function Walk:cast_along_chord(on, box, x, y)
  local contact, passed
  for count = 0, Walk.MOST_PASSED do
    contact = self:cast(box, x - box.x, y - box.y, on.met.edge.source)
    if not contact or count == Walk.MOST_PASSED then break end
    local stop = self:end_above(on, box, contact, x)
    if stop then
      if (stop - contact.x) * self.direction <= AHEAD then break end
      on.stop = stop
      x, y = Walk.place_on(on, box, stop)
    end
    passed = passed or {}
    passed[count + 1] = contact.edge.source or contact.edge
    passed[count + 1].is_ignored = true
  end
  if passed then
    for i = 1, #passed do passed[i].is_ignored = nil end
  end
  return contact, x, y
end
