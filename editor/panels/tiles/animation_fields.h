// The frames of a tile's animation, and how it plays.
#pragma once

#include "edit/tile_animation_tools.h"
#include "panels/ui/number_field.h"

namespace talus {

class AnimationFields {
 public:
  void draw(const Session& session, TileNumber tile, Actions& actions, Ui& ui);

 private:
  void draw_buttons(const Session& session, TileNumber tile, Actions& actions, Ui& ui) const;
  void draw_frame(const Session& session, TileNumber tile, int index, Actions& actions, Ui& ui);

  NumberEdit number_edit_;
};

}  // namespace talus
