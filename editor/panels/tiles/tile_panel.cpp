// Fields for what has no picture: all selected tiles get what is typed.
#include "tile_panel.h"

#include <algorithm>

#include "edit/tile_note_tools.h"
#include "panels/emit_edit.h"
#include "panels/sprites/tile_number.h"

namespace talus {
namespace {

constexpr float kClass = 128, kProbability = 112;  // px at scale 1

TileNumber first_tile(const Level& level, const SpriteArea& area) {
  return static_cast<TileNumber>(area.tile_at(level, 0, 0));
}

// "Tile 12", "Tiles 12 to 29, of which the first is shown".
std::string title_of(const Level& level, const SpriteArea& area) {
  const std::string first = std::to_string(first_tile(level, area));
  const int count = area.tiles.w * area.tiles.h;
  if (count == 1) return "Tile " + first;
  return std::to_string(count) + " tiles from " + first + ": the first is shown, all are changed";
}

}  // namespace

void TilePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  int& kept = ui.view.sprites.kept_tile;
  if (kept >= level.tile_count()) kept = -1;
  const SpriteArea area =
      kept < 0 ? session.choices().area : SpriteArea{SheetId::tiles, ui.place_on_sheet(kept)};
  if (area.sheet != SheetId::tiles) {
    ui.hint("Select a tile on the sheet of tiles: sprites have no class, properties and animations.");
    return;
  }
  if (area != shown_) {
    type_ = note_of(level.tile_notes, first_tile(level, area)).type;
    properties_.forget();
  }
  shown_ = area;
  ImGui::BeginChild("tile", ImGui::GetContentRegionAvail(), false, ImGuiWindowFlags_NavFlattened);
  draw_header(session, area, ui);
  draw_note(session, area, actions, ui);
  ui.heading("Properties");
  draw_properties(session, area, actions, ui);
  animation_.draw(session, first_tile(level, area), actions, ui);
  ImGui::EndChild();
}

void TilePanel::draw_header(const Session& session, const SpriteArea& area, Ui& ui) {
  int& kept = ui.view.sprites.kept_tile;
  bool keeps = kept >= 0;
  if (checkbox("stay", "keep", keeps)) kept = keeps ? first_tile(session.level(), area) : -1;
  ui.item("tile/keep", "Keeps this tile here while others are selected on the sheet, as for its animation.");
  ImGui::SameLine();
  ui.heading(title_of(session.level(), area));
}

void TilePanel::draw_note(const Session& session, const SpriteArea& area, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const TileNote& note = note_of(level.tile_notes, first_tile(level, area));
  ui.begin_row();
  ImGui::SetNextItemWidth(ui.px(kClass));
  input_text("class", "class", type_);
  ui.item("tile/class", "What games take the tile for, in Tiled its class.");
  if (ImGui::IsItemDeactivatedAfterEdit() && type_ != note.type)
    emit_edit(actions, set_tile_class(level, area, type_));
  else if (!ImGui::IsItemActive())
    type_ = note.type;  // Undo may have changed it
  ui.same_line_if_fits(ui.px(kProbability));
  const auto common = common_probability(level, area);
  double value = common.value_or(1);
  if (draw_number_field({"tile/probability", common ? "probability %.6g" : "probability differs",
                         "How often random painting takes the tile: 1 as most, 0 never, 2 twice as often.",
                         kProbability, 0.02f},
                        value, session, number_edit_, ui))
    emit_edit(actions, set_probability(level, area, std::clamp(value, 0.0, kMaxProbability)),
              number_edit_.stroke);
  ui.end_row();
}

void TilePanel::draw_properties(const Session& session, const SpriteArea& area, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  std::optional<std::string> wrong;
  const auto change = properties_.draw(
      "tile/tile", "tile", note_of(level.tile_notes, first_tile(level, area)).properties, "", wrong, ui);
  if (wrong) actions.push_back(action::ShowMessage{*wrong, true});
  if (!change) return;
  emit_edit(actions, change_tile_properties(
                         level, area, [&](const std::string& text) { return with_property(text, *change); }));
}

}  // namespace talus
