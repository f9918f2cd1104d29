// Keeps the scenes of the last versions of a level, with their solvers.
#include "scene_cache.h"

#include <algorithm>
#include <utility>

namespace talus {

ScenePtr SceneCache::known(const VersionPtr& version, const LoneBodyPtr& alone) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.version == version && entry.alone == alone;
  });
  if (found == entries_.end()) return nullptr;
  std::rotate(entries_.begin(), found, found + 1);
  return entries_.front().scene;
}

ScenePtr SceneCache::scene_of(const VersionPtr& version, const LoneBodyPtr& alone) {
  if (alone == nullptr) return scene_of(version);
  if (ScenePtr scene = known(version, alone)) return scene;
  put({version, alone, std::make_shared<const Scene>(scene_for(*alone, *scene_of(version))), {}});
  return entries_.front().scene;
}

ScenePtr SceneCache::scene_of(const VersionPtr& version) {
  if (ScenePtr scene = known(version, nullptr)) return scene;
  const Level level = level_of(*version);
  for (const Entry& entry : entries_) {
    if (entry.alone != nullptr) continue;
    const auto cells = changed_cells(*entry.version, *version, kMaxCells);
    if (!cells) continue;
    put(version, std::make_shared<const Scene>(recompile_scene(*entry.scene, level, *cells)));
    return entries_.front().scene;
  }
  put(version, std::make_shared<const Scene>(compile_scene(level)));
  return entries_.front().scene;
}

void SceneCache::put(VersionPtr version, ScenePtr scene) {
  put({std::move(version), nullptr, std::move(scene), {}});
}

void SceneCache::put(Entry entry) {
  entries_.insert(entries_.begin(), std::move(entry));
  if (entries_.size() > kMax) entries_.pop_back();
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
