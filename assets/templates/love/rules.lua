-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- What the game is about: an example, for you to replace. Tiles with a flag of the name `coin` are coins to collect.
-- Those with `enemy` walk to and fro: jump on them. One that is met in any other way ends the game.
-- rules(world, level) begins a game and gives goes_on(), after each step: whether it does; and text(): what to show.
local tile_bodies = require "tile_bodies"
local PACE = 0.5  -- px a frame, of an enemy

local function sound(hertz)
  local data = love.sound.newSoundData(2000, 20000, 16, 1)
  for i = 0, 1999 do data:setSample(i, (1 - i / 2000) / 3 * math.sin(2 * math.pi * hertz * i / 20000)) end
  return love.audio.newSource(data)
end
local thud, ring = sound(110), sound(880)

-- Turns at walls, and where the floor ends.
local function walk(world, enemy)
  local way = enemy.input and enemy.input.right and "right" or "left"
  local ends = enemy.grounded and not world:floor_ahead(enemy, way)
  if ends or enemy.touched[way] then way = way == "left" and "right" or "left" end
  enemy.input = {[way] = true}
end

return function(world, level)
  local hero, coins, enemies, found = nil, {}, {}, 0
  level.kinds.coin = {rule = "still", foot = "box", look = "tile"}
  level.kinds.enemy = {rule = "run", foot = "box", look = "tile", run_speed = PACE}
  for _, body in ipairs(world.bodies) do hero = hero or level.kinds[body.kind].takes_keys and body end
  if hero then coins, enemies = tile_bodies(world, "coin"), tile_bodies(world, "enemy") end

  local function goes_on()
    for _, enemy in ipairs(enemies) do walk(world, enemy) end
    for _, event in ipairs(world.events) do
      if event.kind == "landed" and event.body == hero then thud:play() end
    end
    for _, body in ipairs(hero and world:bodies_in(hero.x, hero.y, hero.w, hero.h) or {}) do
      if body.kind == "enemy" then
        if hero.y + hero.h - hero.vy > body.y + body.h / 2 then return false end  -- it did not come from above
        hero.vy = -level.tuning.jump_speed / 2
      end
      if body.kind == "coin" then found = found + 1 end
      if body.sensor then
        world:remove(body)
        ring:play()
      end
    end
    return true
  end
  local function text() return #coins > 0 and found .. " of " .. #coins .. " coins" or "" end
  return {goes_on = goes_on, text = text}
end
