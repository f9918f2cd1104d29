// The properties that users wrote for objects and tiles: members of a JSON object, as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "formats/text/json_text.h"

namespace talus {

// What a property can be. Values of other kinds, which only files have, count as text.
enum class PropertyKind { text, whole_number, number, yes_or_no };
inline constexpr int kPropertyKinds = 4;
std::string_view label_of(PropertyKind kind);  // "text", "whole number" ...
PropertyKind kind_of(const Json& value);

// The members of the text; an empty object if it is empty, or none.
Json properties_in(const std::string& text);
// The text of the members; empty if there are none.
std::string text_of_properties(const Json& properties);

struct PropertyChange {
  std::string name;
  std::optional<Json> value;  // nothing: the property goes
};
// The text with one property changed.
std::string with_property(const std::string& properties, const PropertyChange& change);

// A value as it is typed.
std::string text_of_value(const Json& value);
// What a typed text means as a value of a kind; nothing if it is none. yes_or_no: "true" or "false".
std::optional<Json> value_of_text(const std::string& text, PropertyKind kind);
// The value as one of another kind: 0, false or its text if it does not mean one.
Json in_kind(const Json& value, PropertyKind kind);

}  // namespace talus
