// The message: says what went wrong or was done, in a few sentences, with the others behind a button. An
// error stays until it is dismissed; above the message is a line for each that came before it.
#pragma once

#include <string>

#include "panels/panel.h"

namespace talus {

class MessagePanel : public Panel {
 public:
  std::string_view id() const override { return "message"; }
  std::string_view title() const override { return "Message"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_message(const Message& message, float width, float most_height, const Session& session,
                    Actions& actions, Ui& ui);
  void draw_text_of(const Message& message, float width, float most_height, Ui& ui);

  std::string opened_;  // the message that is shown with its details; empty: none
};

}  // namespace talus
