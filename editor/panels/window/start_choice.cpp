#include "start_choice.h"

namespace talus {
namespace {

struct StartLabel {
  StartsWith starts_with;
  const char* key;
  const char* label;
};
constexpr StartLabel kStartLabels[] = {{StartsWith::welcome, "welcome", "the welcome page"},
                                       {StartsWith::last_level, "last_level", "my last level"},
                                       {StartsWith::demo, "demo", "the demo level"}};

}  // namespace

void draw_start_choice(const std::string& widget, float width, Ui& ui) {
  StartsWith& chosen = ui.view.preferences.starts_with;
  const char* shown = kStartLabels[static_cast<std::size_t>(chosen)].label;
  if (!ui.begin_combo(widget, shown, width, "What Talus shows first when it is started without a file."))
    return;
  for (const StartLabel& choice : kStartLabels) {
    if (selectable(choice.label, {}, chosen == choice.starts_with)) chosen = choice.starts_with;
    ui.item(widget + "/" + choice.key);
  }
  ImGui::EndCombo();
}

}  // namespace talus
