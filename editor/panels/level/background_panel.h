// The dialog of what is seen where the map shows nothing.
#pragma once

#include "panels/panel.h"

namespace talus {

class BackgroundPanel : public Panel {
 public:
  std::string_view id() const override { return "background"; }
  std::string_view title() const override { return "Background of the map"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_choices(const Session& session, Actions& actions, Ui& ui);
  void draw_color(const Session& session, Actions& actions, Ui& ui);

  int stroke_ = 0;  // of the change of the colour
};

}  // namespace talus
