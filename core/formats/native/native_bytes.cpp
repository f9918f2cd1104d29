#include "native_bytes.h"

#include <algorithm>

#include "../text/base64.h"

namespace talus {

Json json_of_bytes(std::string_view bytes) {
  const std::string text = encode_base64(bytes);
  Json lines = Json::array();
  for (std::size_t at = 0; at < text.size(); at += kBytesLine) lines.push_back(text.substr(at, kBytesLine));
  return lines;
}

std::optional<std::string> base64_of(const Json& lines) {
  const bool is_text = lines.is_array() && std::all_of(lines.begin(), lines.end(),
                                                       [](const Json& line) { return line.is_string(); });
  if (!is_text) return std::nullopt;
  std::string text;
  for (const Json& line : lines) text += line.get_ref<const std::string&>();
  return text;
}

}  // namespace talus
