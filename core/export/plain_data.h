// Plain data on the ground, shared by the exports to Lua, JSON, CSV, C and SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/collision/terrain.h>
#include <talus/level/level.h>
#include <talus/level/progress.h>

namespace talus {

// The shape of a tile as numbers. y: px down from the tile's top.
struct PlainShape {
  int tile = 0;  // below tile_count()
  TileShape::Kind kind = TileShape::Kind::solid;
  // Ground lies above the line, up to the tile's top; else below it, down to the tile's bottom.
  bool is_ceiling = false;
  bool one_way = false;    // only the line stops bodies, and only from its open side
  int tiles = 1;           // width; all but the first reach over the cells to the right
  std::vector<double> ys;  // of the line, at equal distances from end to end; at least 2
  // Of the line in the middle of each column of pixels, x = 0.5, 1.5, ...; as many as the tiles are wide. A
  // floor at the tile's bottom, or a ceiling at 0, means that nothing is there, unless it is one-way.
  std::vector<double> columns;
  int tile_height = 8;  // px
  // Of a polygon or a group: the outline of each part, px from the tile's top left. Then `ys` and `columns`
  // are the highest ground over the tile, at the borders and in the middle of columns of pixels.
  struct Outline {
    bool one_way = false;
    bool is_ceiling = false;  // of a one-way one: whether its lower lines stop bodies
    std::vector<Vec2> points;
  };
  std::vector<Outline> outlines = {};
  double conveyor = 0;  // px/frame, as TileShape::conveyor

  // Whether bodies can stand on the shape at this y of its line. A ceiling has a flat top where it is thick.
  bool has_floor_at(double y) const;
};

// All usable shapes (see ground_of), by tile number.
std::vector<PlainShape> plain_shapes(const TerrainSource& ground);

// A body at its start.
struct PlainBody {
  int id = 1;     // the id that the simulation gives it
  int tile = -1;  // of a ball that is a tile of the map; -1: placed by hand
  Spawn start;    // its picture has the frames alone that are on their sheet
};

// All bodies in the order of their ids, from 1: first the ball tiles of the map, column by column from left
// to right, each from top to bottom; then those placed by hand.
class PlainBodies {
 public:
  explicit PlainBodies(const Level& level);  // the level must outlive this object
  std::size_t size() const { return tiles_.size() + level_.spawns.size(); }
  PlainBody at(std::size_t index) const;  // index: less than size()

 private:
  const Level& level_;
  std::vector<Cell> tiles_;
};

// "the exact form of 2 polygons, ...", for Exported::dropped of exports that know heights alone; empty if no
// tile on the map is a polygon or a group.
std::vector<std::string> dropped_polygons(const Level& level);

// "parts of 2 tiles that are polygons, ...", for Exported::dropped of exports for bump.lua; empty if it takes
// all.
std::vector<std::string> dropped_by_bump(const Level& level);

// "2 curves", for Exported::dropped of exports that cannot hold curves; empty if the level has no curves.
std::vector<std::string> dropped_curves(const Level& level);
// Says so if bodies have pictures, for exports that cannot hold those.
void tell_body_pictures(const Level& level, std::vector<std::string>& dropped);

// How many tiles on the map are conveyors.
int conveyor_tiles(const Level& level);
// Says so if tiles on the map are conveyors, for exports that cannot hold the speeds; and of curves, if the
// export holds curves.
void tell_conveyors(const Level& level, bool holds_curves, std::vector<std::string>& dropped);

// The words of the exports: "solid", "slope", "profile" or "none"; "box" or "centre"; "fall" or "run"; "tile"
// or "figure".
std::string_view kind_word(TileShape::Kind kind);
std::string_view foot_word(Foot foot);
std::string_view rule_word(BodyRule rule);
std::string_view look_word(BodyLook look);

// How far the points of a curve's line may be from the curve. A line between two of them stays as near.
inline constexpr double kPlainLineError = 1.0 / 64;  // px

// A thin line through points, px. Seen along the points its open side is on the left, as for polygons: floors
// go to the right.
struct PlainLine {
  bool is_curve = false;    // a free curve; else the line of one-way tiles
  bool both_sides = false;  // whether it stops bodies from both sides; only for curves
  std::string name;         // name of a curve; may be empty
  std::vector<Vec2> points;
  double conveyor = 0;  // px/frame, of a curve, as Curve::conveyor
  friend bool operator==(const PlainLine&, const PlainLine&) = default;
};

// First the lines of one-way tiles, without parts inside of ground, joined where they meet: those that face
// up come first, from left to right. Then the curves in the level's order. Corners are exact.
std::vector<PlainLine> plain_lines(const Level& level, const Progress& progress = {});

}  // namespace talus
