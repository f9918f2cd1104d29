// A floating window of rows: a name at the left, a control at the right.
#include "settings_panel.h"

#include <array>

#include "gamepad_settings.h"
#include "panels/canvas/overlay_painter.h"
#include "panels/commands/commands.h"
#include "panels/ui/floating_window.h"
#include "start_choice.h"

namespace talus {
namespace {

constexpr float kSettingNames = 150, kSettingWidth = 250, kCommandLineWidth = 300;  // px at scale 1
constexpr std::array<double, 9> kSettingScales = {0, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4};

std::string scale_label(double scale) {
  return scale == 0 ? "by the window's height" : std::to_string(static_cast<int>(scale * 100)) + " %";
}

void setting_row(std::string_view name, Ui& ui) {
  ImGui::AlignTextToFramePadding();
  draw_text(name);
  ImGui::SameLine(ui.px(kSettingNames));
}

void draw_looks(const Session& session, Actions& actions, Ui& ui) {
  Preferences& preferences = ui.view.preferences;
  setting_row("Theme", ui);
  for (const auto& [kind, label, widget] : {std::tuple{ThemeKind::dark, "Dark", "settings/dark"},
                                            std::tuple{ThemeKind::light, "Light", "settings/light"}}) {
    if (ui.text_button(widget, label, preferences.theme == kind, "The colours of the panels.",
                       keys_of("view/light_theme"_command, ui), true, ui.px(72)))
      preferences.theme = kind;
    ImGui::SameLine();
  }
  ImGui::NewLine();
  setting_row("Size of everything", ui);
  if (ui.begin_combo("settings/scale", scale_label(ui.view.window.ui_scale), ui.px(kSettingWidth),
                     "How large text and controls are, for screens with many pixels.")) {
    for (double scale : kSettingScales) {
      if (selectable(scale_label(scale), {}, ui.view.window.ui_scale == scale))
        ui.view.window.ui_scale = scale;
      ui.item("settings/scale/" + std::to_string(static_cast<int>(scale * 100)));
    }
    ImGui::EndCombo();
  }
  if (ui.view.window.ui_scale > ui.scale) {
    setting_row("", ui);
    ui.hint("This window has room for " + scale_label(ui.scale) + ".");
  }
  setting_row("Size of text", ui);
  int size = static_cast<int>(preferences.font_size);
  ImGui::SetNextItemWidth(ui.px(kSettingWidth));
  if (ImGui::SliderInt("##font_size", &size, static_cast<int>(kMinFontSize), static_cast<int>(kMaxFontSize),
                       "%d px"))
    preferences.font_size = std::clamp<double>(size, kMinFontSize, kMaxFontSize);
  ui.item("settings/font_size", "The height of text, in controls of the same size.");
  setting_row("Overlays", ui);
  command_text_button("view/safe_colours"_command, session, actions, ui, {.widget = "settings/safe_colours"});
  ImGui::SetCursorPosX(ui.px(kSettingNames));
  const float swatch = ui.px(14);
  for (const Overlay* overlay : all_overlays()) {
    paint_overlay_swatch(*ImGui::GetWindowDrawList(), *overlay, ImGui::GetCursorScreenPos(), swatch,
                         session.choices().overlay_palette);
    ImGui::Dummy({swatch, swatch});
    ui.tooltip(overlay->label);
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

void draw_opening(Ui& ui) {
  setting_row("Start", ui);
  draw_start_choice("settings/start", ui.px(kSettingWidth), ui);
  setting_row("Opening", ui);
  checkbox("Play a level when it opens", "plays_opened", ui.view.preferences.plays_opened);
  ui.item("settings/plays_opened", "A level with bodies plays as soon as it is open. A recording waits.");
}

void draw_middle_button(Ui& ui) {
  setting_row("Middle button", ui);
  checkbox("Picks at once, as in TIC-80", "middle_picks", ui.view.preferences.middle_picks);
  ui.item("settings/middle_picks",
          "The middle button picks tiles and colours as it goes down, and a drag picks a rectangle of tiles. "
          "Otherwise a drag moves the view, and a click picks.");
}

void draw_layouts(const Session& session, Actions& actions, Ui& ui) {
  setting_row("Layout", ui);
  command_text_button("view/layout_draw"_command, session, actions, ui,
                      {.label = "Draw", .widget = "settings/layout_draw"});
  ImGui::SameLine();
  command_text_button("view/layout_play"_command, session, actions, ui,
                      {.label = "Play", .widget = "settings/layout_play"});
  ImGui::SameLine();
  command_text_button("view/layout_debug"_command, session, actions, ui,
                      {.label = "Debug", .widget = "settings/layout_debug"});
  ImGui::SameLine();
  command_text_button("view/reset_layout"_command, session, actions, ui,
                      {.label = "Reset", .widget = "settings/reset_layout"});
  setting_row("Keys", ui);
  command_text_button("edit/keys"_command, session, actions, ui,
                      {.label = "Change keys...", .widget = "settings/keys"});
}

}  // namespace

void SettingsPanel::draw_programs(Ui& ui) {
  Preferences& preferences = ui.view.preferences;
  ui.heading("Other programs: {file} is the level's file, {folder} its folder");
  for (const ProgramInfo& info : program_infos()) {
    const auto index = static_cast<std::size_t>(info.id);
    const std::string widget = "settings/" + std::string(info.key);
    setting_row(info.label, ui);
    ImGui::SetNextItemWidth(ui.px(kCommandLineWidth));
    input_text(widget, "", typed_[index]);
    if (ImGui::IsItemDeactivatedAfterEdit()) preferences.programs[index] = typed_[index];
    if (!ImGui::IsItemActive()) typed_[index] = preferences.programs[index];
    ui.item(widget, info.settings);
    ImGui::SameLine();
    if (ui.icon_button(widget + "_reset", Icon::restart, false, "Restores the default command.", {},
                       preferences.programs[index] != info.command))
      preferences.programs[index] = std::string(info.command);
  }
}

void SettingsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  bool& open = ui.view.window.settings_open;
  if (!open) return;
  if (begin_floating_window({.title = "Settings", .open = &open})) {
    ui.begin_row();
    draw_looks(session, actions, ui);
    ImGui::Separator();
    draw_opening(ui);
    draw_middle_button(ui);
    draw_layouts(session, actions, ui);
    ImGui::Separator();
    draw_gamepad_settings(ui.px(kSettingNames), ui.px(kSettingWidth), ui);
    ImGui::Separator();
    draw_programs(ui);
    ui.end_row();
  }
  ImGui::End();
}

}  // namespace talus
