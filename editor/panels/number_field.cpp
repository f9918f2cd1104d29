#include "number_field.h"

#include <cmath>
#include <string>

namespace talus {

bool draw_number_field(const NumberField& field, double& value, const Session& session, int& stroke, Ui& ui) {
  double edited = value;
  ImGui::SetNextItemWidth(ui.px(field.width));
  const bool changed = ImGui::DragScalar(("##" + std::string(field.name)).c_str(), ImGuiDataType_Double,
                                         &edited, field.speed, nullptr, nullptr, field.format);
  if (ImGui::IsItemActivated()) stroke = session.next_stroke();
  ui.item(field.name, field.help, "drag, or double click to type");
  if (!changed || !std::isfinite(edited) || edited == value) return false;
  value = edited;
  return true;
}

}  // namespace talus
