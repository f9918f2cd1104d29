// ShownFrame: the shown frame for the debugger: with the frames before it, and its stages.
#pragma once

#include "debug/expression.h"
#include "debug/stages.h"
#include "sim/timeline.h"

namespace talus {

// Read only on request, a little at a time, and kept until another frame is shown.
class ShownFrame {
 public:
  // source: the frames of the timeline's current branch, including the shown one (asserted). Valid until the
  // next call for another frame. Until it is read, which may take many steps, the frame is alone: without
  // frames before it and without another side.
  // other: the id of the other side, if its frame is there; else 0.
  FrameView view(const Timeline& timeline, const FrameSource& source, int other);
  // Spends so many seconds on reading what view() was asked for, if that is still shown. Returns true if
  // nothing is left to read.
  bool advance(const Timeline& timeline, const FrameSource& source, int other, double seconds);
  bool is_read() const { return is_read_; }  // what view() was asked for last
  // The stages of what the timeline shows; the step is not made again. ground: as Frame::ground.
  const std::vector<Stage>& stages(const Timeline& timeline, std::shared_ptr<const Terrain> ground, int body);
  void forget();  // the timeline belongs to another level now

 private:
  struct Key {
    int branch = 0, revision = 0;
    std::int64_t frame = -1;
    std::uint64_t hash = 0;
    int other = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  static Key key_of(const Timeline& timeline, int other);
  static void put_shown(const Timeline& timeline, Frame& into);

  Key key_;
  FrameHistory history_{kMaxBefore + 1};
  bool is_read_ = true;  // whether the frame of key_ is read
  Frame alone_;          // the same frame while it is not read
  Key staged_;           // the body and frame of the stages
  int staged_body_ = 0;
  Frame staged_frame_;  // kept for its memory
  std::vector<Stage> stages_;
};

}  // namespace talus
