// A modal with its answers.
#include "question_panel.h"

#include <algorithm>
#include <array>
#include <span>

#include "panels/files/asked_exports.h"
#include "panels/ui/copy_all.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr float kQuestionWidth = 520;  // px at scale 1, at most
constexpr float kQuestionLines = 12;   // of a question before it scrolls

struct AnswerChoice {
  const char* widget;
  const char* label;
  const char* help;
  action::Answer answer;
  char letter;  // of the label; pressing it answers
};
// Enter gives the first answer, which loses nothing for good.
constexpr std::array<AnswerChoice, 3> kUnsavedAnswers = {
    {{"question/save", "Save", "Saves, then goes on.", action::Answer::save, 'S'},
     {"question/discard", "Discard", "Goes on without saving.", action::Answer::discard, 'D'},
     {"question/cancel", "Cancel", "Goes back to the level.", action::Answer::cancel, 'C'}}};
constexpr std::array<AnswerChoice, 2> kChangedAnswers = {
    {{"question/reload", "Read again", "Reads the file as it is now; Undo brings your changes back.",
      action::Answer::reload, 'R'},
     {"question/keep", "Keep mine", "Leaves the level as it is here; the next save replaces the file.",
      action::Answer::keep, 'K'}}};

constexpr std::array<AnswerChoice, 2> kDropAnswers = {
    {{"question/cancel", "Cancel", "Keeps the branch.", action::Answer::cancel, 'C'},
     {"question/drop", "Drop it", "Deletes the branch.", action::Answer::discard, 'D'}}};

constexpr std::array<AnswerChoice, 2> kReplaceAnswers = {
    {{"question/cancel", "Cancel", "Writes nothing.", action::Answer::cancel, 'C'},
     {"question/replace", "Replace", "Writes the export over them.", action::Answer::replace, 'R'}}};

constexpr std::array<AnswerChoice, 3> kBranchAnswers = {
    {{"question/save", "Save as...", "Asks for a file, then goes on.", action::Answer::save, 'S'},
     {"question/discard", "Discard", "Goes on without the recording.", action::Answer::discard, 'D'},
     {"question/cancel", "Cancel", "Goes back to it.", action::Answer::cancel, 'C'}}};

constexpr std::array<AnswerChoice, 3> kUnstoredAnswers = {
    {{"question/save", "Save as...", "Asks for a name, then goes on.", action::Answer::save, 'S'},
     {"question/discard", "Go on", "Goes on, and loses what the file cannot hold.", action::Answer::discard,
      'G'},
     {"question/cancel", "Cancel", "Goes back to the level.", action::Answer::cancel, 'C'}}};

constexpr std::array<AnswerChoice, 2> kAllowAnswers = {
    {{"question/not_now", "Not now", "Writes none of their files. The level is saved nevertheless.",
      action::Answer::cancel, 'N'},
     {"question/allow", "Allow", "Writes them, now and later, as long as nobody else changes the presets.",
      action::Answer::allow, 'A'}}};

constexpr std::array<AnswerChoice, 3> kMergeAnswers = {
    {{"question/keep", "Mine", "Takes what is here in these places; Undo goes back.", action::Answer::keep,
      'M'},
     {"question/reload", "Theirs", "Takes what the file has in these places; Undo brings yours back.",
      action::Answer::reload, 'T'},
     {"question/cancel", "Not now", "Changes nothing; saving asks again.", action::Answer::cancel, 'N'}}};

constexpr std::array<AnswerChoice, 2> kPaintAnswers = {
    {{"question/paint", "Paint", "Paints it here; saving the level writes the file. Undo takes it back.",
      action::Answer::allow, 'P'},
     {"question/cancel", "Cancel", "Leaves the picture as it is.", action::Answer::cancel, 'C'}}};

constexpr std::array<AnswerChoice, 3> kBeyondAnswers = {
    {{"question/save", "Save as...", "Makes the edit, and asks for a name for a level of Talus.",
      action::Answer::save, 'S'},
     {"question/edit", "Edit anyway", "Makes the edit; the file cannot be saved until Undo takes it back.",
      action::Answer::allow, 'E'},
     {"question/cancel", "Cancel", "Leaves the level as it is.", action::Answer::cancel, 'C'}}};

constexpr std::array<AnswerChoice, 2> kReadAnswers = {
    {{"question/do_not_read", "Do not read",
      "Opens the map without them: numbered boxes stand for its tiles.", action::Answer::cancel, 'D'},
     {"question/read", "Read", "Reads them, now and later, for all maps in this folder.",
      action::Answer::allow, 'R'}}};

// By Question::Kind. Each has a title of its own, so that a new dialog opens when one question follows
// another.
struct QuestionDialog {
  const char* title;
  std::span<const AnswerChoice> choices;
};
constexpr std::array<QuestionDialog, 11> kQuestionDialogs = {
    {{"Unsaved changes", kUnsavedAnswers},
     {"Changed by another program", kChangedAnswers},
     {"Drop a branch", kDropAnswers},
     {"Replace files", kReplaceAnswers},
     {"Keep the recording", kBranchAnswers},
     {"Not all is saved", kUnstoredAnswers},
     {"Exports of this file", kAllowAnswers},
     {"Changed in both places", kMergeAnswers},
     {"Files outside of the map's folder", kReadAnswers},
     {"Paint a file", kPaintAnswers},
     {"More than the file can hold", kBeyondAnswers}}};

bool leaves_all_as_it_is(action::Answer answer, Question::Kind kind) {
  if (kind == Question::Kind::merge) return answer == action::Answer::cancel;
  return answer == action::Answer::cancel || answer == action::Answer::keep;
}

// For a question with a list, which scrolls.
ImVec2 size_of_list(const Ui& ui) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  return {std::min(ui.px(680), window.x - ui.px(32)), std::min(ui.px(380), window.y - ui.px(64))};
}

void draw_answers(std::span<const AnswerChoice> choices, Question::Kind kind, Actions& actions, Ui& ui) {
  for (const AnswerChoice& choice : choices) {
    const bool is_first = &choice == choices.data();
    if (!is_first) ImGui::SameLine();
    const DialogButton button{.widget = choice.widget,
                              .label = choice.label,
                              .help = choice.help,
                              .letter = choice.letter,
                              .is_default = is_first,
                              .is_cancel = leaves_all_as_it_is(choice.answer, kind),
                              .width = ui.px(96),
                              .gets_the_keys = is_first};
    if (dialog_button(button, ui)) actions.push_back(action::AnswerQuestion{choice.answer});
  }
}

}  // namespace

void QuestionPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto& question = session.question();
  for (const QuestionDialog& dialog : kQuestionDialogs) {
    const auto kind = static_cast<Question::Kind>(&dialog - kQuestionDialogs.data());
    const auto asks = [kind](const Session& now, const View&) {
      return now.question() && now.question()->kind == kind;
    };
    const bool asked = asks(session, ui.view);
    const bool has_list = asked && kind == Question::Kind::allow_exports;
    if (!begin_dialog(dialog.title, asks, has_list ? size_of_list(ui) : ImVec2{0, 0}, session, ui)) continue;
    if (asked) {
      draw_scrolled_text("text", question->text,
                         {has_list ? ImGui::GetContentRegionAvail().x : ui.px(kQuestionWidth),
                          kQuestionLines * ImGui::GetTextLineHeight()},
                         theme::tone(theme::kText));
      ui.item("question/text");
      draw_copy_all("question/copy_all", question->text, ui);
      ImGui::Spacing();
      if (has_list && session.asked_exports() != nullptr)
        draw_asked_exports(*session.asked_exports(), ui.px(theme::kButton) + ui.px(12), ui);
      draw_answers(dialog.choices, kind, actions, ui);
    }
    ImGui::EndPopup();
  }
}

}  // namespace talus
