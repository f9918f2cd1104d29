// The palette: sixteen swatches, with the colours of the two buttons marked.
#pragma once

#include "panels/panel.h"

namespace talus {

class PalettePanel : public Panel {
 public:
  std::string_view id() const override { return "palette"; }
  std::string_view title() const override { return "Palette"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
