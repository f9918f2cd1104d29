#include "plot_list.h"

#include <limits>

namespace talus {
namespace {

int body_of(const PlotText& plot, int chosen_body) { return plot.body != 0 ? plot.body : chosen_body; }

}  // namespace

void PlotList::put(std::size_t index, PlotText plot) {
  if (index >= entries_.size()) {
    index = entries_.size();
    entries_.emplace_back();
  }
  Entry& entry = entries_[index];
  auto parsed = Expression::parse(plot.text);
  entry.plot = std::move(plot);
  entry.expression.reset();
  if (parsed) {
    entry.expression = std::move(*parsed);
  } else {
    entry.error = std::move(parsed.error());
  }
  begin_again();
}

void PlotList::remove(std::size_t index) {
  if (index >= entries_.size()) return;
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(index));
  begin_again();
}

const Series* PlotList::series(const Entry& entry) const {
  return reader_ && entry.expression ? &reader_->series()[entry.series] : nullptr;
}

double PlotList::value(const Entry& entry, const FrameView& view, int chosen_body) {
  if (!entry.expression) return std::numeric_limits<double>::quiet_NaN();
  return PlottedExpression{*entry.expression, body_of(entry.plot, chosen_body)}.value(view);
}

bool PlotList::advance(const FrameSource& source, int chosen_body, std::int64_t most_frames) {
  if (reader_ && chosen_body != chosen_body_) begin_again();
  if (!reader_) {
    chosen_body_ = chosen_body;
    std::vector<PlottedExpression> plots;
    for (Entry& entry : entries_) {
      if (!entry.expression) continue;
      entry.series = plots.size();
      plots.push_back({*entry.expression, body_of(entry.plot, chosen_body)});
    }
    reader_.emplace(std::move(plots), 0, kMaxPoints);
  }
  return reader_->series().empty() || reader_->advance(source, most_frames);
}

}  // namespace talus
