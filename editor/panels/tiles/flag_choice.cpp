// A list of all flags and values of fields.
#include "flag_choice.h"

#include "flag_label.h"
#include "panels/commands/commands.h"

namespace talus {

void draw_flag_choice(const std::string& name, const std::string& preview, float width,
                      const Session& session, Actions& actions, Ui& ui) {
  const auto now = session.choices().flag_overlay;
  const Command& tint = find_command("canvas/flag_tint"_command);
  const bool open =
      ui.begin_combo(name, preview, width, "Tints the cells and tiles that have a flag.", keys_of(tint, ui));
  if (!open) return;
  if (ImGui::Selectable("no tint", !now)) actions.push_back(action::SetFlagOverlay{});
  ui.item(name + "_none");
  int number = 0;
  for (const FlagPattern& pattern : flag_patterns(session.level())) {
    const std::string id = std::to_string(number++);
    if (selectable(pattern_label(session.level(), pattern), id, now == pattern))
      actions.push_back(action::SetFlagOverlay{pattern});
    ui.item(name + id);
  }
  ImGui::EndCombo();
}

}  // namespace talus
