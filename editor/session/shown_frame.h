// The frame that is shown, as the debugger sees it: with those before it, and its stages.
#pragma once

#include "debug/expression.h"
#include "debug/stages.h"
#include "sim/timeline.h"

namespace talus {

// Read only when somebody asks, and kept until another frame is shown.
class ShownFrame {
 public:
  // source: the frames of the timeline's current branch, the shown one among them (asserted). Good until the
  // next call for another frame.
  // other: the run of the other side whose frame is there; 0: none is.
  FrameView view(const Timeline& timeline, const FrameSource& source, int other);
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

  Key key_;
  FrameHistory history_{kMaxBefore + 1};
  Key staged_;  // whose stages are known, of a body
  int staged_body_ = 0;
  Frame staged_frame_;  // kept for its memory
  std::vector<Stage> stages_;
};

}  // namespace talus
