// Base64, with + and / and = as in MIME.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus {

// On one line, with its padding.
std::string encode_base64(std::string_view bytes);

// Blanks and = are passed over, wherever they are, and bits at the end that make no byte are left out.
// Nothing when another character is not a digit of Base64.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace talus
