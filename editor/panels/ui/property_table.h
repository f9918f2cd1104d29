// A table of properties: name, kind and value of each, with those to add and to remove.
#pragma once

#include <optional>
#include <string>

#include "property_text.h"
#include "ui.h"

namespace talus {

class PropertyTable {
 public:
  // Draws it, and returns what the user has just changed. id: begins the names of its widgets. of: what has
  // the properties, "object", for the help. properties: as in property_text.h. has_field: the name of a
  // property that has a field elsewhere, and is left out; empty: none. wrong: gets a sentence if the typed
  // value was none.
  std::optional<PropertyChange> draw(const std::string& id, const std::string& of,
                                     const std::string& properties, const std::string& has_field,
                                     std::optional<std::string>& wrong, Ui& ui);
  // Another thing is shown: what was being typed is left.
  void forget();

 private:
  std::optional<PropertyChange> draw_row(const std::string& id, const std::string& of,
                                         const std::string& name, const Json& value,
                                         std::optional<std::string>& wrong, Ui& ui);
  std::optional<Json> draw_value(const std::string& name, const Json& value,
                                 std::optional<std::string>& wrong, Ui& ui);
  std::optional<PropertyChange> draw_new(const std::string& id, const Json& properties, Ui& ui);

  std::string text_;  // what properties_ were read from
  Json properties_ = Json::object();
  std::string typed_, value_;               // the property that is typed, and its text
  std::string added_;                       // the name of a new property
  PropertyKind kind_ = PropertyKind::text;  // of a new property
  float room_of_values_ = 0;                // px of the screen, the width of a field for a value
};

}  // namespace talus
