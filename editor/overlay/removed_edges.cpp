#include "removed_edges.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "overlay_pen.h"

namespace talus {
namespace {

// A horizontal or vertical line.
struct Edge {
  bool upright;
  double at;        // its y; or its x if it is vertical; px
  double from, to;  // along the line, px
  auto line() const { return std::make_tuple(upright, at); }
  auto key() const { return std::make_tuple(upright, at, from, to); }
};

class Collector {
 public:
  Collector(const Terrain& ground, Rect visible, OverlayDrawing& out)
      : ground_(ground), visible_(visible), out_(out) {
    const auto cell = [](double px, int side, int count) {
      return static_cast<int>(std::clamp(std::floor(px / side), 0.0, static_cast<double>(count)));
    };
    const auto [tile_width, tile_height] = ground.tile_size();
    left_ = cell(visible.x, tile_width, ground.width());
    top_ = cell(visible.y, tile_height, ground.height());
    right_ = cell(visible.right() + tile_width, tile_width, ground.width());
    bottom_ = cell(visible.bottom() + tile_height, tile_height, ground.height());
  }

  void draw() {
    between_full_tiles();
    for (int y = std::max(top_ - kMaxShapeTiles, 0); y < std::min(bottom_ + kMaxShapeTiles, ground_.height());
         ++y) {
      for (int x = std::max(left_ - kMaxShapeTiles, 0); x < right_; ++x) gather({x, y});
    }
    put_uncovered();
  }

 private:
  bool is_full(int x, int y) const { return ground_.is_solid({x, y}); }

  // Draws the sides between two full tiles, joined to lines as long as possible.
  void between_full_tiles() {
    const auto runs = [&](bool upright, int lines_from, int lines_to, int first, int last) {
      for (int line = std::max(lines_from, 1); line < lines_to; ++line) {
        int start = first;
        for (int i = first; i <= last; ++i) {
          const bool shared = i < last && (upright ? is_full(line - 1, i) && is_full(line, i)
                                                   : is_full(i, line - 1) && is_full(i, line));
          if (shared) continue;
          if (i > start && upright) put({true, ground_.x_of(line), ground_.y_of(start), ground_.y_of(i)});
          if (i > start && !upright) put({false, ground_.y_of(line), ground_.x_of(start), ground_.x_of(i)});
          start = i + 1;
        }
      }
    };
    runs(true, left_, right_, top_, bottom_);
    runs(false, top_, bottom_, left_, right_);
  }

  // Collects the sides of the shape in a cell, and the part of the outline there.
  void gather(Cell c) {
    if (ground_.is_detailed(c)) {
      for (const Piece<double>& piece : ground_.pieces_in(c)) {
        if (outline_.size() == kMaxDrawnLines) {  // a cell may have thousands of curves
          out_.is_cut = true;
          break;
        }
        if (piece.is_wall()) {
          outline_.push_back({true, piece.x0, piece.y0, piece.y1});
        } else if (piece.stretch == 0 && piece.y0 == piece.y1) {
          outline_.push_back({false, piece.y0, piece.x0, piece.x1});
        }
      }
    }
    const TileShape& shape = ground_.shape_at(c);
    const double x = ground_.x_of(c.x), right = ground_.x_of(c.x + 1);
    const double y = ground_.y_of(c.y), bottom = ground_.y_of(c.y + 1);
    if (is_full(c.x, c.y)) {
      if (!ground_.is_detailed(c)) return;
      if (!is_full(c.x - 1, c.y)) sides_.push_back({true, x, y, bottom});
      if (!is_full(c.x + 1, c.y)) sides_.push_back({true, right, y, bottom});
      if (!is_full(c.x, c.y - 1)) sides_.push_back({false, y, x, right});
      if (!is_full(c.x, c.y + 1)) sides_.push_back({false, bottom, x, right});
    } else if (!shape.one_way && !shape.heights.empty()) {
      const bool floor = shape.side == TileShape::Side::floor;
      const double base = floor ? bottom : y, end = ground_.x_of(c.x + shape.tiles);
      sides_.push_back({false, base, x, end});
      for (const auto& [at, height] : {std::pair{x, shape.heights.front()}, {end, shape.heights.back()}}) {
        if (height > 0)
          sides_.push_back(
              {true, at, floor ? base - weld(height) : base, floor ? base : base + weld(height)});
      }
    }
  }

  // Draws each part of the sides that is not on the outline, once.
  void put_uncovered() {
    const auto less = [](const Edge& a, const Edge& b) { return a.key() < b.key(); };
    std::sort(sides_.begin(), sides_.end(), less);
    std::sort(outline_.begin(), outline_.end(), less);
    auto cover = outline_.begin();
    for (std::size_t i = 0; i < sides_.size();) {
      Edge side = sides_[i++];
      for (; i < sides_.size() && sides_[i].line() == side.line() && sides_[i].from <= side.to; ++i)
        side.to = std::max(side.to, sides_[i].to);
      while (cover != outline_.end() && cover->line() < side.line()) ++cover;
      double from = side.from;
      for (auto c = cover; c != outline_.end() && c->line() == side.line() && from < side.to; ++c) {
        if (c->to <= from) continue;
        if (c->from > from) put({side.upright, side.at, from, std::min(c->from, side.to)});
        from = std::max(from, c->to);
      }
      if (from < side.to) put({side.upright, side.at, from, side.to});
    }
  }

  void put(const Edge& e) {
    const Vec2 from = e.upright ? Vec2{e.at, e.from} : Vec2{e.from, e.at};
    const Vec2 to = e.upright ? Vec2{e.at, e.to} : Vec2{e.to, e.at};
    if (meets(from, to, visible_))
      out_.lines.push_back({.overlay = &overlay::removed_edges, .from = from, .to = to, .strength = 0.6});
  }

  const Terrain& ground_;
  const Rect visible_;
  OverlayDrawing& out_;
  int left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;  // cells; right and bottom are outside
  std::vector<Edge> sides_, outline_;
};

}  // namespace

void add_removed_edges(const Terrain& ground, Rect visible, OverlayDrawing& drawing) {
  Collector(ground, visible, drawing).draw();
}

namespace {

void draw_removed_edges(const OverlaySource& source, OverlayPen& pen) {
  if (source.ground != nullptr) add_removed_edges(*source.ground, pen.visible(), pen.drawing());
}

}  // namespace

namespace overlay {

const Overlay removed_edges{
    .key = "removed_edges",
    .label = "removed edges",
    .help = "Sides of tiles and slopes that are not in the merged outline, as other shapes cover them.",
    .group = OverlayGroup::ground,
    .color = 0x9aa5b1,
    .safe_color = 0x6e8c6e,
    .digit = '1',
    .shift = true,
    .needs_ground = true,
    .near_only = true,
    .layer = -2,
    .is_faint = true,
    .covers_much = true,
    .draw = draw_removed_edges,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({4, 0}, {4, 8});
          pen.line({0, 4}, {8, 4});
        },
};

}  // namespace overlay
}  // namespace talus
