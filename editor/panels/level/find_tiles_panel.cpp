// The two tiles, the number of cells with the first one, and the buttons.
#include "find_tiles_panel.h"

#include <string>

#include "edit/map_replace.h"
#include "edit/tile_search.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/commands/commands.h"
#include "panels/ui/floating_window.h"

namespace talus {
namespace {

constexpr float kFindLabel = 64;  // px at scale 1

std::string last_tile_text(const Ui& ui) { return std::to_string(ui.layout(SheetId::tiles).count - 1); }

TileNumber tile_of(int number) { return static_cast<TileNumber>(number); }

}  // namespace

// A picture of the tile, its number, and a button that takes the tile chosen on the sheet.
void FindTilesPanel::draw_tile(const std::string& name, const char* label, Field& field, int& tile,
                               const Session& session, Ui& ui) const {
  if (field.tile != tile || ImGui::IsWindowAppearing()) field = {tile, tile};  // a command has chosen it
  ImGui::AlignTextToFramePadding();
  draw_text(label);
  ImGui::SameLine(ui.px(kFindLabel));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ui.px(theme::kButton);
  ImGui::Dummy({side, side});
  const CanvasView view{at, {at.x + side, at.y + side}, {at.x, at.y}, side / kCartTileSize};
  draw_stamp(*ImGui::GetWindowDrawList(), {1, 1, {tile_of(tile)}}, {0, 0, 1, 1}, view, ui, 255);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ui.px(56));
  ImGui::InputInt(("##" + name).c_str(), &field.typed, 0);
  if (field.typed >= 0 && field.typed < session.level().tile_count()) field.tile = tile = field.typed;
  ui.item(name, "The number of the tile, 0 to " + last_tile_text(ui) + ".");
  ImGui::SameLine();
  if (ui.text_button(name + "_take", "Take chosen", false,
                     "Takes the tile that is chosen on the sheet or picked."))
    field.typed = field.tile = tile = session.choices().stamp.tiles.front().tile;
}

void FindTilesPanel::draw_count(std::size_t count, bool of_selection, Ui& ui) const {
  if (find_.is_tile() && replace_.is_tile()) {
    const std::string place = of_selection ? "the selection" : "the map";
    draw_text(std::to_string(count) + (count == 1 ? " cell" : " cells") + " of " + place);
    return;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kError));
  draw_text("Tiles have the numbers 0 to " + last_tile_text(ui) + ".");
  ImGui::PopStyleColor();
  ui.item("find_tiles/problem");
}

void FindTilesPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!ui.view.level.find_tiles_open) return;
  if (begin_floating_window({.title = "Find and replace tiles",
                             .open = &ui.view.level.find_tiles_open,
                             .place = {0.5f, ui.px(64) / ImGui::GetIO().DisplaySize.y},
                             .pivot = {0.5f, 0}})) {
    const Choices& choices = session.choices();
    const Level& level = session.level();
    const std::size_t count = count_tile(level.map, tile_of(ui.view.level.find_tile), choices.selection);
    ui.begin_row();
    draw_tile("find_tiles/find", "Find", find_, ui.view.level.find_tile, session, ui);
    draw_tile("find_tiles/replace", "Put", replace_, ui.view.level.replace_tile, session, ui);
    ui.end_row();
    const bool found = find_.is_tile() && count > 0;
    draw_count(count, choices.selection.has_value(), ui);
    command_text_button("map/find_previous"_command, session, actions, ui,
                        {.label = "Previous", .widget = "find_tiles/previous", .enabled = found});
    ImGui::SameLine();
    command_text_button("map/find_next"_command, session, actions, ui,
                        {.label = "Next", .widget = "find_tiles/next", .enabled = found});
    ImGui::SameLine();
    const bool differs = ui.view.level.find_tile != ui.view.level.replace_tile;
    if (ui.text_button("find_tiles/replace_all", "Replace all", false,
                       "Puts the second tile into all these cells; one Undo takes it back.", {},
                       found && replace_.is_tile() && differs)) {
      const Stamp put{1, 1, {tile_of(ui.view.level.replace_tile)}};
      actions.push_back(action::EditLevel{
          replace_tile(level, tile_of(ui.view.level.find_tile), {0, 0}, put, choices.selection)});
    }
    ui.place("find_tiles/window", ImGui::GetWindowPos(),
             {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
              ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  }
  ImGui::End();
}

}  // namespace talus
