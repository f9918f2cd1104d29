// Goes through UTF-8 text, character by character.
#include "xml_text.h"

#include <algorithm>
#include <cstdint>

#include "utf8_text.h"

namespace talus {
namespace {

// Valid code points that XML documents may not have.
bool is_forbidden(std::uint32_t code) { return code == 0xfffe || code == 0xffff; }

}  // namespace

std::string xml_text(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  while (!text.empty()) {
    const auto [code, bytes] = first_code_point(text);
    if (bytes == 0 || is_forbidden(code))
      clean += "\xef\xbf\xbd";
    else if (code < 32 && code != '\t' && code != '\n' && code != '\r')
      clean += ' ';
    else
      clean += text.substr(0, bytes);
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return clean;
}

bool is_xml_text(std::string_view text) {
  while (!text.empty()) {
    const auto byte = static_cast<unsigned char>(text[0]);
    if (byte >= 32 && byte < 128) {  // nearly all text, and fast to test
      text.remove_prefix(1);
      continue;
    }
    const auto [code, bytes] = first_code_point(text);
    if (bytes == 0 || is_forbidden(code)) return false;
    if (code < 32 && code != '\t' && code != '\n' && code != '\r') return false;
    text.remove_prefix(bytes);
  }
  return true;
}

}  // namespace talus
