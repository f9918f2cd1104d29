// The status bar: what is under the mouse, the stamp, the file, the problems.
#pragma once

#include "panel.h"

namespace talus {

class StatusPanel : public Panel {
 public:
  std::string_view id() const override { return "status"; }
  std::string_view title() const override { return "Status"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
