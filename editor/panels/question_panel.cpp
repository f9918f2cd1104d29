// A modal with its answers.
#include "question_panel.h"

#include <array>
#include <span>

#include "dialog.h"

namespace talus {
namespace {

struct AnswerChoice {
  const char* widget;
  const char* label;
  const char* help;
  action::Answer answer;
  ImGuiKey key;  // ImGuiKey_COUNT: none
};
constexpr std::array<AnswerChoice, 3> kUnsavedAnswers = {
    {{"question/save", "Save", "Saves, then goes on.", action::Answer::save, ImGuiKey_Enter},
     {"question/discard", "Discard", "Goes on without saving.", action::Answer::discard, ImGuiKey_COUNT},
     {"question/cancel", "Cancel", "Goes back to the level.", action::Answer::cancel, ImGuiKey_Escape}}};
constexpr std::array<AnswerChoice, 2> kChangedAnswers = {
    {{"question/reload", "Read again", "Takes what the file has now; Undo brings your changes back.",
      action::Answer::reload, ImGuiKey_COUNT},
     {"question/keep", "Keep mine", "Leaves the level as it is here; the next save replaces the file.",
      action::Answer::keep, ImGuiKey_Escape}}};

constexpr std::array<AnswerChoice, 2> kDropAnswers = {
    {{"question/drop", "Drop it", "Forgets the run.", action::Answer::discard, ImGuiKey_Enter},
     {"question/cancel", "Cancel", "Keeps the run.", action::Answer::cancel, ImGuiKey_Escape}}};

constexpr std::array<AnswerChoice, 2> kReplaceAnswers = {
    {{"question/replace", "Replace", "Writes the export over them.", action::Answer::replace, ImGuiKey_COUNT},
     {"question/cancel", "Cancel", "Writes nothing.", action::Answer::cancel, ImGuiKey_Escape}}};

constexpr std::array<AnswerChoice, 3> kRunAnswers = {
    {{"question/save", "Save as...", "Asks for a file, then goes on.", action::Answer::save, ImGuiKey_Enter},
     {"question/discard", "Discard", "Goes on without the recording.", action::Answer::discard,
      ImGuiKey_COUNT},
     {"question/cancel", "Cancel", "Goes back to it.", action::Answer::cancel, ImGuiKey_Escape}}};

// By Question::Kind; each has a title of its own, so that a new dialog opens where one follows another.
struct QuestionDialog {
  const char* title;
  std::span<const AnswerChoice> choices;
};
constexpr std::array<QuestionDialog, 5> kQuestionDialogs = {{{"Unsaved changes", kUnsavedAnswers},
                                                             {"Changed by another program", kChangedAnswers},
                                                             {"Drop a run", kDropAnswers},
                                                             {"Replace files", kReplaceAnswers},
                                                             {"Keep the recording", kRunAnswers}}};

const char* key_label(ImGuiKey key) {
  return key == ImGuiKey_Enter ? "Enter" : key == ImGuiKey_Escape ? "Esc" : "";
}

void draw_answers(std::span<const AnswerChoice> choices, Actions& actions, Ui& ui) {
  for (const AnswerChoice& choice : choices) {
    const bool is_first = &choice == choices.data();
    if (!is_first) ImGui::SameLine();
    if (ui.text_button(choice.widget, choice.label, is_first, choice.help, key_label(choice.key), true,
                       ui.px(96)) ||
        (choice.key != ImGuiKey_COUNT && key_pressed(choice.key)))
      actions.push_back(action::AnswerQuestion{choice.answer});
  }
}

}  // namespace

void QuestionPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto& question = session.question();
  for (const QuestionDialog& dialog : kQuestionDialogs) {
    const bool asked = question && static_cast<std::size_t>(question->kind) ==
                                       static_cast<std::size_t>(&dialog - kQuestionDialogs.data());
    if (!begin_dialog(dialog.title, asked, {0, 0}, ui)) continue;
    if (asked) {
      ImGui::TextUnformatted(question->text.c_str());
      ImGui::Spacing();
      draw_answers(dialog.choices, actions, ui);
    }
    ImGui::EndPopup();
  }
}

}  // namespace talus
