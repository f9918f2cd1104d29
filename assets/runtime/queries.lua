-- ---- Questions about the ground ----

local function block_of(terrain, x, y, w, h, margin, margin_y)
  local function column(at) return clamp(floor(at / TILE_W), -1, terrain.width) end
  local function row(at) return clamp(floor(at / TILE_H), -1, terrain.height) end
  return max(column(x - margin), 0), min(column(x + w + margin), terrain.width - 1),
         max(row(y - (margin_y or margin)), 0), min(row(y + h + (margin_y or margin)), terrain.height - 1)
end

-- skip_detailed: leaves out the tiles that slopes lead to.
local function overlaps_tile(terrain, x, y, w, h, forgiven, skip_detailed)
  local left, right, top, bottom = block_of(terrain, x, y, w, h, -forgiven)
  for row = top, bottom do
    for column = left, right do
      if terrain:is_solid(column, row) and
          not (skip_detailed and terrain:is_detailed(column, row)) then
        return true
      end
    end
  end
  return false
end

-- Whether the upright line at x is in a full tile, or between two that are side by side.
function Terrain:middle_is_in_tile(x, y, h, forgiven)
  local left, right, top, bottom = block_of(self, x, y, 0.0, h, -forgiven)
  for row = top, bottom do
    if self:is_solid(left, row) and self:is_solid(right, row) then return true end
  end
  return false
end

-- Whether the box is inside of anything but full tiles.
function Terrain:overlaps_shapes() return false end

-- Whether the box is inside of the ground by more than rounding.
local function overlaps_ground(terrain, x, y, w, h, is_centre)
  local forgiven = rounding_slack(x, y, w, h, 0.0, 0.0)
  if overlaps_tile(terrain, x, y, w, h, forgiven, is_centre) then return true end
  if is_centre and terrain:middle_is_in_tile(x + w / 2, y, h, forgiven) then return true end
  return terrain:overlaps_shapes(x, y, w, h, is_centre, forgiven)
end

-- How far the box is behind a side that it overlaps, and the way back to the front of the side.
local function exit_past(exits, piece, x, y, w, h, is_centre, forgiven)
  local distance, out_x, out_y
  if piece.facing >= LEFT then
    if not (y + h > piece.y0 + forgiven and y < piece.y1 - forgiven) then return end
    local limit = piece.facing == LEFT and piece.x0 - w or piece.x0
    if piece.facing == LEFT then distance = x - limit else distance = limit - x end
    out_x, out_y = limit - x, 0.0
  else
    if not (x + w > piece.x0 + forgiven and x < piece.x1 - forgiven) then return end
    local limit = piece.form.rest(piece, x, w, h, is_centre)
    if piece.facing == UP then distance = y - limit else distance = limit - y end
    out_x, out_y = 0.0, limit - y
  end
  if not (distance > forgiven) then return end
  -- Of two equally long ways the vertical one counts, so that mirrored boxes leave alike.
  local at = #exits + 1
  while at > 1 do
    local before = exits[at - 1]
    local is_less = distance < before.distance
    if distance == before.distance then is_less = out_x == 0 and before.x ~= 0 end
    if not is_less then break end
    at = at - 1
  end
  table.insert(exits, at, {distance = distance, x = out_x, y = out_y})
end

local Side = {}  -- the form of a full tile's sides
function Side.rest(side, _, _, h) return side.y0 - (side.facing == UP and h or 0.0) end

-- The sides in a cell: those of a full tile that no other tile covers.
function Terrain:sides(column, row)
  if not self:is_solid(column, row) then return {} end
  local x0, y0 = column * TILE_W, row * TILE_H
  local x1, y1 = x0 + TILE_W, y0 + TILE_H
  local sides = {}
  local function put(beside_x, beside_y, facing, ax, ay, bx1, by1)
    if self:is_solid(column + beside_x, row + beside_y) then return end
    sides[#sides + 1] = {x0 = ax, y0 = ay, x1 = bx1, y1 = by1, facing = facing, form = Side}
  end
  put(0, -1, UP, x0, y0, x1, y0)
  put(0, 1, DOWN, x0, y1, x1, y1)
  put(-1, 0, LEFT, x0, y0, x0, y1)
  put(1, 0, RIGHT, x1, y0, x1, y1)
  return sides
end

-- The shortest way out of the ground; nil if the box is not in it, or there is no way.
local function way_out(terrain, x, y, w, h, is_centre)
  if not overlaps_ground(terrain, x, y, w, h, is_centre) then return nil end
  local forgiven = rounding_slack(x, y, w, h, 0.0, 0.0)
  local exits = {}
  local left, right, top, bottom = block_of(terrain, x, y, w, h, forgiven)
  for row = top, bottom do
    for column = left, right do
      for _, side in ipairs(terrain:sides(column, row)) do
        exit_past(exits, side, x, y, w, h, is_centre, forgiven)
      end
    end
  end
  for _, exit in ipairs(exits) do
    -- A box that stands on its middle is not led off the floor there.
    local stays = is_centre and cast_box(terrain, x + w / 2, y, 0.0, h, exit.x, abs(exit.y))
    if not stays and not overlaps_ground(terrain, x + exit.x, y + exit.y, w, h, is_centre) then
      return exit.x, exit.y
    end
  end
  return nil
end
