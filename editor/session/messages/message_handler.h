// MessageHandler: the last message, and the question that waits for an answer.
#pragma once

#include <functional>
#include <optional>

#include "message.h"
#include "message_actions.h"

namespace talus {

class MessageHandler {
 public:
  void apply(const MessageAction& action);

  // Each replaces the message before.
  void tell(std::string text) { message_ = Message{std::move(text), false, false}; }
  void tell_error(std::string text) { message_ = Message{std::move(text), true, false}; }
  void add(const std::string& sentence);  // appends to the message; does nothing if there is none
  void offer_ground(std::string text) { message_ = Message{std::move(text), false, true}; }
  void dismiss_error();  // other messages stay
  const std::optional<Message>& message() const { return message_; }

  // Asks, and replaces the question before, whose answer nobody waits for any more. on_answer: called once,
  // when the question is gone.
  void ask(Question question, std::function<void(action::Answer)> on_answer);
  void take_back_question();
  const std::optional<Question>& question() const { return question_; }

 private:
  // For each action of MessageAction, in message_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  std::optional<Message> message_;
  std::optional<Question> question_;
  std::function<void(action::Answer)> on_answer_;  // set while there is a question
};

}  // namespace talus
