-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
-- `love . --trace FRAMES` prints frame, id, x, y, vx and vy of every body in every frame, as `talus sim --trace` plays
-- the level, without keys and without the game's rules, and ends.
return function(world, frames)
  for _ = 1, frames do
    world:step()
    for _, b in ipairs(world.bodies) do
      print(string.format("%d %d %.17g %.17g %.17g %.17g", world.frame, b.id, b.x, b.y, b.vx, b.vy))
    end
  end
  love.event.quit()
end
