// A box at the bottom of the right column, whose panels make room for it.
#include "message_panel.h"

#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "edit/layer_ground.h"
#include "edit/layer_tools.h"
#include "panels/emit_edit.h"
#include "panels/ui/copy_all.h"

namespace talus {
namespace {

constexpr const char* kMessageWindow = "message";
constexpr float kFoldedLines = 4;     // of a message whose details are not shown
constexpr float kMaxLines = 10;       // of a message before it scrolls
constexpr std::size_t kMaxName = 24;  // bytes, of a layer on a button
constexpr float kGap = 8;             // px at scale 1

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

// y of the message's lower side: at the bottom of the right column, else at the screen's.
float bottom_of_message(const Ui& ui) {
  const ImVec2 min = ui.side_min, max = ui.side_max;
  const ImGuiWindow* window = ImGui::FindWindowByName(kMessageWindow);
  const float height = window != nullptr ? window->Size.y : ImGui::GetFrameHeight() + ui.px(16);
  const bool is_free = !is_under_window({min.x, max.y - height, max.x, max.y});
  return is_free ? max.y : ImGui::GetIO().DisplaySize.y - ui.px(kGap);
}

float height_of_text(std::string_view text, float width) {
  const std::string shown = shown_text(text);
  return ImGui::CalcTextSize(shown.data(), shown.data() + shown.size(), false, width).y;
}

// The sentences at the start that take few lines; at least the first.
std::string_view first_sentences(std::string_view text, float width) {
  const float most = kFoldedLines * ImGui::GetTextLineHeight();
  std::size_t end = 0;
  while (end < text.size()) {
    const std::size_t line = text.find('\n', end), stop = text.find(". ", end);
    const std::size_t next = std::min({line, stop == std::string_view::npos ? stop : stop + 1, text.size()});
    if (end > 0 && height_of_text(text.substr(0, next), width) > most) break;
    end = next;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\n')) ++end;
  }
  return text.substr(0, end);
}

void draw_ground_button(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const std::string name = shown_line(layer_name(level, level.layers.chosen), kMaxName);
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

// Those that wait for the user, one line each, above the message.
void draw_earlier(const std::vector<Message>& messages, Actions& actions, Ui& ui) {
  for (std::size_t i = 0; i < messages.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ui.icon_button("message/dismiss_earlier" + std::to_string(i), Icon::close, false,
                       "Dismisses the message.", ""))
      actions.push_back(action::DismissMessage{i});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    draw_short_text(messages[i].text, ImGui::GetContentRegionAvail().x,
                    theme::tone(messages[i].is_error ? theme::kError : theme::kText));
    ui.item("message/earlier" + std::to_string(i), messages[i].text);
    ImGui::PopID();
  }
  if (!messages.empty()) ImGui::Separator();
}

}  // namespace

void MessagePanel::draw_text_of(const Message& message, float width, float most_height, Ui& ui) {
  const bool is_open = message.text == opened_;
  const std::string_view first = first_sentences(message.text, width);
  const std::string_view shown = is_open ? std::string_view(message.text) : first;
  const float lines = is_open ? kMaxLines : kFoldedLines;
  draw_scrolled_text("text", shown, {width, std::min(lines * ImGui::GetTextLineHeight(), most_height)},
                     theme::tone(theme::kText));
  ui.item("message/text");
  if (first.size() == message.text.size()) return;
  if (ui.text_button("message/details", is_open ? "Less" : "Details", is_open,
                     "Shows all that the message says, or its first sentences alone."))
    opened_ = is_open ? std::string() : message.text;
}

void MessagePanel::draw_message(const Message& message, float width, float most_height,
                                const Session& session, Actions& actions, Ui& ui) {
  if (ui.icon_button("message/dismiss", Icon::close, false, "Dismisses the message.", "Esc"))
    actions.push_back(action::DismissMessage{});
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  draw_text_of(message, width - ImGui::GetCursorPosX() - ui.px(kGap),
               most_height - ui.px(2 * theme::kButton + 32), ui);
  draw_copy_all("message/copy_all", message.text, ui);
  if (message.offers_ground) draw_ground_button(session, actions, ui);
  if (!message.place.empty() && ui.text_button("message/copy_place", "Copy the path", false,
                                               "Copies where it was written: " + shown_line(message.place)))
    ImGui::SetClipboardText(message.place.c_str());
}

void MessagePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  ui.messages_height = 0;
  if (!session.message() && session.earlier_messages().empty()) return opened_.clear();
  const Message message = session.message().value_or(Message{});
  const ImVec2 min = ui.side_min, max = ui.side_max;
  const float bottom = bottom_of_message(ui), width = max.x - min.x - 2 * ui.px(kGap);
  const float most = (max.y - min.y) / 2 - ui.px(kGap);
  ImGui::SetNextWindowPos({min.x + ui.px(kGap), bottom}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, most});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::tone(message.is_error ? theme::kErrorNote : theme::kNote));
  ImGui::PushStyleColor(ImGuiCol_Border, theme::tone(message.is_error ? theme::kError : theme::kAccent));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin(kMessageWindow, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNavInputs);
  draw_earlier(session.earlier_messages(), actions, ui);
  if (session.message()) draw_message(message, width, most, session, actions, ui);
  if (bottom == max.y) ui.messages_height = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

}  // namespace talus
