#include "outline.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "collision/outline_compiler.h"
#include "visible.h"

namespace talus {
namespace {

constexpr double kOutwardLength = 3;  // px
constexpr double kPassLength = 5;     // px, of a one-way side's arrow on either side of it
constexpr double kNormalGap = 16;     // px, at most, from one normal of a piece to the next
constexpr double kMostLines = 1024;   // for a curve that crosses the whole view

Vec2 normal_of(Facing facing) {
  switch (facing) {
    case Facing::up:
      return {0, -1};
    case Facing::down:
      return {0, 1};
    case Facing::left:
      return {-1, 0};
    case Facing::right:
      return {1, 0};
  }
  return {};
}

// One piece where it is visible: the x that it reaches over, and its points.
class VisiblePiece {
 public:
  VisiblePiece(const Piece<double>& piece, std::span<const CurveStretch<double>> stretches,
               const Rect& visible)
      : piece_(piece),
        stretches_(stretches),
        from_(std::max(piece.x0, visible.x)),
        to_(std::min(piece.x1, visible.right())),
        step_(std::max(1.0, visible.w / kMostLines)) {}

  // fn(from, to) for each of its lines.
  template <class Fn>
  void each_line(Fn fn) const {
    if (from_ > to_) return;
    if (piece_.is_wall()) return fn(Vec2{piece_.x0, piece_.y0}, Vec2{piece_.x1, piece_.y1});
    const int count = piece_.stretch == 0 ? 1 : parts(step_);
    for (int i = 0; i < count; ++i) fn(point(i, count), point(i + 1, count));
  }
  // fn(point, normal) at equal distances.
  template <class Fn>
  void each_normal(Fn fn) const {
    if (from_ > to_) return;
    const int count = parts(kNormalGap);
    for (int i = 0; i < count; ++i) {
      const Vec2 at = point(2 * i + 1, 2 * count);
      fn(at, normal_at(at.x));
    }
  }

 private:
  // Into how many parts of this length, px, it is cut.
  int parts(double length) const {
    const double whole = piece_.is_wall() ? piece_.y1 - piece_.y0 : to_ - from_;
    return std::max(1, static_cast<int>(std::ceil(whole / length)));
  }
  Vec2 point(int i, int count) const {
    const double part = static_cast<double>(i) / count;
    if (piece_.is_wall()) return {piece_.x0, piece_.y0 + (piece_.y1 - piece_.y0) * part};
    const double x = from_ + (to_ - from_) * part;
    return {x, piece_.y_at(x, stretches_)};
  }
  Vec2 normal_at(double x) const {
    if (piece_.is_wall()) return normal_of(piece_.facing);
    Vec2 along{1, piece_.slope};
    if (piece_.stretch != 0) {
      const auto tangent = stretches_[piece_.stretch - 1].tangent_at(x);
      along = {tangent.x, tangent.y};
    }
    const double sign = (piece_.facing == Facing::up ? 1 : -1) / std::hypot(along.x, along.y);
    return {along.y * sign, -along.x * sign};
  }

  const Piece<double>& piece_;
  std::span<const CurveStretch<double>> stretches_;
  double from_, to_, step_;
};

class OutlineDrawer {
 public:
  OutlineDrawer(const Terrain& ground, OverlaySet overlays, const Rect& visible, OverlayDrawing& out)
      : ground_(ground), overlays_(overlays), visible_(visible), out_(out) {}

  void draw() {
    const auto cell = [](double px, int count) {
      return std::clamp(static_cast<int>(std::floor(px / kTileSide)), -1, count);
    };
    const int x0 = std::max(cell(visible_.x, ground_.width()), 0),
              x1 = cell(visible_.right(), ground_.width());
    const int y0 = std::max(cell(visible_.y, ground_.height()), 0);
    const int y1 = cell(visible_.bottom(), ground_.height());
    for (int y = y0; y <= std::min(y1, ground_.height() - 1); ++y) {
      for (int x = x0; x <= std::min(x1, ground_.width() - 1); ++x) draw_cell({x, y});
    }
  }

 private:
  void draw_cell(Cell cell) {
    if (ground_.is_detailed(cell)) {
      for (const Piece<double>& piece : ground_.pieces_in(cell)) draw_piece(piece);
    } else if (ground_.is_solid(cell)) {
      draw_side(cell, {0, -1}, Facing::up);
      draw_side(cell, {0, 1}, Facing::down);
      draw_side(cell, {-1, 0}, Facing::left);
      draw_side(cell, {1, 0}, Facing::right);
    }
  }

  // A side of a full tile, unless another one is beyond it.
  void draw_side(Cell cell, Cell towards, Facing facing) {
    if (ground_.is_solid({cell.x + towards.x, cell.y + towards.y})) return;
    const double x = cell.x * kTileSide, y = cell.y * kTileSide;
    const double right = facing == Facing::right ? kTileSide : 0,
                 low = facing == Facing::down ? kTileSide : 0;
    const bool is_wall = facing == Facing::left || facing == Facing::right;
    const Vec2 from{x + right, y + low};
    const Vec2 to = is_wall ? Vec2{from.x, y + kTileSide} : Vec2{x + kTileSide, from.y};
    line(from, to);
    normal((from + to) * 0.5, normal_of(facing));
  }

  // A piece in several cells is drawn once.
  void draw_piece(const Piece<double>& piece) {
    const auto key =
        std::make_tuple(piece.origin, piece.stretch, piece.facing, piece.x0, piece.y0, piece.x1, piece.y1);
    if (!drawn_.insert(key).second) return;
    const VisiblePiece shown(piece, ground_.stretches(), visible_);
    shown.each_line([this](Vec2 from, Vec2 to) { line(from, to); });
    shown.each_normal([&](Vec2 at, Vec2 n) {
      normal(at, n);
      if (piece.one_way && overlays_.has(OverlayId::one_way))
        add({OverlayId::one_way, at - n * kPassLength, at + n * kPassLength, true});
    });
  }

  void line(Vec2 from, Vec2 to) {
    if (overlays_.has(OverlayId::outline)) add({OverlayId::outline, from, to});
  }
  void normal(Vec2 at, Vec2 n) {
    if (overlays_.has(OverlayId::outline))
      add({.overlay = OverlayId::outline, .from = at, .to = at + n * kOutwardLength, .detail = true});
  }
  void add(const OverlayLine& l) {
    if (meets(l.from, l.to, visible_)) out_.lines.push_back(l);
  }

  const Terrain& ground_;
  const OverlaySet overlays_;
  const Rect& visible_;
  OverlayDrawing& out_;
  std::set<std::tuple<std::int32_t, std::uint32_t, Facing, double, double, double, double>> drawn_;
};

}  // namespace

void add_outline(const Terrain& ground, OverlaySet overlays, Rect visible, OverlayDrawing& drawing) {
  OutlineDrawer(ground, overlays, visible, drawing).draw();
}

std::vector<CurveLine> curve_lines(const Level& level, Rect visible) {
  std::vector<Curve> curves;
  for (const LevelCurve& c : level.curves) {
    if (problem_of(c.curve)) continue;
    curves.push_back(c.curve);
    curves.back().faces = Curve::Faces::up;  // one that faces both ways is two pieces in one place
  }
  const CurveOutline outline = cut_curves(curves);
  std::vector<CurveLine> lines;
  for (const Piece<double>& piece : outline.pieces) {
    VisiblePiece(piece, outline.stretches, visible).each_line([&](Vec2 from, Vec2 to) {
      if (meets(from, to, visible)) lines.push_back({from, to});
    });
  }
  return lines;
}

}  // namespace talus
