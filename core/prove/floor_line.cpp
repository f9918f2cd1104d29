#include "floor_line.h"

namespace talus {
namespace {

constexpr int kMaxPieces = 64;               // under one body, and gaps between them
constexpr Fine kJustAhead = kFinePx / 1024;  // how far ahead of two pieces the higher one is chosen
constexpr Fine kGap = kFinePx / kWeldParts;  // between two floors that count as one

}  // namespace

FloorLine::FloorLine(const RawGround& ground, Fine x, Fine y, Fine x0, Fine x1, double steepest, Fine slack)
    : slack_(slack) {
  follow(ground, x, y, x0, steepest);
  std::reverse(stretches_.begin(), stretches_.end());
  follow(ground, x, y, x1, steepest);
}

// Of the floors that begin or go on at the end of the line, or past a gap, the highest one is its next
// stretch.
void FloorLine::follow(const RawGround& ground, Fine x, Fine y, Fine until, double steepest) {
  const Fine direction = until < x ? -1 : 1;
  bool in_gap = false;
  for (int i = 0; i < kMaxPieces && (until - x) * direction > 0; ++i) {
    const Fine next = x + direction * std::min(kJustAhead, (until - x) * direction);
    std::optional<RawLine> best;
    Fine best_end = 0;
    const FineBox area{std::min(x, next), y - slack_, std::max(x, next), y + slack_};
    ground.for_parts(area, [&](const RawPart& part) {
      const RawLine& top = part.top;
      const bool is_here = part.is_floor() && top.x0 <= std::min(x, next) && top.x1 >= std::max(x, next);
      if (!is_here || std::abs(top.at(x) - y) > slack_) return true;
      const Fine end = direction < 0 ? std::max(top.x0, until) : std::min(top.x1, until);
      if (top.is_steeper_than(steepest, next) || top.is_steeper_than(steepest, end)) return true;
      const Fine height = top.at(next);
      if (best && height >= best->at(next)) return true;
      if (ground.is_solid_at(next, height - 2 * slack_))
        return true;  // where a solid goes on in the next cell
      best = top;
      best_end = end;
      return true;
    });
    if (!best) {
      if (in_gap) return;
      in_gap = true;
      x += direction * kGap;
      continue;
    }
    in_gap = false;
    const Fine end = end_of_way(ground, *best, x, best_end);
    if (end == x) return;
    stretches_.push_back({std::min(x, end), std::max(x, end), *best});
    x = end;
    y = best->at(end);
  }
}

// Where a way along a floor goes into ground, or through a line that stops it; else its end.
Fine FloorLine::end_of_way(const RawGround& ground, const RawLine& top, Fine from, Fine to) const {
  const FineBox area{std::min(from, to), top.highest(from, to), std::max(from, to), top.lowest(from, to)};
  Fine end = to;
  ground.for_parts(area, [&](const RawPart& part) {
    if (const auto stop = stop_at(part, top, from, to); stop && std::abs(*stop - from) < std::abs(end - from))
      end = *stop;
    return true;
  });
  return end;
}

// Where a part stops that way, found to a slack.
std::optional<Fine> FloorLine::stop_at(const RawPart& part, const RawLine& top, Fine from, Fine to) const {
  using Kind = RawPart::Kind;
  const bool right = from < to;
  const Fine x0 = std::max(part.top.x0, std::min(from, to)), x1 = std::min(part.top.x1, std::max(from, to));
  if (part.kind == (right ? Kind::left : Kind::right)) {
    const Fine y = top.at(x0);
    const auto [upper, lower] = std::minmax(part.top.y0, part.top.y1);
    const bool is_met = y > upper + slack_ && y < lower - slack_;
    return is_met ? std::optional(x0) : std::nullopt;
  }
  if (x1 - x0 <= 2 * slack_) return std::nullopt;
  const auto is_above = [&](Fine x) {
    return part.kind != Kind::ceiling && top.at(x) <= part.top.at(x) + slack_;
  };
  const auto is_below = [&](Fine x) {
    return part.kind != Kind::floor && top.at(x) >= part.bottom.at(x) - slack_;
  };
  Fine free = right ? x0 : x1, inside = right ? x0 + slack_ : x1 - slack_;
  const bool comes_above = is_above(free), comes_below = is_below(free);
  if (part.kind != Kind::solid && !comes_above && !comes_below) return std::nullopt;
  const auto is_inside = [&](Fine x) {
    return !(comes_above && is_above(x)) && !(comes_below && is_below(x));
  };
  for (const Fine x : {inside, (x0 + x1) / 2, right ? x1 - slack_ : x0 + slack_}) {
    inside = x;
    if (is_inside(x)) break;
    free = x;
  }
  if (!is_inside(inside)) return std::nullopt;
  while (std::abs(inside - free) > slack_) {
    const Fine middle = free + (inside - free) / 2;
    (is_inside(middle) ? inside : free) = middle;
  }
  return free;
}

Fine FloorLine::at(Fine x) const {
  const auto here =
      std::find_if(stretches_.begin(), stretches_.end(), [&](const Stretch& s) { return s.x1 >= x; });
  return here->top.at(x);
}

bool FloorLine::covers(const RawPart& part, Fine x0, Fine x1) const {
  if (!reaches(x0, x1)) return false;
  const auto is_below = [&](Fine x) { return part.top.at(x) >= at(x) - slack_; };
  return is_below(x0) && is_below(x1) &&
         std::all_of(stretches_.begin(), stretches_.end(),
                     [&](const Stretch& s) { return s.x1 <= x0 || s.x1 >= x1 || is_below(s.x1); });
}

}  // namespace talus
