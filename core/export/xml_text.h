// Text for XML.
#pragma once

#include <string>
#include <string_view>

namespace talus {

// The text with what XML 1.0 has no character for replaced: control characters other than tab and line breaks
// by a blank, U+FFFE, U+FFFF, surrogates and bytes that are no UTF-8 by U+FFFD. Marks such as < are left to
// the writer.
std::string xml_text(std::string_view text);

}  // namespace talus
