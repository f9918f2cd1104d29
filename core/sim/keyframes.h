// Keyframes: copies of some states of a recording, from which the frames between them are run again.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <talus/sim/state.h>

namespace talus {

struct Keyframe {
  std::int64_t frame = 0;
  bool is_edit = false;  // whether the level was edited at this frame
  std::shared_ptr<const State> state;
};

// The keyframes of one branch, by frame. Copies share the states.
class Keyframes {
 public:
  // The last keyframe that is not after `frame`; null if there is none.
  const Keyframe* before(std::int64_t frame) const;
  void drop_from(std::int64_t frame);
  std::size_t size() const { return list_.size(); }

 private:
  friend class KeyframeStore;
  std::vector<Keyframe> list_;
};

// Decides which states become keyframes, so that those of all branches stay within a memory budget: each
// `stride`th frame, and the frames of edits, as going on from them needs a compiled level. Beyond the budget
// the stride doubles and every other keyframe is dropped; those of edits go last. With many bodies the first
// stride is larger, so that no step pays for more than kBodiesAStep copies of a body.
class KeyframeStore {
 public:
  static constexpr std::int64_t kFirstStride = 8;  // frames
  // The copy of a body, with the memory that it uses first, takes about as long as its step at rest.
  static constexpr std::size_t kBodiesAStep = 16;

  explicit KeyframeStore(std::size_t budget) : budget_(budget) {}

  // Keeps the state if it becomes a keyframe. It must be later than all of `keyframes`.
  void offer(Keyframes& keyframes, const State& state, bool is_edit) const;
  bool over_budget() const { return *bytes_ > budget_; }
  void widen_stride() { stride_ *= 2; }
  // Call it for every branch after the stride has grown.
  void thin(Keyframes& keyframes, bool keep_edits) const;

  std::size_t bytes() const { return *bytes_; }  // memory of all states, each counted once
  std::int64_t stride() const { return stride_; }

 private:
  std::size_t budget_;
  std::int64_t stride_ = kFirstStride;
  // A state may outlive the store.
  std::shared_ptr<std::size_t> bytes_ = std::make_shared<std::size_t>(0);
};

}  // namespace talus
