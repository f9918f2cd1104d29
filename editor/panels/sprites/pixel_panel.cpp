// Tools, sizes and brushes beside the canvas.
#include "pixel_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "checkered.h"
#include "panels/canvas/camera_hand.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr int kToolColumns = 4;
constexpr float kToolGap = 2;                        // px at scale 1, between the tools
constexpr std::array<int, 4> kSizes = {1, 2, 4, 8};  // tiles, of the canvas

constexpr std::array<CommandId, 12> kTools = {
    "pixels/pencil"_command,  "pixels/pick"_command,   "pixels/select"_command,
    "pixels/fill"_command,    "pixels/line"_command,   "pixels/rectangle"_command,
    "pixels/ellipse"_command, "pixels/clear"_command,  "pixels/flip_h"_command,
    "pixels/flip_v"_command,  "pixels/rotate"_command, "pixels/neighbours"_command};

// A square of so many tiles at the area's place; if it is smaller, around a pixel of the canvas.
SpriteArea resized(const SheetLayout& sheet, const SpriteArea& area, int tiles, Cell pixel) {
  const int columns = sheet.columns,
            rows = sheet.count / sheet.columns;  // without a last row that is shorter
  const auto place = [&](int first, int count, int tile, int room) {
    const int at = tiles < count ? first + tile / tiles * tiles : first;
    return std::clamp(at, 0, std::max(room - tiles, 0));
  };
  return {area.sheet,
          {place(area.tiles.x, area.tiles.w, pixel.x / area.tile.width, columns),
           place(area.tiles.y, area.tiles.h, pixel.y / area.tile.height, rows), std::min(tiles, columns),
           std::min(tiles, std::max(rows, 1))},
          area.tile};
}

int smaller_size(int tiles) {
  const auto next = std::lower_bound(kSizes.begin(), kSizes.end(), tiles);
  return next == kSizes.begin() ? tiles : *std::prev(next);
}

int larger_size(int tiles) {
  const auto next = std::upper_bound(kSizes.begin(), kSizes.end(), tiles);
  return next == kSizes.end() ? tiles : *next;
}

void draw_grid_lines(ImDrawList& list, const SpriteArea& area, const CanvasView& view) {
  const ImVec2 from = view.min, to = view.max;
  const auto step = [&](int tile) { return view.zoom >= 8 ? 1 : tile; };
  const auto color = [](int i, int tile) { return theme::color(theme::kText, i % tile == 0 ? 90 : 24); };
  for (int i = step(area.tile.width); i < area.width(); i += step(area.tile.width)) {
    const float x = from.x + static_cast<float>(i) * view.zoom;
    list.AddRectFilled({x, from.y}, {x + 1, to.y}, color(i, area.tile.width));
  }
  for (int i = step(area.tile.height); i < area.height(); i += step(area.tile.height)) {
    const float y = from.y + static_cast<float>(i) * view.zoom;
    list.AddRectFilled({from.x, y}, {to.x, y + 1}, color(i, area.tile.height));
  }
}

// The n-th of these zooms that is larger than the one at which all has room; that one if n is 0.
float zoom_above(float fitting, int steps) {
  constexpr std::array<float, 12> kZooms = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
  if (steps <= 0) return fitting;
  const auto larger = std::upper_bound(kZooms.begin(), kZooms.end(), fitting);
  const auto left = kZooms.end() - larger;
  return left == 0 ? fitting : larger[std::min<std::ptrdiff_t>(steps, left) - 1];
}

// The zoom at which so many px of art have so much room, whole if possible.
float fitting_zoom(ImVec2 room, const SpriteArea& area, float margin) {
  const auto along = [&](float pixels, int art) {
    return (pixels - 2) / (static_cast<float>(art) + 2 * margin);
  };
  const float zoom = std::max(0.05f, std::min(along(room.x, area.width()), along(room.y, area.height())));
  return zoom < 1 ? zoom : std::floor(zoom);
}

void draw_image(ImDrawList& list, const SpriteArea& area, bool in_rgba, const CanvasView& view,
                const Ui& ui) {
  const UvRect uv = ui.uv_of(area.sheet, area.tiles);
  if (in_rgba) draw_checkered(list, view.min, view.max, ui.px(8));
  list.AddImage(ui.sheet(area.sheet), view.min, view.max, uv.from, uv.to);
  list.AddRect({view.min.x - 1, view.min.y - 1}, {view.max.x + 1, view.max.y + 1},
               theme::color(theme::kLine));
}

}  // namespace

void PixelPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(kToolGap), ui.px(kToolGap)));
  ImGui::BeginGroup();
  draw_tools(session, actions, ui);
  draw_sizes(session, actions, ui);
  draw_brushes(session, actions, ui);
  ImGui::EndGroup();
  ImGui::PopStyleVar();
  ImGui::SameLine(0, ui.px(2 * theme::kGap));
  draw_canvas(session, actions, ui);
}

void PixelPanel::draw_tools(const Session& session, Actions& actions, Ui& ui) {
  for (std::size_t i = 0; i < kTools.size(); ++i) {
    if (i % kToolColumns != 0) ImGui::SameLine();
    command_button(kTools[i], session, actions, ui);
  }
}

void PixelPanel::draw_sizes(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  for (int tiles : kSizes) {
    if (tiles != kSizes.front()) ImGui::SameLine();
    const std::string side = std::to_string(tiles * area.tile.width);
    const std::string count = std::to_string(tiles);
    const bool has_cart_tiles = session.level().map.tile_size() == TileSize{};
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (ui.text_button("pixels/size" + side, has_cart_tiles ? side : count + "x",
                       area.tiles.w == tiles && area.tiles.h == tiles,
                       "A canvas of " + count + "x" + count + " tiles, " + side + "x" +
                           std::to_string(tiles * area.tile.height) +
                           " px; a drag on the sheet chooses any size, up to all of it.",
                       "wheel over the canvas", true, ui.px(theme::kButton)))
      actions.push_back(action::SelectTiles{resized(ui.layout(area.sheet), area, tiles, {0, 0})});
    ImGui::PopStyleVar();
  }
}

void PixelPanel::draw_brushes(const Session& session, Actions& actions, Ui& ui) {
  for (int size = 1; size <= kMaxBrush; ++size) {
    if (size > 1) ImGui::SameLine();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string number = std::to_string(size);
    if (ui.icon_button(
            "pixels/brush" + number, Icon::none, session.choices().brush == size,
            "A brush of " + number + "x" + number + " px for pencil, line, rectangle and ellipse.",
            keys_of("pixels/smaller_brush"_command, ui) + "  " + keys_of("pixels/larger_brush"_command, ui)))
      actions.push_back(action::SetBrush{size});
    const float side = ui.px(static_cast<float>(size) * 3);
    const float inset = std::floor((ui.px(theme::kButton) - side) / 2);
    const ImVec2 from{at.x + inset, at.y + inset};
    ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + side, from.y + side},
                                              theme::tone(theme::kText));
  }
}

void PixelPanel::draw_canvas(const Session& session, Actions& actions, Ui& ui) {
  const bool is_zoomed = ui.view.sprites.pixel_zoom > 0;
  ImGui::BeginChild("canvas", ImGui::GetContentRegionAvail(), false,
                    is_zoomed ? ImGuiWindowFlags_HorizontalScrollbar
                              : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_pixels(session, actions, ui);
  ImGui::EndChild();
}

void PixelPanel::draw_pixels(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  const bool surrounded = ui.view.sprites.pixels.neighbours && area.sheet == SheetId::tiles;
  const float margin = surrounded ? kSurroundings : 0;  // px of the art
  const ImVec2 room = ImGui::GetWindowSize();
  const float zoom = zoom_above(fitting_zoom(room, area, margin), ui.view.sprites.pixel_zoom);
  const ImVec2 size{static_cast<float>(area.width()) * zoom, static_cast<float>(area.height()) * zoom};
  ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = std::max(1.0f, margin * zoom);
  at = {std::floor(at.x + std::max(side, (room.x - size.x) / 2)), std::floor(at.y + 1 + margin * zoom)};
  const bool has_new_zoom = std::exchange(shown_zoom_, zoom) != zoom;
  if (has_new_zoom) keep_in_place(zoom);  // in the next frame
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton("pixels", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ui.item("pixels/canvas");
  move_by_middle_button(ui);
  const CanvasView view{at, {at.x + size.x, at.y + size.y}, {at.x, at.y}, zoom, area.tile};
  const Vec2 place = view.to_level(ImGui::GetIO().MousePos);
  const Cell pixel{static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y))};
  const bool hovered = ImGui::IsItemHovered() && area.contains(pixel);
  if (hovered) {
    ui.view.canvas.hover.sprite = pixel;
    take_wheel(session, actions, pixel, ui);
    const ImVec2 mouse = ImGui::GetIO().MousePos, corner = ImGui::GetWindowPos();
    if (!has_new_zoom) zoomed_about_ = {place, {mouse.x - corner.x, mouse.y - corner.y}};
  }
  const bool was_active = hand_.active();
  hand_.update(session, actions, pixel, hovered, middle_button_picks(ui.view.preferences));
  if (!was_active && hand_.active()) note_color(session, ui);
  KeyCursor& cursor = ui.view.canvas.cursor;
  cursor.visit("pixels", view, {area.canvas()}, ImGui::GetIO().MousePos);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_image(list, area, is_in_rgba(session.level(), area.sheet), view, ui);
  if (session.choices().grid) draw_grid_lines(list, area, view);
  if (surrounded) surroundings_.draw(list, session, view, ui);
  hand_.draw(list, session, view, pixel, hovered, ui.scale);
  cursor.draw("pixels", list, view, ui.scale);
}

// What the mouse was on last stays under it.
void PixelPanel::keep_in_place(float zoom) const {
  ImGui::SetScrollX(static_cast<float>(zoomed_about_.pixel.x) * zoom - zoomed_about_.mouse.x);
  ImGui::SetScrollY(static_cast<float>(zoomed_about_.pixel.y) * zoom - zoomed_about_.mouse.y);
}

// Where larger pixels do not all have room.
void PixelPanel::move_by_middle_button(const Ui& ui) {
  if (ui.view.preferences.middle_picks || !ImGui::IsItemActive() || !ImGui::IsMouseDragging(2)) return;
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  ImGui::SetScrollX(ImGui::GetScrollX() - by.x);
  ImGui::SetScrollY(ImGui::GetScrollY() - by.y);
}

// A colour that is painted with in true colour becomes the first of the recent ones.
void PixelPanel::note_color(const Session& session, Ui& ui) {
  constexpr std::size_t kMaxRecent = 8;
  const Choices& choices = session.choices();
  const bool paints = choices.sprite_tool != SpriteTool::pick && choices.sprite_tool != SpriteTool::select;
  const Rgba color = ImGui::IsMouseClicked(1) ? choices.secondary_rgba : choices.rgba;
  if (!paints || color.a == 0 || !is_in_rgba(session.level(), choices.area.sheet)) return;
  std::vector<Rgba>& recent = ui.view.sprites.recent_colors;
  std::erase(recent, color);
  recent.insert(recent.begin(), color);
  recent.resize(std::min(recent.size(), kMaxRecent));
}

// Up: fewer pixels, larger; with Ctrl the same pixels, larger. Touch pads turn the wheel by fractions, which
// add up.
void PixelPanel::take_wheel(const Session& session, Actions& actions, Cell pixel, Ui& ui) {
  if (hand_.active()) return;
  int& zoom_steps = ui.view.sprites.pixel_zoom;
  const bool zooms = ImGui::GetIO().KeyCtrl;
  if (!zooms && zoom_steps > 0) return;  // it scrolls
  wheel_ += ImGui::GetIO().MouseWheel;
  const int steps = static_cast<int>(wheel_);
  wheel_ -= static_cast<float>(steps);
  if (steps == 0) return;
  if (zooms) {
    zoom_steps = std::clamp(zoom_steps + steps, 0, kMaxPixelZoom);
    return;
  }
  const SpriteArea& area = session.choices().area;
  const int now = std::max(area.tiles.w, area.tiles.h);
  int tiles = now;
  for (int i = 0; i < std::abs(steps); ++i) tiles = steps > 0 ? smaller_size(tiles) : larger_size(tiles);
  if (tiles != now)
    actions.push_back(
        action::SelectTiles{resized(session.level().sheet(area.sheet).layout(), area, tiles, pixel)});
}

}  // namespace talus
