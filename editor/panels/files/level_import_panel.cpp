// Levels, layers, tiles, and the result.
#include "level_import_panel.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

#include "ldtk_mapping_table.h"
#include "panels/ui/copy_all.h"
#include "panels/ui/dialog.h"
#include "panels/ui/long_list.h"
#include "reading_panel.h"
#include "world_picture.h"

namespace talus {
namespace {

constexpr float kReportWidth = 520;  // px at scale 1
constexpr float kListLines = 8;      // of a list before it scrolls
constexpr float kWorldHeight = 200;  // px at scale 1

// What was read, or why it cannot be read, in sentences.
std::string text_of(const LevelImport& import) {
  if (!import.plan) {
    const FormatError& error = import.plan.error();
    return capitalized((error.place.empty() ? "the file" : error.place) + " " + error.message + ".");
  }
  const TileMap& map = import.plan->level.map;
  std::string text =
      "A level of " + std::to_string(map.width()) + "x" + std::to_string(map.height()) + " cells.";
  const char* separator = " Not in it: ";
  for (const std::string& what : import.plan->dropped) {
    text.append(separator).append(what);
    separator = "; ";
  }
  return import.plan->dropped.empty() ? text : text + ".";
}

std::string layer_label(const TiledLayerName& layer) {
  return (layer.name.empty() ? "without a name" : layer.name) + " (" + std::to_string(layer.cells) +
         (layer.cells == 1 ? " tile)" : " tiles)");
}

std::string level_label(const LdtkLevelName& level) {
  return (level.world.empty() ? "" : level.world + "/") + level.name + " (" + std::to_string(level.width) +
         "x" + std::to_string(level.height) + " px)";
}

}  // namespace

void LevelImportPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto asks = [](const Session& now, const View&) { return now.level_import() && !shows_reading(now); };
  if (!begin_dialog("What to open", asks, {0, 0}, session, ui)) return;
  if (const auto& import = session.level_import()) {
    const std::string name = shown_line(std::filesystem::path(import->path).filename().string(), kMaxLabel);
    const bool is_project = import->is_mapping || !import->levels.empty();
    ui.heading(is_project ? name + ", a project of LDtk" : name + " holds more than a level can");
    ImportChoices choices = import->choices;
    if (import->layers.size() > 1) draw_layers(*import, choices, ui);
    if (import->levels.size() > 1) draw_levels(*import, choices, ui);
    if (is_project)
      draw_mapping(*import, choices, ui);
    else
      draw_tiles(choices, ui);
    if (choices != import->choices) actions.push_back(action::SetLevelImport{choices});
    draw_report(*import, ui);
    draw_buttons(*import, actions, ui);
  }
  ImGui::EndPopup();
}

void LevelImportPanel::draw_levels(const LevelImport& import, ImportChoices& choices, Ui& ui) {
  ImGui::TextUnformatted("A level is one of the project's. Take:");
  choices.level_number = 1 + draw_world(import.levels, import.pictures, choices.level_number - 1,
                                        {ui.px(kReportWidth), ui.px(kWorldHeight)}, ui);
  const int count = static_cast<int>(import.levels.size());
  const float lines = std::min(static_cast<float>(count), kListLines);
  ImGui::BeginChild("levels", {ui.px(kReportWidth), lines * ImGui::GetFrameHeightWithSpacing()}, false,
                    ImGuiWindowFlags_NavFlattened);
  draw_rows(count, [&](int row) {
    const std::string number = std::to_string(row + 1);
    const std::string label = level_label(import.levels[static_cast<std::size_t>(row)]);
    if (radio_button(label, number, choices.level_number == row + 1)) choices.level_number = row + 1;
    ui.item("choose/level" + number, "Opens this level of the project.", "Space");
  });
  ImGui::EndChild();
  ImGui::Spacing();
}

void LevelImportPanel::draw_mapping(const LevelImport& import, ImportChoices& choices, Ui& ui) {
  const LdtkOrigin* const origin = import.plan ? import.plan->level.ldtk.get() : nullptr;
  if (origin == nullptr || origin->things.empty()) return;
  ImGui::TextUnformatted("What values, tags and entities stand for:");
  LdtkMapping mapping = choices.mapping.value_or(origin->mapping);
  const float lines = std::min(static_cast<float>(origin->things.size()), kListLines);
  if (draw_ldtk_mapping(origin->things, mapping,
                        {ui.px(kReportWidth), lines * ImGui::GetFrameHeightWithSpacing()}, ui))
    choices.mapping = mapping;
  ImGui::Spacing();
}

void LevelImportPanel::draw_layers(const LevelImport& import, ImportChoices& choices, Ui& ui) {
  ImGui::TextUnformatted("Take of the layers:");
  const int count = static_cast<int>(import.layers.size());
  const float lines = std::min(static_cast<float>(count), kListLines);
  if (radio_button("all of them", "0", choices.layer_number == 0)) choices.layer_number = 0;
  ui.item("choose/layer0", "The level has each as a layer.", "Space");
  ImGui::BeginChild("layers", {ui.px(kReportWidth), lines * ImGui::GetFrameHeightWithSpacing()}, false,
                    ImGuiWindowFlags_NavFlattened);
  draw_rows(count, [&](int row) {
    const std::string number = std::to_string(row + 1);
    const std::string label = layer_label(import.layers[static_cast<std::size_t>(row)]);
    if (radio_button(label, number, choices.layer_number == row + 1)) choices.layer_number = row + 1;
    ui.item("choose/layer" + number, "The level has this layer alone.", "Space");
  });
  ImGui::EndChild();
  ImGui::Spacing();
}

void LevelImportPanel::draw_tiles(ImportChoices& choices, Ui& ui) {
  ImGui::TextUnformatted("Take of the tiles:");
  if (ImGui::RadioButton("all of the tilesets that the map shows", !choices.used_tiles))
    choices.used_tiles = false;
  ui.item("choose/all_tiles",
          "Works with up to 65,536 tiles in all. Mirrored and turned ones become tiles of their own.",
          "Space");
  if (ImGui::RadioButton("those that the map shows, with new numbers", choices.used_tiles))
    choices.used_tiles = true;
  ui.item("choose/used_tiles", "The sheet has no others. Mirrored and turned ones become tiles of their own.",
          "Space");
  ImGui::Spacing();
}

void LevelImportPanel::draw_report(const LevelImport& import, Ui& ui) {
  const std::string text = text_of(import);
  draw_scrolled_text("report", text, {ui.px(kReportWidth), kListLines * ImGui::GetTextLineHeight()},
                     theme::tone(import.plan ? theme::kText : theme::kError));
  ui.item(import.plan ? "choose/report" : "choose/error");
  draw_copy_all("choose/copy_all", text, ui);
  ImGui::Spacing();
}

void LevelImportPanel::draw_buttons(const LevelImport& import, Actions& actions, Ui& ui) {
  const bool can_open = import.plan.has_value();
  const float width = ui.px(112);
  const DialogButton open{.widget = "choose/open",
                          .label = "Open",
                          .help = import.is_mapping
                                      ? "Reads the level with this mapping, which undo takes back."
                                      : "Opens it; LDtk's projects stay as they are.",
                          .letter = 'O',
                          .is_default = true,
                          .enabled = can_open,
                          .width = width,
                          .gets_the_keys = true};
  if (dialog_button(open, ui)) actions.push_back(action::ApplyLevelImport{});
  ImGui::SameLine();
  const DialogButton cancel{.widget = "choose/cancel",
                            .label = "Cancel",
                            .help = "Goes back to the level.",
                            .letter = 'C',
                            .is_cancel = true,
                            .width = width,
                            .gets_the_keys = !can_open};
  if (dialog_button(cancel, ui)) actions.push_back(action::CancelLevelImport{});
}

}  // namespace talus
