// Three choices, each an edit, and the colour of the third.
#include "background_panel.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "edit/level_settings.h"
#include "panels/emit_edit.h"
#include "panels/ui/dialog.h"

namespace talus {

void BackgroundPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto is_open = [](const Session&, const View& view) { return view.level.background_open; };
  if (!begin_dialog("Background of the map", is_open, {0, 0}, session, ui)) return;
  draw_choices(session, actions, ui);
  draw_color(session, actions, ui);
  ImGui::Spacing();
  if (dialog_button({.widget = "background/close",
                     .label = "Close",
                     .help = "Changes stay; Undo takes them back.",
                     .is_default = true,
                     .is_cancel = true,
                     .width = ui.px(96),
                     .gets_the_keys = true},
                    ui))
    ui.view.level.background_open = false;
  ImGui::EndPopup();
}

void BackgroundPanel::draw_choices(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const auto choice = [&](const char* id, const char* label, const char* help, std::optional<Rgba> color,
                          bool is_chosen) {
    if (radio_button(label, id, is_chosen) && !is_chosen) emit_edit(actions, set_background(level, color));
    ui.item(id, help);
  };
  const bool is_clear = level.background && level.background->a == 0;
  choice("background/colour_0", "colour 0 of the palette", "Follows the palette, as in carts.", std::nullopt,
         !level.background);
  choice("background/clear", "nothing", "The map is clear there, and shows what is behind it.", Rgba{},
         is_clear);
  const Rgb of_palette = level.palette[0];
  choice("background/own", "a colour of its own", "Any colour, which may be partly clear.",
         Rgba{of_palette.r, of_palette.g, of_palette.b, 255}, level.background && !is_clear);
}

void BackgroundPanel::draw_color(const Session& session, Actions& actions, Ui& ui) {
  const Rgba now = background_of(session.level());
  std::array<float, 4> color = {now.r / 255.0f, now.g / 255.0f, now.b / 255.0f, now.a / 255.0f};
  ImGui::SetNextItemWidth(ui.px(180));
  const bool changed = ImGui::ColorEdit4(
      "##background_color", color.data(),
      ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_AlphaPreviewHalf);
  // Each press begins another undo, also in the window that the colour opens.
  if (ImGui::IsItemActivated() || ImGui::IsMouseClicked(0)) stroke_ = session.next_stroke();
  ui.item("background/color", "The colour as RRGGBBAA, with its opacity; a click on it opens a picker.");
  if (!changed) return;
  const auto byte = [](float part) { return static_cast<std::uint8_t>(std::lround(part * 255)); };
  emit_edit(
      actions,
      set_background(session.level(), Rgba{byte(color[0]), byte(color[1]), byte(color[2]), byte(color[3])}),
      stroke_);
}

}  // namespace talus
