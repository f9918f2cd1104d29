// XML in other encodings than UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <talus/formats/format.h>

namespace talus {

// Whether the text is in UTF-16, by its byte order mark or by its first character, "<".
bool is_utf16(std::string_view bytes);

// The same text in UTF-8, with a declaration that says so. Nothing if the text says that it is UTF-8, or does
// not say what it is. An error if it is damaged, or in an encoding that Talus does not know.
FormatResult<std::optional<std::string>> xml_in_utf8(std::string_view bytes);

}  // namespace talus
