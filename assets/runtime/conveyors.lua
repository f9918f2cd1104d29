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

local function conveyor_of(terrain, cell) return terrain.conveyors[terrain.tiles[cell]] or 0.0 end

-- How fast the surface that a box touches goes along it. Of full tiles the one counts that the middle of the box
-- touches, if it touches ground there; of two beside one another there, half of both.
local function conveyor_at(terrain, contact, x, y, w, h)
  local piece = contact.edge or contact.piece
  if piece then return piece.origin and conveyor_of(terrain, piece.origin) or piece.conveyor or 0.0 end
  local is_flat = contact.facing == UP or contact.facing == DOWN
  local middle, sum, count = (y + h / 2) / TILE_H, 0.0, 0
  if is_flat then middle = (x + w / 2) / TILE_W end
  for n = 1, 2 do
    local at = n == 1 and ceil(middle) - 1 or floor(middle)
    local column, row = is_flat and at or contact.column, is_flat and contact.row or at
    if terrain:is_solid(column, row) then
      sum = sum + conveyor_of(terrain, row * terrain.width + column)
      count = count + 1
    end
  end
  if count > 0 then return sum / count end
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

-- Bodies that meet rub on it. M: see meet.lua.
local function carry_meetings(M)
  local step, add_ground, terrain = M.step, M.add_ground, nil
  function M.step(world, input)
    terrain = world.terrain
    step(world, input)
  end
  function M.add_ground(m, nx, ny, contact)
    local touch = add_ground(m, nx, ny, contact)
    local x, y = M.place_at(m, M.time)
    touch.conveyor = conveyor_at(terrain, contact, x, y, m.w, m.h)
    return touch
  end
end
if World.meeting then carry_meetings(World.meeting) end

end

World.begin_conveyors()
