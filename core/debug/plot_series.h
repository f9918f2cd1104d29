// Plots: expressions over a range of frames, as a bounded number of points for sparklines and plots.
#pragma once

#include <string>
#include <vector>

#include "expression.h"

namespace talus {

// A number over some frames that follow one another.
struct SeriesPoint {
  double least, greatest;  // over the frames that have a number; NaN if none has
  double last;             // in the last of the frames; NaN if it has no number
};

// One number for each frame. The points are bounded: when they are used up, two points become one. No peak
// gets lost.
class Series {
 public:
  // first: the frame of the first number. most: maximum of points, an even number from 2 (asserted).
  Series(std::int64_t first, std::size_t most);

  void add(double number);  // number: that of the next frame; NaN if it has none
  std::int64_t first() const { return first_; }
  std::int64_t frames() const { return frames_; }  // frames added so far
  std::int64_t frames_of_point() const {
    return frames_of_point_;
  }  // a power of 2; the last point may have fewer
  const std::vector<SeriesPoint>& points() const { return points_; }

 private:
  void halve();

  std::int64_t first_;
  std::size_t most_;
  std::int64_t frames_ = 0, frames_of_point_ = 1;
  std::vector<SeriesPoint> points_;
};

// An expression about a body.
struct PlottedExpression {
  Expression expression;
  int body = 0;  // id

  // The value in the newest frame of a view. NaN if there is nothing, such as a truth value of a body that is
  // gone, which conditions count as false.
  double value(const FrameView& view) const;
};

// Makes the series of several plots over the frames of a branch, a few frames at a time. Goes on when the
// branch has grown.
class PlotReader {
 public:
  // first: the first frame; the last one is last(). most: as in Series.
  PlotReader(std::vector<PlottedExpression> plots, std::int64_t first, std::size_t most);

  // Reads up to `most` frames of the source, fewer if it has to run to them first. The source must be the
  // same in every call. Returns true at the source's last frame. To cancel, drop the object.
  bool advance(const FrameSource& source, std::int64_t frames);
  double progress(const FrameSource& source) const;              // 0 to 1
  const std::vector<Series>& series() const { return series_; }  // one for each plot

 private:
  std::vector<PlottedExpression> plots_;
  std::vector<Series> series_;
  FrameHistory history_;
  std::int64_t first_, next_;
};

}  // namespace talus
