// The editor of the palette: the chosen colour's channels, and the palette in the clipboard.
#pragma once

#include "panel.h"

namespace talus {

class ColorPanel : public Panel {
 public:
  std::string_view id() const override { return "color"; }
  std::string_view title() const override { return "Colour"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  int stroke_ = 0;  // of the drag of a slider
};

}  // namespace talus
