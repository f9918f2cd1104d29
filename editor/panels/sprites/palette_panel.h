// The palette: sixteen swatches, with the colours of the two buttons marked; in true colour, those of the
// picture.
#pragma once

#include "panels/panel.h"
#include "rgba_swatches.h"

namespace talus {

class PalettePanel : public Panel {
 public:
  std::string_view id() const override { return "palette"; }
  std::string_view title() const override { return "Palette"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  RgbaSwatches rgba_;  // for sheets in true colour
};

}  // namespace talus
