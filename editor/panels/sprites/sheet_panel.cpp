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

constexpr float kMostZoom = 32;  // px of the screen for a pixel

void draw_frame(ImDrawList& list, CellRect tiles, ImVec2 at, float cell, ImU32 color, const Ui& ui) {
  const ImVec2 from{at.x + static_cast<float>(tiles.x) * cell, at.y + static_cast<float>(tiles.y) * cell};
  const ImVec2 to{from.x + static_cast<float>(tiles.w) * cell, from.y + static_cast<float>(tiles.h) * cell};
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark), 0, 0,
               ui.px(1) + 2);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, color, 0, 0, ui.px(1));
}

// The tiles that the stamp paints, if the selection does not show them already.
void mark_stamp(ImDrawList& list, const Choices& choices, ImVec2 at, float cell, const Ui& ui) {
  const SheetLayout& sheet = ui.layout(SheetId::tiles);
  if (choices.area.sheet != SheetId::tiles || choices.stamp == stamp_of_sheet(sheet, choices.area.tiles))
    return;
  const std::set<TileNumber> tiles(choices.stamp.tiles.begin(), choices.stamp.tiles.end());
  for (const TileNumber tile : tiles)
    draw_frame(list, ui.place_on_sheet(tile), at, cell, theme::color(theme::kAccent), ui);
}

// Tints the tiles with the chosen flag, as on the map.
void tint_tiles(ImDrawList& list, const Sheet& sheet, FlagPattern pattern, ImVec2 at, float cell) {
  const int flag = pattern.lowest_flag();
  for (int tile = 0; tile < sheet.count(); ++tile) {
    if (!pattern.matches(sheet.flags[static_cast<std::size_t>(tile)])) continue;
    const Cell place = sheet.layout().place_of(tile);
    const ImVec2 from{at.x + static_cast<float>(place.x) * cell, at.y + static_cast<float>(place.y) * cell};
    const ImVec2 to{from.x + cell, from.y + cell};
    list.AddRectFilled(from, to, flag_color(flag, 110));
    list.AddRect(from, to, flag_color(flag, 220));
  }
}

void draw_grid(ImDrawList& list, const SheetLayout& sheet, ImVec2 at, float cell) {
  const float width = cell * static_cast<float>(sheet.columns),
              height = cell * static_cast<float>(sheet.rows());
  const ImU32 color = theme::color(theme::kText, 22);
  for (int i = 0; i <= sheet.columns; ++i) {
    const float x = at.x + static_cast<float>(i) * cell;
    list.AddRectFilled({x, at.y}, {x + 1, at.y + height}, color);
  }
  for (int i = 0; i <= sheet.rows(); ++i) {
    const float y = at.y + static_cast<float>(i) * cell;
    list.AddRectFilled({at.x, y}, {at.x + width, y + 1}, color);
  }
}

std::string selection_text(const Level& level, const SpriteArea& area) {
  std::string text = std::to_string(number_on_screen(area.sheet, area.tile_at(level, 0, 0)));
  text.insert(0, 1, '#');
  if (area.tiles.w == 1 && area.tiles.h == 1) return text;
  return text + "  " + std::to_string(area.tiles.w) + "x" + std::to_string(area.tiles.h);
}

}  // namespace

void SheetPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_header(session, actions, ui);
  ImGui::BeginChild("scrolled", ImGui::GetContentRegionAvail(), false,
                    ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoBackground);
  draw_sheet(session, actions, ui);
  ImGui::EndChild();
}

// The zoom at which the sheet fits, if it does at 1 px a pixel; else that at which its width fits, but not
// less than 1. The user's zoom comes on top.
float SheetPanel::zoom_of(const SheetLayout& sheet, ImVec2 room, const Ui& ui) const {
  const float width = static_cast<float>(sheet.columns * kCartTileSize);
  const float height = static_cast<float>(sheet.rows() * kCartTileSize);
  const float fits = std::floor(std::min(room.x / width, room.y / height));
  const float bar = ImGui::GetStyle().ScrollbarSize;
  const float zoom = fits >= 1 ? fits : std::max(1.0f, std::floor((room.x - bar) / width));
  return std::clamp(zoom + static_cast<float>(ui.view.sprites.sheet_zoom), 1.0f, kMostZoom);
}

void SheetPanel::draw_sheet(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  const SheetLayout& sheet = ui.layout(area.sheet);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float zoom = zoom_of(sheet, room, ui), cell = zoom * kCartTileSize;
  const float width = cell * static_cast<float>(sheet.columns),
              height = cell * static_cast<float>(sheet.rows());
  ImVec2 at = ImGui::GetCursorScreenPos();
  at.x = std::floor(at.x + std::max(0.0f, (room.x - width) / 2));
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton("sheet", {width, height},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.item(area.sheet == SheetId::tiles ? "sheet/tiles" : "sheet/sprites");
  handle_mouse(session, actions, ui, at, cell);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddImage(ui.sheet(area.sheet), at, {at.x + width, at.y + height});
  if (area.sheet == SheetId::tiles && session.choices().overlays.has(overlay::shapes)) {
    const std::uint32_t color = overlay_color(overlay::shapes, session.choices().overlay_palette);
    draw_sheet_shapes(list, session.level(), at, cell, color, ui);
  }
  if (session.choices().grid) draw_grid(list, sheet, at, cell);
  if (const auto pattern = session.choices().flag_overlay)
    tint_tiles(list, session.level().sheet(area.sheet), *pattern, at, cell);
  mark_stamp(list, session.choices(), at, cell, ui);
  draw_frame(list, area.tiles, at, cell, theme::color(theme::kText), ui);
  const CanvasView view{at, {at.x + width, at.y + height}, {at.x, at.y}, zoom};
  const CellRect pixels{0, 0, sheet.columns * kCartTileSize, sheet.rows() * kCartTileSize};
  ui.view.canvas.cursor.visit("sheet", view, {pixels, {kCartTileSize, kCartTileSize}},
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
  ui.right_aligned(selection_text(session.level(), area), theme::color(theme::kMuted));
  ui.tooltip("The selected tile, and how many tiles wide and high the selection is.");
}

void SheetPanel::handle_mouse(const Session& session, Actions& actions, Ui& ui, ImVec2 at, float cell) {
  const SheetId sheet = session.choices().area.sheet;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse = io.MousePos;
  const SheetLayout layout = session.level().sheet(sheet).layout();
  const Cell tile = layout.nearest({static_cast<int>(std::floor((mouse.x - at.x) / cell)),
                                    static_cast<int>(std::floor((mouse.y - at.y) / cell))});
  const int number = layout.tile_at(tile);
  const bool paints = session.choices().map_tool == MapTool::flag;
  if (ImGui::IsItemHovered()) {
    ui.view.canvas.hover.tile = number;
    if (io.KeyCtrl && io.MouseWheel != 0) ui.view.sprites.sheet_zoom += io.MouseWheel > 0 ? 1 : -1;
  }
  if (ImGui::IsItemActivated()) drag_from_ = tile;
  const bool selects = !paints || io.MouseDown[1];
  if (drag_from_ && selects) actions.push_back(action::SelectTiles{{sheet, spanned(*drag_from_, tile)}});
  if (paints) {
    if (flag_brush_.active() && is_drag_cancelled()) flag_brush_.cancel(session, actions);
    flag_brush_.update(
        session, actions, sheet, tile,
        [&](Cell c) { return layout.contains(c) ? std::optional(layout.tile_at(c)) : std::nullopt; },
        ImGui::IsItemHovered() && ImGui::IsMouseClicked(0), io.MouseDown[0]);
    ui.tooltip(flag_brush_.text(session, sheet, number), "the right button selects");
  }
  if (!ImGui::IsItemActive()) drag_from_.reset();
}

}  // namespace talus
