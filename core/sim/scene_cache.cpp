// Scenes by version.
#include "scene_cache.h"

#include <algorithm>
#include <utility>

namespace talus {

ScenePtr SceneCache::scene_of(const VersionPtr& version) {
  const auto known = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.version == version; });
  if (known != entries_.end()) {
    std::rotate(entries_.begin(), known, known + 1);
    return entries_.front().scene;
  }
  const Level level = level_of(*version);
  for (const Entry& entry : entries_) {
    const auto cells = changed_cells(*entry.version, *version, kMostCells);
    if (!cells) continue;
    put(version, std::make_shared<const Scene>(recompile_scene(*entry.scene, level, *cells)));
    return entries_.front().scene;
  }
  put(version, std::make_shared<const Scene>(compile_scene(level)));
  return entries_.front().scene;
}

void SceneCache::put(VersionPtr version, ScenePtr scene) {
  entries_.insert(entries_.begin(), {std::move(version), std::move(scene), {}});
  if (entries_.size() > kMost) entries_.pop_back();
}

std::shared_ptr<Solver> SceneCache::solver_of(const VersionPtr& version, const ScenePtr& scene) {
  const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.version == version && entry.scene == scene;
  });
  std::shared_ptr<Solver> solver = known != entries_.end() ? known->solver.lock() : nullptr;
  if (solver != nullptr) return solver;
  solver = make_solver(scene);
  if (known != entries_.end()) known->solver = solver;
  return solver;
}

}  // namespace talus
