#include "outline.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "collision/outline_compiler.h"
#include "overlay_pen.h"

namespace talus {
namespace {

constexpr double kOutwardLength = 3;  // px
constexpr double kPassLength = 5;     // px on either side of a one-way side, of its arrow
constexpr double kNormalGap = 16;     // the largest distance between two normals of a piece, px
constexpr double kMaxLines = 1024;    // for a curve that crosses the whole view

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

// A piece where it is visible: the range of x, and its points.
class VisiblePiece {
 public:
  VisiblePiece(const Piece<double>& piece, std::span<const CurveStretch<double>> stretches,
               const Rect& visible)
      : piece_(piece),
        stretches_(stretches),
        from_(std::max(piece.x0, visible.x)),
        to_(std::min(piece.x1, visible.right())),
        step_(std::max(1.0, visible.w / kMaxLines)) {}

  // Calls fn(from, to) for each of its lines.
  template <class Fn>
  void each_line(Fn fn) const {
    if (from_ > to_) return;
    if (piece_.is_wall()) return fn(Vec2{piece_.x0, piece_.y0}, Vec2{piece_.x1, piece_.y1});
    const int count = piece_.stretch == 0 ? 1 : parts(step_);
    for (int i = 0; i < count; ++i) fn(point(i, count), point(i + 1, count));
  }
  // Calls fn(point, normal) at equal distances.
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
  // The number of parts into which this length (px) is cut.
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

// Calls fn(cell) for the visible cells of the ground.
template <class Fn>
void each_visible_cell(const Terrain& ground, const Rect& visible, Fn fn) {
  const auto cell = [](double px, int side, int count) {
    return std::clamp(static_cast<int>(std::floor(px / side)), -1, count);
  };
  const auto column = [&](double x) { return cell(x, ground.tile_size().width, ground.width()); };
  const auto row = [&](double y) { return cell(y, ground.tile_size().height, ground.height()); };
  const int x0 = std::max(column(visible.x), 0), x1 = column(visible.right());
  const int y0 = std::max(row(visible.y), 0), y1 = row(visible.bottom());
  for (int y = y0; y <= std::min(y1, ground.height() - 1); ++y) {
    for (int x = x0; x <= std::min(x1, ground.width() - 1); ++x) fn(Cell{x, y});
  }
}

// Finds the pieces that were not met before, as a piece may be in several cells. A cell may have thousands of
// curves, so it finds no more once too much is drawn.
class NewPieces {
 public:
  explicit NewPieces(OverlayDrawing& drawing) : drawing_(drawing) {}

  bool has(const Piece<double>& piece) {
    if (drawing_.lines.size() >= kMaxDrawnLines || ++looked_at_ > kMaxDrawnLines) {
      drawing_.is_cut = true;
      return false;
    }
    return met_.insert({piece.origin, piece.stretch, piece.facing, piece.x0, piece.y0, piece.x1, piece.y1})
        .second;
  }

 private:
  OverlayDrawing& drawing_;
  std::size_t looked_at_ = 0;  // pieces
  std::set<std::tuple<std::int32_t, std::uint32_t, Facing, double, double, double, double>> met_;
};

class OutlineDrawer {
 public:
  OutlineDrawer(const Terrain& ground, const Rect& visible, OverlayDrawing& out)
      : ground_(ground), pen_(overlay::outline, visible, out), new_pieces_(out) {}

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

 private:
  // Draws a side of a full tile, unless another full tile is beyond it.
  void draw_side(Cell cell, Cell towards, Facing facing) {
    if (ground_.is_solid({cell.x + towards.x, cell.y + towards.y})) return;
    const bool is_wall = facing == Facing::left || facing == Facing::right;
    const Vec2 from{ground_.x_of(cell.x + (facing == Facing::right ? 1 : 0)),
                    ground_.y_of(cell.y + (facing == Facing::down ? 1 : 0))};
    const Vec2 to = is_wall ? Vec2{from.x, ground_.y_of(cell.y + 1)} : Vec2{ground_.x_of(cell.x + 1), from.y};
    pen_.line(from, to);
    draw_normal((from + to) * 0.5, normal_of(facing));
  }

  void draw_piece(const Piece<double>& piece) {
    if (!new_pieces_.has(piece)) return;
    const VisiblePiece shown(piece, ground_.stretches(), pen_.visible());
    shown.each_line([this](Vec2 from, Vec2 to) { pen_.line(from, to); });
    shown.each_normal([this](Vec2 at, Vec2 n) { draw_normal(at, n); });
  }

  void draw_normal(Vec2 at, Vec2 n) { pen_.line(at, at + n * kOutwardLength, false, 1, true); }

  const Terrain& ground_;
  OverlayPen pen_;
  NewPieces new_pieces_;
};

}  // namespace

void add_outline(const Terrain& ground, Rect visible, OverlayDrawing& drawing) {
  OutlineDrawer drawer(ground, visible, drawing);
  each_visible_cell(ground, visible, [&](Cell cell) { drawer.draw_cell(cell); });
}

void add_one_way_arrows(const Terrain& ground, Rect visible, OverlayDrawing& drawing) {
  OverlayPen pen(overlay::one_way, visible, drawing);
  NewPieces new_pieces(drawing);
  each_visible_cell(ground, visible, [&](Cell cell) {
    if (!ground.is_detailed(cell)) return;
    for (const Piece<double>& piece : ground.pieces_in(cell)) {
      if (!piece.one_way || !new_pieces.has(piece)) continue;
      VisiblePiece(piece, ground.stretches(), visible).each_normal([&](Vec2 at, Vec2 n) {
        pen.line(at - n * kPassLength, at + n * kPassLength, true);
      });
    }
  });
}

namespace {

// Arrows along the surfaces of conveyors, which go on with the frames.
class ConveyorDrawer {
 public:
  ConveyorDrawer(const Terrain& ground, std::int64_t frame, OverlayPen& pen)
      : ground_(ground), frame_(frame), pen_(pen), new_pieces_(pen.drawing()) {}

  void draw_cell(Cell cell) {
    if (ground_.is_detailed(cell)) {
      for (const Piece<double>& piece : ground_.pieces_in(cell)) draw_piece(piece);
    } else if (const double speed = ground_.shape_at(cell).conveyor; speed != 0 && ground_.is_solid(cell)) {
      const Vec2 half{ground_.tile_size().width / 2.0, ground_.tile_size().height / 2.0};
      const Vec2 middle = Vec2{ground_.x_of(cell.x), ground_.y_of(cell.y)} + half;
      for (const Facing facing : {Facing::up, Facing::down, Facing::left, Facing::right}) {
        const Vec2 n = normal_of(facing);
        const Cell beyond{cell.x + static_cast<int>(n.x), cell.y + static_cast<int>(n.y)};
        if (!ground_.is_solid(beyond))
          draw_arrow(middle + Vec2{n.x * half.x, n.y * half.y} - n * kInside, n, speed);
      }
    }
  }

 private:
  static constexpr double kInside = 1.5, kOutside = 2;  // px, of the arrows from the surface

  void draw_piece(const Piece<double>& piece) {
    const double speed = ground_.conveyor_of(piece.origin);
    if (speed == 0 || !new_pieces_.has(piece)) return;
    // A curve is thin, and may face both ways: its arrows lie on the side that they belong to.
    const double inside = piece.origin < 0 ? -kOutside : kInside;
    VisiblePiece(piece, ground_.stretches(), pen_.visible()).each_normal([&](Vec2 at, Vec2 n) {
      draw_arrow(at - n * inside, n, speed);
    });
  }

  void draw_arrow(Vec2 at, Vec2 n, double speed) {
    constexpr double kGap = 8, kLength = 5;  // px
    const double gone = std::fmod(speed * static_cast<double>(frame_), kGap);
    const double shift = gone + (gone < -kGap / 2 ? kGap : gone > kGap / 2 ? -kGap : 0);
    const Vec2 onward = Vec2{-n.y, n.x} * (speed > 0 ? 1 : -1), middle = at + Vec2{-n.y, n.x} * shift;
    pen_.line(middle - onward * (kLength / 2), middle + onward * (kLength / 2), true);
  }

  const Terrain& ground_;
  const std::int64_t frame_;
  OverlayPen& pen_;
  NewPieces new_pieces_;
};

}  // namespace

std::vector<CurveLine> curve_lines(const Level& level, Rect visible) {
  std::vector<Curve> curves;
  for (const LevelCurve& c : level.curves) {
    if (problem_of(c.curve)) continue;
    curves.push_back(c.curve);
    curves.back().faces = Curve::Faces::up;  // a curve that faces both ways is two pieces at one place
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

namespace {

void draw_outline(const OverlaySource& source, OverlayPen& pen) {
  if (source.ground != nullptr) add_outline(*source.ground, pen.visible(), pen.drawing());
}
void draw_one_way(const OverlaySource& source, OverlayPen& pen) {
  if (source.ground != nullptr) add_one_way_arrows(*source.ground, pen.visible(), pen.drawing());
}

bool has_conveyors(const Level& level) {
  const auto is_conveyor = [](const TileShape& shape) { return shape.conveyor != 0; };
  return std::any_of(level.tile_shapes.begin(), level.tile_shapes.end(), is_conveyor) ||
         std::any_of(level.flag_shapes.begin(), level.flag_shapes.end(), is_conveyor) ||
         std::any_of(level.curves.begin(), level.curves.end(),
                     [](const LevelCurve& curve) { return curve.curve.conveyor != 0; });
}

std::string_view why_no_conveyors(const Level& level) {
  return level.tuning.solver == SolverKind::exact ? "" : "Conveyors move only with the solver exact.";
}

void draw_conveyors(const OverlaySource& source, OverlayPen& pen) {
  // Another solver than `exact` has no ground in its scene, and no conveyors.
  if (source.ground == nullptr || !source.scene.ground || !source.ground->has_conveyors()) return;
  ConveyorDrawer drawer(*source.ground, source.state.frame, pen);
  each_visible_cell(*source.ground, pen.visible(), [&](Cell cell) { drawer.draw_cell(cell); });
}

}  // namespace

namespace overlay {

const Overlay outline{
    .key = "outline",
    .label = "outline",
    .help =
        "The outline of the ground as the exact solver sees it, with short normals where it stops bodies.",
    .group = OverlayGroup::ground,
    .color = 0xb39dff,
    .safe_color = 0xaaaaff,
    .digit = '9',
    .needs_ground = true,
    .near_only = true,
    .layer = -1,
    .covers_much = true,
    .draw = draw_outline,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({0, 6.5}, {8, 3.5});
          pen.line({4, 5}, {3, 2});
        },
};

const Overlay one_way{
    .key = "one_way",
    .label = "one-way sides",
    .help =
        "Arrows through one-way floors, ceilings and lines, in the direction in which "
        "bodies may pass.",
    .group = OverlayGroup::ground,
    .color = 0x66d9c0,
    .safe_color = 0x288c8c,
    .digit = '2',
    .shift = true,
    .needs_ground = true,
    .near_only = true,
    .layer = -1,
    .covers_much = true,
    .draw = draw_one_way,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({4, 7.5}, {4, 0.5}, true);
          pen.line({0, 5}, {8, 5});
        },
};

const Overlay conveyors{
    .key = "conveyors",
    .label = "conveyors",
    .help = "Arrows along ground whose surface moves: conveyors.",
    .group = OverlayGroup::ground,
    .color = 0xc8d4e0,
    .safe_color = 0xa8b8b4,
    .digit = '0',
    .shift = true,
    .is_default = true,
    .applies = has_conveyors,
    .why_nothing = why_no_conveyors,
    .near_only = true,
    .layer = -1,
    .covers_much = true,
    .draw = draw_conveyors,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({0, 3}, {7, 3}, true);
          pen.line({0, 5}, {8, 5});
        },
};

}  // namespace overlay
}  // namespace talus
