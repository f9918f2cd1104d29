// MessageHandler: the last message, and the question that waits for an answer.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "message.h"
#include "message_actions.h"

namespace talus {

class MessageHandler {
 public:
  void apply(const MessageAction& action);

  // Each replaces the message before, which goes among the earlier ones if it waits for the user.
  // place: as Message::place.
  void tell(std::string text, std::string place = {}) {
    show({std::move(text), false, false, std::move(place)});
  }
  void tell_error(std::string text) { show({std::move(text), true, false}); }
  void offer_ground(std::string text) { show({std::move(text), false, true}); }
  void add(const std::string& sentence);  // appends to the message; does nothing if there is none
  void dismiss_errors();                  // also the earlier ones; other messages stay
  const std::optional<Message>& message() const { return message_; }
  // Those that were replaced before they were dismissed, the oldest first; at most kMaxEarlier.
  const std::vector<Message>& earlier() const { return earlier_; }

  // Asks, and replaces the question before, whose answer nobody waits for any more. on_answer: called once,
  // when the question is gone.
  void ask(Question question, std::function<void(action::Answer)> on_answer);
  void take_back_question();
  const std::optional<Question>& question() const { return question_; }

 private:
  // For each action of MessageAction, in message_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  static constexpr std::size_t kMaxEarlier = 3;

  void show(Message message);

  std::optional<Message> message_;
  std::vector<Message> earlier_;
  std::optional<Question> question_;
  std::function<void(action::Answer)> on_answer_;  // set while there is a question
};

}  // namespace talus
