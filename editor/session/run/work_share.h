// How much work is done between two looks at the clock, so that slow steps do not hold the window up, and
// quick ones pay for few looks.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace talus {

// A clock that runs from where it is made.
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
  // most: pieces of work at once, >= 1. seconds: that they may take. It begins with one piece.
  WorkShare(std::int64_t most, double seconds) : most_(most), seconds_(seconds) {}

  std::int64_t count() const { return count_; }  // pieces to do now, 1 to `most`
  // Other pieces are next, and nobody knows yet how long one takes.
  void begin_again() { count_ = 1; }
  // What they took. Fewer are done at once after that if it was too long, and more if it was short.
  void note(double seconds) {
    count_ = seconds > seconds_ ? std::max<std::int64_t>(count_ / 4, 1) : std::min(count_ * 2, most_);
  }

 private:
  std::int64_t most_;
  double seconds_;
  std::int64_t count_ = 1;
};

// Notes how long it lives.
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
