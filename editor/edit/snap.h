// Where a dragged point on the map goes: to ends of other lines, to borders of tiles, to pixels.
#pragma once

#include <talus/level/level.h>

namespace talus {

struct SnapRules {
  double zoom = 1;         // screen px for each px of the level: a hand is as exact as the screen
  bool off = false;        // no snapping: only rounding to 1/256 px, as curves need
  bool halves = false;     // only to halves of a pixel
  int without_curve = -1;  // index of the dragged curve, whose own ends do not count; -1: no curve is dragged
};

struct SnappedPoint {
  enum class To { nothing, half, pixel, tile, end };
  Vec2 point;  // px
  To to = To::nothing;
  friend bool operator==(const SnappedPoint&, const SnappedPoint&) = default;
};

// Snaps to the nearest end of a curve or of a sloped tile's line within 6 px of the screen. Else each
// coordinate snaps to the border of a tile within 2 px of the screen, else to a whole pixel.
SnappedPoint snap(const Level& level, Vec2 point, const SnapRules& rules);

// Where an end of a slope of tiles goes: to the nearest end of a sloped tile's line within 6 px of the screen
// or 7/8 of a tile; else to the nearest side of a column, and there to the floor of a slope within 1.5 tiles,
// else to the side of a row, and out of solid ground up to its top, within 8 rows. zoom: as in SnapRules.
Vec2 snap_slope_end(const Level& level, Vec2 point, double zoom);

// The nearest point on the map, edges included: where a drag that goes beside the map should begin or end.
Vec2 onto_map(const TileMap& map, Vec2 point);

}  // namespace talus
