// A flag to search, how often it is used, and the list of its tiles.
#include "flag_search_panel.h"

#include <string>

#include "flag_choice.h"
#include "flag_label.h"
#include "level/level_text.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

std::string place_text(const Level& level, SearchedLayers layers) {
  if (level.layers.count() == 1) return " of the map";
  return layers == SearchedLayers::all ? " of all layers" : " of the chosen layer";
}

// Selects a tile, and shows its next cell, if the map has one.
void show_tile(int tile, FlagPattern pattern, const Session& session, Actions& actions, Ui& ui) {
  actions.push_back(action::SelectTiles{{SheetId::tiles, ui.place_on_sheet(tile)}});
  if (const auto cell = find_flagged_cell(session.level(), pattern, ui.view.canvas.search_start(), true, tile,
                                          ui.view.level.flag_layers))
    ui.view.show_on_map(*cell);
}

}  // namespace

void FlagSearchPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_choice(session, actions, ui);
  const auto pattern = session.choices().flag_overlay;
  if (!pattern) {
    ui.hint("Choose a flag to see which tiles have it, and where they are on the map.");
    return;
  }
  draw_layer_choice(session, ui);
  count(session, *pattern, ui.view.level.flag_layers);
  if (use_.tiles.empty()) {
    ui.hint("No tile has it: click its lamp, or paint it on the sheet with Paint flags (" +
            keys_of("flags/brush"_command, ui) + ").");
    return;
  }
  const std::string text = count_text(use_.tiles.size(), "tile") + ", " +
                           count_text(use_.cell_count, "cell") +
                           place_text(session.level(), ui.view.level.flag_layers);
  ui.muted(text);
  ui.item("flag_search/count");
  draw_tiles(session, actions, ui);
}

void FlagSearchPanel::draw_choice(const Session& session, Actions& actions, Ui& ui) {
  const auto now = session.choices().flag_overlay;
  const float button = ui.px(theme::kButton),
              width = ImGui::GetContentRegionAvail().x - 2 * button - ui.px(8);
  draw_flag_choice("flag_search/flag", now ? pattern_label(session.level(), *now) : "no tint", width, session,
                   actions, ui);
  ImGui::SameLine(0, ui.px(4));
  command_text_button("flags/previous"_command, session, actions, ui,
                      {.label = "<", .widget = "flag_search/previous", .width = button});
  ImGui::SameLine(0, ui.px(4));
  command_text_button("flags/next"_command, session, actions, ui,
                      {.label = ">", .widget = "flag_search/next", .width = button});
}

// Of a map with several layers.
void FlagSearchPanel::draw_layer_choice(const Session& session, Ui& ui) {
  if (session.level().layers.count() == 1) return;
  SearchedLayers& layers = ui.view.level.flag_layers;
  bool chosen = layers == SearchedLayers::chosen;
  if (checkbox("in the chosen layer alone", "chosen layer", chosen))
    layers = chosen ? SearchedLayers::chosen : SearchedLayers::all;
  ui.item("flag_search/chosen_layer",
          "Whether cells are counted and looked for in the chosen layer alone; else in all layers.");
}

void FlagSearchPanel::count(const Session& session, FlagPattern pattern, SearchedLayers layers) {
  const int layer = session.level().layers.chosen;
  if (counted_ == pattern && layers_ == layers && layer_ == layer && revision_ == session.revision()) return;
  use_ = find_flag_use(session.level(), pattern, layers);
  counted_ = pattern;
  layers_ = layers;
  layer_ = layer;
  revision_ = session.revision();
}

void FlagSearchPanel::draw_tiles(const Session& session, Actions& actions, Ui& ui) const {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("tiles", 2, kFlags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupColumn("tile", ImGuiTableColumnFlags_WidthFixed, ui.px(64));
  ImGui::TableSetupColumn("cells", ImGuiTableColumnFlags_WidthStretch);
  const float side = ImGui::GetTextLineHeight();
  for (const int tile : use_.tiles) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string number = std::to_string(tile);
    if (selectable("", number, false, ImGuiSelectableFlags_SpanAllColumns))
      show_tile(tile, *counted_, session, actions, ui);
    ui.item("flag_search/tile" + number, "Selects tile " + number + ".", "click again for its next cell");
    const UvRect uv = ui.uv_of(tile);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddImage(ui.sheet(SheetId::tiles), at, {at.x + side, at.y + side}, uv.from, uv.to);
    add_text(list, {at.x + side + ui.px(8), at.y}, theme::tone(theme::kText), "#" + number);
    ImGui::TableSetColumnIndex(1);
    const std::size_t cells = use_.cells[static_cast<std::size_t>(tile)];
    ui.muted(cells == 0 ? "not on the map" : count_text(cells, "cell"));
  }
  ImGui::EndTable();
}

}  // namespace talus
