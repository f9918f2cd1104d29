// The message bar: says what went wrong or was done. An error stays until it is dismissed.
#pragma once

#include "panels/panel.h"

namespace talus {

class MessagePanel : public Panel {
 public:
  std::string_view id() const override { return "message"; }
  std::string_view title() const override { return "Message"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
