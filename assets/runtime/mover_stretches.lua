-- A curve that bends towards the box: whoever slides along it meets it again at once.
function is_hollow(piece)
  return piece.stretch ~= nil and piece.stretch.bends_down ~= (piece.facing == UP)
end

-- Turns a motion along the tangent of a hollow curve into the chord to where it goes on the curve: the chord,
-- that place, and the motion from there.
function follow(box, piece, x, y)
  local offset = foot_offset(piece, box.w, box.centre)
  local there = clamp(moved_x(box.x, box.w, x), min(box.x, piece.x0 - offset), max(box.x, piece.x1 - offset))
  local rest = rest_on(piece, there, box.w, box.h, box.centre)
  local chord_x, chord_y = there - box.x, rest - box.y
  local used = x == 0 and 1.0 or min(1.0, chord_x / x)
  local along_x, along_y = tangent_at(piece.stretch, there + offset)
  local length = sqrt(x * x + y * y) * (1 - used)
  local signed = (x < 0 and -1 or 1) * length
  if used < 1 then return chord_x, chord_y, there, rest, along_x * signed, along_y * signed end
  return chord_x, chord_y, there, rest, 0.0, 0.0
end
