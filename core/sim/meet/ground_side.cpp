#include "ground_side.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "../../collision/box_on_piece.h"
#include "../../collision/cell_block.h"

namespace talus {
namespace {

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

// ---- Finding sides ----

GroundSide line(Vec2 from, Vec2 to, Vec2 along, Vec2 normal, Facing facing, std::int32_t origin) {
  GroundSide side;
  side.from = from;
  side.to = to;
  side.along = along;
  side.normal = normal;
  side.facing = facing;
  side.origin = origin;
  return side;
}

// The open sides of full tiles in a row: upper and lower ones reach over as many tiles as there are.
void add_tiles(const Terrain& ground, const Terrain::RowWindow& window, int column, int count, int row,
               std::vector<GroundSide>& found) {
  const double top = ground.y_of(row), bottom = ground.y_of(row + 1);
  for (const Facing facing : {Facing::up, Facing::down, Facing::left, Facing::right}) {
    const bool is_flat = facing == Facing::up || facing == Facing::down;
    std::uint64_t bits = window.open(facing) & (~std::uint64_t{0} >> (64 - count));
    while (bits != 0) {
      const int first = std::countr_zero(bits);
      const int many = is_flat ? std::countr_one(bits >> first) : 1;
      bits &= many == 64 ? 0 : ~(((std::uint64_t{1} << many) - 1) << first);
      const double left = ground.x_of(column + first), right = ground.x_of(column + first + many);
      const std::int32_t origin = row * ground.width() + column + first;
      if (is_flat) {
        const double y = facing == Facing::up ? top : bottom;
        found.push_back(
            line({left, y}, {right, y}, {1, 0}, {0, facing == Facing::up ? -1.0 : 1.0}, facing, origin));
      } else {
        const double x = facing == Facing::left ? left : right;
        found.push_back(
            line({x, top}, {x, bottom}, {0, 1}, {facing == Facing::left ? -1.0 : 1.0, 0}, facing, origin));
      }
    }
  }
}

// ---- The nearest point of a curve ----

// px: the x of the point of an arc that is nearest, or infinite if that is on the other half of the circle.
double nearest_on_arc(const CurveStretch<double>& arc, Vec2 middle) {
  const Vec2 way{middle.x - arc.c[0], middle.y - arc.c[1]};
  const double far = length(way);
  if (!(far > 0) || way.y * arc.sign < 0) return way.x < 0 ? -HUGE_VAL : HUGE_VAL;
  return arc.c[0] + way.x / far * arc.c[2];
}

// The same for other curves, between two places on the side. Of several points that are nearer than those
// beside them, the nearest of some samples leads to one. is_fine: the samples are close together.
double nearest_by_halving(const GroundSide& side, double x0, double x1, Vec2 middle, bool is_fine = false) {
  constexpr int kSamples = 8;
  const CurveStretch<double>& curve = *side.stretch;
  int best = 0;
  double least = HUGE_VAL;
  const auto sample = [&](int i) { return i == kSamples ? x1 : x0 + (x1 - x0) * i / kSamples; };
  for (int i = 0; i <= kSamples; ++i) {
    const double x = sample(i);
    const Vec2 way{x - middle.x, curve.y_at(x) - middle.y};
    if (const double far = dot(way, way); far < least) {
      least = far;
      best = i;
    }
  }
  // Over 0: the point at x is too far to the right.
  const auto beyond = [&](double x) {
    return dot(Vec2{x - middle.x, curve.y_at(x) - middle.y}, curve.tangent_at(x));
  };
  double left = sample(std::max(best - 1, 0)), right = sample(std::min(best + 1, kSamples));
  double at_left = beyond(left), at_right = beyond(right);
  if (!(at_left < 0 && at_right > 0)) {
    const bool is_first = best == 0 && at_left >= 0, is_last = best == kSamples && at_right <= 0;
    const double at = sample(best), curvature = curve.curvature_at(at);
    // In a hollow narrower than the circle its lowest point may be farther than those on either side.
    const bool is_narrow = side.is_hollow() && least * curvature * curvature > 1;
    if (is_fine || ((is_first || is_last) && !is_narrow))
      return is_first ? -HUGE_VAL : is_last ? HUGE_VAL : at;
    const double fine = nearest_by_halving(side, left, right, middle, true);
    if (fine < left) return left == x0 ? -HUGE_VAL : left;
    if (fine > right) return right == x1 ? HUGE_VAL : right;
    return fine;
  }
  constexpr int kMaxTries = 60;
  for (int i = 0; i < kMaxTries; ++i) {
    double x = left - at_left * (right - left) / (at_right - at_left);
    if (i % 3 == 2 || !(x > left && x < right)) x = left + (right - left) / 2;
    if (!(x > left && x < right)) break;
    const double at = beyond(x);
    if (at == 0) return x;
    (at < 0 ? left : right) = x;
    (at < 0 ? at_left : at_right) = at;
  }
  return at_right < -at_left ? right : left;
}

Nearness near_point(Vec2 point, Vec2 middle, double radius) {
  const Vec2 way = middle - point;
  const double far = length(way);
  Nearness near;
  near.normal = far > 0 ? way * (1 / far) : Vec2{0, -1};
  near.gap = far - radius;
  near.bend = 1 / radius;
  near.on_end = true;
  return near;
}

// px: the same, of a point that is on the curve, or hardly beside it.
double nearest_by_steps(const CurveStretch<double>& curve, double x0, double x1, Vec2 point) {
  constexpr int kMaxSteps = 6;
  double x = point.x;
  for (int i = 0; i < kMaxSteps && x > x0 && x < x1; ++i) {
    const Vec2 along = curve.tangent_at(x);
    const double step = dot(point - Vec2{x, curve.y_at(x)}, along) * along.x;
    if (x + step == x) break;
    x += step;
  }
  return x;
}

// A corner of a box has no radius, and is on the curve, or hardly beside it.
SideNearness corner_nearness(const GroundSide& side, Vec2 corner) {
  const CurveStretch<double>& curve = *side.stretch;
  const bool is_arc = curve.kind == CurveStretch<double>::Kind::arc;
  const double on_curve =
      is_arc ? nearest_on_arc(curve, corner) : nearest_by_steps(curve, side.from.x, side.to.x, corner);
  const double x = std::clamp(on_curve, side.from.x, side.to.x);
  SideNearness found;
  found.near.normal = normal_on(curve.tangent_at(x), side.facing);
  found.near.gap = dot(corner - Vec2{x, curve.y_at(x)}, found.near.normal);
  found.near.bend = curve.curvature_at(x) * (side.is_hollow() ? -1 : 1);
  found.near.on_end = x != on_curve;
  return found;
}

}  // namespace

bool GroundSide::is_hollow() const {
  return stretch != nullptr && stretch->bends_down != (facing == Facing::up);
}

bool is_first_nearer(const GroundSide& side, Vec2 point) {
  const Vec2 from = point - side.from, to = point - side.to;
  return dot(from, from) <= dot(to, to);
}

GroundSide side_of(const Piece<double>& piece, std::span<const CurveStretch<double>> stretches) {
  GroundSide side;
  if (piece.is_wall()) {
    side = line({piece.x0, piece.y0}, {piece.x1, piece.y1}, {0, 1},
                {piece.facing == Facing::left ? -1.0 : 1.0, 0}, piece.facing, piece.origin);
  } else {
    const double size = std::sqrt(1 + piece.slope * piece.slope), up = piece.facing == Facing::up ? 1 : -1;
    side = line({piece.x0, piece.y0}, {piece.x1, piece.y1}, {1 / size, piece.slope / size},
                {up * piece.slope / size + 0.0, -up / size}, piece.facing, piece.origin);
  }
  side.piece = &piece;
  if (piece.stretch != 0) side.stretch = &stretches[piece.stretch - 1];
  side.is_thin = piece.one_way || piece.origin < 0;
  return side;
}

SideNearness nearness(const GroundSide& side, Vec2 middle, double radius) {
  const auto end = [&](Vec2 point, Vec2 normal) {
    return SideNearness{near_point(point, middle, radius), dot(middle - point, normal) >= 0};
  };
  if (side.stretch == nullptr) {
    const Vec2 way = middle - side.from, back = middle - side.to;
    const double passed = dot(way, side.along), left = -dot(back, side.along);
    if (passed < 0) return end(side.from, side.normal);
    if (left < 0) return end(side.to, side.normal);
    const double far = dot(passed < left ? way : back, side.normal);
    return {{side.normal, far - radius}, far >= 0};
  }
  if (!(radius > 0)) return corner_nearness(side, middle);
  const CurveStretch<double>& curve = *side.stretch;
  const auto normal_at = [&](double x) { return normal_on(curve.tangent_at(x), side.facing); };
  const bool is_arc = curve.kind == CurveStretch<double>::Kind::arc;
  const double x =
      is_arc ? nearest_on_arc(curve, middle) : nearest_by_halving(side, side.from.x, side.to.x, middle);
  if (x < side.from.x) return end(side.from, normal_at(side.from.x));
  if (x > side.to.x) return end(side.to, normal_at(side.to.x));
  const Vec2 normal = normal_at(x);
  const double far = dot(middle - Vec2{x, curve.y_at(x)}, normal);
  SideNearness found{{normal, far - radius}, far >= 0};
  const double around = 1 / curve.curvature_at(x);  // px
  const double middles = side.is_hollow() ? radius - around : radius + around;
  if (std::isfinite(around) && middles != 0) found.near.bend = 1 / middles;
  return found;
}

void find_sides(const Terrain& ground, const Rect& area, CastBudget& budget, std::vector<GroundSide>& found) {
  found.clear();
  const CellBlock cells = cells_met(ground, area, 0.0).on(ground);
  for (int column = cells.left; column <= cells.right; column += 64) {
    const int count = std::min(cells.right - column + 1, 64);
    Terrain::Window window(ground, column, count);
    for (int row = cells.top; row <= cells.bottom && budget.left > 0; ++row) {
      const auto here = window.row(row);
      add_tiles(ground, here, column, count, row, found);
      std::uint64_t detailed = here.detailed() & (~std::uint64_t{0} >> (64 - count));
      for (; detailed != 0; detailed &= detailed - 1) {
        for (const Piece<double>& piece : window.pieces(std::countr_zero(detailed), row))
          found.push_back(side_of(piece, ground.stretches()));
      }
      --budget.left;
    }
  }
  budget.left -= static_cast<std::int64_t>(found.size());
}

}  // namespace talus
