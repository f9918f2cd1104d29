// The dialog that starts a level with tiles and a map of any size.
#pragma once

#include "panels/panel.h"

namespace talus {

class NewLevelPanel : public Panel {
 public:
  std::string_view id() const override { return "new_level"; }
  std::string_view title() const override { return "New level of a size"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_tile_sizes(Ui& ui);
  void draw_map_sizes(Ui& ui);
  void draw_content(Ui& ui) const;
  void draw_answers(Actions& actions, Ui& ui);

  // What the fields say, possible or not; they keep it until the window closes.
  TileSize tile_{16, 16};         // px
  int width_ = 60, height_ = 34;  // cells, of the map
};

}  // namespace talus
