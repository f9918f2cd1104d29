#include "tile_note_text.h"

#include "formats/text/append_number.h"
#include "formats/text/json_text.h"

namespace talus {

std::string text_of_note(const TileNote& note) {
  std::string text = note.type.empty() ? "" : "class " + note.type;
  const auto add = [&](const std::string& phrase) { text += (text.empty() ? "" : ", ") + phrase; };
  if (note.probability != 1) {
    std::string number = "probability ";
    append_number(number, note.probability);
    add(number);
  }
  const auto properties =
      note.properties.empty() ? FormatResult<Json>(Json::object()) : parse_json(note.properties);
  if (!properties || !properties->is_object()) return text;
  for (const auto& [name, value] : properties->items())
    add(name + ": " +
        (value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, Json::error_handler_t::replace)));
  return text;
}

}  // namespace talus
