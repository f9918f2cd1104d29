// The palette editor: the channels of the chosen colour, and the palette in the clipboard. In true colour,
// the picker.
#pragma once

#include <string>

#include "panels/panel.h"
#include "rgba_picker.h"

namespace talus {

class ColorPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kColor; }
  std::string_view title() const override { return "Colour"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // Returns the chosen colour with what has been typed. A number that gets the focus by Tab shows it.
  Rgb draw_hex(const Session& session, Actions& actions, Ui& ui);

  RgbaPicker rgba_{"color"};  // for sheets in true colour
  int stroke_ = 0;            // of a slider's drag
  Rgb before_;                // the colour at the start of the drag
  std::string typed_;         // text of the hexadecimal field
  int typed_color_ = 0;       // 0..15, the colour that it belongs to
  bool typing_ = false;       // whether the user types in that field
};

}  // namespace talus
