// Handles dragging, typing and the menu.
#include "number_field.h"

#include <imgui_internal.h>

#include <cmath>
#include <string>

#include "debug/number_text.h"

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
  if (draw_number_menu(std::string(field.name), value, field.standard, ui)) {
    edit = {session.next_stroke(), {}};
    edited = *field.standard;
    changed = true;
  }
  if (!changed || std::isnan(edited) || edited == value) return false;
  value = edited;
  return true;
}

bool draw_number_menu(const std::string& name, double value, std::optional<double> standard, Ui& ui) {
  if (!ImGui::BeginPopupContextItem()) return false;
  bool resets = false;
  if (standard) {
    resets = menu_item("Back to " + exact_text(*standard), "reset", {}, false, value != *standard);
    ui.item(name + "_reset");
  }
  if (menu_item("Copy", "copy")) ImGui::SetClipboardText(exact_text(value).c_str());
  ui.item(name + "_copy");
  ImGui::EndPopup();
  return resets;
}

}  // namespace talus
