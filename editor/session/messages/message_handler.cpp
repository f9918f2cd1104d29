// Shows messages, asks, and passes on the answers.
#include "message_handler.h"

#include <utility>

namespace talus {

template <>
void MessageHandler::carry_out(const action::ShowMessage& a) {
  show({a.text, a.is_error, false});
}

template <>
void MessageHandler::carry_out(const action::DismissMessage& a) {
  if (!a.earlier) return message_.reset();
  if (*a.earlier < earlier_.size())
    earlier_.erase(earlier_.begin() + static_cast<std::ptrdiff_t>(*a.earlier));
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

// The same text again is one message, and a message of success only says what is seen anyway.
void MessageHandler::show(Message message) {
  if (message_ && (message_->is_error || message_->offers_ground)) earlier_.push_back(*std::move(message_));
  std::erase_if(earlier_, [&](const Message& before) { return before.text == message.text; });
  if (earlier_.size() > kMaxEarlier) earlier_.erase(earlier_.begin());
  message_ = std::move(message);
}

void MessageHandler::dismiss_errors() {
  if (message_ && message_->is_error) message_.reset();
  std::erase_if(earlier_, [](const Message& message) { return message.is_error; });
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
