// Drawing on pixels.
#include "pixel_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "commands.h"

namespace talus {
namespace {

constexpr float kSizeWidth = 92;  // px at scale 1, for "128x128"

void draw_pixels(ImDrawList& list, const SpriteArea& area, ImVec2 at, float zoom, const Ui& ui, bool grid) {
  const float side = 1.0f / kSheetColumns;
  const auto x = static_cast<float>(area.tiles.x), y = static_cast<float>(area.tiles.y);
  const float w = static_cast<float>(area.width()) * zoom, h = static_cast<float>(area.height()) * zoom;
  list.AddImage(
      ui.sheet(area.sheet), at, {at.x + w, at.y + h}, {x * side, y * side},
      {(x + static_cast<float>(area.tiles.w)) * side, (y + static_cast<float>(area.tiles.h)) * side});
  list.AddRect({at.x - 1, at.y - 1}, {at.x + w + 1, at.y + h + 1}, theme::color(theme::kLine));
  if (!grid) return;
  const int step = zoom >= 8 ? 1 : kTileSize;
  for (int i = step; i < area.width(); i += step) {
    const float d = static_cast<float>(i) * zoom;
    list.AddRectFilled({at.x + d, at.y}, {at.x + d + 1, at.y + h},
                       theme::color(theme::kText, i % kTileSize == 0 ? 90 : 24));
  }
  for (int i = step; i < area.height(); i += step) {
    const float d = static_cast<float>(i) * zoom;
    list.AddRectFilled({at.x, at.y + d}, {at.x + w, at.y + d + 1},
                       theme::color(theme::kText, i % kTileSize == 0 ? 90 : 24));
  }
}

}  // namespace

void PixelPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_toolbar(session, actions, ui);
  const SpriteArea& area = session.choices().area;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float longer = static_cast<float>(std::max(area.width(), area.height()));
  const float zoom = std::max(1.0f, std::floor((std::min(room.x, room.y) - 2) / longer));
  const ImVec2 size{static_cast<float>(area.width()) * zoom, static_cast<float>(area.height()) * zoom};
  ImVec2 at = ImGui::GetCursorScreenPos();
  at = {std::floor(at.x + std::max(1.0f, (room.x - size.x) / 2)), at.y + 1};
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton("pixels", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ui.item("pixels/canvas");
  handle_mouse(session, actions, ui, at, zoom);
  draw_pixels(*ImGui::GetWindowDrawList(), area, at, zoom, ui, session.choices().grid);
  if (const auto pixel = ui.view.hover.sprite) {
    const ImVec2 corner{at.x + static_cast<float>(pixel->x) * zoom,
                        at.y + static_cast<float>(pixel->y) * zoom};
    ImGui::GetWindowDrawList()->AddRect(corner, {corner.x + zoom, corner.y + zoom},
                                        theme::color(theme::kText));
  }
}

void PixelPanel::draw_toolbar(const Session& session, Actions& actions, Ui& ui) {
  struct Tool {
    std::string_view command;
    Icon icon;
  };
  constexpr Tool kTools[] = {{"pixels/pencil", Icon::pencil},
                             {"pixels/pick", Icon::pick},
                             {"pixels/fill", Icon::fill},
                             {"pixels/flip_h", Icon::flip_horizontal},
                             {"pixels/flip_v", Icon::flip_vertical},
                             {"pixels/rotate", Icon::rotate},
                             {"pixels/clear", Icon::clear}};
  for (const Tool& tool : kTools) {
    if (&tool != kTools) ui.same_line_if_fits(ui.px(theme::kButton));
    command_button(tool.command, tool.command, tool.icon, session, actions, ui);
  }
  ui.same_line_if_fits(ui.px(kSizeWidth));
  draw_size_choice(session, actions, ui);
}

void PixelPanel::draw_size_choice(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  const std::string now = std::to_string(area.width()) +
                          (area.width() == area.height() ? "" : "x" + std::to_string(area.height()));
  const bool open =
      ui.begin_combo("pixels/size", now, ui.px(kSizeWidth),
                     "How many pixels wide and high the canvas is; a drag on the sheet chooses any size.");
  if (!open) return;
  for (int tiles : {1, 2, 4, 8}) {
    if (!ImGui::Selectable((std::to_string(tiles * kTileSize) + " px").c_str(), area.tiles.w == tiles))
      continue;
    const CellRect rect{std::min(area.tiles.x, kSheetColumns - tiles),
                        std::min(area.tiles.y, kSheetColumns - tiles), tiles, tiles};
    actions.push_back(action::SelectTiles{{area.sheet, rect}});
  }
  ImGui::EndCombo();
}

void PixelPanel::handle_mouse(const Session& session, Actions& actions, Ui& ui, ImVec2 at, float zoom) {
  const SpriteArea& area = session.choices().area;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Cell pixel{static_cast<int>(std::floor((mouse.x - at.x) / zoom)),
                   static_cast<int>(std::floor((mouse.y - at.y) / zoom))};
  const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < area.width() && pixel.y < area.height();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && inside) {
    ui.view.hover.sprite = pixel;
    if (ImGui::IsMouseClicked(2))
      actions.push_back(action::SetColor{pixel_at(session.level(), area, pixel.x, pixel.y)});
    const bool right = ImGui::IsMouseClicked(1);
    if (ImGui::IsMouseClicked(0) || right) {
      secondary_ = right;
      stroke_ = session.next_stroke();
      last_ = pixel;
      use_tool(session, actions, pixel, true);
    }
  }
  if (!last_) return;
  if (!ImGui::GetIO().MouseDown[secondary_ ? 1 : 0]) {
    last_.reset();
  } else if (pixel != *last_) {
    use_tool(session, actions, pixel, false);
    last_ = pixel;
  }
}

void PixelPanel::use_tool(const Session& session, Actions& actions, Cell pixel, bool pressed) {
  const Level& level = session.level();
  const Choices& choices = session.choices();
  const auto color = static_cast<std::uint8_t>(secondary_ ? choices.secondary_color : choices.color);
  switch (choices.sprite_tool) {
    case SpriteTool::pencil:
      actions.push_back(action::EditLevel{draw_line(level, choices.area, *last_, pixel, color), stroke_});
      break;
    case SpriteTool::pick:
      if (pressed)
        actions.push_back(action::SetColor{pixel_at(level, choices.area, pixel.x, pixel.y), secondary_});
      break;
    case SpriteTool::fill:
      if (!pressed) break;
      actions.push_back(action::EditLevel{
          ImGui::GetIO().KeyCtrl
              ? replace_color(level, choices.area, pixel_at(level, choices.area, pixel.x, pixel.y), color)
              : fill_pixels(level, choices.area, pixel, color)});
      break;
  }
}

}  // namespace talus
