// Splits the line of a shape into its straight parts, each a box or two.
#include "bump_boxes.h"

#include <algorithm>

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

}  // namespace

std::vector<BumpBox> bump_boxes(const TileShape& shape, TileSize tile) {
  if (shape.kind == TileShape::Kind::none) return {};
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
