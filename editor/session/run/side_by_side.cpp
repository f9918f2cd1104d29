#include "side_by_side.h"

namespace talus {

const BranchFrames& FollowedFrames::of(const Branch& branch) {
  if (frames_ && branch.id == branch_ && branch.revision == revision_) {
    frames_->grow(branch);
  } else {
    frames_.emplace(branch);
    ++id_;
  }
  branch_ = branch.id;
  revision_ = branch.revision;
  return *frames_;
}

void SideBySide::set_variant(std::optional<Variant> variant) {
  variant_.reset();
  frames_.clear();
  if (variant) variant_.emplace(*variant);
}

const Branch* SideBySide::branch(const Timeline& shown) const {
  if (!variant_) return shown.compared();
  return variant_->timeline() != nullptr ? &variant_->timeline()->current() : nullptr;
}

void SideBySide::follow(const Timeline& shown, const Level& level, std::int64_t most_steps) {
  if (variant_) {
    const int begun = variant_->begun();
    variant_->follow(shown, level, most_steps);
    if (variant_->begun() != begun) frames_.clear();  // another branch, though it has the same number
    frames_.of(variant_->timeline()->current());
  } else if (const Branch* compared = shown.compared()) {
    frames_.of(*compared);
  } else {
    frames_.clear();
  }
}

}  // namespace talus
