// Splits the line of a shape into its straight parts, each a box or two.
#include "bump_boxes.h"

#include <algorithm>

#include <talus/collision/shape_forms.h>

namespace talus {
namespace {

// Puts boxes between two heights over the cell's bottom or, for a ceiling, under its top.
class BoxMaker {
 public:
  BoxMaker(const TileShape& shape, TileSize tile)
      : tile_height_(tile.height),
        is_ceiling_(shape.kind != TileShape::Kind::solid && shape.side == TileShape::Side::ceiling),
        one_way_(shape.one_way) {}

  // The straight part of the ground's line over x .. x + w. A part of a longer line becomes one box down to
  // the base: a seam in it could become a step by rounding. A single straight line becomes a slope on a full
  // box.
  void add_part(double x, double w, double h0, double h1, bool is_alone) {
    const auto [low, high] = std::minmax(h0, h1);
    if (one_way_) return add(x, w, low - 1, high, {{h0, h1}});  // the box of a level line needs a height
    add(x, w, is_alone ? low : 0, high, {{h0, h1}});
    if (is_alone) add(x, w, 0, low, {});
  }
  std::vector<BumpBox> take() { return std::move(boxes_); }

 private:
  struct Heights {
    double h0, h1;
  };
  void add(double x, double w, double from, double to, std::optional<Heights> line) {
    BumpBox made{{x, is_ceiling_ ? from : tile_height_ - to, w, to - from}, {}};
    if (line) made.line = {line->h0 - from, line->h1 - from, is_ceiling_, one_way_};
    if (made.box.w > 0 && made.box.h > 0) boxes_.push_back(made);
  }

  double tile_height_;  // px
  bool is_ceiling_, one_way_;
  std::vector<BumpBox> boxes_;
};

// Whether a level line separates its top from its bottom.
bool is_separable(const Trapezoid& part) {
  return std::max(part.top_left, part.top_right) <= std::min(part.bottom_left, part.bottom_right);
}

BumpBox floor_of(const Trapezoid& part, double base, bool one_way) {
  const double top = std::min(part.top_left, part.top_right);
  return {{part.left, top, part.right - part.left, base - top},
          BumpLine{base - part.top_left, base - part.top_right, false, one_way}};
}
BumpBox ceiling_of(const Trapezoid& part, double base, bool one_way) {
  const double bottom = std::max(part.bottom_left, part.bottom_right);
  return {{part.left, base, part.right - part.left, bottom - base},
          BumpLine{part.bottom_left - base, part.bottom_right - base, true, one_way}};
}

// The slope on its top, the full part, and the slope under it; of a one-way polygon one of its lines.
void add_part(const TileShape& polygon, const Trapezoid& part, std::vector<BumpBox>& boxes) {
  const double low = std::max(part.top_left, part.top_right);
  const double high = std::min(part.bottom_left, part.bottom_right);
  if (polygon.one_way) {  // the box of a level line needs a height
    const bool is_floor = polygon.side == TileShape::Side::floor;
    boxes.push_back(is_floor ? floor_of(part, low + 1, true) : ceiling_of(part, high - 1, true));
    return;
  }
  if (!is_separable(part)) return;
  if (part.top_left != part.top_right) boxes.push_back(floor_of(part, low, false));
  if (low < high) boxes.push_back({{part.left, low, part.right - part.left, high - low}, {}});
  if (part.bottom_left != part.bottom_right) boxes.push_back(ceiling_of(part, high, false));
}

std::vector<BumpBox> boxes_of_parts(const TileShape& shape, TileSize tile) {
  std::vector<BumpBox> boxes;
  for (const TileShape& part : shape.parts) {
    const std::vector<BumpBox> more = bump_boxes(part, tile);
    boxes.insert(boxes.end(), more.begin(), more.end());
  }
  if (shape.kind != TileShape::Kind::polygon) return boxes;
  for (const Trapezoid& part : trapezoids_of(shape)) add_part(shape, part, boxes);
  return boxes;
}

}  // namespace

bool bump_takes_all_of(const TileShape& shape) {
  if (shape.kind == TileShape::Kind::group)
    return std::all_of(shape.parts.begin(), shape.parts.end(), bump_takes_all_of);
  if (shape.kind != TileShape::Kind::polygon || shape.one_way) return true;
  const std::vector<Trapezoid> parts = trapezoids_of(shape);
  return std::all_of(parts.begin(), parts.end(), is_separable);
}

bool article_takes_all_of(const TileShape& shape, TileSize tile) {
  const std::vector<BumpBox> boxes = bump_boxes(shape, tile);
  return bump_takes_all_of(shape) && std::none_of(boxes.begin(), boxes.end(), [](const BumpBox& box) {
           return box.line && (box.line->is_ceiling || box.line->one_way);
         });
}

std::vector<BumpBox> bump_boxes(const TileShape& shape, TileSize tile) {
  if (shape.kind == TileShape::Kind::none) return {};
  if (has_parts(shape)) return boxes_of_parts(shape, tile);
  const bool is_solid = shape.kind == TileShape::Kind::solid;
  const double full = tile.height;
  const std::vector<double> heights = is_solid ? std::vector<double>{full, full} : shape.heights;
  const double width = shape.tiles * tile.width;
  const std::size_t last = heights.size() - 1;
  const auto count = static_cast<double>(last);
  BoxMaker boxes(shape, tile);
  std::size_t from = 0;
  for (std::size_t i = 1; i <= last; ++i) {
    const bool goes_on = i < last && heights[i + 1] - heights[i] == heights[i] - heights[i - 1];
    if (goes_on) continue;
    boxes.add_part(width * static_cast<double>(from) / count, width * static_cast<double>(i - from) / count,
                   heights[from], heights[i], last == 1);
    from = i;
  }
  return boxes.take();
}

}  // namespace talus
