// Tools, sizes and brushes beside the canvas.
#include "pixel_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

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
  const auto place = [&](int first, int count, int px, int room) {
    const int at = tiles < count ? first + px / kCartTileSize / tiles * tiles : first;
    return std::clamp(at, 0, std::max(room - tiles, 0));
  };
  return {
      area.sheet,
      {place(area.tiles.x, area.tiles.w, pixel.x, columns), place(area.tiles.y, area.tiles.h, pixel.y, rows),
       std::min(tiles, columns), std::min(tiles, std::max(rows, 1))}};
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
  const int step = view.zoom >= 8 ? 1 : kCartTileSize;
  const auto color = [](int i) { return theme::color(theme::kText, i % kCartTileSize == 0 ? 90 : 24); };
  for (int i = step; i < area.width(); i += step) {
    const float x = from.x + static_cast<float>(i) * view.zoom;
    list.AddRectFilled({x, from.y}, {x + 1, to.y}, color(i));
  }
  for (int i = step; i < area.height(); i += step) {
    const float y = from.y + static_cast<float>(i) * view.zoom;
    list.AddRectFilled({from.x, y}, {to.x, y + 1}, color(i));
  }
}

void draw_image(ImDrawList& list, const SpriteArea& area, const CanvasView& view, const Ui& ui) {
  const UvRect uv = ui.uv_of(area.sheet, area.tiles);
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
    const std::string side = std::to_string(tiles * kCartTileSize);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (ui.text_button("pixels/size" + side, side, area.tiles.w == tiles && area.tiles.h == tiles,
                       "A canvas of " + side + "x" + side +
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
  const SpriteArea& area = session.choices().area;
  const bool surrounded = ui.view.sprites.pixels.neighbours && area.sheet == SheetId::tiles;
  const float margin = surrounded ? kSurroundings : 0;  // px of the art
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const auto zoom_for = [&](float pixels, int art) {
    return (pixels - 2) / (static_cast<float>(art) + 2 * margin);
  };
  const float zoom =
      std::max(1.0f, std::floor(std::min(zoom_for(room.x, area.width()), zoom_for(room.y, area.height()))));
  const ImVec2 size{static_cast<float>(area.width()) * zoom, static_cast<float>(area.height()) * zoom};
  ImVec2 at = ImGui::GetCursorScreenPos();
  at = {std::floor(at.x + std::max(1.0f, (room.x - size.x) / 2)), std::floor(at.y + 1 + margin * zoom)};
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton("pixels", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ui.item("pixels/canvas");
  const CanvasView view{at, {at.x + size.x, at.y + size.y}, {at.x, at.y}, zoom};
  const Cell pixel = [&] {
    const Vec2 p = view.to_level(ImGui::GetIO().MousePos);
    return Cell{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))};
  }();
  const bool hovered = ImGui::IsItemHovered() && pixel.x >= 0 && pixel.y >= 0 && pixel.x < area.width() &&
                       pixel.y < area.height();
  if (hovered) {
    ui.view.canvas.hover.sprite = pixel;
    change_size_by_wheel(session, actions, pixel);
  }
  hand_.update(session, actions, pixel, hovered);
  KeyCursor& cursor = ui.view.canvas.cursor;
  cursor.visit("pixels", view, {{0, 0, area.width(), area.height()}}, ImGui::GetIO().MousePos);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_image(list, area, view, ui);
  if (session.choices().grid) draw_grid_lines(list, area, view);
  if (surrounded) surroundings_.draw(list, session, view, ui);
  hand_.draw(list, session, view, pixel, hovered, ui.scale);
  cursor.draw("pixels", list, view, ui.scale);
}

// Up: fewer pixels, larger. Touch pads turn the wheel by fractions, which add up.
void PixelPanel::change_size_by_wheel(const Session& session, Actions& actions, Cell pixel) {
  if (hand_.active()) return;
  wheel_ += ImGui::GetIO().MouseWheel;
  const int steps = static_cast<int>(wheel_);
  wheel_ -= static_cast<float>(steps);
  if (steps == 0) return;
  const SpriteArea& area = session.choices().area;
  const int now = std::max(area.tiles.w, area.tiles.h);
  int tiles = now;
  for (int i = 0; i < std::abs(steps); ++i) tiles = steps > 0 ? smaller_size(tiles) : larger_size(tiles);
  if (tiles != now)
    actions.push_back(
        action::SelectTiles{resized(session.level().sheet(area.sheet).layout(), area, tiles, pixel)});
}

}  // namespace talus
