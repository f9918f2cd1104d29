// The saved layouts: a floating window.
#pragma once

#include <string>

#include "panels/panel.h"

namespace talus {

class LayoutsPanel : public Panel {
 public:
  std::string_view id() const override { return "layouts"; }
  std::string_view title() const override { return "Layouts"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  std::string name_;  // of the layout to save, as it is typed
};

}  // namespace talus
