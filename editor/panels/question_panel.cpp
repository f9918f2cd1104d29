// A modal with three answers.
#include "question_panel.h"

#include "dialog.h"

namespace talus {

void QuestionPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  constexpr const char* kTitle = "Unsaved changes";
  if (!begin_dialog(kTitle, session.question().has_value(), {0, 0}, ui)) return;
  if (session.question()) {
    ImGui::TextUnformatted(session.question()->text.c_str());
    ImGui::Spacing();
    const float width = ui.px(96);
    const auto answer = [&](action::Answer a) { actions.push_back(action::AnswerQuestion{a}); };
    if (ui.text_button("question/save", "Save", true, "Saves, then goes on.", "Enter", true, width) ||
        key_pressed(ImGuiKey_Enter))
      answer(action::Answer::save);
    ImGui::SameLine();
    if (ui.text_button("question/discard", "Discard", false, "Goes on without saving.", {}, true, width))
      answer(action::Answer::discard);
    ImGui::SameLine();
    if (ui.text_button("question/cancel", "Cancel", false, "Goes back to the level.", "Esc", true, width) ||
        key_pressed(ImGuiKey_Escape))
      answer(action::Answer::cancel);
  }
  ImGui::EndPopup();
}

}  // namespace talus
