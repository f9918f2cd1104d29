// The layers of the map, as in Tiled: the front one is at the top. Tools paint on the chosen one.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "layer_look_fields.h"
#include "level/layer_tree.h"
#include "panels/panel.h"

namespace talus {

class LayersPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kLayers; }
  std::string_view title() const override { return "Layers"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // A layer or a group.
  struct Item {
    LayerInOrder layer;
    int group = -1;  // index in TileLayers::groups; -1: it is the layer
    friend bool operator==(const Item&, const Item&) = default;
  };
  static Item item_of(const LayerNode& node);
  // A name that is being typed.
  struct Renaming {
    Item item;
    std::string name;
    bool has_keys = false;  // whether the field has had the keys
  };
  std::vector<LayerNode> rows_of(const Level& level) const;
  void draw_list(const Session& session, Actions& actions, Ui& ui);
  void draw_row(const LayerNode& node, const Session& session, Actions& actions, Ui& ui);
  void draw_fold(const LayerNode& node, const Session& session, Ui& ui);
  void draw_name(const LayerNode& node, const Session& session, Actions& actions, Ui& ui);
  void draw_name_field(const Session& session, Actions& actions, Ui& ui);
  void choose(const Item& item, const Session& session, Actions& actions, Ui& ui);
  void drag_item(ImVec2 top, float row, const std::vector<LayerNode>& rows, const Session& session,
                 Actions& actions, const Ui& ui);
  void draw_looks(const Session& session, Actions& actions, Ui& ui);
  void follow_choice(const Session& session);

  std::optional<Renaming> renaming_;
  std::optional<Item> dragged_;   // what the mouse moves
  std::set<std::string> folded_;  // groups, by their names and those around them
  int followed_ = -1;             // the chosen layer that the list last scrolled to
  LayerLookFields look_fields_;
  bool looks_of_other_ = false;  // whether the fields are about a layer of objects or of a picture
  int chosen_tiles_ = -1, chosen_other_ = -1;  // the layers that were chosen in the last frame
};

}  // namespace talus
