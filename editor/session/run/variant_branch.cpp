#include "variant_branch.h"

namespace talus {
namespace {

Tuning with(Variant variant, Tuning tuning) {
  tuning.solver = variant.solver;
  tuning.exact.single_precision = variant.single_precision ? 1 : 0;
  return tuning;
}

Recording with(Variant variant, Recording recording) {
  recording.level.tuning = with(variant, recording.level.tuning);
  for (RecordedEdit& edit : recording.edits) {
    LevelVersion version = *edit.version;
    version.tuning = with(variant, version.tuning);
    edit.version = std::make_shared<const LevelVersion>(std::move(version));
  }
  recording.hashes.clear();
  return recording;
}

}  // namespace

void VariantBranch::follow(const Timeline& a, const Level& level, std::int64_t most_steps) {
  const Branch& branch = a.current();
  const bool goes_on = timeline_ != nullptr && branch.id == branch_ && branch.revision == revision_ &&
                       branch.chapters.size() == chapters_;
  if (!goes_on) begin(a, level);
  Timeline& b = *timeline_;
  if (b.behind()) return b.catch_up(most_steps);
  if (b.last_frame() >= branch.run_frame()) return;
  if (b.on_the_way()) return b.go_on(most_steps);
  if (b.in_past()) return b.seek(b.last_frame());  // it is run again from a keyframe, wherever it is
  for (; most_steps > 0 && b.last_frame() < branch.run_frame(); --most_steps)
    b.step(branch.input(b.last_frame() + 1), false);
}

void VariantBranch::begin(const Timeline& a, const Level& level) {
  const Branch& branch = a.current();
  timeline_ = std::make_unique<Timeline>(with(variant_, a.recording(branch, level)));
  timeline_->limit_way(1);
  branch_ = branch.id;
  revision_ = branch.revision;
  chapters_ = branch.chapters.size();
  ++begun_;
}

}  // namespace talus
