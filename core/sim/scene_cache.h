// The scenes of the versions of a level that were needed last.
#pragma once

#include <memory>
#include <vector>

#include <talus/sim/scene.h>
#include <talus/sim/solver.h>
#include "../level/level_version.h"

namespace talus {

using VersionPtr = std::shared_ptr<const LevelVersion>;
using ScenePtr = std::shared_ptr<const Scene>;

// A scene may take more memory than a whole recording, so few are kept; the others are compiled again, from
// one that differs in few cells where there is one.
class SceneCache {
 public:
  ScenePtr scene_of(const VersionPtr& version);
  void put(VersionPtr version, ScenePtr scene);  // that somebody else has compiled
  // The solver of that scene, one for all who ask as long as one of them has it: of a large level it takes
  // more time and memory than the scene.
  std::shared_ptr<Solver> solver_of(const VersionPtr& version, const ScenePtr& scene);

 private:
  static constexpr std::size_t kMost = 4;
  static constexpr std::size_t kMostCells = 1000;  // beyond that the whole level is compiled no slower

  struct Entry {
    VersionPtr version;
    ScenePtr scene;
    std::weak_ptr<Solver> solver;
  };
  std::vector<Entry> entries_;  // the one used last is first
};

}  // namespace talus
