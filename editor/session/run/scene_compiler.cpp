// A thread for one level at a time.
#include "scene_compiler.h"

#include <utility>

#include "formats/last_catch.h"

namespace talus {

void SceneCompiler::start(const Level& level) {
  cancel();
  job_ = std::make_unique<Job>();
  job_->level = std::make_shared<const Level>(level);
  thread_ = std::thread([job = job_.get()] {
    try {
      auto scene = compile_scene(*job->level, [job](double done) {
        job->progress = done;
        return job->wanted.load();
      });
      if (scene) job->scene = std::make_shared<const Scene>(*std::move(scene));
    } catch (...) {
      job->problem = caught_text();
    }
    job->done = true;
  });
}

void SceneCompiler::cancel() {
  if (!job_) return;
  job_->wanted = false;
  thread_.join();
  job_.reset();
}

double SceneCompiler::progress() const { return job_ ? job_->progress.load() : 1; }

std::optional<SceneCompiler::Result> SceneCompiler::take() {
  if (!job_ || !job_->done) return std::nullopt;
  thread_.join();
  const auto job = std::exchange(job_, nullptr);
  return Result{job->level, job->scene, job->problem};
}

}  // namespace talus
