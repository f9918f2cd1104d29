// What the tiles that are selected on the sheet say: class, probability, properties, and their animation.
#pragma once

#include <string>

#include "animation_fields.h"
#include "edit/sprite_area.h"
#include "panels/panel.h"
#include "panels/ui/property_table.h"

namespace talus {

class TilePanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kTile; }
  std::string_view title() const override { return "Tile"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_header(const Session& session, const SpriteArea& area, Ui& ui);
  void draw_note(const Session& session, const SpriteArea& area, Actions& actions, Ui& ui);
  void draw_properties(const Session& session, const SpriteArea& area, Actions& actions, Ui& ui);

  SpriteArea shown_;  // in the last frame
  std::string type_;  // while it is typed
  NumberEdit number_edit_;
  PropertyTable properties_;
  AnimationFields animation_;
};

}  // namespace talus
