// Shapes of tiles made of other forms: rectangles, ellipses, mirror images.
#pragma once

#include <talus/collision/shape.h>

namespace talus {

// A rectangle as a polygon. box: px from the tile's top left, its size above zero. degrees: by how much it is
// turned clockwise about its top left, any finite number.
TileShape polygon_of_rectangle(const Rect& box, double degrees = 0);

// No side of polygon_of_ellipse() is further than this from the ellipse, px, before its points are welded. An
// ellipse that needs more than kMaxPolygonPoints points for that has so many, and is off by more.
inline constexpr double kEllipseError = 1.0 / 16;

// The polygon with the fewest points, a multiple of four, that lie on an ellipse. box: px, around the ellipse
// before it is turned; degrees: as for a rectangle, about the top left of the box.
TileShape polygon_of_ellipse(const Rect& box, double degrees = 0);

// Which sides of a tile change places in a mirror image.
enum class ShapeMirror : std::uint8_t {
  left_right,  // left and right change places
  up_down      // top and bottom change places
};
// The mirror image of a shape in its own tile. A slope or profile keeps its own cell at its left end. A full
// one-way tile stays as it is. A conveyor goes the other way.
TileShape mirrored(TileShape shape, TileSize tile, ShapeMirror mirror);

// Ground between two straight lines, and between two upright ones; px from the tile's top left.
struct Trapezoid {
  double left;          // x of its left side
  double right;         // x of its right side, > left
  double top_left;      // y of the left end of its upper line
  double top_right;     // y of the right end
  double bottom_left;   // y of the left end of its lower line, >= top_left
  double bottom_right;  // y of the right end, >= top_right
};
// Cuts a usable polygon (see problem_of) at its points. The parts do not overlap, and are all of it.
std::vector<Trapezoid> trapezoids_of(const TileShape& polygon);

// Whether a place, px from the tile's top left, is in the ground of a usable shape (see problem_of). A
// one-way shape has no ground.
bool is_in_ground(const TileShape& shape, TileSize tile, Vec2 place);

}  // namespace talus
