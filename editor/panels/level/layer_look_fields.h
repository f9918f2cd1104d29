// The fields of how a layer or a group of layers is drawn: opacity, tint, offset, parallax.
#pragma once

#include <string>

#include "edit/layer_looks.h"
#include "panels/ui/number_field.h"

namespace talus {

class LayerLookFields {
 public:
  // The height of all fields, px of the screen.
  static float height(const Ui& ui);
  // layer: one that the level has. group: an index in TileLayers::groups; -1: the fields are about the layer.
  void draw(const LayerInOrder& layer, int group, const Session& session, Actions& actions, Ui& ui);

 private:
  void draw_opacity(LayerLooks looks, const Session& session, Actions& actions, Ui& ui);
  void draw_tint(LayerLooks looks, const Session& session, Actions& actions, Ui& ui);
  void draw_pair(const std::string& label, Vec2 LayerLooks::*pair, float speed, const char* help,
                 const Session& session, Actions& actions, Ui& ui);
  LayerLooks looks_in(const Level& level) const;
  void change(const LayerLooks& looks, int stroke, const Session& session, Actions& actions) const;

  LayerInOrder layer_;  // whose fields are drawn
  int group_ = -1;      // the same, if it is a group
  NumberEdit number_edit_;
  int opacity_stroke_ = 0;     // of a drag of the opacity
  double opacity_before_ = 1;  // which Escape brings back
  int tint_stroke_ = 0;        // of a press that changes the tint
};

}  // namespace talus
