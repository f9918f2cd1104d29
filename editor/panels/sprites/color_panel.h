// The editor of the palette: the chosen colour's channels, and the palette in the clipboard.
#pragma once

#include <string>

#include "panels/panel.h"

namespace talus {

class ColorPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kColor; }
  std::string_view title() const override { return "Colour"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // Returns the chosen colour with what has been typed: a number that gets the keys by Tab begins with it.
  Rgb draw_hex(const Session& session, Actions& actions, Ui& ui);

  int stroke_ = 0;       // of the drag of a slider
  Rgb before_;           // the colour as the drag began
  std::string typed_;    // in the field of the hexadecimal colour
  int typed_color_ = 0;  // 0..15, which it is of
  bool typing_ = false;  // there
};

}  // namespace talus
