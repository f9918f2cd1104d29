// Two branches side by side: where their bodies differ, and since when.
#pragma once

#include <vector>

#include "frame.h"

namespace talus {

// A body of one branch and the same body of the other. The same body comes from the same ball tile or spawn.
struct BodyDifference {
  int a = 0, b = 0;     // ids; 0: that branch has no such body
  Vec2 position;        // px, from a to b; {0,0}, like velocity, if one branch has no such body
  Vec2 velocity;        // px/frame
  double distance = 0;  // px; infinite if one branch has no such body
};

// First the bodies of `a` by id, then those that only `b` has, by id.
std::vector<BodyDifference> differences(const State& a, const State& b);

// Distance of a body from the same body in another state, px; infinite if the other state has no such body.
double parting_of(const Body& body, const State& other);

// All frames of one branch, each with the same frame of another one, for conditions on `parting`. The other
// branch may be shorter.
class ComparedFrames final : public FrameSource {
 public:
  // b: the other branch; null: there is none. Both must stay alive while this is used.
  ComparedFrames(const FrameSource& a, const FrameSource* b) : a_(a), b_(b) {}
  std::int64_t last() const override { return a_.last(); }
  void read(std::int64_t frame, Frame& into) const override;
  bool approach(std::int64_t frame) const override;

 private:
  bool has_other(std::int64_t frame) const { return b_ != nullptr && frame <= b_->last(); }

  const FrameSource& a_;
  const FrameSource* b_;
};

// The condition that a body of ComparedFrames is further than so far (px, finite) from the same body of the
// other branch. To find the first frame where they part, search forwards from -1.
std::string parting_condition(double threshold);

}  // namespace talus
