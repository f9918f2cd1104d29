// Keyframes: copies of states here and there in a recording, from which the frames between are run again.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <talus/sim/state.h>

namespace talus {

struct Keyframe {
  std::int64_t frame = 0;
  bool is_edit = false;  // the level was edited at this frame
  std::shared_ptr<const State> state;
};

// Those of one branch, by frame. Copies share the states.
class Keyframes {
 public:
  // The last one that is not after `frame`; null: none.
  const Keyframe* before(std::int64_t frame) const;
  void drop_from(std::int64_t frame);
  std::size_t size() const { return list_.size(); }

 private:
  friend class KeyframeStore;
  std::vector<Keyframe> list_;
};

// Says which states become keyframes, so that those of all branches together stay within a budget: each
// `stride`th frame and the frames of edits, from which it would take a compiled level to go on. When they
// take more, the stride doubles and every other one goes; those of edits go last. Of many bodies fewer frames
// are kept from the start, so that no step pays for more than kBodiesAStep copies of a body.
class KeyframeStore {
 public:
  static constexpr std::int64_t kFirstStride = 8;  // frames
  // A copy of a body, with the memory that it is the first to use, takes about as long as its step at rest.
  static constexpr std::size_t kBodiesAStep = 16;

  explicit KeyframeStore(std::size_t budget) : budget_(budget) {}

  // Keeps the state, which must be later than all of `keyframes`, if it is one to be kept.
  void offer(Keyframes& keyframes, const State& state, bool is_edit) const;
  bool over_budget() const { return *bytes_ > budget_; }
  void widen_stride() { stride_ *= 2; }
  // To be called for every branch after the stride was widened.
  void thin(Keyframes& keyframes, bool keep_edits) const;

  std::size_t bytes() const { return *bytes_; }  // that the states take, each counted once
  std::int64_t stride() const { return stride_; }

 private:
  std::size_t budget_;
  std::int64_t stride_ = kFirstStride;
  // Outlives the store where a state does.
  std::shared_ptr<std::size_t> bytes_ = std::make_shared<std::size_t>(0);
};

}  // namespace talus
