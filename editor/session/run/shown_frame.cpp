#include "shown_frame.h"

#include <cassert>

#include "work_share.h"

namespace talus {
namespace {

constexpr double kReadSeconds = 0.004;  // of processor time that view() spends on reading

}  // namespace

ShownFrame::Key ShownFrame::key_of(const Timeline& timeline, int other) {
  const Branch& branch = timeline.current();
  const std::int64_t frame = timeline.frame();
  return {branch.id, branch.revision, frame, branch.hashes[static_cast<std::size_t>(frame)], other};
}

FrameView ShownFrame::view(const Timeline& timeline, const FrameSource& source, int other) {
  assert(timeline.frame() <= source.last());
  const Key key = key_of(timeline, other);
  if (key == key_) return is_read_ ? history_.view() : FrameView({&alone_});
  const bool follows =
      key.branch == key_.branch && key.revision == key_.revision && key.frame == key_.frame + 1;
  if (!follows) history_.clear();
  key_ = key;
  is_read_ = false;
  if (advance(timeline, source, other, kReadSeconds)) return history_.view();
  alone_ = {};
  alone_.ground = timeline.scene().ground;
  put_shown(timeline, alone_);
  return FrameView({&alone_});
}

bool ShownFrame::advance(const Timeline& timeline, const FrameSource& source, int other, double seconds) {
  if (!is_read_ && key_of(timeline, other) != key_) forget();
  const Stopwatch watch;
  do is_read_ = is_read_ || history_.approach(source, key_.frame);
  while (!is_read_ && watch.seconds() < seconds);
  return is_read_;
}

void ShownFrame::put_shown(const Timeline& timeline, Frame& into) {
  into.scene = timeline.shown_scene();
  into.state = timeline.state();
  into.record = timeline.record();
  into.input = timeline.frame() > 0 ? timeline.current().input(timeline.frame()) : Input();
}

void ShownFrame::forget() {
  key_ = staged_ = {};
  is_read_ = true;
  staged_frame_ = {};
  history_.clear();
}

const std::vector<Stage>& ShownFrame::stages(const Timeline& timeline, std::shared_ptr<const Terrain> ground,
                                             int body) {
  const Key key = key_of(timeline, 0);
  if (key == staged_ && body == staged_body_) return stages_;
  staged_ = key;
  staged_body_ = body;
  staged_frame_.ground = std::move(ground);
  put_shown(timeline, staged_frame_);
  stages_ = stages_of(staged_frame_, body);
  return stages_;
}

}  // namespace talus
