// Chooses the form.
#include "tiled_document.h"

namespace talus {

FormatResult<std::unique_ptr<TiledDocument>> tiled_document(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of("\xef\xbb\xbf \t\r\n");
  const bool is_xml = first != bytes.npos && bytes[first] == '<';
  return is_xml ? tiled_xml_document(bytes) : tiled_json_document(bytes);
}

std::string_view line_end_of(std::string_view text) {
  const std::size_t last = text.rfind('\n');
  return last != text.npos && last > 0 && text[last - 1] == '\r' ? "\r\n" : "\n";
}

}  // namespace talus
