// The pixel canvas: the selected tiles, enlarged, to draw on.
#pragma once

#include <optional>

#include "panel.h"

namespace talus {

class PixelPanel : public Panel {
 public:
  std::string_view id() const override { return "pixels"; }
  std::string_view title() const override { return "Pixels"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_toolbar(const Session& session, Actions& actions, Ui& ui);
  void draw_size_choice(const Session& session, Actions& actions, Ui& ui);
  void handle_mouse(const Session& session, Actions& actions, Ui& ui, ImVec2 at, float zoom);
  void use_tool(const Session& session, Actions& actions, Cell pixel, bool pressed);

  std::optional<Cell> last_;  // px, of the stroke
  bool secondary_ = false;    // the stroke is the right button's
  int stroke_ = 0;
};

}  // namespace talus
