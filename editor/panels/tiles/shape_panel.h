// The shape of the selected tile: magnified, in numbers, in parts, suggested from its pixels, and copied to
// other tiles.
#pragma once

#include "edit/tile_shapes.h"
#include "panels/panel.h"
#include "panels/ui/number_field.h"
#include "shape_canvas.h"

namespace talus {

class ShapePanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kShape; }
  std::string_view title() const override { return "Shape"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_below_line(const Session& session, Actions& actions, Ui& ui);
  void draw_below_polygon(const Session& session, Actions& actions, Ui& ui);
  void follow_tile(const Session& session, Ui& ui);
  void draw_kind(const Session& session, Actions& actions, Ui& ui) const;
  void draw_polygon_tools(const Session& session, Actions& actions, Ui& ui) const;
  void draw_fields(const Session& session, Actions& actions, Ui& ui);
  void draw_point(const Session& session, Actions& actions, Ui& ui);
  void draw_parts(const Session& session, Actions& actions, Ui& ui) const;
  void draw_new_part(const Session& session, Actions& actions, Ui& ui) const;
  void draw_canvas(const Session& session, Actions& actions, Ui& ui, int tile);
  void draw_copy(const Session& session, Actions& actions, Ui& ui, int tile);
  void draw_turn_choice(Ui& ui);
  void draw_target(const Session& session, Actions& actions, Ui& ui, int target);

  ShapeCanvas canvas_;
  int shown_ = -1;  // tile in the last frame
  NumberEdit field_;
  ShapeTurn turn_ = ShapeTurn::mirrored;
  int target_ = -1;      // tile that a copy goes to; -1: the first free one
  int target_for_ = -1;  // the tile that target_ was chosen for
  int typed_ = 0;        // text of the target's field, used when the typing ends
};

}  // namespace talus
