// Shows how much of a large file is read, with a button that ends the reading.
#pragma once

#include "panels/panel.h"

namespace talus {

// Whether a file takes so long that the dialog is shown; for shorter ones it would flicker.
bool shows_reading(const Session& session);

class ReadingPanel : public Panel {
 public:
  std::string_view id() const override { return "reading"; }
  std::string_view title() const override { return "Reading"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
