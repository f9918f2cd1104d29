-- Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
function love.conf(t)
  t.identity = "talus-level"
  t.version = "11.4"
  t.window.title = "Talus level"
  t.window.width, t.window.height = 960, 544  -- 30 x 17 tiles of 8 px four times as large, or of 16 px twice
  t.window.resizable = true
  t.modules.physics, t.modules.video = false, false
end
