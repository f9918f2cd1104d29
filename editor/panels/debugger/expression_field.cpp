#include "expression_field.h"

#include <algorithm>
#include <optional>

#include "debug/completion.h"
#include "panels/ui/text_focus.h"

namespace talus {
namespace {

constexpr std::size_t kMaxCandidates = 8;

void accept(const Completion& completion, const Candidate& candidate, std::string& text,
            std::size_t& cursor) {
  text.replace(completion.from, completion.to - completion.from, candidate.text);
  cursor = completion.from + candidate.text.size();
}

bool is_whole(const Completion& completion) {
  return completion.candidates.size() == 1 &&
         completion.candidates[0].text.size() == completion.to - completion.from;
}

std::optional<ExpressionError> error_of(const std::string& text, bool condition) {
  const auto parsed = condition ? Expression::parse_condition(text) : Expression::parse(text);
  if (parsed) return std::nullopt;
  return parsed.error();
}

}  // namespace

// Tab inserts the first candidate or, without one, goes on. ImGui calls this in every frame with the cursor.
int ExpressionField::on_edit(ImGuiInputTextCallbackData* data) {
  auto& field = *static_cast<ExpressionField*>(data->UserData);
  field.cursor_ = static_cast<std::size_t>(data->CursorPos);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory)
    field.way_ = data->EventKey == ImGuiKey_UpArrow ? FieldWay::up : FieldWay::down;
  if (data->EventFlag != ImGuiInputTextFlags_CallbackCompletion) return 0;
  const Completion completion =
      complete({data->Buf, static_cast<std::size_t>(data->BufTextLen)}, field.cursor_);
  if (completion.candidates.empty() || is_whole(completion)) {
    field.way_ = FieldWay::on;
    return 0;
  }
  const std::string& candidate = completion.candidates.front().text;
  data->DeleteChars(static_cast<int>(completion.from), static_cast<int>(completion.to - completion.from));
  data->InsertChars(static_cast<int>(completion.from), candidate.c_str());
  return 0;
}

bool ExpressionField::draw(std::string_view name, std::string& text, bool condition, float width,
                           std::string_view hint, Ui& ui) {
  way_ = FieldWay::none;
  ImGui::SetNextItemWidth(width);
  take_text_focus(name, ui);
  constexpr ImGuiInputTextFlags kFlags =
      ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_CallbackCompletion |
      ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_EnterReturnsTrue;
  const bool confirmed = input_text(name, hint, text, kFlags, on_edit, this);
  const bool left = ImGui::IsItemDeactivatedAfterEdit();
  const float edge = ImGui::GetItemRectMin().x;  // its message is below it
  const bool active = ImGui::IsItemActive();
  by_enter_ = confirmed;
  const auto error = text.empty() ? std::nullopt : error_of(text, condition);
  // The message about the text is below it, where help would cover it.
  constexpr std::string_view kHelp =
      "An expression such as \"vy > 3 && grounded\". Tab completes a name, or goes on if there is nothing to "
      "complete; Up and Down go to the other rows.";
  ui.item(name, error || active ? std::string_view() : kHelp);
  if (error) draw_error(text, *error, ui);
  if (active || open_) draw_candidates(name, edge, text, ui);
  if (error && confirmed) ui.ask(request::FocusField(name));  // so that the user can correct it
  open_ = active || (open_ && ImGui::IsMouseDown(0));
  return !error && (confirmed || (left && !text.empty()));
}

void ExpressionField::draw_error(const std::string& text, const ExpressionError& error, Ui& ui) const {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const auto width_to = [&](std::size_t at) { return size_of_text(std::string_view(text).substr(0, at)).x; };
  const float x = min.x + ImGui::GetStyle().FramePadding.x + width_to(error.position);
  const float end = std::max(x + ui.px(6), min.x + ImGui::GetStyle().FramePadding.x + width_to(text.size()));
  ImGui::GetWindowDrawList()->AddRectFilled({x, max.y - ui.px(2)}, {end, max.y}, theme::tone(theme::kError));
  ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kError));
  ImGui::SetCursorScreenPos({min.x, ImGui::GetCursorScreenPos().y});
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + max.x - min.x);
  draw_text("at " + std::to_string(error.position + 1) + ": " + error.message);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void ExpressionField::draw_candidates(std::string_view name, float edge, std::string& text, Ui& ui) {
  const Completion completion = complete(text, cursor_);
  const std::size_t count = std::min(completion.candidates.size(), kMaxCandidates);
  if (count == 0 || is_whole(completion)) return;
  ImGui::SetCursorScreenPos({edge, ImGui::GetCursorScreenPos().y});
  for (std::size_t i = 0; i < count; ++i) {
    const Candidate& candidate = completion.candidates[i];
    if (i > 0) ui.same_line_if_fits(size_of_text(candidate.label).x + ui.px(8));
    if (small_button(candidate.label)) {
      accept(completion, candidate, text, cursor_);
      ImGui::SetWindowFocus();
    }
    ui.item(std::string(name) + "/" + candidate.text, candidate.help);
  }
}

}  // namespace talus
