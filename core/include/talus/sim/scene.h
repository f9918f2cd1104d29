// Scene: a level compiled for the simulation. Immutable once made.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>
#include <talus/collision/terrain.h>
#include <talus/level/level.h>

namespace talus {

// Where a body comes from: a ball tile of the map, or a spawn of the level.
struct BodyOrigin {
  Cell cell;       // the ball tile's cell; {0,0} for a spawn
  int spawn = -1;  // index into Level::spawns; -1 for a ball tile
  friend bool operator==(const BodyOrigin&, const BodyOrigin&) = default;
};

// A straight line of the ground across a box. At its higher end it reaches the top of the box; for a ceiling,
// the bottom. The rest of the box is ground; a one-way box has no ground.
struct GroundLine {
  bool rises_to_the_right = false;  // its right end is the higher one
  double low = 0;        // px, height of the lower end over the box's bottom; for a ceiling below its top
  bool ceiling = false;  // it hangs from the top of the box
  bool one_way = false;  // only the line stops bodies, and only from its open side
  friend bool operator==(const GroundLine&, const GroundLine&) = default;
};

// One box of the scene: an obstacle, or the start of a body.
struct SceneItem {
  TileRole role = TileRole::solid;  // solid, up_slope, down_slope or ball; never none
  Rect box;                         // px
  Cell cell;                        // the tile it was made of; {0,0} for a spawn
  Vec2 velocity;                    // px/frame, at the start; only for a ball
  int spawn = -1;                   // as BodyOrigin::spawn
  BodyKind kind = BodyKind::ball;   // of a body
  Foot foot = Foot::box;            // of a body
  std::optional<GroundLine> line =
      {};  // of an obstacle that is neither full nor a slope from corner to corner
  // Of a body: where it comes from.
  BodyOrigin origin() const { return {cell, spawn}; }
  friend bool operator==(const SceneItem&, const SceneItem&) = default;
};

// What the bodies of a scene need.
struct SceneFeatures {
  bool pairs = false;    // several bodies that block one another, or meet
  bool meets = false;    // bodies other than players that meet, see BodyPairs
  bool players = false;  // a player, who takes the keys
  friend bool operator==(const SceneFeatures&, const SceneFeatures&) = default;
};

// Everything that a step reads besides the state. compile_scene() makes it; it is shared by const pointers.
struct Scene {
  // In map order, as the article adds them: columns from left to right, each from top to bottom; then the
  // spawns. Bodies get their ids in this order, and ties go to the earlier item. For the exact solver, which
  // has the ground, only bodies.
  std::vector<SceneItem> items;
  // Only for the exact solver; null if the tuning asks for single precision.
  std::shared_ptr<const Terrain> ground;
  // Only for the exact solver, if the tuning asks for single precision; else null.
  std::shared_ptr<const BasicTerrain<float>> single_ground;
  std::vector<std::string> curve_names;  // of the ground's curves, by their numbers; may be empty
  // Only for the exact solver: lines of the level's ground, see <talus/level/ground.h>. If they are too many,
  // there is no ground.
  std::size_t ground_lines = 0;
  // What the numbers of the ground from `tile_count` on stand for: the tiles of several layers in one cell,
  // from the back to the front, or one that is turned; sorted. Empty if the level has one layer of ground,
  // and none of its ground is turned.
  std::vector<std::vector<MapCell>> stacks;
  SceneFeatures features;  // what its bodies need
  TileSize tile_size;      // of the level's map
  Tuning tuning;           // the level's
};
bool operator==(const Scene& a, const Scene& b);  // grounds are compared by their cells and outlines

// The scene of a level. Tiles outside of the map are empty; so are all tiles of a level with a
// ground_problem().
Scene compile_scene(const Level& level);
// The same for a large level: `progress` is called now and then with the share that is done, 0..1. Returns
// nothing if it returned false.
std::optional<Scene> compile_scene(const Level& level, const std::function<bool(double)>& progress);

// Whether the ground of a level is the same with both tunings.
bool is_same_ground(const Tuning& a, const Tuning& b);

// The same as compile_scene(edited). `scene` belongs to a level that differs from it only in these cells of
// the map, inside of both, in its spawns and in its tuning. Takes time by the number of cells and bodies,
// except for solvers other than exact, and if is_same_ground() is false.
Scene recompile_scene(const Scene& scene, const Level& edited, std::span<const Cell> changed);

}  // namespace talus
