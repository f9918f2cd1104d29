// The sheet, at the largest whole zoom that fits.
#include "sheet_panel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "edit/stamp.h"
#include "formats/tilesets/new_tileset.h"
#include "level/single_change.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/canvas/shape_drawing.h"
#include "panels/commands/commands.h"
#include "panels/ui/long_list.h"
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
  std::set<TileNumber> tiles;
  for (const MapCell& painted : choices.stamp.tiles) tiles.insert(painted.tile);
  for (const TileNumber tile : tiles)
    draw_frame(list, ui.place_on_sheet(tile), at, cell, theme::color(theme::kAccent), ui);
}

// The columns and rows of the sheet that are shown: of a tileset, or all.
CellRect shown_part(const Session& session, const Ui& ui) {
  const SheetId id = session.choices().area.sheet;
  const SheetLayout& sheet = ui.layout(id);
  const auto& sets = session.level().tilesets;
  const auto index = static_cast<std::size_t>(ui.view.sprites.tileset);
  if (id != SheetId::tiles || ui.view.sprites.tileset < 0 || index >= sets.size())
    return {0, 0, sheet.columns, sheet.rows()};
  const Tileset& set = sets[index];
  const Cell first = sheet.place_of(set.first);
  return {first.x, first.y, set.columns, (set.count - 1) / sheet.columns + 1};
}

// Calls use(tile, its corner) for the tiles of some columns and rows that can be seen.
template <class Use>
void for_each_visible(ImDrawList& list, const SheetLayout& sheet, CellRect part, ImVec2 at, float cell,
                      Use use) {
  const float top = list.GetClipRectMin().y, bottom = list.GetClipRectMax().y;
  const int from = std::max(part.y, static_cast<int>(std::floor((top - at.y) / cell)));
  const int to = std::min(part.y + part.h - 1, static_cast<int>(std::floor((bottom - at.y) / cell)));
  for (int y = from; y <= to; ++y)
    for (int x = part.x; x < part.x + part.w; ++x)
      if (sheet.contains({x, y}))
        use(sheet.tile_at({x, y}),
            ImVec2{at.x + static_cast<float>(x) * cell, at.y + static_cast<float>(y) * cell});
}

// Tints the tiles with the chosen flag, as on the map.
void tint_tiles(ImDrawList& list, const Sheet& sheet, FlagPattern pattern, CellRect part, ImVec2 at,
                float cell) {
  const int flag = pattern.lowest_flag();
  for_each_visible(list, sheet.layout(), part, at, cell, [&](int tile, ImVec2 from) {
    if (!pattern.matches(sheet.flags[static_cast<std::size_t>(tile)])) return;
    const ImVec2 to{from.x + cell, from.y + cell};
    list.AddRectFilled(from, to, flag_color(flag, 110));
    list.AddRect(from, to, flag_color(flag, 220));
  });
}

void draw_grid(ImDrawList& list, CellRect part, ImVec2 at, float cell) {
  const float width = cell * static_cast<float>(part.w), height = cell * static_cast<float>(part.h);
  const ImU32 color = theme::color(theme::kText, 22);
  for (int i = 0; i <= part.w; ++i) {
    const float x = at.x + static_cast<float>(i) * cell;
    list.AddRectFilled({x, at.y}, {x + 1, at.y + height}, color);
  }
  for (int i = 0; i <= part.h; ++i) {
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
  const bool is_large = ui.layout(SheetId::tiles) != SheetLayout() || !session.level().tilesets.empty();
  const SpritesView& view = ui.view.sprites;
  if (session.choices().area.sheet == SheetId::tiles && (is_large || view.finds || view.marks_used)) {
    draw_tabs(session, actions, ui);
    finder_.draw(session, actions, ui);
  }
  ImGui::BeginChild("scrolled", ImGui::GetContentRegionAvail(), false,
                    ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoBackground);
  draw_sheet(session, actions, ui);
  ImGui::EndChild();
}

// The zoom at which the sheet fits, if it does at 1 px a pixel; else that at which its width fits, but not
// less than 1. The user's zoom comes on top.
float SheetPanel::zoom_of(CellRect part, ImVec2 room, const Ui& ui) const {
  const float width = static_cast<float>(part.w * kCartTileSize);
  const float height = static_cast<float>(part.h * kCartTileSize);
  const float fits = std::floor(std::min(room.x / width, room.y / height));
  const float bar = ImGui::GetStyle().ScrollbarSize;
  const float zoom = fits >= 1 ? fits : std::max(1.0f, std::floor((room.x - bar) / width));
  return std::clamp(zoom + static_cast<float>(ui.view.sprites.sheet_zoom), 1.0f, kMostZoom);
}

void SheetPanel::draw_sheet(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  const SheetLayout& sheet = ui.layout(area.sheet);
  const CellRect part = shown_part(session, ui);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float zoom = zoom_of(part, room, ui), cell = zoom * kCartTileSize;
  const float width = cell * static_cast<float>(part.w), height = cell * static_cast<float>(part.h);
  ImVec2 min = ImGui::GetCursorScreenPos();
  min.x = std::floor(min.x + std::max(0.0f, (room.x - width) / 2));
  const ImVec2 max{min.x + width, min.y + height};
  if (const int tile = std::exchange(ui.view.sprites.shown_tile, -1); tile >= 0 && tile < sheet.count) {
    const Cell place = sheet.place_of(tile);
    ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY() +
                             (static_cast<float>(place.y - part.y) + 0.5f) * cell);
    ImGui::SetScrollFromPosX((static_cast<float>(place.x - part.x) + 0.5f) * cell - ImGui::GetScrollX());
  }
  // Where tile 0 of the whole sheet would be.
  const ImVec2 at{min.x - static_cast<float>(part.x) * cell, min.y - static_cast<float>(part.y) * cell};
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("sheet", {width, height},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.item(area.sheet == SheetId::tiles ? "sheet/tiles" : "sheet/sprites");
  handle_mouse(session, actions, ui, part, at, cell);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const UvRect uv = ui.uv_of(area.sheet, part);
  list.AddImage(ui.sheet(area.sheet), min, max, uv.from, uv.to);
  list.PushClipRect({min.x - ui.px(2), min.y - ui.px(2)}, {max.x + ui.px(2), max.y + ui.px(2)}, true);
  if (area.sheet == SheetId::tiles && session.choices().overlays.has(overlay::shapes)) {
    const std::uint32_t color = overlay_color(overlay::shapes, session.choices().overlay_palette);
    draw_sheet_shapes(list, session.level(), at, cell, color, ui);
  }
  if (session.choices().grid) draw_grid(list, part, min, cell);
  if (const auto pattern = session.choices().flag_overlay)
    tint_tiles(list, session.level().sheet(area.sheet), *pattern, part, at, cell);
  if (area.sheet == SheetId::tiles) draw_marks(session, part, at, cell, ui);
  mark_stamp(list, session.choices(), at, cell, ui);
  draw_frame(list, area.tiles, at, cell, theme::color(theme::kText), ui);
  list.PopClipRect();
  const CanvasView view{min, max, {at.x, at.y}, zoom};
  const CellRect pixels{part.x * kCartTileSize, part.y * kCartTileSize, part.w * kCartTileSize,
                        part.h * kCartTileSize};
  ui.view.canvas.cursor.visit("sheet", view, {pixels, {kCartTileSize, kCartTileSize}},
                              ImGui::GetIO().MousePos);
  ui.view.canvas.cursor.draw("sheet", list, view, ui.scale);
}

// Dims what is not found or not used, and gives used tiles a corner.
void SheetPanel::draw_marks(const Session& session, CellRect tiles, ImVec2 at, float cell, const Ui& ui) {
  const bool marks = ui.view.sprites.marks_used;
  if (!marks && !finder_.is_searching()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const SheetLayout& sheet = ui.layout(SheetId::tiles);
  const ImU32 dim = theme::color(theme::kDark, 190), color = theme::color(theme::kAccent);
  const float corner = std::max(3.0f, cell / 4);
  for_each_visible(list, sheet, tiles, at, cell, [&](int tile, ImVec2 from) {
    const bool is_used = marks && finder_.uses_of(session, tile) > 0;
    if ((marks && !is_used) || (finder_.is_searching() && !finder_.is_found(tile)))
      list.AddRectFilled(from, {from.x + cell, from.y + cell}, dim);
    if (is_used) list.AddTriangleFilled(from, {from.x + corner, from.y}, {from.x, from.y + corner}, color);
  });
}

// As buttons if they fit, else as a list; then a button for the menu of the shown one.
void SheetPanel::draw_tabs(const Session& session, Actions& actions, Ui& ui) {
  const auto& sets = session.level().tilesets;
  int& shown = ui.view.sprites.tileset;
  if (shown >= static_cast<int>(sets.size())) shown = -1;
  if (sets.empty()) return;
  constexpr int kMostButtons = 16;
  const float menu = ui.px(24), gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x - menu - gap;
  const auto name_of = [&](int set) {
    const std::string name = set < 0 ? "All" : sets[static_cast<std::size_t>(set)].name;
    return name.empty() ? "tileset " + std::to_string(set + 1) : shown_text(name);
  };
  const int count = static_cast<int>(sets.size());
  float width = 0;
  for (int set = -1; set < std::min(count, kMostButtons); ++set)
    width += size_of_text(name_of(set)).x + ui.px(16) + gap;
  if (count > kMostButtons || width > room) {
    if (ui.begin_combo("sheet/tileset", shown < 0 ? "All tiles" : name_of(shown), room,
                       "The tileset whose tiles are shown.")) {
      draw_rows(count + 1, [&](int row) {
        if (selectable(name_of(row - 1), std::to_string(row), row - 1 == shown)) shown = row - 1;
        ui.item("sheet/tileset" + std::to_string(row - 1));
      });
      ImGui::EndCombo();
    }
  } else {
    for (int set = -1; set < count; ++set) {
      if (set >= 0) ImGui::SameLine();
      if (ui.text_button("sheet/tileset" + std::to_string(set), name_of(set), set == shown,
                         set < 0 ? "All tiles of the level." : "The tiles of this tileset."))
        shown = set;
    }
  }
  if (shown < 0 || session.level().tiled != nullptr) return;  // Tiled owns the tilesets of its maps
  ImGui::SameLine();
  if (ui.text_button("sheet/tileset_menu", "...", false, "Renames or removes the tileset.", {}, true, menu)) {
    tileset_name_ = sets[static_cast<std::size_t>(shown)].name;
    ImGui::OpenPopup("tileset menu");
  }
  if (!ImGui::BeginPopup("tileset menu")) return;
  draw_tileset_menu(session, shown, actions, ui);
  ImGui::EndPopup();
}

void SheetPanel::draw_tileset_menu(const Session& session, int index, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const Tileset& set = level.tilesets[static_cast<std::size_t>(index)];
  ImGui::SetNextItemWidth(ui.px(200));
  if (input_text("name", "no name", tileset_name_, ImGuiInputTextFlags_EnterReturnsTrue)) {
    std::vector<Tileset> renamed = level.tilesets;
    renamed[static_cast<std::size_t>(index)].name = tileset_name_;
    const Edit edit = single_change("Rename tileset", TilesetsChange{level.tilesets, std::move(renamed)});
    if (!edit.empty()) actions.push_back(action::EditLevel{edit});
  }
  ui.item("sheet/tileset_name", "The tileset's name.", "Enter");
  if (set.link) ui.hint("linked to " + shown_text(set.link->path));
  std::size_t uses = 0;
  for (int tile = set.first; tile < set.first + set.count; ++tile) uses += finder_.uses_of(session, tile);
  if (uses > 0)
    draw_text(std::to_string(uses) +
                  (uses == 1 ? " cell uses it, and becomes" : " cells use it, and become") +
                  " empty if it is removed.",
              theme::tone(theme::kMuted));
  if (ui.text_button("sheet/remove_tileset", "Remove the tileset", false,
                     "Removes the tileset with its tiles; undoable.")) {
    auto without = std::make_shared<const Level>(without_tileset(level, static_cast<std::size_t>(index)));
    actions.push_back(action::EditLevel{replace_by(level, std::move(without), "Remove tileset")});
    ImGui::CloseCurrentPopup();
  }
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

void SheetPanel::handle_mouse(const Session& session, Actions& actions, Ui& ui, CellRect part, ImVec2 at,
                              float cell) {
  const SheetId sheet = session.choices().area.sheet;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse = io.MousePos;
  const SheetLayout layout = session.level().sheet(sheet).layout();
  const auto clamped = [&](float from, float to, int first, int count) {
    return std::clamp(static_cast<int>(std::floor((to - from) / cell)), first, first + count - 1);
  };
  const Cell tile =
      layout.nearest({clamped(at.x, mouse.x, part.x, part.w), clamped(at.y, mouse.y, part.y, part.h)});
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
  } else if (sheet == SheetId::tiles && ImGui::IsItemHovered() && !io.MouseDown[0]) {
    ui.tooltip(finder_.text_of(session, number));
  }
  if (!ImGui::IsItemActive()) drag_from_.reset();
}

}  // namespace talus
