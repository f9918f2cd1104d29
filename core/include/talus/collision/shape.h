// What the ground is made of: the shape of a tile, and curves that are free of the grid.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <talus/collision/geometry.h>

namespace talus {

inline constexpr int kMaxTileSide = 256;  // px

// The size of a terrain's tiles, each side 1 to kMaxTileSide px.
struct TileSize {
  int width = 8;   // px
  int height = 8;  // px
  friend bool operator==(const TileSize&, const TileSize&) = default;
};

// Whether a terrain's tiles can have this size.
constexpr bool is_tile_size(TileSize size) {
  return size.width >= 1 && size.width <= kMaxTileSide && size.height >= 1 && size.height <= kMaxTileSide;
}

inline constexpr int kMaxShapeTiles = 8;  // tiles that one slope may span, in width or in height

// How many heights a profile has at most: one for each column of pixels of the widest, and one more.
constexpr int max_shape_heights(TileSize tile) { return kMaxShapeTiles * tile.width + 1; }

inline constexpr std::size_t kMaxPolygonPoints = 256;  // of one polygon
inline constexpr std::size_t kMaxGroupParts = 64;      // of one group
inline constexpr std::size_t kMaxGroupPoints = 1024;   // of all polygons of one group
inline constexpr double kMaxConveyor = 64;             // px/frame, of a conveyor in either direction

// Which part of a body's box stands on slopes: its whole bottom edge, or the middle of it.
enum class Foot : std::uint8_t { box, centre };

// The number of a tile, by which cells say what is in them.
using TileNumber = std::uint16_t;
inline constexpr int kMaxTiles = 65'536;  // different tiles, as many as there are numbers

// A straight line between two points, with from.x <= to.x. A vertical one has from.y < to.y; one that only
// becomes vertical by welding may have any y.
struct Segment {
  Vec2 from;  // px, welded
  Vec2 to;    // px, welded
  friend bool operator==(const Segment&, const Segment&) = default;
};

// The shape that a cell of the grid gives to the ground. A slope belongs to the cell at its left end. It may
// reach over the cells to its right, and up (a floor) or down (a ceiling). A polygon may reach over the cells
// on all sides.
struct TileShape {
  // What the ground in the cell is.
  enum class Kind : std::uint8_t {
    none,     // air; the fields below are not used
    solid,    // the whole cell; of the fields below only `one_way` is used
    slope,    // a straight line between two heights
    profile,  // a line through several heights, at equal distances
    polygon,  // the inside of `points`
    group     // all of its `parts`; only they and `kind` are used
  };
  // On which side of the line the ground lies.
  enum class Side : std::uint8_t {
    floor,    // ground between the line and the cell's bottom; heights are measured upwards from there
    ceiling,  // ground between the line and the cell's top; heights are measured downwards from there
    // Of one-way polygons that cells turn by a quarter: their lines to the left or to the right would stop
    // bodies. No solver knows such ground, so problem_of() refuses it.
    left,
    right
  };
  Kind kind = Kind::none;  // what the ground is
  // Of a slope or profile; of a one-way polygon, whether its upper (floor) or its lower lines stop bodies.
  Side side = Side::floor;
  bool one_way = false;  // only the line stops bodies, and only those that come from its open side
  int tiles = 1;         // width in tiles, 1..kMaxShapeTiles
  // px, 0 to kMaxShapeTiles times the tile's height, left to right: 2 for a slope, 3 to max_shape_heights()
  // for a profile, empty for the others.
  std::vector<double> heights = {};
  // px from the tile's top left, around a polygon in either direction; empty for the others. They are welded.
  // 3 to kMaxPolygonPoints points, none further than kMaxShapeTiles tiles from the tile. No two sides may
  // meet but neighbours in their common end.
  std::vector<Vec2> points = {};
  // px from the tile's top left. Of a polygon that is a part of a larger area: for each point, the line that
  // the side from there to the next point is a part of. Then points are not welded, as they lie on these
  // lines. Empty: each side is a line of its own.
  std::vector<Segment> lines = {};
  // Of a group, 1 to kMaxGroupParts; empty for the others. No part is a group or nothing. Where parts overlap
  // or touch, they are one. Their polygons have at most kMaxGroupPoints points.
  std::vector<TileShape> parts = {};
  // px/frame, -kMaxConveyor to kMaxConveyor: the speed at which its surface goes round it clockwise: on a
  // floor to the right. 0: it stands still. Parts of a group have 0.
  double conveyor = 0;
  friend bool operator==(const TileShape&, const TileShape&) = default;
};

// Whether a shape is a slope or a profile, and so has a line through heights.
inline bool has_heights(const TileShape& shape) {
  return shape.kind == TileShape::Kind::slope || shape.kind == TileShape::Kind::profile;
}
// Whether a shape is a polygon or a group, and so no single line or full tile.
inline bool has_parts(const TileShape& shape) {
  return shape.kind == TileShape::Kind::polygon || shape.kind == TileShape::Kind::group;
}

// Why a shape is invalid for tiles of a size, as the end of a sentence ("has a height that is not a number");
// nothing if it is valid.
std::optional<std::string> problem_of(const TileShape& shape, TileSize tile);

inline constexpr int kWeldParts = 256;  // of a px; ends are rounded to it

// Rounds to 1/256 px, halves away from zero: ends that ought to meet do, and mirrored ones are mirrored.
double weld(double coordinate);
// The same for both coordinates.
inline Vec2 weld(Vec2 point) { return {weld(point.x), weld(point.y)}; }

// Curves are thin lines y = f(x); px. Each stops bodies on the sides that it faces. Their ends, the control
// point of a parabola and the heights of a polyline are welded: rounded to 1/256 px. Other numbers are not. A
// curve without width after that (a segment: without length) cannot be used.
//
// So all ends meet others on that grid. Where this puts the end of an arc or a sine off the curve, the last
// quarter of a px, but at most half of the curve, is a straight line to the end.
//
// A part of a circle.
struct Arc {
  Vec2 center;        // px
  double radius = 0;  // px, > 0
  double x0 = 0;      // px, left end, within the circle, welded
  double x1 = 0;      // px, right end, > x0, within the circle, welded
  bool upper = true;  // the upper half of the circle (a hill), else the lower (a bowl)
  friend bool operator==(const Arc&, const Arc&) = default;
};
// The quadratic Bezier curve whose control point is half way between the ends in x.
struct Parabola {
  Vec2 from;             // px, left end, welded
  Vec2 to;               // px, right end, to.x > from.x, welded
  double control_y = 0;  // px, of the control point, welded
  friend bool operator==(const Parabola&, const Parabola&) = default;
};
// A cubic in Hermite form.
struct Cubic {
  Vec2 from;              // px, left end, welded
  Vec2 to;                // px, right end, to.x > from.x, welded
  double from_slope = 0;  // dy/dx at the left end
  double to_slope = 0;    // dy/dx at the right end
  friend bool operator==(const Cubic&, const Cubic&) = default;
};
// y = middle + amplitude * sin(2 pi (x - origin) / wavelength).
struct Sine {
  double x0 = 0;          // px, left end, welded
  double x1 = 0;          // px, right end, > x0, welded
  double middle = 0;      // px, y of the zero crossings
  double amplitude = 0;   // px, any sign
  double wavelength = 0;  // px, > 0; x0..x1 holds at most kMaxWaves waves
  double origin = 0;      // px, where the sine is 0 and, with a positive amplitude, goes down on the screen
  friend bool operator==(const Sine&, const Sine&) = default;
};
// Straight lines through heights at equal distances. The distances are at least 1/256 px, and welded, too.
struct Polyline {
  double x0 = 0;           // px, left end, welded
  double x1 = 0;           // px, right end, > x0, welded
  std::vector<double> ys;  // px, welded, left to right; 2..kMaxPolylineHeights of them
  friend bool operator==(const Polyline&, const Polyline&) = default;
};

// A curve with the sides that it stops bodies on.
struct Curve {
  // The direction of its normals. A vertical segment that faces up faces left; one that faces down faces
  // right. A segment that only becomes vertical by welding keeps its side.
  enum class Faces : std::uint8_t { up, down, both };
  std::variant<Segment, Arc, Parabola, Cubic, Sine, Polyline> form;  // where it runs
  Faces faces = Faces::up;                                           // the sides that stop bodies
  double conveyor = 0;  // px/frame, as TileShape::conveyor: on its upper side to the right
  friend bool operator==(const Curve&, const Curve&) = default;
};

// A terrain may be long or high: only its area is limited, so that the index of a cell fits 32 bits.
inline constexpr int kMaxTerrainSide = 1 << 21;    // cells
inline constexpr int kMaxTerrainCells = 1 << 24;   // 4096 x 4096
inline constexpr double kMaxCoordinate = 1 << 24;  // px; no terrain or curve goes further from the origin
inline constexpr double kMaxWaves = 4096;          // of a sine; each is cut into four stretches
inline constexpr std::size_t kMaxPolylineHeights = 65536;  // of one polyline

// Whether a terrain of such tiles can have this size, in cells.
constexpr bool is_terrain_size(std::int64_t width, std::int64_t height, TileSize tile = {}) {
  const auto is_side = [](std::int64_t cells, int tile_side) {
    return cells >= 1 && cells <= kMaxTerrainSide && static_cast<double>(cells * tile_side) <= kMaxCoordinate;
  };
  return is_tile_size(tile) && is_side(width, tile.width) && is_side(height, tile.height) &&
         width * height <= kMaxTerrainCells;
}

// Why a curve is invalid, in the words of problem_of(shape); nothing if it is valid.
std::optional<std::string> problem_of(const Curve& curve);

// About how many cells of a size a curve crosses, on a map or off it. A cell counts each time that the curve
// enters it, and twice if the curve faces both ways. The memory of a terrain for a curve grows with this
// number. At least 0, and finite for valid curves.
double cells_passed(const Curve& curve, TileSize tile);

}  // namespace talus
