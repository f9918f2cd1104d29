#include "text_field.h"

#include "shown_text.h"

namespace talus {

bool draw_text_field(const TextField& field, std::string& typed, const std::string& now, Ui& ui) {
  ui.field_label(field.label);
  ImGui::SetNextItemWidth(2 * ui.px(kFormField) + ImGui::GetStyle().ItemSpacing.x);
  input_text(field.name, field.hint, typed);
  ui.item(field.name, field.help);
  if (ImGui::IsItemDeactivatedAfterEdit() && typed != now) return true;
  if (!ImGui::IsItemActive()) typed = now;  // Undo may have changed it
  return false;
}

}  // namespace talus
