// Fields, the usual sizes as buttons, and what the map measures.
#include "new_level_panel.h"

#include <string>

#include "map_size.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr int kUsualSides[] = {8, 16, 24, 32, 48, 64};  // px
constexpr float kAnswer = 96;                           // px at scale 1

std::string px_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

// Why there is no level with these numbers, as a sentence; empty if there is one.
std::string problem_of(TileSize tile, int width, int height) {
  if (!is_tile_size(tile))
    return "A tile must be 1 to " + std::to_string(kMaxTileSide) + " px wide and high.";
  return problem_of_map_size(width, height, tile);
}

}  // namespace

void NewLevelPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto is_open = [](const Session&, const View& view) { return view.level.new_level_open; };
  if (!begin_dialog("New level", is_open, {0, 0}, session, ui)) return;
  draw_tile_sizes(ui);
  ImGui::Spacing();
  draw_map_sizes(ui);
  ImGui::Spacing();
  draw_content(ui);
  ImGui::Spacing();
  draw_answers(actions, ui);
  ImGui::EndPopup();
}

void NewLevelPanel::draw_tile_sizes(Ui& ui) {
  draw_text("A tile, in px");
  for (const int side : kUsualSides) {
    if (side != kUsualSides[0]) ImGui::SameLine();
    const TileSize usual{side, side};
    if (ui.text_button("new_level/tile" + std::to_string(side), px_text(side, side), tile_ == usual,
                       "Tiles of " + px_text(side, side) + " px."))
      tile_ = usual;
  }
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  draw_map_number("new_level/tile_width", "Width", tile_.width, "px, 1 to 256.", ui);
  draw_map_number("new_level/tile_height", "Height", tile_.height, "px, 1 to 256.", ui);
}

void NewLevelPanel::draw_map_sizes(Ui& ui) {
  draw_text("The map, in cells");
  draw_map_number("new_level/width", "Columns", width_, "Cells in a row. " + text_of_map_limits(), ui);
  draw_map_number("new_level/height", "Rows", height_, "Rows of cells. " + text_of_map_limits(), ui);
}

void NewLevelPanel::draw_content(Ui& ui) const {
  NewContent& content = ui.view.level.new_content;
  ImGui::Checkbox("Playable", &content.plays);
  ui.item("new_level/plays", "Begins with ground, slopes and a player; else the map is empty.");
  const bool has_palette = tile_ == TileSize{};
  bool in_true_colour = content.in_true_colour || !has_palette;
  ImGui::BeginDisabled(!has_palette);
  if (ImGui::Checkbox("True colour", &in_true_colour)) content.in_true_colour = in_true_colour;
  ImGui::EndDisabled();
  ui.item("new_level/true_colour",
          "Tiles in any colours; else in the 16 colours of a palette, as TIC-80 has them. Tiles that are not "
          "8x8 px are always in true colour.",
          "", has_palette);
}

void NewLevelPanel::draw_answers(Actions& actions, Ui& ui) {
  const std::string problem = problem_of(tile_, width_, height_);
  if (problem.empty())
    draw_map_note("The level has " + px_text(width_ * tile_.width, height_ * tile_.height) + " px.",
                  theme::kMuted);
  else
    draw_map_note(problem, theme::kError);
  const bool creates = dialog_button({.widget = "new_level/apply",
                                      .label = "New level",
                                      .help = "Starts a level with these tiles.",
                                      .letter = 'N',
                                      .is_default = true,
                                      .enabled = problem.empty(),
                                      .width = ui.px(kAnswer)},
                                     ui);
  ImGui::SameLine();
  const bool cancels = dialog_button({.widget = "new_level/cancel",
                                      .label = "Cancel",
                                      .help = "Keeps the level that is open.",
                                      .letter = 'C',
                                      .is_cancel = true,
                                      .width = ui.px(kAnswer)},
                                     ui);
  const NewContent& content = ui.view.level.new_content;
  if (creates) actions.push_back(action::NewLevel{tile_, width_, height_, content});
  if (creates && !content.plays) ui.view.sprites.pixels.unfolded = true;  // its tiles wait to be drawn
  if (creates || cancels) ui.view.level.new_level_open = false;
}

}  // namespace talus
