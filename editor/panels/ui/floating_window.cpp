#include "floating_window.h"

#include <algorithm>
#include <cfloat>

#include <imgui_internal.h>

namespace talus {
namespace {

// The place of a window that is shown already, moved between the edges of the program's window.
ImVec2 place_within(const ImGuiWindow& window, ImVec2 room) {
  return {std::clamp(window.Pos.x, 0.0f, std::max(room.x - window.Size.x, 0.0f)),
          std::clamp(window.Pos.y, 0.0f, std::max(room.y - window.Size.y, 0.0f))};
}

}  // namespace

bool begin_floating_window(const FloatingWindow& window) {
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  const ImGuiWindow* shown = ImGui::FindWindowByName(window.title);
  const bool is_placed = shown != nullptr && shown->WasActive && shown->SetWindowPosVal.x == FLT_MAX;
  if (is_placed) {
    ImGui::SetNextWindowPos(place_within(*shown, room));
  } else {
    ImGui::SetNextWindowPos({room.x * window.place.x, room.y * window.place.y}, ImGuiCond_Appearing,
                            window.pivot);
  }
  const bool fits_content = !(window.size.x > 0);
  if (!fits_content)
    ImGui::SetNextWindowSize({std::min(window.size.x, room.x), std::min(window.size.y, room.y)},
                             ImGuiCond_Appearing);
  ImGui::SetNextWindowSizeConstraints({std::min(window.least.x, room.x), std::min(window.least.y, room.y)},
                                      room);
  return ImGui::Begin(window.title, window.open,
                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | window.flags |
                          (fits_content ? ImGuiWindowFlags_AlwaysAutoResize : 0));
}

}  // namespace talus
