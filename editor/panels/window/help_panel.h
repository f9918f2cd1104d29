// The help window: every key and what the mouse does.
#pragma once

#include "panels/panel.h"

namespace talus {

class HelpPanel : public Panel {
 public:
  std::string_view id() const override { return "help"; }
  std::string_view title() const override { return "Help"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
