// Handles dragging and typing.
#include "number_field.h"

#include <imgui_internal.h>

#include <cmath>
#include <string>

namespace talus {

bool draw_number_field(const NumberField& field, double& value, const Session& session, NumberEdit& edit,
                       Ui& ui) {
  double edited = value;
  ImGui::SetNextItemWidth(ui.px(field.width));
  bool changed = ImGui::DragScalar(("##" + std::string(field.name)).c_str(), ImGuiDataType_Double, &edited,
                                   field.speed, nullptr, nullptr, field.format);
  if (ImGui::IsItemActivated()) edit = {session.next_stroke(), {}};
  if (changed && ImGui::TempInputIsActive(ImGui::GetItemID())) {
    edit.typed = edited;  // the first digits of a number are another number, which may not be allowed
    changed = false;
  }
  if (ImGui::IsItemDeactivated() && edit.typed) {
    edited = *edit.typed;
    edit.typed.reset();
    changed = true;
  }
  ui.item(field.name, field.help, "drag, or double click to type");
  if (!changed || std::isnan(edited) || edited == value) return false;
  value = edited;
  return true;
}

}  // namespace talus
