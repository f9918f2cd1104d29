#include "floor_line.h"

#include <optional>

namespace talus {
namespace {

constexpr int kMostPieces = 64;              // under one body
constexpr Fine kJustAhead = kFinePx / 1024;  // how far ahead of two pieces the higher one is chosen

}  // namespace

FloorLine::FloorLine(const RawGround& ground, Fine x, Fine y, Fine x0, Fine x1, double steepest, Fine slack)
    : slack_(slack) {
  points_.push_back({x, y});
  follow(ground, {x, y}, x0, steepest);
  std::reverse(points_.begin(), points_.end());
  follow(ground, {x, y}, x1, steepest);
  if (points_.size() == 1) points_.clear();
}

// Of the floors that begin or go on at the end of the line, the highest one is its next piece.
void FloorLine::follow(const RawGround& ground, Point from, Fine until, double steepest) {
  const Fine direction = until < from.x ? -1 : 1;
  for (int i = 0; i < kMostPieces && (until - from.x) * direction > 0; ++i) {
    const Fine next = from.x + direction * std::min(kJustAhead, (until - from.x) * direction);
    std::optional<Point> best;
    Fine best_height = 0;
    const FineBox area{std::min(from.x, next), from.y - slack_, std::max(from.x, next), from.y + slack_};
    ground.for_parts(area, [&](const RawPart& part) {
      const RawLine& top = part.top;
      const bool is_here =
          part.is_floor() && top.x0 <= std::min(from.x, next) && top.x1 >= std::max(from.x, next);
      if (!is_here || std::abs(top.at(from.x) - from.y) > slack_) return true;
      const Fine end = direction < 0 ? std::max(top.x0, until) : std::min(top.x1, until);
      if (top.is_steeper_than(steepest, next) || top.is_steeper_than(steepest, end)) return true;
      const Fine height = top.at(next);
      if (best && height >= best_height) return true;
      best = Point{end, top.at(end)};
      best_height = height;
      return true;
    });
    if (!best) return;
    points_.push_back(*best);
    from = *best;
  }
}

Fine FloorLine::at(Fine x) const {
  const auto after = std::find_if(points_.begin(), points_.end(), [&](Point p) { return p.x >= x; });
  if (after == points_.begin()) return after->y;
  const Point a = *(after - 1), b = *after;
  return RawLine{a.x, a.y, b.x, b.y}.at(x);
}

bool FloorLine::covers(const RawPart& part, Fine x0, Fine x1) const {
  if (points_.empty() || x0 < points_.front().x || x1 > points_.back().x) return false;
  const auto is_below = [&](Fine x) { return part.top.at(x) >= at(x) - slack_; };
  return is_below(x0) && is_below(x1) && std::all_of(points_.begin(), points_.end(), [&](Point p) {
           return p.x <= x0 || p.x >= x1 || is_below(p.x);
         });
}

}  // namespace talus
