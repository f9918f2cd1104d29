#include "plot_list.h"

#include <limits>

namespace talus {
namespace {

int body_of(const WatchText& watch, int chosen_body) { return watch.body != 0 ? watch.body : chosen_body; }

}  // namespace

void Watches::put(std::size_t index, WatchText watch) {
  if (index >= entries_.size()) {
    index = entries_.size();
    entries_.emplace_back();
  }
  Entry& entry = entries_[index];
  auto parsed = Expression::parse(watch.text);
  entry.watch = std::move(watch);
  entry.expression.reset();
  if (parsed) {
    entry.expression = std::move(*parsed);
  } else {
    entry.error = std::move(parsed.error());
  }
  begin_again();
}

void Watches::remove(std::size_t index) {
  if (index >= entries_.size()) return;
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(index));
  begin_again();
}

const Series* Watches::series(const Entry& entry) const {
  return run_ && entry.expression ? &run_->series()[entry.series] : nullptr;
}

double Watches::value(const Entry& entry, const FrameView& view, int chosen_body) {
  if (!entry.expression) return std::numeric_limits<double>::quiet_NaN();
  return Watch{*entry.expression, body_of(entry.watch, chosen_body)}.value(view);
}

bool Watches::advance(const FrameSource& source, int chosen_body, std::int64_t most_frames) {
  if (run_ && chosen_body != chosen_body_) begin_again();
  if (!run_) {
    chosen_body_ = chosen_body;
    std::vector<Watch> watches;
    for (Entry& entry : entries_) {
      if (!entry.expression) continue;
      entry.series = watches.size();
      watches.push_back({*entry.expression, body_of(entry.watch, chosen_body)});
    }
    run_.emplace(std::move(watches), 0, kMostPoints);
  }
  return run_->series().empty() || run_->advance(source, most_frames);
}

}  // namespace talus
