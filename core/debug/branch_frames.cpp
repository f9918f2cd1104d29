#include "branch_frames.h"

#include <cassert>

namespace talus {

void BranchFrames::know(const VersionPtr& version, const ScenePtr& scene) const {
  if (known_ == version) return;
  known_ = version;
  scenes_.put(version, scene);
}

void BranchFrames::read(std::int64_t frame, Frame& into) const {
  assert(frame >= 0 && frame <= last());
  runner_.go_to(branch_, frame, &into.record);
  const VersionPtr& version = branch_.chapters[branch_.chapter_at(frame)].version;
  if (version != ground_version_) {
    ground_version_ = version;
    ground_ = measured_ground(*runner_.scene(), level_of(*version));
  }
  into.scene = runner_.scene();
  into.ground = ground_;
  into.state = runner_.state();
  into.input = frame > 0 ? branch_.input(frame) : Input();
  into.other.reset();
}

}  // namespace talus
