// Draws the sheet and takes its mouse.
#include "sheet_panel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edit/pixel_color.h"
#include "edit/stamp.h"
#include "formats/tilesets/displaced_tile.h"
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

void draw_frame(ImDrawList& list, CellRect tiles, ImVec2 at, float cell, ImU32 color, const Ui& ui) {
  const ImVec2 from{at.x + static_cast<float>(tiles.x) * cell, at.y + static_cast<float>(tiles.y) * cell};
  const ImVec2 to{from.x + static_cast<float>(tiles.w) * cell, from.y + static_cast<float>(tiles.h) * cell};
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark), 0, 0,
               ui.px(1) + 2);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, color, 0, 0, ui.px(1));
}

// The tiles that the stamp paints, if the selection does not show them already.
void mark_stamp(ImDrawList& list, const Choices& choices, TileNumber displaced, ImVec2 at, float cell,
                const Ui& ui) {
  if (choices.area.sheet != SheetId::tiles ||
      choices.stamp == stamp_of_tiles(ui.layout(SheetId::tiles), choices.area.tiles, displaced))
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

// Where the chosen tiles are seen: a displaced tile in the place that its tileset gives it.
CellRect place_of_choice(CellRect tiles, TileNumber displaced, const Ui& ui) {
  const bool is_it = displaced != 0 && tiles == ui.place_on_sheet(displaced);
  return is_it ? CellRect{0, 0, 1, 1} : tiles;
}

// Calls use(tile, its corner) for the tiles of some columns and rows that can be seen.
template <class Use>
void for_each_visible(ImDrawList& list, const SheetLayout& sheet, CellRect part, ImVec2 at, float cell,
                      Use use) {
  const ImVec2 top_left = list.GetClipRectMin(), bottom_right = list.GetClipRectMax();
  const auto index = [cell](float pixels) { return static_cast<int>(std::floor(pixels / cell)); };
  const int left = std::max(part.x, index(top_left.x - at.x));
  const int right = std::min(part.x + part.w - 1, index(bottom_right.x - at.x));
  const int from = std::max(part.y, index(top_left.y - at.y));
  const int to = std::min(part.y + part.h - 1, index(bottom_right.y - at.y));
  for (int y = from; y <= to; ++y)
    for (int x = left; x <= right; ++x)
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
  draw_sheet(session, actions, ui);
}

void SheetPanel::draw_sheet(const Session& session, Actions& actions, Ui& ui) {
  const SheetId sheet = session.choices().area.sheet;
  displaced_ = sheet == SheetId::tiles ? displaced_tile(session.level()) : TileNumber{0};
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const ImVec2 room{std::max(1.0f, std::floor(left.x)), std::max(1.0f, std::floor(left.y))};
  camera_.begin(session, ui, shown_part(session, ui), room);
  follow_choice(session, ui);
  const ImVec2 at = ImGui::GetCursorScreenPos(), corner{std::floor(at.x), std::floor(at.y)};
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("sheet", room,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ui.item("sheet/canvas");
  if (camera_.take_mouse(session, ui, corner))
    drag_from_.reset();
  else
    handle_mouse(session, actions, ui, camera_.view(corner));
  const CellRect tiles = camera_.view(corner).tiles;
  const int side = session.level().map.tile_size().width;
  const CursorGround ground{{0, 0, tiles.w * side, tiles.h * side}, {side, side}};
  if (const auto moved =
          ui.view.canvas.cursor.visit("sheet", camera_.view(corner).canvas, ground, ImGui::GetIO().MousePos))
    camera_.show(*moved);
  const SheetView view = camera_.view(corner);
  ui.place(sheet == SheetId::tiles ? "sheet/tiles" : "sheet/sprites", view.min(), view.max());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(view.canvas.min, view.canvas.max, true);
  draw_layers(list, session, view, ui);
  ui.view.canvas.cursor.draw("sheet", list, view.canvas, ui.scale);
  list.PopClipRect();
}

// A choice that was not made here comes into sight.
void SheetPanel::follow_choice(const Session& session, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  const int asked = std::exchange(ui.view.sprites.shown_tile, -1);
  const bool is_new = asked >= 0 || area.tiles != shown_choice_;
  shown_choice_ = area.tiles;
  const CellRect part = shown_part(session, ui), place = place_of_choice(area.tiles, displaced_, ui);
  if (is_new && !drag_from_ && part.contains({place.x, place.y})) camera_.show(place);
}

void SheetPanel::draw_layers(ImDrawList& list, const Session& session, const SheetView& view, const Ui& ui) {
  const SpriteArea& area = session.choices().area;
  const CellRect part = view.tiles;
  const ImVec2 at = view.first();
  const float cell = view.cell();
  const UvRect uv = ui.uv_of(area.sheet, part);
  // Art is made for the dark of the canvas.
  if (theme::is_light()) list.AddRectFilled(view.min(), view.max(), theme::color(theme::kOutside));
  list.AddImage(ui.sheet(area.sheet), view.min(), view.max(), uv.from, uv.to);
  if (displaced_ != 0 && part.contains({0, 0})) {  // it is seen in its place, too
    const UvRect its = ui.uv_of(displaced_);
    list.AddImage(ui.sheet(area.sheet), at, {at.x + cell, at.y + cell}, its.from, its.to);
  }
  if (area.sheet == SheetId::tiles && session.choices().overlays.has(overlay::shapes)) {
    const std::uint32_t color = overlay_color(overlay::shapes, session.choices().overlay_palette);
    draw_sheet_shapes(list, session.level(), at, cell, color, ui);
  }
  if (session.choices().grid) draw_grid(list, part, view.min(), cell);
  if (const auto pattern = session.choices().flag_overlay)
    tint_tiles(list, session.level().sheet(area.sheet), *pattern, part, at, cell);
  if (area.sheet == SheetId::tiles) draw_marks(list, session, view, ui);
  mark_stamp(list, session.choices(), displaced_, at, cell, ui);
  draw_frame(list, place_of_choice(area.tiles, displaced_, ui), at, cell, theme::color(theme::kText), ui);
}

// Dims what is not found or not used, and gives used tiles a corner.
void SheetPanel::draw_marks(ImDrawList& list, const Session& session, const SheetView& view, const Ui& ui) {
  const bool marks = ui.view.sprites.marks_used;
  if (!marks && !finder_.is_searching()) return;
  const float cell = view.cell();
  const SheetLayout& sheet = ui.layout(SheetId::tiles);
  const ImU32 dim = theme::color(theme::kDark, 190), color = theme::color(theme::kAccent);
  const float corner = std::max(3.0f, cell / 4);
  for_each_visible(list, sheet, view.tiles, view.first(), cell, [&](int tile, ImVec2 from) {
    const bool is_used = marks && finder_.uses_of(session, tile) > 0;
    if ((marks && !is_used) || (finder_.is_searching() && !finder_.is_found(tile)))
      list.AddRectFilled(from, {from.x + cell, from.y + cell}, dim);
    if (is_used) list.AddTriangleFilled(from, {from.x + corner, from.y}, {from.x, from.y + corner}, color);
  });
}

// "All" and the tilesets as tabs, which scroll; very many are a list.
void SheetPanel::draw_tabs(const Session& session, Actions& actions, Ui& ui) {
  constexpr int kMaxTabsInRow = 64;
  const auto& sets = session.level().tilesets;
  int& shown = ui.view.sprites.tileset;
  if (shown >= static_cast<int>(sets.size())) shown = -1;
  if (sets.empty()) return;
  std::vector<std::string> names{"All"};
  for (std::size_t set = 0; set < sets.size(); ++set)
    names.push_back(sets[set].name.empty() ? "tileset " + std::to_string(set + 1) : sets[set].name);
  const bool opens_menu = names.size() > kMaxTabsInRow ? draw_tileset_list(session, names, ui)
                                                       : draw_tileset_tabs(session, names, ui);
  if (opens_menu && shown >= 0) {
    tileset_name_ = sets[static_cast<std::size_t>(shown)].name;
    ImGui::OpenPopup("tileset menu");
  }
  if (!ImGui::BeginPopup("tileset menu")) return;
  if (shown >= 0) draw_tileset_menu(session, shown, actions, ui);
  ImGui::EndPopup();
}

// Tiled owns the tilesets of its maps.
bool SheetPanel::has_tileset_menu(const Session& session, const Ui& ui) {
  return ui.view.sprites.tileset >= 0 && session.level().tiled == nullptr;
}

// Returns whether the menu of the shown tileset was asked for.
bool SheetPanel::draw_tileset_tabs(const Session& session, std::span<const std::string> names, Ui& ui) {
  int& shown = ui.view.sprites.tileset;
  const bool is_asked = std::exchange(shown_tab_, shown) != shown;
  bool opens_menu = false;
  if (!ImGui::BeginTabBar("tilesets", ImGuiTabBarFlags_FittingPolicyScroll | ImGuiTabBarFlags_NoTooltip))
    return false;
  int open = shown;
  for (int set = -1; set + 1 < static_cast<int>(names.size()); ++set) {
    const std::string widget = "sheet/tileset" + std::to_string(set);
    const bool wanted = is_asked && set == shown;
    const bool is_open = begin_tab_item(names[static_cast<std::size_t>(set + 1)], widget,
                                        wanted ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    ui.item(widget, set < 0 ? "All tiles of the level." : "The tiles of this tileset.");
    if (!is_open) continue;
    open = set;
    ImGui::EndTabItem();
  }
  if (!is_asked) shown = shown_tab_ = open;
  if (has_tileset_menu(session, ui)) {
    opens_menu = ImGui::TabItemButton("...", ImGuiTabItemFlags_Trailing | ImGuiTabItemFlags_NoTooltip);
    ui.item("sheet/tileset_menu", "Renames or removes the tileset.");
  }
  ImGui::EndTabBar();
  return opens_menu;
}

// The same.
bool SheetPanel::draw_tileset_list(const Session& session, std::span<const std::string> names, Ui& ui) {
  int& shown = ui.view.sprites.tileset;
  const float menu = ui.px(24), gap = ImGui::GetStyle().ItemSpacing.x;
  const std::string now = shown < 0 ? "All tiles" : shown_line(names[static_cast<std::size_t>(shown + 1)]);
  if (ui.begin_combo("sheet/tileset", now, ImGui::GetContentRegionAvail().x - menu - gap,
                     "The tileset whose tiles are shown.")) {
    draw_rows(static_cast<int>(names.size()), [&](int row) {
      const std::string& name = names[static_cast<std::size_t>(row)];
      if (selectable(name, std::to_string(row), row - 1 == shown)) shown = row - 1;
      ui.item("sheet/tileset" + std::to_string(row - 1));
    });
    ImGui::EndCombo();
  }
  if (!has_tileset_menu(session, ui)) return false;
  ImGui::SameLine();
  return ui.text_button("sheet/tileset_menu", "...", false, "Renames or removes the tileset.", {}, true,
                        menu);
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
  const bool in_rgba = is_in_rgba(session.level(), area.sheet);
  std::vector<CommandId> buttons = {"sheet/zoom_out"_command, "sheet/zoom_in"_command};
  if (in_rgba) buttons.push_back("pixels/show"_command);
  buttons.push_back("pixels/enlarge"_command);
  const float needed =
      static_cast<float>(buttons.size()) * (ui.px(theme::kButton) + ImGui::GetStyle().ItemSpacing.x);
  if (needed > ImGui::GetContentRegionAvail().x)
    buttons.erase(buttons.begin(), buttons.begin() + 2);  // the wheel zooms, too
  for (const CommandId id : buttons) {
    command_button(id, session, actions, ui);
    ImGui::SameLine();
  }
  const std::string selection = selection_text(session.level(), area);
  if (size_of_text(selection).x > ImGui::GetContentRegionAvail().x) return ImGui::NewLine();
  ui.right_aligned(selection, theme::color(theme::kMuted));
  ui.tooltip("The selected tile, and how many tiles wide and high the selection is.");
}

void SheetPanel::handle_mouse(const Session& session, Actions& actions, Ui& ui, const SheetView& view) {
  const SheetId sheet = session.choices().area.sheet;
  const ImGuiIO& io = ImGui::GetIO();
  const SheetLayout layout = session.level().sheet(sheet).layout();
  const CellRect part = view.tiles;
  const Cell pointed = view.place_at(io.MousePos);
  const Cell tile = layout.nearest({std::clamp(pointed.x, part.x, part.x + part.w - 1),
                                    std::clamp(pointed.y, part.y, part.y + part.h - 1)});
  const auto tile_at = [&](Cell place) {
    return place == Cell{0, 0} && displaced_ != 0 ? int{displaced_} : layout.tile_at(place);
  };
  const int number = tile_at(tile);
  const bool paints = session.choices().map_tool == MapTool::flag;
  const bool hovered = ImGui::IsItemHovered() && part.contains(pointed);
  if (hovered) ui.view.canvas.hover.tile = number;
  if (hovered && (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1))) drag_from_ = tile;
  const bool selects = !paints || io.MouseDown[1];
  if (drag_from_ && selects) {
    const CellRect chosen = spanned(*drag_from_, tile);
    const bool is_displaced = displaced_ != 0 && chosen == CellRect{0, 0, 1, 1};
    actions.push_back(action::SelectTiles{{sheet, is_displaced ? ui.place_on_sheet(displaced_) : chosen}});
  }
  if (paints) {
    if (flag_brush_.active() && is_drag_cancelled()) flag_brush_.cancel(session, actions);
    flag_brush_.update(
        session, actions, sheet, tile,
        [&](Cell c) { return layout.contains(c) ? std::optional(tile_at(c)) : std::nullopt; },
        hovered && ImGui::IsMouseClicked(0), io.MouseDown[0]);
    ui.tooltip(flag_brush_.text(session, sheet, number), "the right button selects");
  } else if (sheet == SheetId::tiles && hovered && !io.MouseDown[0]) {
    ui.tooltip(finder_.text_of(session, number));
  }
  if (!ImGui::IsItemActive()) drag_from_.reset();
}

}  // namespace talus
