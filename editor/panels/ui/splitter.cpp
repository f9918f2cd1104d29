// The bar between two regions.
#include "splitter.h"

namespace talus {

float splitter(std::string_view name, ImVec2 size, SplitterAxis axis, Ui& ui) {
  const bool sideways = axis == SplitterAxis::horizontal;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(std::string(name).c_str(), size);
  const bool active = ImGui::IsItemActive(), hot = active || ImGui::IsItemHovered();
  ui.item(name, "Drag to resize.");
  if (hot) ImGui::SetMouseCursor(sideways ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y},
                                            theme::tone(hot ? theme::kAccent : theme::kBackground));
  if (!active) return 0;
  return sideways ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
}

}  // namespace talus
