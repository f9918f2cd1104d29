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

// A straight line of the ground across a box, that reaches its top, or of a ceiling its bottom, at the higher
// end. What else is in the box is ground, and nothing of it if it is one-way.
struct GroundLine {
  bool rises_to_the_right = false;  // its right end is the higher one
  double low = 0;                   // px, of the lower end over the box's bottom; of a ceiling below its top
  bool ceiling = false;             // it hangs from the top of the box
  bool one_way = false;             // only the line stops bodies, and only from its open side
  friend bool operator==(const GroundLine&, const GroundLine&) = default;
};

// One box of the scene: an obstacle, or the start of a body.
struct SceneItem {
  TileRole role = TileRole::solid;  // solid, up_slope, down_slope or ball; never none
  Rect box;                         // px
  Cell cell;                        // the tile it was made of; {0,0} for a spawn
  Vec2 velocity;                    // px/frame, at the start; of a ball only
  int spawn = -1;                   // as BodyOrigin::spawn
  BodyKind kind = BodyKind::ball;   // of a body
  Foot foot = Foot::box;            // of a body
  std::optional<GroundLine> line =
      {};  // of an obstacle that is neither full nor a slope from corner to corner
  // Of a body: where it comes from.
  BodyOrigin origin() const { return {cell, spawn}; }
  friend bool operator==(const SceneItem&, const SceneItem&) = default;
};

// What the bodies of a scene make necessary.
struct SceneFeatures {
  bool pairs = false;    // several bodies, which block one another
  bool players = false;  // there is one, who takes the keys
  friend bool operator==(const SceneFeatures&, const SceneFeatures&) = default;
};

// Everything that a step reads besides the state. compile_scene() makes it; it is shared by const pointers.
struct Scene {
  // Map order, as the article adds them: columns left to right, each from top to bottom; then the spawns.
  // Bodies get their ids in this order, and ties go to the earlier item. For the exact solver, which has the
  // ground, bodies only.
  std::vector<SceneItem> items;
  // For the exact solver alone, and null where the tuning asks for single precision.
  std::shared_ptr<const Terrain> ground;
  // For the exact solver alone, where the tuning asks for single precision; else null.
  std::shared_ptr<const BasicTerrain<float>> single_ground;
  std::vector<std::string> curve_names;  // of the ground's curves, by their numbers; may be empty
  // For the exact solver, of the level's ground, see ground.h; where they are too many, there is none of it.
  std::size_t ground_lines = 0;
  SceneFeatures features;  // what its bodies make necessary
  Tuning tuning;           // the level's
};
bool operator==(const Scene& a, const Scene& b);  // grounds are compared by their cells and outlines

// The scene of a level. Tiles outside the map are empty; so are all of a level with a ground_problem().
Scene compile_scene(const Level& level);
// The same, for a large level: `progress` is called now and then with the part that is done, 0..1. Nothing:
// it said false, which gives up.
std::optional<Scene> compile_scene(const Level& level, const std::function<bool(double)>& progress);

// Whether the ground of a level is the same with either.
bool is_same_ground(const Tuning& a, const Tuning& b);

// The same as compile_scene(edited), where `scene` is that of a level which differs from it in these cells of
// the map, inside both, and otherwise in its spawns and its tuning alone. Takes time by the number of cells
// and bodies, but for the other solvers than the exact one and where is_same_ground() is false.
Scene recompile_scene(const Scene& scene, const Level& edited, std::span<const Cell> changed);

}  // namespace talus
