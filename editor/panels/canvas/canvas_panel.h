// The middle of the window: the map, the play view, or both, below a toolbar.
#pragma once

#include "level_canvas.h"
#include "panels/panel.h"

namespace talus {

class CanvasPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kCanvas; }
  std::string_view title() const override { return "Level"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_toolbar(const Session& session, Actions& actions, Ui& ui);
  void draw_flag_tint_choice(const Session& session, Actions& actions, Ui& ui);
  void draw_play(const Session& session, Actions& actions, Ui& ui, ImVec2 size);
  void draw_both(const Session& session, Actions& actions, Ui& ui);

  LevelCanvas map_{LevelCanvas::Kind::map, "map"};
  LevelCanvas second_map_{LevelCanvas::Kind::map, "second_map", true};
  LevelCanvas play_{LevelCanvas::Kind::play, "play"};
};

}  // namespace talus
