// Actions: what the session tells, and the answers to what it asks.
#pragma once

#include <string>
#include <variant>

namespace talus {
namespace action {

struct ShowMessage {  // for what panels and the platform find out
  std::string text;
  bool is_error = false;
};
struct DismissMessage {};
// To "unsaved changes": save, discard or cancel. To "the file was changed": reload or keep. To "drop this
// run": discard or cancel. To "replace these files": replace or cancel. To "keep the recording", and to "the
// file cannot hold all of this level": save (as), discard or cancel. To "these exports came with the file":
// allow or cancel.
enum class Answer { save, discard, cancel, reload, keep, replace, allow };
struct AnswerQuestion {  // to Session::question()
  Answer answer = Answer::cancel;
};

}  // namespace action

// What MessageHandler carries out.
using MessageAction = std::variant<action::ShowMessage, action::DismissMessage, action::AnswerQuestion>;

}  // namespace talus
