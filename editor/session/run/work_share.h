// WorkShare: how much work to do between two checks of the clock, so that slow steps do not stop the window,
// and quick steps do not pay for many checks. The clock is the processor time of the calling thread: on a
// busy machine a turn does the same work as on an idle one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>

namespace talus {

// s, processor time of this thread.
inline double processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

// Measures the processor time of its thread since it was made.
class Stopwatch {
 public:
  double seconds() const { return processor_time() - begin_; }

 private:
  double begin_ = processor_time();
};

class WorkShare {
 public:
  // most: pieces of work in one go, >= 1. seconds: time that they may take. It begins with one piece.
  WorkShare(std::int64_t most, double seconds) : most_(most), seconds_(seconds) {}

  std::int64_t count() const { return count_; }  // pieces to do now, 1 to `most`
  // The next pieces are of another kind, whose time is not known yet.
  void begin_again() { count_ = 1; }
  // The time of the last pieces. If it was too long, fewer are done in one go after that; if it was short,
  // more.
  void note(double seconds) {
    count_ = seconds > seconds_ ? std::max<std::int64_t>(count_ / 4, 1) : std::min(count_ * 2, most_);
  }

 private:
  std::int64_t most_;
  double seconds_;
  std::int64_t count_ = 1;
};

// Measures how long it lives.
class TimedPiece {
 public:
  explicit TimedPiece(WorkShare& share) : share_(share) {}
  ~TimedPiece() { share_.note(watch_.seconds()); }
  TimedPiece(const TimedPiece&) = delete;
  TimedPiece& operator=(const TimedPiece&) = delete;

 private:
  WorkShare& share_;
  Stopwatch watch_;
};

}  // namespace talus
