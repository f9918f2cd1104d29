// The status bar: what is under the mouse, the stamp, the file, the problems.
#pragma once

#include <string>

#include "panels/panel.h"

namespace talus {

// What is under the mouse, in words: "(12, 9)  tile 34 (solid, flag 2)   px 98, 74.5"; empty if it is on
// nothing.
std::string hover_text(const Session& session, const Hover& hover);

class StatusPanel : public Panel {
 public:
  std::string_view id() const override { return "status"; }
  std::string_view title() const override { return "Status"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
