// Where a point that is dragged on the map is put: on ends of other lines, on borders of tiles, on pixels.
#pragma once

#include <talus/level/level.h>

namespace talus {

struct SnapRules {
  double zoom = 1;         // screen px per level px: a hand is as exact as the screen
  bool off = false;        // nowhere: to 1/256 px alone, as curves are
  bool halves = false;     // to halves of a pixel alone
  int without_curve = -1;  // index of the curve that is dragged itself: its ends do not count; -1: none
};

struct SnappedPoint {
  enum class To { nothing, half, pixel, tile, end };
  Vec2 point;  // px
  To to = To::nothing;
  friend bool operator==(const SnappedPoint&, const SnappedPoint&) = default;
};

// To the nearest end of a curve or of a sloped tile's line within 6 px of the screen; else each coordinate to
// the border of a tile within 2 px of the screen, else to a whole pixel.
SnappedPoint snap(const Level& level, Vec2 point, const SnapRules& rules);

// The nearest point on the map, its edges included: where a drag that goes beside it is meant to begin or
// end.
Vec2 onto_map(const TileMap& map, Vec2 point);

}  // namespace talus
