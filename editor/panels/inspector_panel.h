// The inspector: the chosen body's numbers and every contact of its last step, in order.
#pragma once

#include "panel.h"

namespace talus {

class InspectorPanel : public Panel {
 public:
  std::string_view id() const override { return "inspector"; }
  std::string_view title() const override { return "Inspector"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
