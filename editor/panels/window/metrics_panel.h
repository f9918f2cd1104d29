// A small window that shows the cost of the window's frames and of the simulation's steps.
#pragma once

#include "panels/panel.h"

namespace talus {

class MetricsPanel : public Panel {
 public:
  std::string_view id() const override { return "metrics"; }
  std::string_view title() const override { return "Times of the window"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
