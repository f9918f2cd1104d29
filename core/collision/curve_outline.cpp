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

  void put_stretch(const Stretch& stretch, Vec2 a, Vec2 b) {
    outline_.stretches.push_back(stretch);
    put_piece({.x0 = a.x,
               .y0 = a.y,
               .x1 = b.x,
               .y1 = b.y,
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
    Stretch s{.kind = Stretch::Kind::arc, .sign = a.upper ? -1.0 : 1.0};
    const Vec2 center = weld(a.center);
    s.c[0] = center.x;
    s.c[1] = center.y;
    s.c[2] = weld(a.radius);
    s.bends_down = a.upper;
    const double x0 = std::max(weld(a.x0), s.c[0] - s.c[2]), x1 = std::min(weld(a.x1), s.c[0] + s.c[2]);
    put_cut(s, {x0, s.y_at(x0)}, {x1, s.y_at(x1)}, {center.x});
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
    put_cut(s, a, b, std::move(cuts));
  }

  void put(const Sine& w) {
    const double x0 = weld(w.x0), x1 = weld(w.x1), quarter = w.wavelength / 4;
    double x = x0;
    for (double k = std::floor((x0 - w.origin) / quarter); x < x1; ++k) {
      const double end = std::min(x1, w.origin + (k + 1) * quarter);
      if (end <= x) continue;
      // The zero crossing of this quarter: its first end if k is even, else its last end.
      const double crossing = std::fmod(k, 2) == 0 ? k : k + 1;
      const bool falls = std::fmod(crossing, 4) != 0;  // the half wave is upside down
      Stretch s{.kind = Stretch::Kind::sine};
      s.c[0] = w.origin + crossing * quarter;
      s.c[1] = w.middle;
      s.c[2] = falls ? -w.amplitude : w.amplitude;
      s.c[3] = w.wavelength;
      const double side = (crossing == k ? 1 : -1) * s.c[2];  // y - middle has this sign inside the quarter
      s.bends_down = side < 0;
      put_stretch(s, {x, s.y_at(x)}, {end, s.y_at(end)});
      x = end;
    }
  }

  void put_cut(Stretch stretch, Vec2 a, Vec2 b, std::vector<double> cuts) {
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
        put_stretch(stretch, from, to);
      }
      from = to;
    }
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
