// Shows a magnified shape, and changes heights with the mouse.
#include "shape_canvas.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "canvas_note.h"
#include "debug/number_text.h"
#include "overlay/visible.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/canvas/shape_drawing.h"

namespace talus {
namespace {

constexpr float kMargin = 8, kHandle = 4, kReach = 9;  // px at scale 1
constexpr float kMaxTileZoom = 24;                     // px for each px of a tile, at scale 1
constexpr float kLeastTile = 32;                       // px at scale 1, the height of a tile
constexpr float kLeastGrid = 5;                        // px at scale 1, between lines of the grid

// Rounds a length of the mouse to whole px, with Alt to halves.
double rounded(double px) {
  const double grain = ImGui::GetIO().KeyAlt ? 2 : 1;
  return std::round(px * grain) / grain;
}

// Art is magnified by whole numbers. Polygons are worth half a step.
float whole_zoom(float fits, bool halves, float most) {
  if (fits < 1) return fits;
  return std::min(halves && fits < 4 ? std::floor(2 * fits) / 2 : std::floor(fits), most);
}

int rows_of(const TileShape& line, TileSize size) {
  const double highest = *std::max_element(line.heights.begin(), line.heights.end());
  return std::max(1, static_cast<int>(std::ceil(highest / size.height)));
}

// The tiles that a slope or a profile reaches over, and the box around a polygon; px of the tile.
Rect box_of(const TileShape& shape, TileSize size) {
  Rect box{0, 0, 1.0 * size.width, 1.0 * size.height};
  if (has_heights(shape)) {
    const double more = (rows_of(shape, size) - 1.0) * size.height;
    return {0, shape.side == TileShape::Side::floor ? -more : 0, box.w * shape.tiles, box.h + more};
  }
  for (const Vec2 point : shape.points) box = joined_rect(box, {point.x, point.y, 0, 0});
  for (const TileShape& part : shape.parts) box = joined_rect(box, box_of(part, size));
  return box;
}

// A line has the room of its tiles. Polygons may go beyond theirs.
Rect region_of(const EditedShape& edited, const ShapeView& view) {
  const TileSize size = edited.size;
  Rect region = box_of(edited.whole, size);
  if (!is_open(edited)) return region;
  if (edited.is_drawing)
    region = joined_rect(region, box_of({.kind = TileShape::Kind::polygon, .points = *view.drawing}, size));
  const double margin = std::max(1.0, std::ceil(std::min(size.width, size.height) / 4.0));
  return {region.x - margin, region.y - margin, region.w + 2 * margin, region.h + 2 * margin};
}

// px; a cell of the keyboard's cursor has whole px.
TileSize cursor_step(PointSnap snap, TileSize size) {
  if (snap == PointSnap::corners) return size;
  const bool is_even = size.width % 2 == 0 && size.height % 2 == 0;
  return snap == PointSnap::halves && is_even ? TileSize{size.width / 2, size.height / 2} : TileSize{1, 1};
}

// The tiles of the sheet around the shown one; only its own is bright.
void draw_tiles(ImDrawList& list, const Rect& box, int tile, TileSize size, const CanvasView& view, bool dims,
                const Ui& ui) {
  const SheetLayout& sheet = ui.layout(SheetId::tiles);
  const Cell place = sheet.place_of(tile);
  const auto first_x = static_cast<int>(std::floor(box.x / size.width));
  const auto first_y = static_cast<int>(std::floor(box.y / size.height));
  for (int y = first_y; y * size.height < box.bottom(); ++y) {
    for (int x = first_x; x * size.width < box.right(); ++x) {
      const Cell at{place.x + x, place.y + y};
      if (!sheet.contains(at)) continue;
      const UvRect uv = ui.uv_of(SheetId::tiles, {at.x, at.y, 1, 1});
      const ImVec2 from = view.corner_of({x, y}), to = view.corner_of({x + 1, y + 1});
      const bool is_own = x == 0 && y == 0;
      list.AddImage(ui.sheet(SheetId::tiles), from, to, uv.from, uv.to,
                    IM_COL32(255, 255, 255, is_own || !dims ? 255 : 90));
      if (!dims) list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kLine));
    }
  }
}

// Lines where points snap, and brighter ones between the cells.
void draw_snap_grid(ImDrawList& list, const Rect& region, PointSnap snap, TileSize size,
                    const CanvasView& view, const Ui& ui) {
  const Vec2 cell{1.0 * size.width, 1.0 * size.height};
  Vec2 step = snap == PointSnap::free ? Vec2{1, 1} : snap_step(snap, size);
  if (std::min(step.x, step.y) * view.zoom < ui.px(kLeastGrid)) step = cell;
  const auto color = [](double at, double side) {
    return theme::color(theme::kText, std::fmod(at, side) == 0 ? 90 : 22);
  };
  for (double x = std::ceil(region.x / step.x) * step.x; x <= region.right(); x += step.x) {
    const float at = view.to_screen({x, 0}).x;
    list.AddRectFilled({at, view.min.y}, {at + 1, view.max.y}, color(x, cell.x));
  }
  for (double y = std::ceil(region.y / step.y) * step.y; y <= region.bottom(); y += step.y) {
    const float at = view.to_screen({0, y}).y;
    list.AddRectFilled({view.min.x, at}, {view.max.x, at + 1}, color(y, cell.y));
  }
}

// The canvas gets them by a click, and by a move of the mouse onto it.
void take_keys(Ui& ui) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  const bool is_used = moved.x != 0 || moved.y != 0 || ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1);
  if (ImGui::IsItemHovered() && is_used) ui.view.window.focus = Focus::shape;
}

void draw_red_outline(ImDrawList& list, const TileShape& polygon, const CanvasView& view, const Ui& ui) {
  std::vector<ImVec2> points;
  for (const Vec2 point : polygon.points) points.push_back(view.to_screen(point));
  list.AddPolyline(points.data(), static_cast<int>(points.size()), theme::color(theme::kError),
                   ImDrawFlags_Closed, ui.px(2));
}

}  // namespace

// The place of the tiles on the screen in this frame.
struct ShapeCanvas::Frame {
  const Session& session;
  const EditedShape& edited;
  TileShape shape;      // the edited part; changed by the drag
  int rows;             // of tiles that its line may reach over during a drag
  Rect region;          // px of the tile
  CanvasView view;      // of px of the tile, whose top left is (0, 0)
  float reach;          // px of the screen, from a handle to the mouse
  std::uint32_t color;  // 0xRRGGBB, the overlay's
  bool changed = false;

  bool has_line() const { return has_heights(shape) && !edited.is_drawing; }
  bool hangs() const { return shape.side == TileShape::Side::ceiling; }
  double base() const { return hangs() ? 0 : edited.size.height; }
  double width() const { return shape.tiles * edited.size.width; }  // px, of the line
  // A height of the line, by its index.
  ImVec2 point(std::size_t i) const {
    const double x = static_cast<double>(i) * width() / static_cast<double>(shape.heights.size() - 1);
    return view.to_screen({x, hangs() ? shape.heights[i] : base() - shape.heights[i]});
  }
  double highest() const { return rows * edited.size.height; }  // px, the largest that a drag can make
  double height_at(float y) const {                             // px
    const double at = view.to_level({0, y}).y;
    return hangs() ? at : base() - at;
  }
  double rise(float from_y, float to_y) const { return height_at(to_y) - height_at(from_y); }  // px
  int nearest_by_x(float x) const {
    const double last = static_cast<double>(shape.heights.size() - 1);
    return static_cast<int>(std::clamp(std::round(view.to_level({x, 0}).x / width() * last), 0.0, last));
  }
  void set_height(std::size_t i, double wanted) {
    wanted = std::clamp(wanted, 0.0, highest());
    changed = changed || wanted != shape.heights[i];
    shape.heights[i] = wanted;
  }
};

std::optional<TileShape> ShapeCanvas::draw(const Session& session, Actions& actions, int tile,
                                           const EditedShape& edited, ImVec2 room, Ui& ui) {
  const TileSize size = edited.size;
  if (grip_ == Grip::none && !hand_.holds()) {  // else they are kept from when the drag began
    region_ = region_of(edited, ui.view.shape);
    rows_ = has_heights(edited.shape()) ? rows_of(edited.shape(), size) : 1;
  }
  const float margin = ui.px(kMargin);
  const auto wide = static_cast<float>(region_.w), high = static_cast<float>(region_.h);
  const float least = ui.px(kLeastTile) / static_cast<float>(size.height);  // of shapes higher than the room
  const float fits = std::min((room.x - 2 * margin) / wide, std::max((room.y - 2 * margin) / high, least));
  const float zoom = whole_zoom(fits, is_open(edited), kMaxTileZoom * ui.scale);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("shape canvas", {room.x, high * zoom + 2 * margin},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.item("shape/canvas");  // its help would cover it
  const ImVec2 from{std::floor(corner.x + (room.x - wide * zoom) / 2), std::floor(corner.y + margin)};
  const CanvasView view{from,
                        {from.x + wide * zoom, from.y + high * zoom},
                        {from.x - region_.x * zoom, from.y - region_.y * zoom},
                        zoom,
                        size};
  Frame frame{
      session, edited, edited.shape(), rows_,
      region_, view,   ui.px(kReach),  overlay_color(overlay::shapes, session.choices().overlay_palette)};
  ui.place("shape/tile", view.corner_of({0, 0}), view.corner_of({1, 1}));
  if (is_open(edited)) take_keys(ui);
  if (hand_.holds() || !frame.has_line() || chooses_part(frame, ui))
    hand_.update(session, actions, view, ui);
  else
    drag(frame, actions);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (is_open(edited)) list.AddRectFilled(view.min, view.max, theme::color(theme::kOutside));
  list.PushClipRect({view.min.x - 1, view.min.y - 1}, {view.max.x + 1, view.max.y + 1}, true);
  draw_tiles(list, box_of(edited.whole, size), tile, size, view, is_open(edited), ui);
  if (is_open(edited)) draw_snap_grid(list, region_, ui.view.shape.snap, size, view, ui);
  list.PopClipRect();
  list.PushClipRect({view.min.x - margin, view.min.y - margin}, {view.max.x + margin, view.max.y + margin},
                    true);
  draw_shape(frame, ui);
  if (is_open(edited)) hand_.draw(session, view, ui);
  list.PopClipRect();
  if (ui.view.window.focus == Focus::shape)
    list.AddRect({view.min.x - 1, view.min.y - 1}, {view.max.x + 1, view.max.y + 1},
                 theme::color(theme::kAccent));
  if (is_open(edited) || frame.has_line()) follow_cursor(frame, ui);
  if (!frame.changed) return std::nullopt;
  return frame.shape;
}

void ShapeCanvas::follow_cursor(const Frame& frame, Ui& ui) const {
  const Rect& region = frame.region;
  const CellRect room{static_cast<int>(std::ceil(region.x)), static_cast<int>(std::ceil(region.y)),
                      static_cast<int>(std::floor(region.w)), static_cast<int>(std::floor(region.h))};
  const bool on_points = is_open(frame.edited) && !frame.has_line();
  const TileSize step = on_points ? cursor_step(ui.view.shape.snap, frame.edited.size) : TileSize{1, 1};
  ui.view.canvas.cursor.visit("shape", frame.view, {room, step, true}, ImGui::GetIO().MousePos);
  ui.view.canvas.cursor.draw("shape", *ImGui::GetWindowDrawList(), frame.view, ui.scale);
}

// A press beside the handles of a line, and on another part.
bool ShapeCanvas::chooses_part(const Frame& frame, Ui& ui) const {
  if (grip_ != Grip::none || part_count(frame.edited.whole) < 2) return false;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 handle = frame.point(static_cast<std::size_t>(frame.nearest_by_x(mouse.x)));
  if (std::hypot(handle.x - mouse.x, handle.y - mouse.y) <= frame.reach) return false;
  const Vec2 place = frame.view.to_level(mouse);
  const double reach = ui.px(2) / frame.view.zoom;
  return !part_near(frame.shape, frame.edited.size, place, reach) &&
         part_near(frame.edited.whole, frame.edited.size, place, reach);
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

// The parts that are not edited are pale.
void ShapeCanvas::draw_shape(const Frame& frame, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const EditedShape& edited = frame.edited;
  const ImVec2 corner = frame.view.corner_of({0, 0}), end = frame.view.corner_of({1, 1});
  for (std::size_t i = 0; i < part_count(edited.whole); ++i) {
    const TileShape& part = part_at(edited.whole, i);
    const bool is_edited = i == edited.part && !edited.is_drawing;
    if (is_edited && frame.has_line()) continue;
    if (part.kind == TileShape::Kind::solid && !is_open(edited))
      list.AddRectFilled(corner, end, theme::color(frame.color, 70));
    else if (problem_of(part, edited.size))
      draw_red_outline(list, part, frame.view, ui);
    else
      draw_tile_shape(list, part, edited.size, corner, {end.x - corner.x, end.y - corner.y},
                      is_edited ? frame.color : theme::kMuted, ui);
  }
  if (frame.has_line()) draw_line(frame, ui);
}

void ShapeCanvas::draw_line(const Frame& frame, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < frame.shape.heights.size(); ++i) points.push_back(frame.point(i));
  const float base = frame.view.to_screen({0, frame.base()}).y;
  if (!frame.shape.one_way) fill_to_base(list, points, base, theme::color(frame.color, 70));
  const int count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, theme::color(theme::kDark, 200), ImDrawFlags_None, ui.px(2) + 2);
  list.AddPolyline(points.data(), count, theme::color(frame.color), ImDrawFlags_None, ui.px(2));
  draw_handles(frame, points, ui);
}

void ShapeCanvas::draw_handles(const Frame& frame, const std::vector<ImVec2>& points, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int pointed = ImGui::IsItemHovered() ? frame.nearest_by_x(ImGui::GetIO().MousePos.x) : -1;
  const int lit = grip_ == Grip::none ? pointed : held_, count = static_cast<int>(points.size());
  const float width = points.back().x - points.front().x;
  const float side = std::min(ui.px(kHandle), std::max(2.0f, width / static_cast<float>(3 * count)));
  for (int i = 0; i < count; ++i) {
    const ImVec2 p = points[static_cast<std::size_t>(i)];
    list.AddRectFilled({p.x - side - 1, p.y - side - 1}, {p.x + side + 1, p.y + side + 1},
                       theme::color(theme::kDark));
    list.AddRectFilled({p.x - side, p.y - side}, {p.x + side, p.y + side},
                       theme::color(i == lit ? theme::kWarning : theme::kText));
    ui.place("shape/handle" + std::to_string(i), {p.x - side, p.y - side}, {p.x + side, p.y + side});
  }
  if (lit < 0 || lit >= count) return;
  const std::string text = exact_text(frame.shape.heights[static_cast<std::size_t>(lit)]) + " px";
  draw_canvas_note(list, text, points[static_cast<std::size_t>(lit)], 2 * side, frame.view);
}

}  // namespace talus
