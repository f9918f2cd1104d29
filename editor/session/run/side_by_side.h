// SideBySide: the other side of a comparison: another branch of the timeline, or the same input through
// another solver or precision.
#pragma once

#include <optional>

#include "debug/branch_frames.h"
#include "variant_branch.h"

namespace talus {

// The frames of a branch that is followed while it grows.
class FollowedFrames {
 public:
  // Returns the same object as before if it is the same branch and nothing of it was run again; it has grown
  // then.
  const BranchFrames& of(const Branch& branch);
  const BranchFrames* get() const { return frames_ ? &*frames_ : nullptr; }
  void clear() { frames_.reset(); }
  // Unique for every branch that was followed. A branch that was run again gets another one.
  int id() const { return id_; }

 private:
  int branch_ = 0, revision_ = 0, id_ = 0;
  std::optional<BranchFrames> frames_;
};

class SideBySide {
 public:
  // nothing: the other side is the timeline's compared branch, if there is one
  void set_variant(std::optional<Variant> variant);
  const VariantBranch* variant() const { return variant_ ? &*variant_ : nullptr; }

  // Brings it up to the shown frame; a variant makes at most so many steps.
  void follow(const Timeline& shown, const Level& level, std::int64_t most_steps);
  // The other side's frames when they were followed last; null: there is no other side, or it has not begun.
  const BranchFrames* frames() const { return frames_.get(); }
  // unique for every other side; 0: there is none
  int id() const { return frames() != nullptr ? frames_.id() : 0; }
  // The other side's branch; null: there is none, or it has not begun.
  const Branch* branch(const Timeline& shown) const;
  // Whether it has reached this frame.
  bool has(std::int64_t frame) const { return frames() != nullptr && frames()->last() >= frame; }

 private:
  std::optional<VariantBranch> variant_;
  FollowedFrames frames_;
};

}  // namespace talus
