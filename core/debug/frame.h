// What the debugger judges: a frame with the step that led to it, the frames before it, and where both come
// from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <talus/sim/record.h>
#include <talus/sim/state.h>

namespace talus {

// A frame of a run.
struct Frame {
  std::shared_ptr<const Scene> scene;     // never null where the frame is looked at
  std::shared_ptr<const Terrain> ground;  // see measured_ground(); null: what is measured against it is NaN
  State state;                            // after the step
  StepRecord record;                      // of the step that led here; empty at frame 0
  Input input;                            // of that step
  std::optional<State> other;  // the same frame of a run that this one is compared with; none: no such run
};

// The ground of a scene in double precision: the scene's own, or, for a solver that compiles none such, one
// made of the level. Takes time by the size of the map then, so keep it.
std::shared_ptr<const Terrain> measured_ground(const Scene& scene, const Level& level);

// A run that can be asked for any of its frames.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual std::int64_t last() const = 0;                         // frames 0 to last() are there
  virtual void read(std::int64_t frame, Frame& into) const = 0;  // 0..last(); overwrites all of `into`
  // Works a little towards a frame that may take long to read. True: to read it next takes no longer than a
  // step.
  virtual bool approach(std::int64_t) const { return true; }
};

// A frame and those before it; before frame 0 there is frame 0 again. Refers to a FrameHistory.
class FrameView {
 public:
  explicit FrameView(std::vector<const Frame*> newest_first) : frames_(std::move(newest_first)) {}
  const Frame& now() const { return *frames_.front(); }
  // back: frames before now, 0 or more, and no more than the history was made for.
  const Frame& before(std::size_t back) const {
    return *frames_[back < frames_.size() ? back : frames_.size() - 1];
  }
  bool is_first() const { return frames_.size() == 1; }  // there is no frame before

 private:
  std::vector<const Frame*> frames_;  // never empty
};

// The last frames of a run, as many as are asked for.
class FrameHistory {
 public:
  explicit FrameHistory(int before);  // how many frames before the newest one are kept
  FrameHistory(const FrameHistory&) = delete;
  FrameHistory& operator=(const FrameHistory&) = delete;

  void clear();
  Frame& next();  // a new newest frame, to be filled; good until the next call
  // Makes `frame` of the source the newest; reads it alone where the one before is the newest now.
  void go_to(const FrameSource& source, std::int64_t frame);
  // The same a little at a time, no more than some steps a call. True: it is the newest.
  bool approach(const FrameSource& source, std::int64_t frame);
  FrameView view() const;  // there must be a frame (asserted); good until the next change

 private:
  std::vector<Frame> ring_;
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace talus
