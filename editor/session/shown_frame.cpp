#include "shown_frame.h"

#include <cassert>

namespace talus {

ShownFrame::Key ShownFrame::key_of(const Timeline& timeline, int other) {
  const Branch& branch = timeline.current();
  const std::int64_t frame = timeline.frame();
  return {branch.id, branch.revision, frame, branch.hashes[static_cast<std::size_t>(frame)], other};
}

FrameView ShownFrame::view(const Timeline& timeline, const FrameSource& source, int other) {
  const std::int64_t frame = timeline.frame();
  assert(frame <= source.last());
  const Key key = key_of(timeline, other);
  if (key == key_) return history_.view();
  const bool follows =
      key.branch == key_.branch && key.revision == key_.revision && key.frame == key_.frame + 1;
  if (!follows) history_.clear();
  history_.go_to(source, frame);
  key_ = key;
  return history_.view();
}

void ShownFrame::forget() {
  key_ = staged_ = {};
  staged_frame_ = {};
  history_.clear();
}

const std::vector<Stage>& ShownFrame::stages(const Timeline& timeline, std::shared_ptr<const Terrain> ground,
                                             int body) {
  const Key key = key_of(timeline, 0);
  if (key == staged_ && body == staged_body_) return stages_;
  staged_ = key;
  staged_body_ = body;
  staged_frame_.scene = timeline.shown_scene();
  staged_frame_.ground = std::move(ground);
  staged_frame_.state = timeline.state();
  staged_frame_.record = timeline.record();
  staged_frame_.input = timeline.frame() > 0 ? timeline.current().input(timeline.frame()) : Input();
  stages_ = stages_of(staged_frame_, body);
  return stages_;
}

}  // namespace talus
