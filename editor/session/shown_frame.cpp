#include "shown_frame.h"

#include <cassert>

namespace talus {

void ShownFrame::read(const Timeline& timeline, const FrameSource& source) {
  const Branch& branch = timeline.current();
  const std::int64_t frame = timeline.frame();
  assert(frame <= source.last());
  const Key key{branch.id, branch.revision, frame, branch.hashes[static_cast<std::size_t>(frame)], &source};
  if (key == key_) return;
  const bool follows = key.source == key_.source && key.branch == key_.branch &&
                       key.revision == key_.revision && key.frame == key_.frame + 1;
  if (!follows) history_.clear();
  history_.go_to(source, frame);
  key_ = key;
  staged_body_.reset();
}

FrameView ShownFrame::view(const Timeline& timeline, const FrameSource& source) {
  read(timeline, source);
  return history_.view();
}

const std::vector<Stage>& ShownFrame::stages(const Timeline& timeline, const FrameSource& source, int body) {
  read(timeline, source);
  if (staged_body_ != body) stages_ = stages_of(history_.view().now(), body);
  staged_body_ = body;
  return stages_;
}

}  // namespace talus
