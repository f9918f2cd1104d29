// SceneCache: the scenes of the last used versions of a level.
#pragma once

#include <memory>
#include <vector>

#include <talus/sim/scene.h>
#include <talus/sim/solver.h>
#include "../level/level_version.h"
#include "lone_body.h"

namespace talus {

using VersionPtr = std::shared_ptr<const LevelVersion>;
using ScenePtr = std::shared_ptr<const Scene>;
using LoneBodyPtr = std::shared_ptr<const LoneBody>;

// A scene may take more memory than a whole recording, so only few are kept. Others are compiled again; if
// possible, from a scene that differs in few cells.
class SceneCache {
 public:
  ScenePtr scene_of(const VersionPtr& version);
  // The same for a body alone in it; null: for the bodies of the level.
  ScenePtr scene_of(const VersionPtr& version, const LoneBodyPtr& alone);
  void put(VersionPtr version, ScenePtr scene);  // puts a scene that was compiled elsewhere
  // The solver of that scene. All who ask share one, as long as one of them holds it: for a large level it
  // takes more time and memory than the scene.
  std::shared_ptr<Solver> solver_of(const VersionPtr& version, const ScenePtr& scene);

 private:
  static constexpr std::size_t kMax = 4;
  static constexpr std::size_t kMaxCells = 1000;  // with more, compiling the whole level is as quick

  struct Entry {
    VersionPtr version;
    LoneBodyPtr alone;  // null: the bodies of the level
    ScenePtr scene;
    std::weak_ptr<Solver> solver;
  };
  ScenePtr known(const VersionPtr& version, const LoneBodyPtr& alone);  // null: there is none
  void put(Entry entry);

  std::vector<Entry> entries_;  // the last used one is first
};

}  // namespace talus
