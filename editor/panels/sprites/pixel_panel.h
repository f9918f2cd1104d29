// The pixel canvas: the selected tiles, enlarged, to draw on.
#pragma once

#include "panels/panel.h"
#include "panels/tools/pixel/pixel_tools.h"
#include "sprite_surroundings.h"

namespace talus {

class PixelPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kPixels; }
  std::string_view title() const override { return "Pixels"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_tools(const Session& session, Actions& actions, Ui& ui);
  void draw_sizes(const Session& session, Actions& actions, Ui& ui);
  void draw_brushes(const Session& session, Actions& actions, Ui& ui);
  void draw_canvas(const Session& session, Actions& actions, Ui& ui);
  void change_size_by_wheel(const Session& session, Actions& actions, Cell pixel);

  PixelToolHand hand_;
  SpriteSurroundings surroundings_;
  float wheel_ = 0;  // clicks of the wheel that do not make a whole step yet
};

}  // namespace talus
