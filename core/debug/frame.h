// Frame: what the debugger judges. It has a state, the step that led to it, and the frames before.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <talus/sim/record.h>
#include <talus/sim/state.h>

namespace talus {

// A frame of a branch.
struct Frame {
  std::shared_ptr<const Scene> scene;     // never null when the frame is looked at
  std::shared_ptr<const Terrain> ground;  // see measured_ground(); null: numbers measured against it are NaN
  State state;                            // after the step
  StepRecord record;                      // of the step that led here; empty at frame 0
  Input input;                            // of that step
  std::optional<State> other;  // the same frame of the branch compared with; nothing if it has no such frame
};

// The ground of a scene in double precision. It is the scene's own, or, if the solver compiles none, a new
// one made from the level, which takes time by the size of the map: keep it.
std::shared_ptr<const Terrain> measured_ground(const Scene& scene, const Level& level);

// A branch whose frames can be read in any order.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual std::int64_t last() const = 0;                         // frames 0 to last() can be read
  virtual void read(std::int64_t frame, Frame& into) const = 0;  // frame: 0..last(); overwrites all of `into`
  // Works a little towards a frame that may take long to read. Returns true when reading it next takes no
  // longer than a step.
  virtual bool approach(std::int64_t) const { return true; }
};

// A frame and those before it. Before frame 0 there is frame 0 again. Refers to a FrameHistory.
class FrameView {
 public:
  explicit FrameView(std::vector<const Frame*> newest_first) : frames_(std::move(newest_first)) {}
  const Frame& now() const { return *frames_.front(); }
  // back: frames before the newest one, from 0 to the number that the history was made for.
  const Frame& before(std::size_t back) const {
    return *frames_[back < frames_.size() ? back : frames_.size() - 1];
  }
  bool is_first() const { return frames_.size() == 1; }  // whether there is no frame before

 private:
  std::vector<const Frame*> frames_;  // never empty
};

// The last frames of a branch, as many as are asked for.
class FrameHistory {
 public:
  explicit FrameHistory(int before);  // before: how many frames to keep before the newest one
  FrameHistory(const FrameHistory&) = delete;
  FrameHistory& operator=(const FrameHistory&) = delete;

  void clear();
  Frame& next();  // adds a newest frame for the caller to fill; valid until the next call
  // Makes `frame` of the source the newest one. Reads only this frame if the one before it is the newest now.
  void go_to(const FrameSource& source, std::int64_t frame);
  // The same in small steps. Returns true when it is the newest one.
  bool approach(const FrameSource& source, std::int64_t frame);
  FrameView view() const;  // needs a frame (asserted); valid until the next change

 private:
  std::vector<Frame> ring_;
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace talus
