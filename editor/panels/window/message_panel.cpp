// A strip over the bottom of the canvas, or in a place without other windows.
#include "message_panel.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "edit/layer_ground.h"
#include "edit/layer_tools.h"
#include "panels/emit_edit.h"
#include "panels/ui/copy_all.h"

namespace talus {
namespace {

constexpr const char* kMessageWindow = "message";
constexpr float kMostLines = 10;  // of a message before it scrolls

// Whether another window lies there, apart from the window of all panels, which never comes to the front.
bool is_under_window(const ImRect& rect) {
  constexpr ImGuiWindowFlags kOthers = ImGuiWindowFlags_ChildWindow | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                       ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_Popup;
  const auto& windows = ImGui::GetCurrentContext()->Windows;
  return std::any_of(windows.begin(), windows.end(), [&](const ImGuiWindow* window) {
    return window->WasActive && (window->Flags & kOthers) == 0 &&
           window->Name != std::string_view(kMessageWindow) && !window->IsFallbackWindow &&
           window->Rect().Overlaps(rect);
  });
}

// The middle of the message's lower side: at the canvas's bottom, else at its top, else at the screen's
// bottom.
ImVec2 place_of_message(const Ui& ui) {
  const ImVec2 min = ui.canvas_min, max = ui.canvas_max;
  const ImGuiWindow* window = ImGui::FindWindowByName(kMessageWindow);
  const float height = window != nullptr ? window->Size.y : ImGui::GetFrameHeight() + ui.px(16);
  const float half = (window != nullptr ? window->Size.x : ui.px(240)) / 2;
  const float x = (min.x + max.x) / 2, gap = ui.px(8);
  const std::array bottoms = {max.y - gap, min.y + gap + height, ImGui::GetIO().DisplaySize.y - gap};
  const auto free = std::find_if(bottoms.begin(), bottoms.end(), [&](float y) {
    return !is_under_window({x - half, y - height, x + half, y});
  });
  return {x, free != bottoms.end() ? *free : bottoms.front()};
}

void draw_ground_button(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const std::string name = shown_line(layer_name(level, level.layers.chosen), kMostLabel);
  if (!ui.text_button("message/ground", "Make \"" + name + "\" ground", false,
                      "Makes all tiles of the chosen layer solid, which undo takes back. Layers chooses "
                      "another one."))
    return;
  Edit edit = make_tiles_ground(level);
  if (edit.empty())
    return actions.push_back(action::ShowMessage{
        "The layer \"" + name + "\" has no tiles that can become ground: choose another one under Layers.",
        true});
  emit_edit(actions, std::move(edit));
  actions.push_back(action::DismissMessage{});
}

}  // namespace

void MessagePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!session.message()) return;
  const Message message = *session.message();
  // Over the canvas it covers no field and no table.
  const ImVec2 min = ui.canvas_min, max = ui.canvas_max;
  const float width = max.x - min.x - ui.px(16);
  ImGui::SetNextWindowPos(place_of_message(ui), ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSizeConstraints({std::min(ui.px(240), width), 0}, {width, max.y - min.y});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::tone(message.is_error ? theme::kErrorNote : theme::kNote));
  ImGui::PushStyleColor(ImGuiCol_Border, theme::tone(message.is_error ? theme::kError : theme::kAccent));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin(kMessageWindow, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNavInputs);
  if (ui.icon_button("message/dismiss", Icon::close, false, "Dismisses the message.", "Esc"))
    actions.push_back(action::DismissMessage{});
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const float least_left = max.y - min.y - ui.px(16 + theme::kButton);
  draw_scrolled_text("text", message.text,
                     {width - ImGui::GetCursorPosX() - ui.px(8),
                      std::min(kMostLines * ImGui::GetTextLineHeight(), least_left)},
                     theme::tone(theme::kText));
  ui.item("message/text");
  draw_copy_all("message/copy_all", message.text, ui);
  if (message.offers_ground) draw_ground_button(session, actions, ui);
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

}  // namespace talus
