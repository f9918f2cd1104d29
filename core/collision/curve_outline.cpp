// Cuts curves at the points where they turn, or begin to bend to the other side.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "outline_compiler.h"
#include "twofold.h"

namespace talus {
namespace {

using Stretch = CurveStretch<double>;

// A stretch from one point to another.
struct StretchPart {
  Stretch stretch;
  Vec2 from, to;
};

// px; the length of the straight end of a curve, see shape.h.
constexpr double kStraightEnd = 0.25;

class CurveCutter {
 public:
  void cut(const Curve& curve, std::int32_t number) {
    origin_ = -1 - number;
    faces_ = curve.faces;
    std::visit([this](const auto& form) { put(form); }, curve.form);
  }
  CurveOutline take() {
    put_tips();
    return std::move(outline_);
  }

 private:
  // upper, lower: the ways that the piece faces if its curve faces up and down.
  void put_piece(Piece<double> piece, Facing upper = Facing::up, Facing lower = Facing::down) {
    assert(piece.x0 < piece.x1 || (piece.x0 == piece.x1 && piece.y0 < piece.y1));
    piece.origin = origin_;
    piece.one_way = faces_ != Curve::Faces::both;
    piece.convex0 = piece.convex1 = piece.x0 == piece.x1;
    for (const bool up : {true, false}) {
      if (faces_ == (up ? Curve::Faces::down : Curve::Faces::up)) continue;
      piece.facing = up ? upper : lower;
      outline_.pieces.push_back(piece);
    }
  }

  void put_wall(double x, double y0, double y1, bool faces_left) {
    const Facing upper = faces_left ? Facing::left : Facing::right;
    const Facing lower = faces_left ? Facing::right : Facing::left;
    put_piece({.x0 = x, .y0 = y0, .x1 = x, .y1 = y1, .base_x = x, .base_y = y0}, upper, lower);
  }

  // Needs a.x <= b.x. A stretch that is too short for its ends to differ is dropped.
  void put_line(Vec2 a, Vec2 b) {
    if (a == b) return;
    // The upper side of a steep line that rises to the right faces left; that of one that falls faces right.
    if (a.x == b.x) return put_wall(a.x, std::min(a.y, b.y), std::max(a.y, b.y), b.y < a.y);
    const Vec2 base = a.y <= b.y ? a : b;
    const auto slope = Twofold<double>(b.y - a.y) / (b.x - a.x);
    put_piece({.x0 = a.x,
               .y0 = a.y,
               .x1 = b.x,
               .y1 = b.y,
               .base_x = base.x,
               .base_y = base.y,
               .slope = slope.high,
               .slope_rest = slope.low});
  }

  void put_stretch(const StretchPart& part) {
    outline_.stretches.push_back(part.stretch);
    put_piece({.x0 = part.from.x,
               .y0 = part.from.y,
               .x1 = part.to.x,
               .y1 = part.to.y,
               .stretch = static_cast<std::uint32_t>(outline_.stretches.size())});
  }

  void put(const Segment& s) {
    const Vec2 a = weld(s.from), b = weld(s.to);
    if (s.from.x == s.to.x) return put_wall(a.x, a.y, b.y, true);
    put_line(a, b);
  }

  void put(const Polyline& p) {
    const double x0 = weld(p.x0), x1 = weld(p.x1);
    const double parts = static_cast<double>(p.ys.size() - 1);
    const auto point = [&](std::size_t i) {
      return weld(Vec2{x0 + (x1 - x0) * (static_cast<double>(i) / parts), p.ys[i]});
    };
    for (std::size_t i = 0; i + 1 < p.ys.size(); ++i) put_line(point(i), point(i + 1));
  }

  void put(const Arc& a) {
    const double r = a.radius;
    const Stretch s{.kind = Stretch::Kind::arc,
                    .sign = a.upper ? -1.0 : 1.0,
                    .c = {a.center.x, a.center.y, r},
                    .bends_down = a.upper};
    const double x0 = std::max(weld(a.x0), a.center.x - r), x1 = std::min(weld(a.x1), a.center.x + r);
    cut_stretch(s, {x0, s.y_at(x0)}, {x1, s.y_at(x1)}, {a.center.x});
    put_parts(weld({a.x0, s.y_at(a.x0)}), weld({a.x1, s.y_at(a.x1)}));
  }

  void put(const Parabola& p) {
    const Vec2 a = weld(p.from), b = weld(p.to);
    const double control = weld(p.control_y), half = (b.x - a.x) / 2;
    put_polynomial(a, b, ((a.y + b.y) / 2 + control) / 2, (b.y - a.y) / (b.x - a.x),
                   ((a.y + b.y) / 2 - control) / 2 / (half * half), 0);
  }

  void put(const Cubic& p) {
    const Vec2 a = weld(p.from), b = weld(p.to);
    const double half = (b.x - a.x) / 2, rise = (b.y - a.y) / 2 / half;
    const double c2 = (p.to_slope - p.from_slope) / (4 * half);
    const double c3 = ((p.from_slope + p.to_slope) / 2 - rise) / (2 * half * half);
    put_polynomial(a, b, (a.y + b.y) / 2 - c2 * half * half, rise - c3 * half * half, c2, c3);
  }

  // The polynomial is written about the middle, so that a mirrored curve has the same coefficients but for
  // signs.
  void put_polynomial(Vec2 a, Vec2 b, double c0, double c1, double c2, double c3) {
    Stretch s{.kind = Stretch::Kind::polynomial};
    const double middle = (a.x + b.x) / 2;
    const double c[] = {middle, c0, c1, c2, c3};
    std::copy(std::begin(c), std::end(c), s.c);
    std::vector<double> cuts;
    if (c3 != 0) cuts.push_back(middle - c2 / (3 * c3));
    // f' = c1 + 2 c2 u + 3 c3 u^2, by the stable form of the quadratic formula
    const double root = c2 * c2 - 3 * c3 * c1;
    if (root >= 0) {
      const double q = -(c2 + std::copysign(std::sqrt(root), c2));
      if (c3 != 0) cuts.push_back(middle + q / (3 * c3));
      if (q != 0) cuts.push_back(middle + c1 / q);
    }
    cut_stretch(s, a, b, std::move(cuts));
    put_parts(a, b);
  }

  void put(const Sine& w) {
    const double x0 = weld(w.x0), x1 = weld(w.x1), quarter = w.wavelength / 4;
    const auto number_at = [&](double x) { return std::floor((x - w.origin) / quarter); };
    const auto height_at = [&](double x) { return quarter_of(w, number_at(x)).y_at(x); };
    double x = x0;
    for (double k = number_at(x0); x < x1; ++k) {
      const double end = std::min(x1, w.origin + (k + 1) * quarter);
      if (end <= x) continue;
      const Stretch s = quarter_of(w, k);
      parts_.push_back({s, {x, s.y_at(x)}, {end, s.y_at(end)}});
      x = end;
    }
    put_parts(weld({w.x0, height_at(w.x0)}), weld({w.x1, height_at(w.x1)}));
  }

  // The stretch of a sine from `number` to `number` + 1 quarters of a wave right of its origin.
  static Stretch quarter_of(const Sine& w, double number) {
    // The zero crossing of this quarter: its first end if the number is even, else its last end.
    const double crossing = std::fmod(number, 2) == 0 ? number : number + 1;
    const bool falls = std::fmod(crossing, 4) != 0;  // the half wave is upside down
    Stretch s{.kind = Stretch::Kind::sine};
    s.c[0] = w.origin + crossing * (w.wavelength / 4);
    s.c[1] = w.middle;
    s.c[2] = falls ? -w.amplitude : w.amplitude;
    s.c[3] = w.wavelength;
    const double side =
        (crossing == number ? 1 : -1) * s.c[2];  // y - middle has this sign inside the quarter
    s.bends_down = side < 0;
    return s;
  }

  // Appends the parts of a stretch between its cuts.
  void cut_stretch(Stretch stretch, Vec2 a, Vec2 b, std::vector<double> cuts) {
    std::erase_if(cuts, [&](double x) { return !(x > a.x && x < b.x); });
    std::sort(cuts.begin(), cuts.end());
    Vec2 from = a;
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
      const Vec2 to = i == cuts.size() ? b : Vec2{cuts[i], stretch.y_at(cuts[i])};
      if (to.x > from.x) {
        if (stretch.kind == Stretch::Kind::polynomial) {
          const double u = (from.x + to.x) / 2 - stretch.c[0];
          stretch.bends_down = stretch.c[3] + 3 * stretch.c[4] * u > 0;
        }
        parts_.push_back({stretch, from, to});
      }
      from = to;
    }
  }

  // Puts the parts of a whole curve between its welded ends, with straight ends where they are off the curve.
  void put_parts(Vec2 first, Vec2 last) {
    assert(!parts_.empty());  // a valid curve has a width
    const StretchPart &outer = parts_.front(), &other = parts_.back();
    const double half = (last.x - first.x) / 2;
    const Vec2 from =
        outer.from == first ? first : point_at(first.x + std::min(width_of_end(outer, outer.from), half));
    const Vec2 to =
        other.to == last ? last : point_at(last.x - std::min(width_of_end(other, other.to), half));
    if (from.x > first.x) put_end(first, from);
    for (StretchPart part : parts_) {
      if (from.x > part.from.x) part.from = from;
      if (to.x < part.to.x) part.to = to;
      if (part.from.x < part.to.x) put_stretch(part);
    }
    if (to.x < last.x) put_end(to, last);
    parts_.clear();
  }

  static double width_of_end(const StretchPart& part, Vec2 end) {
    return std::max(weld(kStraightEnd * part.stretch.tangent_at(end.x).x), 1.0 / kWeldParts);
  }

  // The point of the current curve at x.
  Vec2 point_at(double x) const {
    const auto part = std::find_if(parts_.begin(), parts_.end(), [&](const auto& p) { return x <= p.to.x; });
    return {x, part->stretch.y_at(x)};
  }

  // A straight end is a stretch, so that steepest_on_curve() holds for it. Needs a.x < b.x.
  void put_end(Vec2 a, Vec2 b) {
    const Vec2 middle = (a + b) * 0.5;
    put_stretch(
        {{.kind = Stretch::Kind::polynomial, .c = {middle.x, middle.y, (b.y - a.y) / (b.x - a.x)}}, a, b});
  }

  // A line that stops bodies on both sides also stops them at its ends.
  void put_tips() {
    outline_.ends = CurveEnds(outline_.pieces);
    const std::vector<Piece<double>> pieces = outline_.pieces;
    const auto goes_on = [&](const Piece<double>& piece, bool first) {
      const Vec2 end = first ? Vec2{piece.x0, piece.y0} : Vec2{piece.x1, piece.y1};
      return !outline_.ends.at(end, !first).empty();
    };
    for (const Piece<double>& piece : pieces) {
      if (piece.one_way || piece.facing == Facing::down || piece.facing == Facing::right) continue;
      const bool wall = piece.is_wall();
      if (wall || !goes_on(piece, true)) put_tip(piece, true, wall ? Facing::up : Facing::left);
      if (wall || !goes_on(piece, false)) put_tip(piece, false, wall ? Facing::down : Facing::right);
    }
  }

  void put_tip(Piece<double> tip, bool first, Facing facing) {
    tip.stretch = 0;
    tip.slope = tip.slope_rest = 0;
    tip.facing = facing;
    tip.x0 = tip.x1 = tip.base_x = first ? tip.x0 : tip.x1;
    tip.y0 = tip.y1 = tip.base_y = first ? tip.y0 : tip.y1;
    tip.convex0 = tip.convex1 = true;
    outline_.pieces.push_back(tip);
  }

  CurveOutline outline_;
  std::vector<StretchPart> parts_;  // of the current curve, from the left
  std::int32_t origin_ = 0;
  Curve::Faces faces_ = Curve::Faces::up;
};

bool is_before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

}  // namespace

CurveEnds::CurveEnds(std::span<const Piece<double>> pieces) {
  for (std::uint32_t n = 0; n < pieces.size(); ++n) {
    const Piece<double>& p = pieces[n];
    if (p.is_wall()) continue;
    begins_.push_back({{p.x0, p.y0}, n});
    ends_.push_back({{p.x1, p.y1}, n});
  }
  const auto by_point = [](const End& a, const End& b) {
    return a.point == b.point ? a.piece < b.piece : is_before(a.point, b.point);
  };
  std::sort(begins_.begin(), begins_.end(), by_point);
  std::sort(ends_.begin(), ends_.end(), by_point);
}

std::span<const CurveEnds::End> CurveEnds::at(Vec2 point, bool first) const {
  const std::vector<End>& all = first ? begins_ : ends_;
  const auto begin = std::lower_bound(all.begin(), all.end(), point,
                                      [](const End& end, Vec2 p) { return is_before(end.point, p); });
  const auto end = std::find_if(begin, all.end(), [&](const End& e) { return e.point != point; });
  return {begin, end};
}

CurveOutline cut_curves(std::span<const Curve> curves) {
  CurveCutter cutter;
  for (std::size_t i = 0; i < curves.size(); ++i) cutter.cut(curves[i], static_cast<std::int32_t>(i));
  return cutter.take();
}

}  // namespace talus
