-- ---- Contacts of circles: friction turns them ----
-- In a set, a body has `sspin` and `sspin_pull`, px/frame and px/frame^2 of a circle's rim, clockwise, and `yields`,
-- px/frame, by which an impulse of 1 along the rim changes its spin: 0, of a box. A contact of a circle has `slow`,
-- px/frame: what parts or slides more slowly is held as if it did not; and may have `parts`, px/frame^2: the gap that
-- straight ways would open, as the other one is bent.

-- A function, as the names of a file of Lua are few. M: see meet.lua.
function World.begin_spins(M)

local STILL = 1e-11  -- px/frame
local MOST_EXACT = 8  -- contacts of circles that are solved together with their friction
local A, b, x = M.A, M.b, M.x

-- Two that turn the same way rub against one another.
local function turning(touch, what)
  local one = touch.a[what]
  return touch.b and one + touch.b[what] or one
end

local function any_turns()
  for _, m in ipairs(M.set) do
    if m.yields > 0 then return true end
  end
  return false
end

-- px/frame: how fast the surface of the body slides on that of the other one.
function M.slip(touch)
  return M.speed(touch, -touch.ny, touch.nx) - turning(touch, "sspin") - touch.conveyor
end

local gain = M.gain
function M.gain(touch, nx, ny) return gain(touch, nx, ny) + (touch.parts or 0.0) end

local function turn(touch, what, impulse)
  local one, other = touch.a, touch.b
  if one.yields ~= 0 then one[what] = one[what] - impulse * one.yields end
  if other and other.yields ~= 0 then other[what] = other[what] - impulse * other.yields end
end

local function along(touch, of) return {touch = touch, x = -touch.ny, y = touch.nx, rubs = true, of = of} end

-- of: the contact's place among those that are solved.
local function rows_across(chosen)
  local rows = {}
  for i, touch in ipairs(chosen) do rows[i] = {touch = touch, x = touch.nx, y = touch.ny, of = i} end
  return rows
end

local function add_friction(rows, chosen)
  for i, touch in ipairs(chosen) do
    if touch.friction > 0 then rows[#rows + 1] = along(touch, i) end
  end
end

-- what: "sspin" for a system of speeds, "sspin_pull" for one of pulls.
local set_up = M.set_up
function M.set_up(rows, value, what)
  set_up(rows, value)
  local size = #rows
  for i, row in ipairs(rows) do
    local one = row.touch
    if row.rubs then
      b[i] = b[i] - turning(one, what)
      if what == "sspin" then b[i] = b[i] - one.conveyor end
      for k = 1, i do
        if rows[k].rubs then
          local other, at = rows[k].touch, (i - 1) * size + k
          if one.a == other.a or one.a == other.b then A[at] = A[at] + one.a.yields end
          if one.b and (one.b == other.b or one.b == other.a) then A[at] = A[at] + one.b.yields end
          A[(k - 1) * size + i] = A[at]
        end
      end
    elseif what == "sspin_pull" then
      b[i] = b[i] + (one.parts or 0.0)
    end
  end
end

-- Gives both bodies of a contact the impulse of a row.
local function push(row, impulse)
  M.push(row.touch, row.x * impulse, row.y * impulse)
  if row.rubs then turn(row.touch, "sspin", impulse) end
end

-- ---- Friction and pressures ----

-- The bounds of friction, from the rows of normals on, for the pressures of the last try. An impact may end what
-- slides; a pull works against it.
local function bound_friction(rows, normals, before, is_impact)
  for i = normals + 1, #rows do
    local touch = rows[i].touch
    local most = touch.friction * max(before[rows[i].of], 0.0)
    local slides = is_impact and 0.0 or M.slip(touch)
    local is_sliding = abs(slides) > max(STILL, touch.slow or 0.0)
    M.bound(i, is_sliding and slides < 0 and most or -most, is_sliding and slides > 0 and -most or most)
  end
end

-- The next pressures to try, from the last two tries: the sum of the two, with weights of 1 in all, whose change is
-- least. Returns the last ones.
local function hurry(before, change, last_change, last)
  local product, square, now = 0.0, 0.0, {}
  for i, value in ipairs(change) do
    local apart = value - last_change[i]
    product = product + value * apart
    square = square + apart * apart
    now[i] = before[i]
  end
  local share = square > 0 and product / square or 0.0
  if #last == #change then
    for i = 1, #change do before[i] = max(0.0, now[i] - share * (now[i] - last[i])) end
  end
  return now
end

-- Friction depends on the pressure, and the pressure on friction: each is solved for the last of the other. Where
-- sliding would press a body ever more into what it slides on, no answer is finite: then friction is that of the
-- pressures without it.
local function solve_with_friction(rows, normals, is_impact)
  local same_turning, hurries, rubs = is_impact and 1e-4 or 1e-7, any_turns(), #rows > normals
  local before, unrubbed, last_change, last = {}, {}, {}, {}
  local ends, tries, first, largest, most = false, 0, 0.0, 0.0, 0.0
  for i = 1, normals do before[i] = 0.0 end
  while tries < 200 and not ends and not (largest > 100 * first) do
    bound_friction(rows, normals, before, is_impact)
    local is_solved
    if rubs then is_solved = M.solve_evenly() else is_solved = M.solve() end
    local change = {}
    ends, largest = true, 0.0
    for i = 1, normals do
      ends = ends and abs(x[i] - before[i]) <= (hurries and same_turning * most or 1e-13 * x[i])
      change[i] = x[i] - before[i]
      before[i], largest = x[i], max(largest, x[i])
    end
    most = max(most, largest)
    ends = ends and is_solved
    if hurries and tries > 1 and not ends then last = hurry(before, change, last_change, last) end
    last_change = change
    if not rubs then break end
    if tries == 0 then
      first = largest
      for i = 1, normals do unrubbed[i] = before[i] end
    end
    tries = tries + 1
  end
  if rubs and not ends and largest > 2 * first then
    bound_friction(rows, normals, unrubbed, is_impact)
    M.solve_evenly()
  end
end

-- ---- What a set does ----

-- Friction of impulses along the normals.
local function rub(chosen, given)
  local rows = {}
  for i, touch in ipairs(chosen) do
    if touch.friction > 0 and given[i] > 0 then rows[#rows + 1] = along(touch, i) end
  end
  if #rows == 0 then return end
  M.set_up(rows, M.speed, "sspin")
  for i, row in ipairs(rows) do
    local most = row.touch.friction * given[row.of]
    M.bound(i, -most, most)
  end
  M.solve_evenly()
  for i, row in ipairs(rows) do push(row, x[i]) end
end

-- Friction that turns a circle presses it against what it touches elsewhere, so both are solved at once.
function M.reflect(chosen)
  local rows, rubs, given = rows_across(chosen), false, {}
  for _, touch in ipairs(chosen) do rubs = rubs or touch.friction > 0 end
  local normals = #rows
  local at_once = rubs and any_turns() and normals <= MOST_EXACT
  if at_once then add_friction(rows, chosen) end
  M.set_up(rows, M.speed, "sspin")
  for i = 1, normals do M.bound(i, chosen[i].caught and -huge or 0.0, huge) end
  if at_once then
    solve_with_friction(rows, normals, true)
  elseif rubs then
    M.solve_evenly()
  else
    M.solve()
  end
  for i, row in ipairs(rows) do
    local touch = row.touch
    if row.rubs then
      push(row, x[i])
    else
      given[i] = x[i] * (1 + touch.bounce)
      touch.impulse = touch.impulse + given[i]
      push(row, given[i])
      if at_once then given[i] = x[i] * touch.bounce end  -- the rest has rubbed
    end
  end
  rub(chosen, given)
end

-- What is left of pulls between large pressures is rounding.
local function forget_rounding()
  for _, m in ipairs(M.set) do
    local most = 1e-13 * m.strain
    if abs(m.spx) <= most then m.spx = 0.0 end
    if abs(m.spy) <= most then m.spy = 0.0 end
    if abs(m.sspin_pull) <= most then m.sspin_pull = 0.0 end
  end
end

function M.support(chosen)
  local rows = rows_across(chosen)
  local normals = #rows
  add_friction(rows, chosen)
  M.set_up(rows, gain, "sspin_pull")
  for i = 1, normals do M.bound(i, 0.0, huge) end
  solve_with_friction(rows, normals, false)
  for _, m in ipairs(M.set) do m.strain = 0.0 end
  for i, row in ipairs(rows) do
    local touch, one, other = row.touch, row.touch.a, row.touch.b
    if i <= normals then touch.pressure = x[i] end
    M.press(touch, row.x * x[i], row.y * x[i])
    if row.rubs then
      touch.rubbing = x[i]
      turn(touch, "sspin_pull", x[i])
    end
    one.strain = max(one.strain, abs(x[i]) * one.inverse)
    if other then other.strain = max(other.strain, abs(x[i]) * other.inverse) end
  end
  forget_rounding()
end

-- Contacts that can change anything, for stop_all(). given: impulses so far. tried: the same, as this turn began. last:
-- the same, as the last turn ended.
local function take_stops(chosen)
  local stops = {}
  for _, touch in ipairs(chosen) do
    local one, other = touch.a, touch.b
    local yields = one.inverse + (other and other.inverse or 0.0)
    if yields > 0 then
      touch.across_yields = yields
      touch.along_yields = yields + one.yields + (other and other.yields or 0.0)
      touch.given_x, touch.given_y = touch.pressure, touch.rubbing
      touch.last_x, touch.last_y = touch.pressure, touch.rubbing
      stops[#stops + 1] = touch
    end
  end
  return stops
end

local function push_stop(touch, change_x, change_y)
  local one, other = touch.a, touch.b
  touch.given_x, touch.given_y = touch.given_x + change_x, touch.given_y + change_y
  local x, y = touch.nx * change_x - touch.ny * change_y, touch.ny * change_x + touch.nx * change_y
  one.svx, one.svy = one.svx + x * one.inverse, one.svy + y * one.inverse
  one.sspin = one.sspin - change_y * one.yields
  if not other then return end
  other.svx, other.svy = other.svx - x * other.inverse, other.svy - y * other.inverse
  other.sspin = other.sspin - change_y * other.yields
end

local function stop_one(touch)
  local one, other, nx, ny = touch.a, touch.b, touch.nx, touch.ny
  local vx, vy, turning = one.svx, one.svy, one.sspin
  if other then vx, vy, turning = vx - other.svx, vy - other.svy, turning + other.sspin end
  local faster = vx * nx + vy * ny + touch.room
  local across = max(0.0, touch.given_x - faster / touch.across_yields)
  local most = touch.friction * across
  local slips = vx * -ny + vy * nx - turning - touch.conveyor
  local rubbed = clamp(touch.given_y - slips / touch.along_yields, -most, most)
  push_stop(touch, across - touch.given_x, rubbed - touch.given_y)
end

-- How much the turn goes against the way of the last ones, and the most that it has changed a contact, in px/frame.
local function result_of_turn(stops)
  local back, largest = 0.0, 0.0
  for _, touch in ipairs(stops) do
    local x, y = touch.given_x - touch.tried_x, touch.given_y - touch.tried_y
    back = back - (x * (touch.given_x - touch.last_x) + y * (touch.given_y - touch.last_y))
    largest = max(max(largest, abs(x) * touch.across_yields), abs(y) * touch.along_yields)
  end
  return back, largest
end

-- Ends all approaches that are faster than the `room` of each contact, without any bounce; nearly, but at a cost that
-- grows with the contacts alone: each is solved alone, again and again. `pressure` and `rubbing` of each get its
-- impulses; a call goes on from those of the last one. still: px/frame, it ends when a turn changes nothing by more.
function M.stop_all(chosen, still, most_turns)
  local stops, pace = take_stops(chosen), 1.0
  for turn = 1, most_turns do
    for _, touch in ipairs(stops) do touch.tried_x, touch.tried_y = touch.given_x, touch.given_y end
    for i = 1, #stops do stop_one(stops[i]) end
    for i = #stops, 1, -1 do stop_one(stops[i]) end
    local back, largest = result_of_turn(stops)
    if largest <= still or turn == most_turns then break end
    if back > 0 then pace = 1.0 end
    local after = (1 + sqrt(1 + 4 * pace * pace)) / 2
    local share = (pace - 1) / after
    pace = after
    for _, touch in ipairs(stops) do
      local x, y = (touch.given_x - touch.last_x) * share, (touch.given_y - touch.last_y) * share
      touch.last_x, touch.last_y = touch.given_x, touch.given_y
      push_stop(touch, x, y)
    end
  end
  for _, touch in ipairs(stops) do touch.pressure, touch.rubbing = touch.given_x, touch.given_y end
end

local function all_sliding(chosen)
  local count = 0
  for _, touch in ipairs(chosen) do
    if touch.friction > 0 and abs(M.slip(touch)) > max(STILL, touch.slow or 0.0) then count = count + 1 end
  end
  return count
end

-- Ends the slow motion of contacts that hold after support(). Returns whether one that slid has ended.
function M.settle(chosen)
  local rows, moves, slid = {}, false, all_sliding(chosen)
  local function add(row, speed)
    if abs(speed) > max(row.touch.still, row.touch.slow or 0.0) then return end
    rows[#rows + 1] = row
    moves = moves or speed ~= 0
  end
  for i, row in ipairs(rows_across(chosen)) do
    local touch = row.touch
    if touch.pressure > 0 then
      add(row, M.speed(touch, touch.nx, touch.ny))
      if abs(touch.rubbing or 0.0) < (1 - 1e-9) * touch.friction * touch.pressure then
        add(along(touch, i), M.slip(touch))
      end
    end
  end
  if not moves then return false end
  M.set_up(rows, M.speed, "sspin")
  for i = 1, #rows do M.bound(i, -huge, huge) end
  M.solve_evenly()
  for i, row in ipairs(rows) do push(row, x[i]) end
  return all_sliding(chosen) < slid
end

end

World.begin_spins(World.meeting)
