// VariantBranch: a branch with the same input as another one, through another solver or precision.
#pragma once

#include <memory>

#include "sim/timeline.h"

namespace talus {

// What it has instead of the level's own.
struct Variant {
  SolverKind solver = SolverKind::exact;
  bool single_precision = false;  // only for exact
  friend bool operator==(const Variant&, const Variant&) = default;
};

class VariantBranch {
 public:
  explicit VariantBranch(Variant variant) : variant_(variant) {}

  const Variant& variant() const { return variant_; }
  // Brings it up to the current branch of `a`, by at most so many steps. Begins anew if that is another
  // branch than the one it followed. level: as in Timeline::recording.
  void follow(const Timeline& a, const Level& level, std::int64_t most_steps);
  const Timeline* timeline() const { return timeline_.get(); }  // null before the first follow()
  int begun() const { return begun_; }                          // how often it began anew

 private:
  void begin(const Timeline& a, const Level& level);

  Variant variant_;
  std::unique_ptr<Timeline> timeline_;
  int branch_ = 0, revision_ = 0;  // of the followed branch
  std::size_t chapters_ = 0;
  int begun_ = 0;
};

}  // namespace talus
