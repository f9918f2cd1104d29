// What the user watches: expressions, with their values over the whole run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "debug/watch.h"

namespace talus {

// An expression whose value is wanted in every frame.
struct WatchText {
  std::string text;
  int body = 0;  // id of the body that it is about; 0: the chosen one
  friend bool operator==(const WatchText&, const WatchText&) = default;
};

class Watches {
 public:
  static constexpr std::size_t kMostPoints = 1024;  // of a series

  struct Entry {
    WatchText watch;
    std::optional<Expression> expression;  // nothing: its text is wrong
    ExpressionError error;                 // then
    std::size_t series = 0;                // its place in the run
  };

  const std::vector<Entry>& all() const { return entries_; }
  void put(std::size_t index,
           WatchText watch);  // in the place of that one, or, if there is none, behind the last
  void remove(std::size_t index);
  // Its numbers in the frames so far; null: its text is wrong.
  const Series* series(const Entry& entry) const;
  // Its value in the last frame of a history; NaN: nothing there.
  static double value(const Entry& entry, const FrameView& view, int chosen_body);

  // The frames are of another run now, or another body is chosen.
  void begin_again() { run_.reset(); }
  // Reads up to so many frames more; true when it has come to the last one.
  bool advance(const FrameSource& source, int chosen_body, std::int64_t most_frames);

 private:
  std::vector<Entry> entries_;
  std::optional<WatchRun> run_;
  int chosen_body_ = 0;  // that the run is about
};

}  // namespace talus
