// What is left out of members.
#include "tiled_node.h"

#include <algorithm>

namespace talus {
namespace {

// Members that have no meaning while they have their default values.
bool says_nothing(std::string_view key, const Json& value) {
  if (key == "opacity" || key == "parallaxx" || key == "parallaxy") return value == 1;
  if (key == "x" || key == "y" || key == "offsetx" || key == "offsety") return value == 0;
  return value == "" || (value.is_structured() && value.empty()) || key == kXmlLineKey;
}

}  // namespace

void TiledNodeReader::drop_others(const JsonNode& node, const std::string& of, Keys known) {
  for (auto it = node.json.begin(); it != node.json.end(); ++it) {
    const bool is_known = std::find(known.begin(), known.end(), it.key()) != known.end();
    if (!is_known && !says_nothing(it.key(), it.value())) drops_.add(quoted_name(it.key()) + " of " + of);
  }
}

}  // namespace talus
