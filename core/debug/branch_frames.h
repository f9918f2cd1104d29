// The frames of a timeline's branch, for those who judge them.
#pragma once

#include "../sim/runner.h"
#include "frame.h"

namespace talus {

// Runs along a branch by itself, in several places at a time, and so changes nothing that a timeline shows.
// Frames that are read in order take a step each, others a seek.
class BranchFrames final : public FrameSource {
 public:
  explicit BranchFrames(Branch branch) : branch_(std::move(branch)) {}

  // The same branch with more frames. One that was run again is another: make new BranchFrames.
  void grow(Branch branch) { branch_ = std::move(branch); }

  // The scene of a version of the level, which need not be compiled then: of a large one that takes long.
  void know(const VersionPtr& version, const ScenePtr& scene) const;

  std::int64_t last() const override { return branch_.run_frame(); }
  void read(std::int64_t frame, Frame& into) const override;
  bool approach(std::int64_t frame) const override;
  // Frame::ground of a frame, 0..last(), without running to it.
  const std::shared_ptr<const Terrain>& ground(std::int64_t frame) const;

 private:
  Branch branch_;  // a copy, which is cheap
  // Where it is along the branch does not show.
  mutable SceneCache scenes_;
  mutable Runners runners_{scenes_};
  mutable VersionPtr known_;                       // that know() was told of last
  mutable std::shared_ptr<const Terrain> ground_;  // of ground_version_
  mutable VersionPtr ground_version_;
};

}  // namespace talus
