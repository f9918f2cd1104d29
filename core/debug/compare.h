// Two runs side by side: where their bodies are apart, and since when.
#pragma once

#include <vector>

#include "frame.h"

namespace talus {

// A body of one run and the same of the other, matched by where they come from: the ball's tile or the spawn.
struct BodyDifference {
  int a = 0, b = 0;     // ids; 0: the other run has no such body
  Vec2 position;        // px, from a to b; of a body alone, as the rest, {0,0}
  Vec2 velocity;        // px/frame
  double distance = 0;  // px; infinite for a body alone
};

// Bodies of `a` by id, then those of `b` alone by id.
std::vector<BodyDifference> differences(const State& a, const State& b);

// How far a body is from the same one in another state, px; infinite when that has none.
double parting_of(const Body& body, const State& other);

// One run, all of its frames, with another beside it, as far as that goes, for conditions on `parting`.
class ComparedFrames final : public FrameSource {
 public:
  // b: null: there is no other. Both must stay while this is used.
  ComparedFrames(const FrameSource& a, const FrameSource* b) : a_(a), b_(b) {}
  std::int64_t last() const override { return a_.last(); }
  void read(std::int64_t frame, Frame& into) const override;
  bool approach(std::int64_t frame) const override;

 private:
  bool has_other(std::int64_t frame) const { return b_ != nullptr && frame <= b_->last(); }

  const FrameSource& a_;
  const FrameSource* b_;
};

// The condition that a body of ComparedFrames is more than so far (px, finite) from its other self. To find
// the first frame where they part, search forwards from -1.
std::string parting_condition(double threshold);

}  // namespace talus
