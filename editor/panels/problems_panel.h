// What is likely wrong in the level; a click shows the place.
#pragma once

#include "panel.h"

namespace talus {

class ProblemsPanel : public Panel {
 public:
  std::string_view id() const override { return "problems"; }
  std::string_view title() const override { return "Problems"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
