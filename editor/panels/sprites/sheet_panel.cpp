// The sheet, at the largest whole zoom that fits.
#include "sheet_panel.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "edit/stamp.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/canvas/shape_drawing.h"
#include "panels/commands/commands.h"
#include "tile_number.h"

namespace talus {
namespace {

void draw_frame(ImDrawList& list, CellRect tiles, ImVec2 at, float cell, ImU32 color, const Ui& ui) {
  const ImVec2 from{at.x + static_cast<float>(tiles.x) * cell, at.y + static_cast<float>(tiles.y) * cell};
  const ImVec2 to{from.x + static_cast<float>(tiles.w) * cell, from.y + static_cast<float>(tiles.h) * cell};
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark), 0, 0,
               ui.px(1) + 2);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, color, 0, 0, ui.px(1));
}

// The tiles that the stamp paints, if the selection does not show them already.
void mark_stamp(ImDrawList& list, const Choices& choices, ImVec2 at, float cell, const Ui& ui) {
  if (choices.area.sheet != SheetId::tiles || choices.stamp == stamp_of_sheet(choices.area.tiles)) return;
  const std::set<std::uint8_t> tiles(choices.stamp.tiles.begin(), choices.stamp.tiles.end());
  for (const std::uint8_t tile : tiles)
    draw_frame(list, {tile % kSheetColumns, tile / kSheetColumns, 1, 1}, at, cell,
               theme::color(theme::kAccent), ui);
}

// Tints the tiles with the chosen flag, as on the map.
void tint_tiles(ImDrawList& list, const Sheet& sheet, FlagPattern pattern, ImVec2 at, float cell) {
  const int flag = pattern.lowest_flag();
  for (int tile = 0; tile < kTileCount; ++tile) {
    if (!pattern.matches(sheet.flags[static_cast<std::size_t>(tile)])) continue;
    const ImVec2 from{at.x + static_cast<float>(tile % kSheetColumns) * cell,
                      at.y + static_cast<float>(tile / kSheetColumns) * cell};
    const ImVec2 to{from.x + cell, from.y + cell};
    list.AddRectFilled(from, to, flag_color(flag, 110));
    list.AddRect(from, to, flag_color(flag, 220));
  }
}

std::string selection_text(const SpriteArea& area) {
  std::string text = std::to_string(number_on_screen(area.sheet, area.tile_at(0, 0)));
  text.insert(0, 1, '#');
  if (area.tiles.w == 1 && area.tiles.h == 1) return text;
  return text + "  " + std::to_string(area.tiles.w) + "x" + std::to_string(area.tiles.h);
}

}  // namespace

void SheetPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_header(session, actions, ui);
  const SpriteArea& area = session.choices().area;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float zoom = std::max(1.0f, std::floor(std::min(room.x, room.y) / kSheetSide));
  const float side = zoom * kSheetSide, cell = zoom * kCartTileSize;
  ImVec2 at = ImGui::GetCursorScreenPos();
  at.x = std::floor(at.x + std::max(0.0f, (room.x - side) / 2));
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton("sheet", {side, side},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.item(area.sheet == SheetId::tiles ? "sheet/tiles" : "sheet/sprites");
  handle_mouse(session, actions, ui, at, cell);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddImage(ui.sheet(area.sheet), at, {at.x + side, at.y + side});
  if (area.sheet == SheetId::tiles && session.choices().overlays.has(overlay::shapes)) {
    const std::uint32_t color = overlay_color(overlay::shapes, session.choices().overlay_palette);
    draw_sheet_shapes(list, session.level(), at, cell, color, ui);
  }
  if (session.choices().grid) {
    for (int i = 0; i <= kSheetColumns; ++i) {
      const float d = static_cast<float>(i) * cell;
      list.AddRectFilled({at.x + d, at.y}, {at.x + d + 1, at.y + side}, theme::color(theme::kText, 22));
      list.AddRectFilled({at.x, at.y + d}, {at.x + side, at.y + d + 1}, theme::color(theme::kText, 22));
    }
  }
  if (const auto pattern = session.choices().flag_overlay)
    tint_tiles(list, session.level().sheet(area.sheet), *pattern, at, cell);
  mark_stamp(list, session.choices(), at, cell, ui);
  draw_frame(list, area.tiles, at, cell, theme::color(theme::kText), ui);
  const CanvasView view{at, {at.x + side, at.y + side}, {at.x, at.y}, zoom};
  ui.view.canvas.cursor.visit("sheet", view, {{0, 0, kSheetSide, kSheetSide}, {kCartTileSize, kCartTileSize}},
                              ImGui::GetIO().MousePos);
  ui.view.canvas.cursor.draw("sheet", list, view, ui.scale);
}

void SheetPanel::draw_header(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  const Command& change = find_command("sheet/switch"_command);
  for (SheetId sheet : {SheetId::tiles, SheetId::sprites}) {
    const bool tiles = sheet == SheetId::tiles;
    if (ui.text_button(tiles ? "sheet/show_tiles" : "sheet/show_sprites", tiles ? "Tiles" : "Sprites",
                       area.sheet == sheet,
                       tiles ? "The images that the map is made of." : "Images that the map does not use.",
                       keys_of(change, ui))) {
      actions.push_back(action::SelectTiles{{sheet, area.tiles}});
    }
    ImGui::SameLine();
  }
  command_button("pixels/enlarge"_command, session, actions, ui);
  ImGui::SameLine();
  ui.right_aligned(selection_text(area), theme::color(theme::kMuted));
  ui.tooltip("The selected tile, and how many tiles wide and high the selection is.");
}

void SheetPanel::handle_mouse(const Session& session, Actions& actions, Ui& ui, ImVec2 at, float cell) {
  const SheetId sheet = session.choices().area.sheet;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse = io.MousePos;
  const Cell tile{std::clamp(static_cast<int>((mouse.x - at.x) / cell), 0, kSheetColumns - 1),
                  std::clamp(static_cast<int>((mouse.y - at.y) / cell), 0, kSheetColumns - 1)};
  const int number = tile.y * kSheetColumns + tile.x;
  const bool paints = session.choices().map_tool == MapTool::flag;
  if (ImGui::IsItemHovered()) ui.view.canvas.hover.tile = number;
  if (ImGui::IsItemActivated()) drag_from_ = tile;
  const bool selects = !paints || io.MouseDown[1];
  if (drag_from_ && selects) actions.push_back(action::SelectTiles{{sheet, spanned(*drag_from_, tile)}});
  if (paints) {
    if (flag_brush_.active() && is_drag_cancelled()) flag_brush_.cancel(session, actions);
    flag_brush_.update(
        session, actions, sheet, tile, [](Cell c) { return std::optional(c.y * kSheetColumns + c.x); },
        ImGui::IsItemHovered() && ImGui::IsMouseClicked(0), io.MouseDown[0]);
    ui.tooltip(flag_brush_.text(session, sheet, number), "the right button selects");
  }
  if (!ImGui::IsItemActive()) drag_from_.reset();
}

}  // namespace talus
