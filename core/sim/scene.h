// Scene: a level compiled for the simulation. Immutable once made.
#pragma once

#include <vector>

#include "../collision/geometry.h"
#include "../level/level.h"

namespace talus {

// Where a body comes from: a ball tile of the map, or a spawn of the level.
struct BodyOrigin {
  Cell cell;       // the ball tile's cell; {0,0} for a spawn
  int spawn = -1;  // index into Level::spawns; -1 for a ball tile
  friend bool operator==(const BodyOrigin&, const BodyOrigin&) = default;
};

// One box of the scene: an obstacle, or the start of a body.
struct SceneItem {
  TileRole role = TileRole::solid;  // solid, up_slope, down_slope or ball; never none
  Rect box;                         // px
  Cell cell;                        // the tile it was made of; {0,0} for a spawn
  Vec2 velocity;                    // px/frame, at the start; of a ball only
  int spawn = -1;                   // as BodyOrigin::spawn
  BodyOrigin origin() const { return {cell, spawn}; }
  friend bool operator==(const SceneItem&, const SceneItem&) = default;
};

struct Scene {
  // Map order, as the article adds them: columns left to right, each from top to bottom; then the spawns.
  // Bodies get their ids in this order, and ties go to the earlier item.
  std::vector<SceneItem> items;
  Tuning tuning;
  friend bool operator==(const Scene&, const Scene&) = default;
};

// The scene of a level. Tiles outside the map are empty.
Scene compile_scene(const Level& level);

}  // namespace talus
