// Text that stands in XML, with its special characters escaped.
#pragma once

#include <string>
#include <string_view>

namespace talus {

// Replaces characters that XML 1.0 does not have: control characters except tab and line breaks become a
// blank; U+FFFE, U+FFFF, surrogates and bytes that are not UTF-8 become U+FFFD. Escaping marks such as < is
// left to the writer.
std::string xml_text(std::string_view text);

// Whether xml_text() leaves the text as it is.
bool is_xml_text(std::string_view text);

}  // namespace talus
