// SceneCompiler: a thread compiles large levels while the editor goes on with the scene that it has.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <talus/level/level.h>
#include "sim/scene_cache.h"

namespace talus {

class SceneCompiler {
 public:
  // A map with more cells takes too long to be compiled between two frames.
  static constexpr std::size_t kMaxCellsAtOnce = std::size_t{1} << 17;
  static bool is_large(const Level& level) { return level.map.cells().size() > kMaxCellsAtOnce; }

  struct Result {
    std::shared_ptr<const Level> level;
    ScenePtr scene;       // its scene; null: there is a problem
    std::string problem;  // why it could not be compiled
  };

  SceneCompiler() = default;
  ~SceneCompiler() { cancel(); }
  SceneCompiler(const SceneCompiler&) = delete;
  SceneCompiler& operator=(const SceneCompiler&) = delete;

  void start(const Level& level);                   // replaces the current job
  void cancel();                                    // waits until the job has given up, a few ms
  bool is_busy() const { return job_ != nullptr; }  // from start() until take() or cancel()
  double progress() const;                          // of the current job, 0..1
  std::optional<Result> take();                     // returns the result once, when it is done

 private:
  struct Job {
    std::shared_ptr<const Level> level;
    std::atomic<double> progress = 0;
    std::atomic<bool> wanted = true, done = false;
    ScenePtr scene;       // written before `done`, like:
    std::string problem;  // empty: no problem
  };
  std::unique_ptr<Job> job_;
  std::thread thread_;
};

}  // namespace talus
