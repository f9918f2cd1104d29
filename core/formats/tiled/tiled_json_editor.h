// TiledJsonEditor: changes tiles and objects in the text of a map or tileset in JSON. What it adds stands in
// one line.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "../text/json_places.h"
#include "../text/json_text.h"
#include "tiled_edits.h"

namespace talus {

class TiledJsonEditor {
 public:
  // All must live as long as this.
  TiledJsonEditor(std::string_view text, const JsonPlaces& places, TextEdits& edits)
      : text_(text), places_(places), root_(places.root()), edits_(edits) {}

  // Each at most once for a value. Nothing happens if it is not of the usual form.
  void edit_tiles(TextSpan tileset, const TiledTileEdits& edits);
  void set_property(TextSpan owner, const TiledPropertyEdit& edit);
  // next_id: gives new objects their numbers.
  void edit_objects(TextSpan group, const std::vector<TiledObjectEdit>& edits,
                    const std::function<int()>& next_id);

 private:
  void edit_tile(TextSpan tile, const TiledTileEdit& edit);
  void edit_object(TextSpan object, const TiledObjectEdit& edit);
  std::vector<JsonMemberEdit> all_of(TextSpan object, const TiledObject& now) const;
  std::vector<JsonMemberEdit> differences(TextSpan object, const TiledObject& before,
                                          const TiledObject& now) const;
  std::string type_key_of(TextSpan object) const;
  // Removes the member `properties` if nothing is left in it.
  void edit_properties(TextSpan owner, const std::vector<TiledPropertyEdit>& edits,
                       std::vector<JsonMemberEdit>& members);
  std::string new_tile(int id, const TiledTileEdit& edit) const;
  std::string new_objects(const std::vector<TiledObjectEdit>& edits) const;  // empty: there are none
  std::string new_object(const TiledObjectEdit& edit, int id) const;
  std::string type_key() const;

  std::string_view text_;
  const JsonPlaces& places_;
  TextSpan root_;
  TextEdits& edits_;
};

}  // namespace talus
