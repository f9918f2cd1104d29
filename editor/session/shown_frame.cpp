#include "shown_frame.h"

#include <cassert>

namespace talus {

FrameView ShownFrame::view(const Timeline& timeline, const FrameSource& source, int other) {
  const Branch& branch = timeline.current();
  const std::int64_t frame = timeline.frame();
  assert(frame <= source.last());
  const Key key{branch.id, branch.revision, frame, branch.hashes[static_cast<std::size_t>(frame)], other};
  if (key == key_) return history_.view();
  const bool follows =
      key.branch == key_.branch && key.revision == key_.revision && key.frame == key_.frame + 1;
  if (!follows) history_.clear();
  history_.go_to(source, frame);
  key_ = key;
  staged_body_.reset();
  return history_.view();
}

void ShownFrame::forget() {
  key_ = {};
  history_.clear();
}

const std::vector<Stage>& ShownFrame::stages(int body) {
  if (staged_body_ != body) stages_ = stages_of(history_.view().now(), body);
  staged_body_ = body;
  return stages_;
}

}  // namespace talus
