-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- Talus: boxes on slopes, swept exactly. Talus made this file for one level; parts that the level does not use
-- are left out. Lua 5.3, 5.4 and LuaJIT give the same bits as the program: every sum is made in the same order.
-- Lengths in pixels, y down; velocities in px a step.
--
--   local talus, level = require "talus", require "level"
--   local world = talus.new(level)
--   world:step {left = false, right = true, jump = false}   -- one frame further; all keys may be missing
--   for _, body in ipairs(world.bodies) do draw(body.x, body.y, body.w, body.h) end
--
-- A body has kind (a key of level.kinds, such as "ball"), x, y, w, h, vx, vy, grounded, and tile, if it is a tile
-- of the map.
-- With the part events, world.events lists what happened in the last step: {kind = "hit", body, other, nx, ny,
-- impulse}, where other is a body, or nil for the ground; {kind = "landed", body}; {kind = "left", body}.
-- Between steps you may change vx and vy, or x and y; then also set clear to false, which frees it from walls.
-- With the part steer, bodies have touched, what they met in the last step at their floor, ceiling, left and right; and
-- they may have input, keys of their own, run_speed, and sensor, true if they pass all bodies.
-- With the part mouse, step() also takes mouse_x, mouse_y and mouse_down, and drags bodies; games for LÖVE and
-- TIC-80 have it. You can ask about the ground, for any box:
--   world:floor(x, y, w, h, 16)      -- the floor's y, at most 16 px below, and its normal nx, ny; or nil
--   world:cast(x, y, w, h, dx, dy)   -- its first contact on that way: t (0..1), x, y, nx, ny; or nil
--   world:overlaps(x, y, w, h)       -- whether it is in the ground
-- The part data tells what the level says beside its ground; x, y: a point of the map:
--   world:flags_at(x, y).ladder             -- whether a tile there has the flag; flags_at(x, y, "front"): in a layer
--   world:tile_at(x, y)                     -- the number of the foremost tile that is not 0, or 0; nil beside the map
--   world:objects {class = "coin"}          -- a list of objects, by class, name and layer: see level.objects
--   world:tiles_with("coin")                -- a list of cells whose tile has the flag: column, row, layer, tile, x, y
--   world:has_flag("coin")                  -- whether the level has such a flag
--
-- What the game adds to the level while it runs:
--   world:add {kind = "player", x = 40, y = 8}   -- a body, which it returns
--   world:remove(body)                           -- takes one out (part steer)
--   world:bodies_in(x, y, w, h)                  -- lists those that a box overlaps (part steer)
--   world:cell_beside(body, side)                -- the cell that one touches at a side (part steer)
--   world:floor_ahead(body, side)                -- whether there is ground at its left or right (part steer)
--   world.terrain:set_tile(x, y, tile)           -- another tile in a cell, counted from 0; with the part data rather
--                                                   world:set_tile(x, y, tile), which the game's pictures follow
-- needs the parts for it: balls and players, for bodies that fall or run; pairs, for several bodies that block one
-- another; slopes and one_way, for tiles of these shapes. Parts that the level itself does not use are named in the
-- export, as in `talus export FILE --to lua-runtime --parts players,pairs -o OUT`, or in the preset's field
-- Parts. talus.parts lists the parts of this file.

local floor, ceil, abs, sqrt, huge = math.floor, math.ceil, math.abs, math.sqrt, math.huge
local TILE_W, TILE_H = 8.0, 8.0   -- px, a cell of the terrain that is looked at; see Terrain:use
local ROUNDING = 8 * 2.0 ^ -52    -- relative error of a number after a few roundings
local SLICE_TILES = 2             -- longer motions are cut, so that only cells near the way are looked at
local SHORT = 16.0                -- px; motions up to this have the same slack
-- The directions that a side of the ground may face; it stops only what comes from there.
local UP, DOWN, LEFT, RIGHT = 1, 2, 3, 4

local function min(a, b) if b < a then return b end return a end
local function max(a, b) if a < b then return b end return a end
local function clamp(v, least, most)
  if v < least then return least end
  if most < v then return most end
  return v
end

-- From a to b by the share t, in the article's own order.
local function lerp(a, b, t) return ((1 - t) * a) + (t * b) end

-- A number of twice the precision is two numbers: one, and what rounding took from it (Dekker, Knuth).
local function two(large, small)
  local high = large + small
  return high, small - (high - large)
end
local function two_add(a, a_low, b, b_low)
  local sum = a + b
  local part = sum - a
  local lost = (a - (sum - part)) + (b - part)
  return two(sum, lost + (a_low + b_low))
end
local function two_multiply(a, a_low, b, b_low)
  local product = a * b
  -- Lua has no fused multiplication: the halves of both factors give the same result.
  local scaled = 134217729.0 * a
  local a_high = scaled - (scaled - a)
  local a_rest = a - a_high
  scaled = 134217729.0 * b
  local b_high = scaled - (scaled - b)
  local b_rest = b - b_high
  local lost = ((a_high * b_high - product) + a_high * b_rest + a_rest * b_high) + a_rest * b_rest
  return two(product, lost + (a * b_low + a_low * b))
end
local function two_divide(a, a_low, b, b_low)
  local quotient = a / b
  local high, low = two_multiply(b, b_low, quotient, 0.0)
  high, low = two_add(a, a_low, -high, -low)
  return two(quotient, (high + low) / b)
end

-- Tables that parts add to. A function of a later part replaces an earlier one, or calls it.
local Terrain = {}  -- methods of the ground
Terrain.__index = Terrain
local World = {}    -- methods of the world
World.__index = World
local rules = {}    -- by name, which kinds of bodies have: a function(world, body, box, input), one frame
local has = {}      -- by name: true for each part of this file
