#include "plot_series.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace talus {
namespace {

int frames_before(const std::vector<PlottedExpression>& plots) {
  int most = 0;
  for (const PlottedExpression& plot : plots) most = std::max(most, plot.expression.frames_before());
  return most;
}

SeriesPoint joined(const SeriesPoint& a, const SeriesPoint& b) {
  return {std::fmin(a.least, b.least), std::fmax(a.greatest, b.greatest), b.last};  // fmin and fmax skip NaN
}

}  // namespace

double PlottedExpression::value(const FrameView& view) const {
  const bool is_about_none = expression.asks_body() && view.now().state.find(body) == nullptr;
  if (is_about_none && expression.type() == ValueType::truth) return std::numeric_limits<double>::quiet_NaN();
  return expression.evaluate(view, body);
}

Series::Series(std::int64_t first, std::size_t most) : first_(first), most_(most) {
  assert(most >= 2 && most % 2 == 0);
}

void Series::add(double number) {
  const SeriesPoint point{number, number, number};
  if (frames_ % frames_of_point_ != 0) {
    points_.back() = joined(points_.back(), point);
  } else {
    if (points_.size() == most_) halve();
    points_.push_back(point);
  }
  ++frames_;
}

void Series::halve() {
  for (std::size_t i = 0; i < most_ / 2; ++i) points_[i] = joined(points_[2 * i], points_[2 * i + 1]);
  points_.resize(most_ / 2);
  frames_of_point_ *= 2;
}

PlotReader::PlotReader(std::vector<PlottedExpression> plots, std::int64_t first, std::size_t most)
    : plots_(std::move(plots)),
      series_(plots_.size(), Series(first, most)),
      history_(frames_before(plots_)),
      first_(first),
      next_(first) {}

bool PlotReader::advance(const FrameSource& source, std::int64_t frames) {
  for (; frames > 0 && next_ <= source.last(); --frames) {
    if (!history_.approach(source, next_)) continue;
    const FrameView view = history_.view();
    for (std::size_t i = 0; i < plots_.size(); ++i) series_[i].add(plots_[i].value(view));
    ++next_;
  }
  return next_ > source.last();
}

double PlotReader::progress(const FrameSource& source) const {
  const std::int64_t all = source.last() + 1 - first_;
  return all > 0 ? static_cast<double>(next_ - first_) / static_cast<double>(all) : 1;
}

}  // namespace talus
