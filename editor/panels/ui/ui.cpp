// The shared controls, with their registration and tooltips.
#include "ui.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace talus {
namespace {

constexpr double kTooltipDelay = 0.45;   // s
constexpr float kMaxTooltipWidth = 320;  // px at scale 1

// A button that is switched on shows it under the mouse, too, a little brighter.
constexpr int kLitColors = 3;
void push_lit_button() {
  ImGui::PushStyleColor(ImGuiCol_Button, theme::tone(theme::kAccent, 150));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme::tone(theme::kAccent, 190));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, theme::tone(theme::kAccent, 220));
}

// The invisible part of a label: "##name".
std::string hidden(std::string_view name) { return "##" + std::string(name); }

}  // namespace

void Ui::place(std::string_view name, ImVec2 min, ImVec2 max, bool enabled) {
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  widgets.add({std::string(name), min, max, window->ClipRect.Min, window->ClipRect.Max,
               window->ScrollMax.y > 0, enabled});
}

void Ui::item(std::string_view name, std::string_view help, std::string_view key, bool enabled) {
  take_focus(name, enabled);
  if (!ImGui::IsItemVisible()) return;
  place(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), enabled);
  if (!help.empty()) show_tooltip_when_rested(ImHashStr(name.data(), name.size()), help, key);
}

void Ui::take_focus(std::string_view name, bool enabled) {
  const ImGuiID id = ImGui::GetItemID();
  const bool typed_into = view.requests.has<request::FocusField>(name);
  if (id == 0 || !enabled || !(typed_into || focuses_next_)) return;
  focuses_next_ = false;
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  ImGui::FocusWindow(window);
  ImGui::SetFocusID(id, window);
  context.NavDisableHighlight = false;
  if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY();
  if (!view.requests.take<request::FocusField>(name)) return;
  context.NavNextActivateId = id;  // the number is typed, not dragged
  context.NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
}

void Ui::tooltip(std::string_view help, std::string_view key) {
  show_tooltip_when_rested(ImHashStr(help.data(), help.size()), help, key);
}

void Ui::show_tooltip_when_rested(ImGuiID id, std::string_view help, std::string_view key) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (ImGui::IsAnyMouseDown()) {
    pressed_on_ = id;
    return;
  }
  if (ImGui::GetTopMostPopupModal() != nullptr) return;  // dialogs explain themselves
  rests_on_ = id;
  if (pressed_on_ != 0) return;  // who has used it, or what has come in its place, needs no help yet
  if (rested_on_ != id) return;  // a control on top of this one may come later in the frame
  if (time - rested_since_ < kTooltipDelay) return;
  place_tooltip();
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(kMaxTooltipWidth));
  draw_text(shown_text(help, kMaxTooltip));
  if (!key.empty()) draw_text(key, theme::tone(theme::kAccent));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

// Dear ImGui puts it beside the mouse, except beside a menu, which it would cover, and above the bars at the
// bottom.
void Ui::place_tooltip() const {
  const float width = ImGui::GetIO().DisplaySize.x;
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  if ((window.Flags & ImGuiWindowFlags_Popup) != 0) {
    const bool is_at_right = window.Pos.x + window.Size.x + px(kMaxTooltipWidth) > width;
    ImGui::SetNextWindowPos({is_at_right ? window.Pos.x - px(4) : window.Pos.x + window.Size.x + px(4),
                             ImGui::GetItemRectMin().y},
                            ImGuiCond_Always, {is_at_right ? 1.0f : 0.0f, 0});
    return;
  }
  if (ImGui::GetItemRectMin().y < bars_top) return;
  const float x = ImGui::GetIO().MousePos.x;
  ImGui::SetNextWindowPos({x, bars_top - px(4)}, ImGuiCond_Always, {x > width / 2 ? 1.0f : 0.0f, 1});
}

bool Ui::icon_button(std::string_view name, Icon icon, bool lit, std::string_view help, std::string_view key,
                     bool enabled) {
  const float side = px(theme::kButton);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(!enabled);
  if (lit) push_lit_button();
  const bool pressed = button("", name, {side, side});
  if (lit) ImGui::PopStyleColor(kLitColors);
  ImGui::EndDisabled();
  const float inset = px(4);
  draw_icon(*ImGui::GetWindowDrawList(), icon, {at.x + inset, at.y + inset}, side - 2 * inset,
            theme::tone(enabled ? theme::kText : theme::kMuted, enabled ? 255 : 110));
  item(name, help, key, enabled);
  return pressed && enabled;  // the focused item may be pressed by a key though it is disabled
}

bool Ui::text_button(std::string_view name, std::string_view label, bool lit, std::string_view help,
                     std::string_view key, bool enabled, float width, float height) {
  ImGui::BeginDisabled(!enabled);
  if (lit) push_lit_button();
  // The control stays the same, and keeps the focus, when its label changes.
  const bool pressed = button(label, name, {width, height > 0 ? height : px(theme::kButton)});
  if (lit) ImGui::PopStyleColor(kLitColors);
  ImGui::EndDisabled();
  item(name, help, key, enabled);
  return pressed && enabled;  // the focused item may be pressed by a key though it is disabled
}

bool Ui::begin_combo(std::string_view name, const std::string& shown, float width, std::string_view help,
                     std::string_view key) {
  const float height = px(theme::kButton), padding = (height - ImGui::GetFontSize()) / 2;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetNextItemWidth(width);
  if (view.requests.take<request::FocusField>(name)) {
    const ImGuiID id = ImGui::GetID(hidden(name).c_str());
    ImGui::OpenPopupEx(ImHashStr("##ComboPopup", 0, id), ImGuiPopupFlags_None);  // as BeginCombo() does
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(6), padding));
  const bool open = talus::begin_combo(name, shown, ImGuiComboFlags_HeightLarge);
  ImGui::PopStyleVar();
  if (open)  // the last item belongs to the list now
    place(name, at, {at.x + width, at.y + height});
  else
    item(name, help, key);
  return open;
}

void Ui::begin_row() {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(px(6), (px(theme::kButton) - ImGui::GetFontSize()) / 2));
  ImGui::AlignTextToFramePadding();
}

void Ui::end_row() { ImGui::PopStyleVar(); }

void Ui::label(std::string_view text) {
  // Dear ImGui lowers text after a button by the padding of its own, lower, buttons.
  const float lowered = ImGui::GetStyle().FramePadding.y;
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (px(theme::kButton) - ImGui::GetFontSize()) / 2 - lowered);
  draw_text(text);
}

void Ui::field_label(std::string_view text) {
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  draw_text(text);
  ImGui::SameLine(left + px(kFormLabel));
}

void Ui::heading(std::string_view text) {
  const auto& fonts = ImGui::GetIO().Fonts->Fonts;
  const bool has_bold = fonts.Size > kBoldFont;
  if (has_bold) ImGui::PushFont(fonts[kBoldFont]);
  draw_text(text, theme::tone(theme::kText));
  if (has_bold) ImGui::PopFont();
}

void Ui::muted(std::string_view text) { draw_text(text, theme::tone(theme::kMuted)); }

void Ui::hint(std::string_view text) { draw_wrapped_text(text, theme::tone(theme::kMuted)); }

void Ui::right_aligned(std::string_view text, ImU32 color) {
  const float width = size_of_text(text).x;
  const float room = ImGui::GetContentRegionAvail().x;
  if (room > width) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
  draw_text(text, color);
}

void Ui::same_line_if_fits(float width, float gap) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float space = ImGui::GetStyle().ItemSpacing.x + gap;
  if (ImGui::GetItemRectMax().x + space + width <= right) ImGui::SameLine(0, space);
}

CellRect Ui::place_on_sheet(int tile) const {
  const Cell place = layout(SheetId::tiles).place_of(tile);
  return {place.x, place.y, 1, 1};
}

UvRect Ui::uv_of(SheetId id, CellRect tiles) const {
  const float columns = static_cast<float>(layout(id).columns), rows = static_cast<float>(layout(id).rows());
  return {{static_cast<float>(tiles.x) / columns, static_cast<float>(tiles.y) / rows},
          {static_cast<float>(tiles.x + tiles.w) / columns, static_cast<float>(tiles.y + tiles.h) / rows}};
}

UvRect Ui::uv_of(int tile) const { return uv_of(SheetId::tiles, place_on_sheet(tile)); }

std::vector<std::string> Ui::wanted_dialogs(const Session& session) const {
  std::vector<std::string> titles;
  for (const auto& [title, is_wanted] : dialogs_)
    if (is_wanted(session, view)) titles.push_back(title);
  return titles;
}

bool Ui::wants_dialog(std::string_view title, const Session& session) const {
  const auto is_it = [&](const auto& dialog) {
    return dialog.first == title && dialog.second(session, view);
  };
  return std::any_of(dialogs_.begin(), dialogs_.end(), is_it) ||
         std::any_of(dialogs_before_.begin(), dialogs_before_.end(), is_it);
}

UiFrame::UiFrame(Ui& ui) : ui_(ui) {
  ui_.widgets.begin_frame();
  ui_.rests_on_ = 0;
  ui_.moves_ = false;
  ui_.dialogs_before_ = std::exchange(ui_.dialogs_, {});
  ui_.view.canvas.hover_before = std::exchange(ui_.view.canvas.hover, {});
}

UiFrame::~UiFrame() {
  if (ui_.rested_on_ != ui_.rests_on_) {
    ui_.rested_on_ = ui_.rests_on_;
    ui_.rested_since_ = ui_.time;
  }
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  const bool has_moved = moved.x != 0 || moved.y != 0;
  if (has_moved && !ImGui::IsAnyMouseDown() && ui_.rests_on_ != ui_.pressed_on_) ui_.pressed_on_ = 0;
  ui_.tooltip_pending_ = ui_.rested_on_ != 0 && ui_.time - ui_.rested_since_ < kTooltipDelay;
}

}  // namespace talus
