// The layers of the map, as in Tiled: the front one is at the top. Tools paint on the chosen one.
#pragma once

#include <optional>
#include <string>

#include "panels/panel.h"
#include "panels/ui/number_field.h"

namespace talus {

class LayersPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kLayers; }
  std::string_view title() const override { return "Layers"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // A name that is being typed.
  struct Renaming {
    int layer = 0;
    std::string name;
    bool has_keys = false;  // whether the field has had the keys
  };
  void draw_object_layers(const Session& session, Actions& actions, Ui& ui);
  void draw_list(const Session& session, Actions& actions, Ui& ui);
  void draw_layer(int layer, const Session& session, Actions& actions, Ui& ui);
  void draw_name(int layer, const Session& session, Actions& actions, Ui& ui);
  void draw_name_field(int layer, const Session& session, Actions& actions, Ui& ui);
  void drag_layer(ImVec2 top, float row, const Session& session, Actions& actions, const Ui& ui);
  void draw_looks(const Session& session, Actions& actions, Ui& ui);
  void draw_opacity(TileLayer& looks, const Session& session, Actions& actions, Ui& ui);
  void draw_tint(TileLayer& looks, const Session& session, Actions& actions, Ui& ui);

  std::optional<Renaming> renaming_;
  std::optional<int> dragged_;  // the layer that the mouse moves
  int followed_ = -1;           // the chosen layer that the list last scrolled to
  NumberEdit number_edit_;
  int opacity_stroke_ = 0;     // of a drag of the opacity
  double opacity_before_ = 1;  // which Escape brings back
  int tint_stroke_ = 0;        // of a press that changes the tint
};

}  // namespace talus
