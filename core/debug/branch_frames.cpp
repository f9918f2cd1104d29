#include "branch_frames.h"

#include <algorithm>
#include <cassert>

namespace talus {

void BranchFrames::know(const VersionPtr& version, const ScenePtr& scene) const {
  if (known_ == version) return;
  known_ = version;
  scenes_.put(version, scene);
}

const std::shared_ptr<const Terrain>& BranchFrames::ground(std::int64_t frame) const {
  assert(frame >= 0 && frame <= last());
  const VersionPtr& version = branch_.version_at(frame);
  if (version != ground_version_) {
    ground_version_ = version;
    ground_ = measured_ground(*scenes_.scene_of(version), level_of(*version));
  }
  return ground_;
}

// The step to a frame is made again, with its record, when the frame is read.
bool BranchFrames::approach(std::int64_t frame) const {
  const std::int64_t before = std::max<std::int64_t>(frame - 1, 0);
  return runners_.nearest(branch_, before).go_to(branch_, before, nullptr, 1);
}

void BranchFrames::read(std::int64_t frame, Frame& into) const {
  assert(frame >= 0 && frame <= last());
  Runner& runner = runners_.nearest(branch_, std::max<std::int64_t>(frame - 1, 0));
  runner.go_to(branch_, frame, &into.record);
  into.scene = runner.scene();
  into.ground = ground(frame);
  into.state = runner.state();
  into.input = frame > 0 ? branch_.input(frame) : Input();
  into.other.reset();
}

}  // namespace talus
