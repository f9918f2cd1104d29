// BranchFrames: the frames of a timeline's branch, for code that judges them.
#pragma once

#include "../sim/runner.h"
#include "frame.h"

namespace talus {

// Runs along a branch on its own, in several places at a time, so what a timeline shows does not change.
// Frames that are read in order cost a step each, others a seek.
class BranchFrames final : public FrameSource {
 public:
  explicit BranchFrames(Branch branch) : branch_(std::move(branch)) {}

  // Takes the same branch with more frames. For a branch that was run again, make new BranchFrames.
  void grow(Branch branch) { branch_ = std::move(branch); }

  // Takes the scene of a version of the level, which then need not be compiled: that takes long for a large
  // level.
  void know(const VersionPtr& version, const ScenePtr& scene) const;

  std::int64_t last() const override { return branch_.run_frame(); }
  void read(std::int64_t frame, Frame& into) const override;
  bool approach(std::int64_t frame) const override;
  // Returns Frame::ground of a frame, 0..last(), without running to it.
  const std::shared_ptr<const Terrain>& ground(std::int64_t frame) const;

 private:
  Branch branch_;  // a copy, which is cheap
  // The place along the branch does not show from outside.
  mutable SceneCache scenes_;
  mutable Runners runners_{scenes_};
  mutable VersionPtr known_;                       // the version that know() was given last
  mutable std::shared_ptr<const Terrain> ground_;  // of ground_version_
  mutable VersionPtr ground_version_;
};

}  // namespace talus
