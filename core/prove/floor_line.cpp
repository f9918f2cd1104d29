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
      if (ground.is_solid_at(next, height - 2 * slack_))
        return true;  // where a solid goes on in the next cell
      best = Point{end, top.at(end)};
      best_height = height;
      return true;
    });
    if (!best) return;
    const Point end = end_of_way(ground, from, *best);
    points_.push_back(end);
    if (end.x != best->x) return;
    from = end;
  }
}

// Where a piece of the line goes into ground, found to a slack; else its end.
FloorLine::Point FloorLine::end_of_way(const RawGround& ground, Point from, Point to) const {
  const bool right = from.x < to.x;
  const RawLine line = right ? RawLine{from.x, from.y, to.x, to.y} : RawLine{to.x, to.y, from.x, from.y};
  Fine end = to.x;
  const FineBox area{line.x0, std::min(from.y, to.y), line.x1, std::max(from.y, to.y)};
  ground.for_parts(area, [&](const RawPart& part) {
    const Fine x0 = std::max(part.top.x0, line.x0), x1 = std::min(part.top.x1, line.x1);
    if (part.kind != RawPart::Kind::solid || x1 - x0 <= 2 * slack_) return true;
    const auto is_inside = [&](Fine x) {
      const Fine y = line.at(x);
      return y > part.top.at(x) + slack_ && y < part.bottom.at(x) - slack_;
    };
    Fine free = right ? x0 : x1, inside = right ? x0 + slack_ : x1 - slack_;
    for (const Fine x : {inside, (x0 + x1) / 2, right ? x1 - slack_ : x0 + slack_}) {
      inside = x;
      if (is_inside(x)) break;
      free = x;
    }
    if (!is_inside(inside)) return true;
    while (std::abs(inside - free) > slack_) {
      const Fine middle = free + (inside - free) / 2;
      (is_inside(middle) ? inside : free) = middle;
    }
    if (right ? free < end : free > end) end = free;
    return true;
  });
  return {end, end == to.x ? to.y : line.at(end)};
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
