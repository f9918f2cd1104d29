// Shows messages, asks, and passes on the answers.
#include "message_handler.h"

#include <utility>

namespace talus {

template <>
void MessageHandler::carry_out(const action::ShowMessage& a) {
  message_ = Message{a.text, a.is_error, false};
}

template <>
void MessageHandler::carry_out(const action::DismissMessage&) {
  message_.reset();
}

template <>
void MessageHandler::carry_out(const action::AnswerQuestion& a) {
  if (!question_) return;
  const auto on_answer = std::exchange(on_answer_, nullptr);
  question_.reset();
  on_answer(a.answer);
}

void MessageHandler::apply(const MessageAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

void MessageHandler::add(const std::string& sentence) {
  if (message_) message_->text += " " + sentence;
}

void MessageHandler::dismiss_error() {
  if (message_ && message_->is_error) message_.reset();
}

void MessageHandler::ask(Question question, std::function<void(action::Answer)> on_answer) {
  question_ = std::move(question);
  on_answer_ = std::move(on_answer);
}

void MessageHandler::take_back_question() {
  question_.reset();
  on_answer_ = nullptr;
}

}  // namespace talus
