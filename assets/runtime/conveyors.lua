-- ---- Conveyors: ground whose surface goes along it, clockwise, at a speed in px a frame ----
has.conveyors = true

-- A function, as the names of a file of Lua are few.
function World.begin_conveyors()

local begin = Terrain.begin
function Terrain:begin(level)
  self.conveyors = {}  -- speeds, by tile
  for tile, shape in pairs(level.shapes) do self.conveyors[tile] = shape.conveyor end
  begin(self, level)
end

-- The pieces of a curve have its speed.
local function cut_conveyors()
  for kind, cut_one in pairs(cutter) do
    cutter[kind] = function(cut, curve)
      local count = #cut.pieces
      cut_one(cut, curve)
      for i = count + 1, #cut.pieces do cut.pieces[i].conveyor = curve.conveyor end
    end
  end
end
if has.segments then cut_conveyors() end

local function conveyor_of(terrain, cell)
  return terrain.conveyors[terrain.tiles[cell]] or 0.0
end

-- The mean speed of the ground along a side of a box, from `from` to `to`. Sums are of what speeds have more than the
-- first one, so that ground of one speed has exactly that. Ground that only touches an end of the side counts where
-- nothing else is.
local function add_speed(mean, from, to, speed)
  local shared = min(to, mean.to) - max(from, mean.from)
  if shared < 0 then return end
  if mean.count == 0 then mean.first = speed end
  mean.count = mean.count + 1
  mean.touched = mean.touched + (speed - mean.first)
  mean.length = mean.length + shared
  mean.along = mean.along + shared * (speed - mean.first)
end
local function mean_of(mean)
  if mean.count == 0 then return nil end
  if mean.length > 0 then return mean.first + mean.along / mean.length end
  return mean.first + mean.touched / mean.count
end

-- Adds those pieces in a cell that lie on a line, or end on it, and face as a contact, either of curves or of tiles, and
-- of them what is from `from` to `to`.
local function add_pieces(terrain, column, row, facing, line, of_curves, from, to, mean)
  if not terrain:is_detailed(column, row) then return end
  local cell = row * terrain.width + column
  for _, piece in ipairs(terrain:detail(column, row).pieces) do
    if piece.facing == facing and (piece.origin == nil) == of_curves then
      local is_wall = facing >= LEFT
      local is_on_line = piece.y0 == line and piece.y1 == line
      if is_wall then
        is_on_line = piece.x0 == line
      elseif (piece.y0 == line) ~= (piece.y1 == line) then
        local at = piece.y0 == line and piece.x0 or piece.x1
        local speed = of_curves and (piece.conveyor or 0.0) or conveyor_of(terrain, piece.origin)
        if at >= from and at <= to then add_speed(mean, at, at, speed) end
      end
      if is_on_line then
        local speed = piece.conveyor or 0.0
        -- The walls of tiles above one another are one, which has the origin of the first.
        if not of_curves then
          speed = conveyor_of(terrain, is_wall and terrain:outline(column, row) and cell or piece.origin)
        end
        add_speed(mean, max(is_wall and piece.y0 or piece.x0, from), min(is_wall and piece.y1 or piece.x1, to), speed)
      end
    end
  end
end

-- The y of level ground that was met, or the x of upright ground.
local function line_of(contact, piece, is_upright)
  if piece then
    if is_upright then return piece.x0 end
    return contact.facing == UP and min(piece.y0, piece.y1) or max(piece.y0, piece.y1)
  end
  local after = (contact.facing == RIGHT or contact.facing == DOWN) and 1 or 0
  if is_upright then return (contact.column + after) * TILE_W end
  return (contact.row + after) * TILE_H
end

-- The mean speed of the level or upright ground that the side of a box touches; nil if nothing is there.
local function mean_conveyor(terrain, contact, piece, x, y, w, h)
  local facing = contact.facing
  local is_upright = facing >= LEFT
  local across, side = is_upright and TILE_W or TILE_H, is_upright and TILE_H or TILE_W
  local last_across, last_along = terrain.height - 1, terrain.width - 1
  if is_upright then last_across, last_along = last_along, last_across end
  local line = line_of(contact, piece, is_upright)
  local curves = clamp(floor(line / across), 0, last_across)
  local tiles = (facing == UP or facing == LEFT) and floor(line / across) or ceil(line / across) - 1
  local from, to = x, x + w
  if is_upright then from, to = y, y + h end
  local mean = {from = from, to = to, first = 0.0, touched = 0.0, length = 0.0, along = 0.0, count = 0}
  local first, last = clamp(ceil(from / side) - 1, 0, last_along), clamp(floor(to / side), 0, last_along)
  for i = first, last do
    local start, stop = i * side, (i + 1) * side
    local column, row = is_upright and tiles or i, is_upright and i or tiles
    if terrain:is_detailed(column, row) then
      add_pieces(terrain, column, row, facing, line, false, start, stop, mean)
    elseif terrain:is_solid(column, row) then
      add_speed(mean, start, stop, conveyor_of(terrain, row * terrain.width + column))
    end
    -- The cells at the sides of the terrain have the curves beyond it, too.
    column, row = is_upright and curves or i, is_upright and i or curves
    add_pieces(terrain, column, row, facing, line, true, i == 0 and -huge or start, i == last_along and huge or stop,
               mean)
  end
  return mean_of(mean)
end

-- How fast the surface that a box touches goes along it.
local function conveyor_at(terrain, contact, x, y, w, h)
  local piece = contact.edge or contact.piece
  -- A flat side may lie on the ends of slopes, beside level ground.
  local is_straight = not piece or piece.facing >= LEFT or piece.y0 == piece.y1 or contact.on_end and contact.nx == 0
  local mean = is_straight and mean_conveyor(terrain, contact, piece, x, y, w, h)
  if mean then return mean end
  if piece then return piece.origin and conveyor_of(terrain, piece.origin) or piece.conveyor or 0.0 end
  return conveyor_of(terrain, contact.row * terrain.width + contact.column)
end

-- How fast the floor that a body stands on carries it, as its velocity along x is measured.
local function conveyor_under(world, body, box)
  local y, met = floor_under(world, body, box, LIP)
  if not y or met.other then return 0.0 end
  local speed = conveyor_at(world.terrain, met, box.x, box.y, box.w, box.h)
  return world.tuning.surface_speed ~= 0 and speed or speed * -met.ny
end

-- A player runs, and stands, in relation to its floor.
local function carry_players(run)
  function rules.run(world, body, box, input)
    box.carried = body.grounded and conveyor_under(world, body, box) or 0.0
    run(world, body, box, input)
  end
end
if rules.run then carry_players(rules.run) end

-- The point at which a circle touches a level or upright side, as a box without size.
local function point_on(side, x, y)
  return clamp(x, side.ax, side.bx), clamp(y, min(side.ay, side.by), max(side.ay, side.by)), 0.0, 0.0
end

-- The same for a body that meets others. What keeps its ground keeps the speed: on the way over a joint a body that has
-- become as fast as its conveyor would be too fast at once, and so on.
local function conveyor_of_touch(M, terrain, m, nx, ny, contact)
  local place = contact.facing >= LEFT and 2 or 1
  local belt = m.belts[place]
  if belt and belt.nx == nx and belt.ny == ny then return belt.speed end
  local speed
  if contact.ax then
    speed = conveyor_at(terrain, contact, point_on(contact, M.middle(M.form_at(m, M.time))))
  else
    local x, y = M.place_at(m, M.time)
    speed = conveyor_at(terrain, contact, x, y, m.w, m.h)
  end
  m.belts[place] = {nx = nx, ny = ny, speed = speed}
  return speed
end

-- Bodies that meet rub on it. M: see meet.lua.
local function carry_meetings(M)
  local step, add_ground, terrain = M.step, M.add_ground, nil
  local run_part, resolve = M.run_part, M.resolve
  function M.run_part(world)
    for _, m in ipairs(M.members) do m.belts = {} end
    run_part(world)
  end
  function M.resolve(world, event)
    if event.kind == "ground" then event.a.belts = {} end
    resolve(world, event)
  end
  function M.step(world, input)
    terrain = world.terrain
    step(world, input)
  end
  function M.add_ground(m, nx, ny, contact)
    local touch = add_ground(m, nx, ny, contact)
    touch.conveyor = conveyor_of_touch(M, terrain, m, nx, ny, contact)
    return touch
  end
end
if World.meeting then carry_meetings(World.meeting) end

end

World.begin_conveyors()
