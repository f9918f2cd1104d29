#include "tab_hand.h"

#include <algorithm>
#include <utility>

namespace talus {
namespace {

constexpr float kFarEnough = 12;  // px at scale 1, from where a press is a drag

struct NamedPlace {
  TabPlace place;
  const char *key, *label;
};
constexpr NamedPlace kTabPlaces[] = {{TabPlace::left, "left", "Move to the left"},
                                     {TabPlace::right_top, "right_top", "Move to the right"},
                                     {TabPlace::right_bottom, "right_bottom", "Move to the lower right"},
                                     {TabPlace::dock, "dock", "Move to the bottom"},
                                     {TabPlace::closed, "close", "Close"}};

}  // namespace

void TabHand::take_tab(const std::string& panel, std::string_view title, Ui& ui) {
  const bool drags = ImGui::IsItemActive() && ImGui::IsMouseDragging(0, ui.px(kFarEnough));
  if (drags && !is_cancelled_) {
    dragged_ = panel;
    title_ = title;
  }
  draw_menu(panel, ui);
}

void TabHand::draw_menu(const std::string& panel, Ui& ui) {
  if (!ImGui::BeginPopupContextItem()) return;
  for (const NamedPlace& choice : kTabPlaces) {
    if (choice.place == TabPlace::closed) ImGui::Separator();
    if (menu_item(choice.label, choice.key)) move_tab(ui.view.window, panel, choice.place);
    ui.item("tabs/" + panel + "/" + choice.key, choice.place == TabPlace::closed
                                                    ? "Hides the panel. View > Panels brings it back."
                                                    : std::string_view());
  }
  ImGui::EndPopup();
}

void TabHand::end_frame(Ui& ui) {
  is_cancelled_ = is_cancelled_ && ImGui::GetIO().MouseDown[0];
  if (dragged_.empty()) return;
  const bool is_stopped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) ||
                          ImGui::GetTopMostPopupModal() != nullptr;
  if (is_stopped) {
    dragged_.clear();
    is_cancelled_ = true;
    return;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto area = std::ranges::find_if(areas_, [&](const Area& a) { return a.has(mouse); });
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  if (area != areas_.end()) {
    list.AddRectFilled(area->min, area->max, theme::tone(theme::kAccent, 60));
    list.AddRect(area->min, area->max, theme::tone(theme::kAccent), 0, 0, ui.px(2));
  }
  add_text(list, {mouse.x + ui.px(12), mouse.y}, theme::tone(theme::kText), title_);
  if (ImGui::GetIO().MouseDown[0]) return;
  if (area != areas_.end()) move_tab(ui.view.window, dragged_, area->place);
  dragged_.clear();
}

}  // namespace talus
