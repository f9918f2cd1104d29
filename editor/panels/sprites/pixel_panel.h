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
  void draw_pixels(const Session& session, Actions& actions, Ui& ui);
  void take_wheel(const Session& session, Actions& actions, Cell pixel, Ui& ui);
  static void move_by_middle_button(const Ui& ui);
  void keep_in_place(float zoom) const;
  static void note_color(const Session& session, Ui& ui);

  PixelToolHand hand_;
  SpriteSurroundings surroundings_;
  struct {
    Vec2 pixel;           // px of the canvas
    ImVec2 mouse;         // px of the screen from the corner of the panel
  } zoomed_about_;        // where the mouse was on the canvas last
  float shown_zoom_ = 0;  // that of the frame before
  float wheel_ = 0;       // clicks of the wheel that do not make a whole step yet
};

}  // namespace talus
