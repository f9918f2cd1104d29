#include "raw_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

// A curve is looked at as so many chords, and the nearest of them so often as so many shorter ones.
constexpr int kChords = 32, kRounds = 3;

double distance(Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

// px, from a point to the line between two others.
double distance(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double length = dot(along, along);
  if (!(length > 0)) return distance(point, from);
  return distance(point, from + along * std::clamp(dot(point - from, along) / length, 0.0, 1.0));
}

double distance_to_curve(const RawLine& line, Vec2 point, double reach) {
  double from = std::max(px_of(line.x0), point.x - reach), to = std::min(px_of(line.x1), point.x + reach);
  if (from > to) return std::numeric_limits<double>::infinity();
  const auto at = [&](double x) { return Vec2{x, px_of(line.at(fine(x)))}; };
  double best = 0;
  for (int round = 0; round < kRounds; ++round) {
    const double width = (to - from) / kChords;
    best = std::numeric_limits<double>::infinity();
    double nearest = from;  // the beginning of the nearest chord
    for (int i = 0; i < kChords; ++i) {
      const double x = from + width * i, here = distance(point, at(x), at(x + width));
      if (here < best) best = here, nearest = x;
    }
    from = std::max(from, nearest - width);
    to = std::min(to, nearest + 2 * width);
  }
  return best;
}

// px, at most `reach` away: further ones get any larger number.
double distance(const RawLine& line, Vec2 point, double reach) {
  if (line.curve != nullptr) return distance_to_curve(line, point, reach);
  return distance(point, {px_of(line.x0), px_of(line.y0)}, {px_of(line.x1), px_of(line.y1)});
}

// px, from a point to a part; 0 inside of a solid one.
double distance(const RawPart& part, Vec2 point, double reach) {
  const double top = distance(part.top, point, reach);
  if (part.kind != RawPart::Kind::solid) return top;
  const Fine x = fine(point.x), y = fine(point.y);
  if (x >= part.top.x0 && x <= part.top.x1 && y >= part.top.at(x) && y <= part.bottom.at(x)) return 0;
  const double x0 = px_of(part.top.x0), x1 = px_of(part.top.x1);
  return std::min({top, distance(part.bottom, point, reach),
                   distance(point, {x0, px_of(part.top.y0)}, {x0, px_of(part.bottom.y0)}),
                   distance(point, {x1, px_of(part.top.y1)}, {x1, px_of(part.bottom.y1)})});
}

// Whether a line, which stops bodies from one side, has a point on that side. Beyond its ends both sides are.
bool faces(const RawPart& part, Vec2 point) {
  const RawLine& line = part.top;
  const double x0 = px_of(line.x0), y0 = px_of(line.y0), x1 = px_of(line.x1), y1 = px_of(line.y1);
  if (part.kind == RawPart::Kind::left) return point.x < x0;
  if (part.kind == RawPart::Kind::right) return point.x > x0;
  double below = 0;
  if (line.curve == nullptr) {
    below = (x1 - x0) * (point.y - y0) - (y1 - y0) * (point.x - x0);
  } else if (point.x > x0 && point.x < x1) {
    below = point.y - px_of(line.at(fine(point.x)));
  }
  return part.kind == RawPart::Kind::floor ? below <= 0 : below >= 0;
}

}  // namespace

FineBox RawForm::around() const {
  if (!is_round()) return fine_box(box_);
  const Vec2 m = middle();
  return {fine(m.x - radius_), fine(m.y - radius_), fine(m.x + radius_), fine(m.y + radius_)};
}

bool RawForm::meets(const RawPart& part, double slack) const {
  if (!is_round()) return part.meets(around().shrunk(fine(slack)));
  return distance(part, middle(), radius_) < radius_ - slack;
}

bool RawForm::is_stopped_by(const RawPart& part, const RawForm& there, double slack) const {
  if (!is_round()) return part.stops(around().shrunk(fine(slack)), there.around().shrunk(fine(slack)));
  if (!there.meets(part, slack)) return false;
  return part.kind == RawPart::Kind::solid || (!meets(part, slack) && faces(part, middle()));
}

}  // namespace talus
