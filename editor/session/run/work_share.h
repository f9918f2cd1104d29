// WorkShare: how much work to do between two checks of the clock, so that slow steps do not stop the window,
// and quick steps do not pay for many checks.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace talus {

// A clock that starts when it is made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
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
