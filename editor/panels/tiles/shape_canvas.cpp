// Changes heights with the mouse.
#include "shape_canvas.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "debug/number_text.h"
#include "edit/tile_shapes.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/canvas/shape_drawing.h"

namespace talus {
namespace {

constexpr float kMargin = 8, kHandle = 4, kReach = 9;  // px at scale 1
constexpr float kMostZoom = 24;                        // px for each px of a tile, at scale 1
constexpr float kLeastTile = 32;                       // px at scale 1, the height of a tile

bool has_line(const TileShape& shape) { return has_heights(shape); }

// Rounds a length of the mouse to whole px, with Alt to halves.
double rounded(double px) {
  const double grain = ImGui::GetIO().KeyAlt ? 2 : 1;
  return std::round(px * grain) / grain;
}

}  // namespace

// The place of the tiles on the screen in this frame.
struct ShapeCanvas::Frame {
  const Session& session;
  CellRect tiles;   // of the sheet
  TileSize size;    // px, of a tile
  TileShape shape;  // changed by the drag
  ImVec2 at;        // px of the screen, the tiles' top-left corner
  float zoom = 1;
  float reach = 1;          // px of the screen, from a handle to the mouse
  std::uint32_t color = 0;  // 0xRRGGBB, the overlay's
  bool changed = false;

  float width() const { return static_cast<float>(tiles.w * size.width) * zoom; }
  float height() const { return static_cast<float>(tiles.h * size.height) * zoom; }
  bool hangs() const { return shape.side == TileShape::Side::ceiling; }
  // A height of the line, by its index.
  ImVec2 point(std::size_t i) const {
    const float part = static_cast<float>(i) / static_cast<float>(shape.heights.size() - 1);
    const float y = static_cast<float>(shape.heights[i]) * zoom;
    return {at.x + part * width(), hangs() ? at.y + y : at.y + height() - y};
  }
  double highest() const { return tiles.h * size.height; }  // px, the largest height that a drag can make
  double height_at(float y) const { return (hangs() ? y - at.y : at.y + height() - y) / zoom; }  // px
  double rise(float from_y, float to_y) const { return height_at(to_y) - height_at(from_y); }    // px
  int nearest_by_x(float x) const {
    const float last = static_cast<float>(shape.heights.size() - 1);
    return static_cast<int>(std::clamp(std::round((x - at.x) / width() * last), 0.0f, last));
  }
  void set_height(std::size_t i, double wanted) {
    wanted = std::clamp(wanted, 0.0, highest());
    changed = changed || wanted != shape.heights[i];
    shape.heights[i] = wanted;
  }
};

std::optional<TileShape> ShapeCanvas::draw(const Session& session, Actions& actions, int tile,
                                           const TileShape& shape, ImVec2 room, Ui& ui) {
  const TileSize size = session.level().map.tile_size();
  CellRect tiles = tiles_of_shape(session.level(), tile, shape);
  if (grip_ != Grip::none && tiles.h != rows_) {  // keeps the number of rows from when the drag began
    if (shape.side == TileShape::Side::floor) tiles.y += tiles.h - rows_;
    tiles.h = rows_;
  }
  rows_ = tiles.h;
  const float margin = ui.px(kMargin);
  const auto columns = static_cast<float>(tiles.w * size.width),
             rows = static_cast<float>(tiles.h * size.height);
  const float least = ui.px(kLeastTile) / static_cast<float>(size.height);  // of shapes higher than the room
  const float fits_high = std::max((room.y - 2 * margin) / rows, least);
  const float fits = std::min((room.x - 2 * margin) / columns, fits_high);
  Frame frame{session, tiles, size, shape, {}, 1, ui.px(kReach)};
  frame.color = overlay_color(overlay::shapes, session.choices().overlay_palette);
  frame.zoom = fits < 1 ? fits : std::min(std::floor(fits), kMostZoom * ui.scale);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("shape canvas", {room.x, frame.height() + 2 * margin});
  frame.at = {std::floor(corner.x + (room.x - frame.width()) / 2), std::floor(corner.y + margin)};
  ui.item("shape/canvas");  // its help would cover it
  if (has_line(shape)) drag(frame, actions);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const SheetLayout& sheet = ui.layout(SheetId::tiles);
  for (int y = 0; y < tiles.h; ++y) {
    for (int x = 0; x < tiles.w; ++x) {
      if (!sheet.contains({tiles.x + x, tiles.y + y})) continue;
      const UvRect uv = ui.uv_of(SheetId::tiles, {tiles.x + x, tiles.y + y, 1, 1});
      const float w = static_cast<float>(size.width) * frame.zoom;
      const float h = static_cast<float>(size.height) * frame.zoom;
      const ImVec2 from{frame.at.x + static_cast<float>(x) * w, frame.at.y + static_cast<float>(y) * h};
      const ImVec2 to{from.x + w, from.y + h};
      list.AddImage(ui.sheet(SheetId::tiles), from, to, uv.from, uv.to);
      list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kLine));
    }
  }
  draw_line(frame, ui);
  if (has_line(shape)) follow_cursor(frame, ui);
  if (!frame.changed) return std::nullopt;
  return frame.shape;
}

void ShapeCanvas::follow_cursor(const Frame& frame, Ui& ui) const {
  const CanvasView view{frame.at,
                        {frame.at.x + frame.width(), frame.at.y + frame.height()},
                        {frame.at.x, frame.at.y},
                        frame.zoom};
  const CellRect room{0, 0, frame.tiles.w * frame.size.width, frame.tiles.h * frame.size.height};
  ui.view.canvas.cursor.visit("shape", view, {room, {1, 1}, true}, ImGui::GetIO().MousePos);
  ui.view.canvas.cursor.draw("shape", *ImGui::GetWindowDrawList(), view, ui.scale);
}

void ShapeCanvas::take_hold(const Frame& frame, ImVec2 mouse) {
  stroke_ = frame.session.next_stroke();
  held_ = frame.nearest_by_x(mouse.x);
  from_y_ = mouse.y;
  from_ = frame.shape.heights;
  const ImVec2 point = frame.point(static_cast<std::size_t>(held_));
  if (std::hypot(point.x - mouse.x, point.y - mouse.y) <= frame.reach)
    grip_ = Grip::handle;
  else
    grip_ = frame.shape.kind == TileShape::Kind::profile ? Grip::free : Grip::line;
}

void ShapeCanvas::drag(Frame& frame, Actions& actions) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(0)) take_hold(frame, mouse);  // not by the Space key
  if (grip_ != Grip::none && is_drag_cancelled()) {
    take_back(frame.session, actions, stroke_);
    grip_ = Grip::none;
  }
  if (!ImGui::IsItemActive()) grip_ = Grip::none;
  if (grip_ == Grip::none || from_.size() != frame.shape.heights.size()) return;
  if (grip_ == Grip::free)
    draw_freely(frame, mouse);
  else
    move_held(frame, mouse.y);
}

// A handle, or the whole line, which keeps its rise.
void ShapeCanvas::move_held(Frame& frame, float y) const {
  const double by = frame.rise(from_y_, y);
  if (grip_ == Grip::handle) {
    const auto held = static_cast<std::size_t>(held_);
    return frame.set_height(held, by == 0 ? from_[held] : rounded(from_[held] + by));
  }
  const auto [least, most] = std::minmax_element(from_.begin(), from_.end());
  const double kept = std::clamp(rounded(by), -*least, std::max(-*least, frame.highest() - *most));
  for (std::size_t i = 0; i < from_.size(); ++i) frame.set_height(i, from_[i] + kept);
}

// Draws from the height at the mouse's last place to that at the new one, so that a fast drag leaves no gaps.
void ShapeCanvas::draw_freely(Frame& frame, ImVec2 mouse) {
  const double height = rounded(frame.height_at(mouse.y));
  const int to = frame.nearest_by_x(mouse.x), step = to < held_ ? -1 : 1;
  for (int i = held_; i != to; i += step) frame.set_height(static_cast<std::size_t>(i), height);
  frame.set_height(static_cast<std::size_t>(to), height);
  held_ = to;
}

void ShapeCanvas::draw_line(const Frame& frame, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{frame.at.x + frame.width(), frame.at.y + frame.height()};
  const ImU32 tint = theme::color(frame.color, 70);
  if (frame.shape.kind == TileShape::Kind::solid) return list.AddRectFilled(frame.at, end, tint);
  if (has_parts(frame.shape)) {
    const ImVec2 cell{frame.zoom * static_cast<float>(frame.size.width),
                      frame.zoom * static_cast<float>(frame.size.height)};
    draw_tile_shape(list, frame.shape, frame.size, frame.at, cell, frame.color, ui);
  }
  if (!has_line(frame.shape)) return;
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < frame.shape.heights.size(); ++i) points.push_back(frame.point(i));
  const float base = frame.hangs() ? frame.at.y : end.y;
  if (!frame.shape.one_way) fill_to_base(list, points, base, tint);
  const int count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, theme::color(theme::kDark, 200), ImDrawFlags_None, ui.px(2) + 2);
  list.AddPolyline(points.data(), count, theme::color(frame.color), ImDrawFlags_None, ui.px(2));
  draw_handles(frame, points, ui);
}

void ShapeCanvas::draw_handles(const Frame& frame, const std::vector<ImVec2>& points, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int pointed = ImGui::IsItemHovered() ? frame.nearest_by_x(ImGui::GetIO().MousePos.x) : -1;
  const int lit = grip_ == Grip::none ? pointed : held_, count = static_cast<int>(points.size());
  const float side = std::min(ui.px(kHandle), std::max(2.0f, frame.width() / static_cast<float>(3 * count)));
  for (int i = 0; i < count; ++i) {
    const ImVec2 p = points[static_cast<std::size_t>(i)];
    list.AddRectFilled({p.x - side - 1, p.y - side - 1}, {p.x + side + 1, p.y + side + 1},
                       theme::color(theme::kDark));
    list.AddRectFilled({p.x - side, p.y - side}, {p.x + side, p.y + side},
                       theme::color(i == lit ? theme::kWarning : theme::kText));
    ui.place("shape/handle" + std::to_string(i), {p.x - side, p.y - side}, {p.x + side, p.y + side});
  }
  if (lit < 0 || lit >= count) return;
  const ImVec2 p = points[static_cast<std::size_t>(lit)];
  const std::string text = exact_text(frame.shape.heights[static_cast<std::size_t>(lit)]) + " px";
  const ImVec2 size = size_of_text(text);
  const float right = frame.at.x + frame.width();
  const ImVec2 at{std::clamp(p.x - size.x / 2, frame.at.x, std::max(frame.at.x, right - size.x)),
                  p.y - size.y - 2 * side < frame.at.y ? p.y + 2 * side : p.y - size.y - 2 * side};
  list.AddRectFilled({at.x - 2, at.y}, {at.x + size.x + 2, at.y + size.y}, theme::color(theme::kDark, 205));
  add_text(list, at, theme::color(theme::kText), text);
}

}  // namespace talus
