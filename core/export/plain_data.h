// What plain exports tell about the ground: one computation for Lua, JSON, CSV, C and SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/collision/terrain.h>
#include <talus/level/level.h>
#include <talus/level/progress.h>

namespace talus {

// The shape of a tile as numbers. y: px from the tile's top, down.
struct PlainShape {
  int tile = 0;  // 0..255
  TileShape::Kind kind = TileShape::Kind::solid;
  bool is_ceiling = false;  // ground lies above the line, from the tile's top; else below it, to its bottom
  bool one_way = false;     // only the line stops bodies, and only from its open side
  int tiles = 1;            // width; what is beyond the first reaches over the cells to the right
  std::vector<double> ys;   // of the line at equal distances, both ends included; 2 at least
  // Of the line in the middle of each column of pixels, x = 0.5, 1.5, ...; 8 * tiles. Where a floor is at 8,
  // or a ceiling at 0, there is nothing, unless it is one-way.
  std::vector<double> columns;

  // Whether bodies can stand on the shape at a y of its line: a ceiling has a flat top, where it is thick.
  bool has_floor_at(double y) const;
};

// Of every tile that has a usable shape (see ground_of), by number.
std::vector<PlainShape> plain_shapes(const TerrainSource& ground);

// A body at its start.
struct PlainBody {
  int id = 1;     // that the simulation gives it
  int tile = -1;  // of a ball that is a tile of the map; -1: it was placed by hand
  Spawn start;
};

// All bodies, in the order of their ids, from 1: the ball tiles of the map, its columns from left to right
// and each from top to bottom, and then what was placed by hand.
class PlainBodies {
 public:
  explicit PlainBodies(const Level& level);  // which must outlive it
  std::size_t size() const { return tiles_.size() + level_.spawns.size(); }
  PlainBody at(std::size_t index) const;  // index < size()

 private:
  const Level& level_;
  std::vector<Cell> tiles_;
};

// "2 curves", for Exported::dropped of exports that cannot hold those of the level; empty without any.
std::vector<std::string> dropped_curves(const Level& level);

// As the exports call them: "solid", "slope", "profile" or "none"; "ball" or "player"; "box" or "centre".
std::string_view kind_word(TileShape::Kind kind);
std::string_view body_word(BodyKind kind);
std::string_view foot_word(Foot foot);

// How far the points of a curve's line may leave the curve. A line between two of them stays within it.
inline constexpr double kPlainLineError = 1.0 / 64;  // px

// A thin line through points, px. Its open side is on the left hand of who walks along them, as that of a
// polygon is: floors go to the right.
struct PlainLine {
  bool is_curve = false;    // a free curve; else the line of one-way tiles
  bool both_sides = false;  // it stops bodies from both; curves alone
  std::string name;         // of a curve; may be empty
  std::vector<Vec2> points;
  friend bool operator==(const PlainLine&, const PlainLine&) = default;
};

// The lines of one-way tiles, as far as they are not inside of ground, joined where they meet, those that
// face up first and from left to right; then the curves in the level's order. Corners are exact.
std::vector<PlainLine> plain_lines(const Level& level, const Progress& progress = {});

}  // namespace talus
