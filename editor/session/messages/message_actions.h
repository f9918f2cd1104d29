// Actions: messages, and answers to questions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

namespace talus {
namespace action {

struct ShowMessage {  // for what panels and the platform find out
  std::string text;
  bool is_error = false;
};
struct DismissMessage {
  // Index in Session::earlier_messages(); an unknown one is ignored. Nothing: the message itself.
  std::optional<std::size_t> earlier = {};
};
// Which answers fit: to "unsaved changes" save, discard or cancel; to "the file was changed" reload or keep,
// and if both changed the same, cancel, too; to "drop this branch" discard or cancel; to "replace these
// files" replace or cancel; to "keep the recording", and to "the file cannot hold all of this level", save
// (as), discard or cancel; to "the file cannot hold this edit" save (as), allow or cancel; to "these exports
// came with the file", "the map names files elsewhere" and "this picture is a file of its own" allow or
// cancel.
enum class Answer { save, discard, cancel, reload, keep, replace, allow };
struct AnswerQuestion {  // to Session::question()
  Answer answer = Answer::cancel;
};

}  // namespace action

// The actions that MessageHandler carries out.
using MessageAction = std::variant<action::ShowMessage, action::DismissMessage, action::AnswerQuestion>;

}  // namespace talus
