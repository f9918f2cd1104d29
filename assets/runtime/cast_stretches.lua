-- ---- Casts against curves ----

function curved(first, last, first_y, last_y, open_first, open_last, up, piece, offset, lift)
  local from, to, gap, last_gap = window_of(first, last, first_y, last_y, open_first, open_last, up, piece)
  local t = curve_time(piece, bx, by, dx, dy, offset, lift, slack, from, to, gap, last_gap)
  if t then offer(t, piece.facing, false, piece, 0.0, first, last) end
end
