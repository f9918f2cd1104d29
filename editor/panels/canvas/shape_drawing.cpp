// Tints and lines of shapes.
#include "shape_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <talus/collision/shape_forms.h>
#include <talus/level/ground.h>
#include <talus/level/tile_turns.h>
#include "tile_drawing.h"

namespace talus {
namespace {

constexpr float kLeastCell = 4;      // px of the screen: smaller ones are left out
constexpr float kOutlinedCell = 24;  // px of the screen: from this size on lines have room for a dark rim
constexpr int kTint = 64;            // of 255

// How far polygons reach from their own cell, in cells.
double reach_of_parts(const TileShape& shape, TileSize tile) {
  double reach = 0;
  for (const Vec2 point : shape.points)
    reach = std::max({reach, std::abs(point.x) / tile.width, std::abs(point.y) / tile.height});
  for (const TileShape& part : shape.parts) {
    reach = std::max({reach, static_cast<double>(part.tiles), reach_of_parts(part, tile)});
    for (const double height : part.heights) reach = std::max(reach, height / tile.height);
  }
  return reach;
}

// How far the shapes reach from their own cells, in cells.
int reach_of(const std::vector<TileShape>& shapes, TileSize tile) {
  double reach = 1;
  for (const TileShape& shape : shapes) {
    reach = std::max(reach, static_cast<double>(shape.tiles));
    for (const double height : shape.heights) reach = std::max(reach, height / tile.height);
    reach = std::max(reach, reach_of_parts(shape, tile));
  }
  return static_cast<int>(reach) + 1;
}

// A polygon is filled part by part, as it need not be convex.
void draw_polygon(ImDrawList& list, const TileShape& shape, ImVec2 corner, ImVec2 zoom, ImU32 bright,
                  ImU32 tint, float width, bool is_outlined) {
  const auto on_screen = [&](double x, double y) {
    return ImVec2{corner.x + static_cast<float>(x) * zoom.x, corner.y + static_cast<float>(y) * zoom.y};
  };
  if (!shape.one_way) {
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // smooth edges would show where parts meet
    for (const auto& part : trapezoids_of(shape))
      list.AddQuadFilled(on_screen(part.left, part.top_left), on_screen(part.right, part.top_right),
                         on_screen(part.right, part.bottom_right), on_screen(part.left, part.bottom_left),
                         tint);
    list.Flags = flags;
  }
  std::vector<ImVec2> points;
  for (const Vec2 point : shape.points) points.push_back(on_screen(point.x, point.y));
  const int count = static_cast<int>(points.size());
  if (is_outlined)
    list.AddPolyline(points.data(), count, theme::color(theme::kDark, 160), ImDrawFlags_Closed, width + 2);
  list.AddPolyline(points.data(), count, bright, ImDrawFlags_Closed, width);
}

// The way that the surface of a conveyor goes above its floor.
void draw_way(ImDrawList& list, bool to_the_right, ImVec2 corner, ImVec2 cell, ImU32 bright, float width) {
  const float way = to_the_right ? cell.x : -cell.x, head = cell.x / 6;
  const ImVec2 middle{corner.x + cell.x / 2, corner.y + cell.y / 2}, tip{middle.x + way * 0.3f, middle.y};
  const float back = to_the_right ? tip.x - head : tip.x + head;
  list.AddLine({middle.x - way * 0.3f, middle.y}, tip, bright, width);
  list.AddLine({back, tip.y - head}, tip, bright, width);
  list.AddLine({back, tip.y + head}, tip, bright, width);
}

}  // namespace

void fill_to_base(ImDrawList& list, const std::vector<ImVec2>& line, float base, ImU32 color) {
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // smooth edges would show where parts meet
  for (std::size_t i = 1; i < line.size(); ++i)
    list.AddQuadFilled(line[i - 1], line[i], {line[i].x, base}, {line[i - 1].x, base}, color);
  list.Flags = flags;
}

void draw_tile_shape(ImDrawList& list, const TileShape& shape, TileSize tile, ImVec2 corner, ImVec2 cell,
                     std::uint32_t color, const Ui& ui) {
  if (shape.kind == TileShape::Kind::none) return;
  const ImU32 bright = theme::color(color), tint = theme::color(color, kTint);
  const bool is_outlined = std::min(cell.x, cell.y) >= kOutlinedCell;
  const float width = is_outlined ? ui.px(2) : ui.px(1);
  if (shape.conveyor != 0) draw_way(list, shape.conveyor > 0, corner, cell, bright, width);
  const bool hangs = shape.side == TileShape::Side::ceiling;
  const float foot = corner.y + cell.y, right = corner.x + cell.x;
  const float base = hangs ? corner.y : foot;
  if (shape.kind == TileShape::Kind::solid) {
    if (shape.one_way)
      list.AddLine({corner.x, hangs ? foot : corner.y}, {right, hangs ? foot : corner.y}, bright, width);
    else
      list.AddRectFilled(corner, {right, foot}, tint);
    return;
  }
  for (const TileShape& part : shape.parts) draw_tile_shape(list, part, tile, corner, cell, color, ui);
  if (shape.kind == TileShape::Kind::polygon) {
    const ImVec2 zoom{cell.x / static_cast<float>(tile.width), cell.y / static_cast<float>(tile.height)};
    draw_polygon(list, shape, corner, zoom, bright, tint, width, is_outlined);
  }
  if (!has_heights(shape)) return;
  std::vector<ImVec2> points;
  points.reserve(shape.heights.size());
  const float step = cell.x * static_cast<float>(shape.tiles) / static_cast<float>(shape.heights.size() - 1);
  for (std::size_t i = 0; i < shape.heights.size(); ++i) {
    const float height = static_cast<float>(shape.heights[i]) * cell.y / static_cast<float>(tile.height);
    points.push_back({corner.x + static_cast<float>(i) * step, hangs ? base + height : base - height});
  }
  if (!shape.one_way) fill_to_base(list, points, base, tint);
  const int count = static_cast<int>(points.size());
  if (is_outlined)
    list.AddPolyline(points.data(), count, theme::color(theme::kDark, 160), ImDrawFlags_None, width + 2);
  list.AddPolyline(points.data(), count, bright, ImDrawFlags_None, width);
}

namespace {

// Draws the shapes of cells of a level, in all of its layers that are ground.
class CellShapes {
 public:
  CellShapes(ImDrawList& list, const Level& level, const CanvasView& view, std::uint32_t color, const Ui& ui)
      : list_(list), level_(level), view_(view), color_(color), ui_(ui), layers_(ground_layers(level)) {}

  const std::vector<TileShape>& shapes() const { return shapes_; }
  bool are_too_small() const { return std::min(size_.x, size_.y) < kLeastCell; }

  void draw(Cell at) {
    const auto index = static_cast<std::size_t>(at.y) * level_.map.width() + at.x;
    for (auto layer = layers_.begin(); layer != layers_.end(); ++layer) {
      const MapCell content = (**layer)[index];
      const auto is_it = [&](LayerCells behind) { return (*behind)[index] == content; };
      const TileShape& its = shapes_[content.tile];
      if (its.kind == TileShape::Kind::none || std::any_of(layers_.begin(), layer, is_it)) continue;
      const TileShape& shown =
          content.turn == TileTurn::none
              ? its
              : turned_.try_emplace(content, turned(its, content.turn, tile_)).first->second;
      draw_tile_shape(list_, shown, tile_, view_.corner_of(at), size_, color_, ui_);
    }
  }

 private:
  ImDrawList& list_;
  const Level& level_;
  const CanvasView& view_;
  std::uint32_t color_;
  const Ui& ui_;
  TileSize tile_ = level_.map.tile_size();
  ImVec2 size_{view_.zoom * static_cast<float>(tile_.width), view_.zoom* static_cast<float>(tile_.height)};
  std::vector<TileShape> shapes_ = usable_shapes(level_);
  std::vector<LayerCells> layers_;
  std::map<MapCell, TileShape> turned_;
};

}  // namespace

void draw_shapes(ImDrawList& list, const Level& level, const CanvasView& view, std::uint32_t color,
                 const Ui& ui) {
  CellShapes cells(list, level, view, color, ui);
  if (cells.are_too_small()) return;
  const TileMap& map = level.map;
  const int reach = reach_of(cells.shapes(), map.tile_size());
  const Cell first = view.to_cell(view.min), last = view.to_cell(view.max);
  for (Cell at{0, std::max(0, first.y - reach)}; at.y <= std::min(map.height() - 1, last.y + reach); ++at.y) {
    for (at.x = std::max(0, first.x - reach); at.x <= std::min(map.width() - 1, last.x + reach); ++at.x)
      cells.draw(at);
  }
}

void draw_shapes_of(std::span<const Cell> cells, ImDrawList& list, const Level& level, const CanvasView& view,
                    std::uint32_t color, const Ui& ui) {
  CellShapes shapes(list, level, view, color, ui);
  for (const Cell cell : cells) shapes.draw(cell);
}

void draw_sheet_shapes(ImDrawList& list, const Level& level, ImVec2 corner, float cell, std::uint32_t color,
                       const Ui& ui) {
  const std::vector<TileShape> shapes = usable_shapes(level);
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  list.PushClipRect(corner,
                    {corner.x + static_cast<float>(sheet.columns) * cell,
                     corner.y + static_cast<float>(sheet.rows()) * cell},
                    true);
  for (int tile = 0; tile < sheet.count; ++tile) {
    const Cell place = sheet.place_of(tile);
    const ImVec2 at{corner.x + static_cast<float>(place.x) * cell,
                    corner.y + static_cast<float>(place.y) * cell};
    const bool is_visible = at.y + cell >= list.GetClipRectMin().y && at.y <= list.GetClipRectMax().y;
    if (!is_visible) continue;
    draw_tile_shape(list, shapes[static_cast<std::size_t>(tile)], level.map.tile_size(), at, {cell, cell},
                    color, ui);
  }
  list.PopClipRect();
}

}  // namespace talus
