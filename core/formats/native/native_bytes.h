// Bytes in native levels: lines of Base64.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "../text/json_text.h"

namespace talus {

inline constexpr std::size_t kBytesLine = 96;  // characters of each line but the last

Json json_of_bytes(std::string_view bytes);
// Nothing if it is not a list of strings.
std::optional<std::string> base64_of(const Json& lines);

}  // namespace talus
