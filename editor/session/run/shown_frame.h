// The frame that is shown, as the debugger sees it: with those before it, and its stages.
#pragma once

#include "debug/expression.h"
#include "debug/stages.h"
#include "sim/timeline.h"

namespace talus {

// Read only when somebody asks, a little at a time, and kept until another frame is shown.
class ShownFrame {
 public:
  // source: the frames of the timeline's current branch, the shown one among them (asserted). Good until the
  // next call for another frame. Until it is read, which may take many steps, the frame is alone, as the
  // timeline shows it: with none before it and no other side.
  // other: the run of the other side whose frame is there; 0: none is.
  FrameView view(const Timeline& timeline, const FrameSource& source, int other);
  // Spends so many seconds on reading what view() was asked for, if that is still shown. True: nothing is
  // left to read.
  bool advance(const Timeline& timeline, const FrameSource& source, int other, double seconds);
  bool is_read() const { return is_read_; }  // what view() was asked for last
  // Of what the timeline shows, for which the step is not made again. ground: as Frame::ground.
  const std::vector<Stage>& stages(const Timeline& timeline, std::shared_ptr<const Terrain> ground, int body);
  void forget();  // the run is of another level now

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
  bool is_read_ = true;  // the frame of key_
  Frame alone_;          // the same while it is not
  Key staged_;           // whose stages are known, of a body
  int staged_body_ = 0;
  Frame staged_frame_;  // kept for its memory
  std::vector<Stage> stages_;
};

}  // namespace talus
