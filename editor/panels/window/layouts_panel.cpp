#include "layouts_panel.h"

#include <optional>

#include "panels/ui/floating_window.h"
#include "tab_places.h"

namespace talus {
namespace {

constexpr float kLayoutName = 220, kLayoutSave = 72;  // px at scale 1

// The index of the layout that was dropped, if one was.
std::optional<std::size_t> draw_saved_layouts(View& view, Ui& ui) {
  std::optional<std::size_t> dropped;
  for (std::size_t i = 0; i < view.layouts.size(); ++i) {
    const SavedLayout& layout = view.layouts[i];
    const std::string widget = "layouts/saved" + std::to_string(i);
    ImGui::PushID(static_cast<int>(i));
    if (ui.text_button(widget, shown_line(layout.name, kMaxLabel), false, "Arranges the window like this.",
                       {}, true, ui.px(kLayoutName))) {
      show_layout(SavedLayout(layout), view);
      view.window.layouts_open = false;
    }
    ImGui::SameLine();
    if (ui.icon_button(widget + "/drop", Icon::clear, false, "Removes this layout from the list.", {}))
      dropped = i;
    ImGui::PopID();
  }
  return dropped;
}

}  // namespace

void LayoutsPanel::draw(const Session&, Actions&, Ui& ui) {
  View& view = ui.view;
  if (!view.window.layouts_open) return;
  if (begin_floating_window({.title = "Layouts",
                             .open = &view.window.layouts_open,
                             .place = {0.5f, 0.25f},
                             .pivot = {0.5f, 0}})) {
    if (view.layouts.empty()) ui.hint("Arrange the window as you like it, and save that with a name.");
    if (const auto dropped = draw_saved_layouts(view, ui))
      view.layouts.erase(view.layouts.begin() + static_cast<std::ptrdiff_t>(*dropped));
    ImGui::Separator();
    ui.begin_row();
    ImGui::SetNextItemWidth(ui.px(kLayoutName));
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered =
        input_text("name", "Name of a new layout", name_, ImGuiInputTextFlags_EnterReturnsTrue);
    ui.item("layouts/name", "A layout that has this name is replaced.");
    ImGui::SameLine();
    const bool saves = ui.text_button("layouts/save", "Save", false, "Saves how the window is arranged now.",
                                      {}, !name_.empty(), ui.px(kLayoutSave));
    ui.end_row();
    if ((saves || entered) && !name_.empty()) {
      save_layout(view, name_);
      name_.clear();
    }
  }
  ImGui::End();
}

}  // namespace talus
