// Expressions over a range of frames, as a bounded number of points for sparklines and plots.
#pragma once

#include <string>
#include <vector>

#include "expression.h"

namespace talus {

// What a number was like in some frames that follow one another.
struct SeriesPoint {
  double least, greatest;  // of the frames that had a number; NaN: none had
  double last;             // in the last of the frames; NaN: nothing there
};

// A number of each frame, summed up so that it never has more points than are asked for: when they are used
// up, two points become one. No peak gets lost.
class Series {
 public:
  // first: the frame of the first number. most: points, an even number of 2 or more (asserted).
  Series(std::int64_t first, std::size_t most);

  void add(double number);  // of the next frame; NaN: it has none
  std::int64_t first() const { return first_; }
  std::int64_t frames() const { return frames_; }  // added so far
  std::int64_t frames_of_point() const {
    return frames_of_point_;
  }  // a power of 2; the last one may have fewer
  const std::vector<SeriesPoint>& points() const { return points_; }

 private:
  void halve();

  std::int64_t first_;
  std::size_t most_;
  std::int64_t frames_ = 0, frames_of_point_ = 1;
  std::vector<SeriesPoint> points_;
};

// An expression of a body.
struct Watch {
  Expression expression;
  int body = 0;  // id

  // In the newest frame of a view. NaN: nothing there, such as the truth about a body that is gone, which
  // conditions take for false.
  double value(const FrameView& view) const;
};

// Makes the series of several watches over frames of a recording, a few frames at a time; goes on when the
// recording has grown.
class WatchRun {
 public:
  // Frames first to last(); most: as of Series.
  WatchRun(std::vector<Watch> watches, std::int64_t first, std::size_t most);

  // Reads up to so many frames of the source, fewer where it has to run to them first, which must be the same
  // in every call. True: it has come to the source's last frame. To cancel it, drop it.
  bool advance(const FrameSource& source, std::int64_t frames);
  double progress(const FrameSource& source) const;              // 0 to 1
  const std::vector<Series>& series() const { return series_; }  // of each watch

 private:
  std::vector<Watch> watches_;
  std::vector<Series> series_;
  FrameHistory history_;
  std::int64_t first_, next_;
};

}  // namespace talus
