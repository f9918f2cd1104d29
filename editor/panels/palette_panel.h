// The palette: sixteen swatches, the two buttons' colours, and an editor of the chosen one.
#pragma once

#include "panel.h"

namespace talus {

class PalettePanel : public Panel {
 public:
  std::string_view id() const override { return "palette"; }
  std::string_view title() const override { return "Palette"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_swatches(const Session& session, Actions& actions, Ui& ui);
  void draw_editor(const Session& session, Actions& actions, Ui& ui);
  int stroke_ = 0;  // of the drag of a slider
};

}  // namespace talus
