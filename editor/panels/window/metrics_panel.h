// A small window that tells what the window's frames and the simulation's steps cost.
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
