// Base64, with + and / and = as in MIME.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus {

// On one line, with its padding.
std::string encode_base64(std::string_view bytes);

// Skips blanks and = anywhere, and drops bits at the end that make no byte. Returns nothing if another
// character is not a digit of Base64.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace talus
