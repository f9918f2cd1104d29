// TiledXmlEditor: changes tiles and objects in the text of a map or tileset in XML. What it adds is indented
// like its neighbours.
#pragma once

#include <functional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../text/xml_places.h"
#include "tiled_edits.h"

namespace talus {

class TiledXmlEditor {
 public:
  // root: of the text. All must live as long as this.
  TiledXmlEditor(std::string_view text, const XmlPlaces& places, const pugi::xml_node& root,
                 TextEdits& edits);

  // Each at most once for an element.
  void edit_tiles(const pugi::xml_node& tileset, const TiledTileEdits& edits);
  void set_property(const pugi::xml_node& owner, const TiledPropertyEdit& edit);
  // next_id: gives new objects their numbers.
  void edit_objects(const pugi::xml_node& group, const std::vector<TiledObjectEdit>& edits,
                    const std::function<int()>& next_id);
  const std::string& unit() const { return unit_; }  // by which children are indented

 private:
  struct NewElement {
    std::string name;
    std::string attributes = {};  // each after a blank
    std::vector<NewElement> children = {};
  };
  struct Changes {  // of the children of an element
    std::vector<pugi::xml_node> removed = {};
    std::vector<std::pair<pugi::xml_node, NewElement>> added = {};  // before that one; null: at the end
    bool removes(const pugi::xml_node& child) const;
    bool empty() const { return removed.empty() && added.empty(); }
  };

  // Returns whether nothing is left of the element.
  bool edit_tile(const pugi::xml_node& tile, const TiledTileEdit& edit);

  void edit_object(const pugi::xml_node& object, const TiledObjectEdit& edit);
  void edit_all(const pugi::xml_node& object, const TiledObject& now, Changes& changes);
  void edit_differences(const pugi::xml_node& object, const TiledObject& before, const TiledObject& now,
                        Changes& changes);
  void edit_form(const pugi::xml_node& object, const TiledObject& now, Changes& changes);
  void edit_number(const pugi::xml_node& element, const char* name, double value);
  void edit_properties(const pugi::xml_node& owner, const std::vector<TiledPropertyEdit>& edits,
                       Changes& changes);
  void change_children(const pugi::xml_node& parent, const Changes& changes);
  static NewElement new_property(const TiledPropertyEdit& edit);  // which has a value
  static NewElement new_properties(const std::vector<TiledPropertyEdit>& edits);
  void edit_animation(const pugi::xml_node& tile, const std::vector<TiledTile::Frame>& frames,
                      Changes& changes);
  static NewElement new_animation(const std::vector<TiledTile::Frame>& frames);
  NewElement new_tile(int id, const TiledTileEdit& edit) const;
  NewElement new_object(const TiledObjectEdit& edit, int id) const;
  std::string print(const NewElement& element, const std::string& line) const;
  const char* type_key(const pugi::xml_node& object) const;

  std::string_view text_;
  const XmlPlaces& places_;
  pugi::xml_node root_;
  TextEdits& edits_;
  std::string unit_ = " ";  // by which children are indented
};

}  // namespace talus
