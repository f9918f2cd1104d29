// Opens a document of Tiled in the form that its bytes have: JSON or XML.
#include "tiled_document.h"

#include "../import/hex_color.h"
#include "../text/xml_encoding.h"

namespace talus {

FormatResult<std::unique_ptr<TiledDocument>> tiled_document(std::string_view bytes) {
  auto converted = xml_in_utf8(bytes);
  if (!converted) return tl::unexpected(converted.error());
  if (*converted) return tiled_xml_document(bytes, **std::move(converted));
  const std::size_t first = bytes.find_first_not_of("\xef\xbb\xbf \t\r\n");
  const bool is_xml = first != bytes.npos && bytes[first] == '<';
  return is_xml ? tiled_xml_document(bytes) : tiled_json_document(bytes);
}

TintEdits tint_edits(const TileLayer& before, const TileLayer& now, std::string_view tint) {
  const bool has_alpha = opacity_of_hex(tint) < 1;
  const bool has_other_tint = before.tint != now.tint, has_other_opacity = before.opacity != now.opacity;
  return {has_other_opacity || (has_alpha && has_other_tint),
          has_other_tint || (has_alpha && has_other_opacity)};
}

std::string_view line_end_of(std::string_view text) {
  const std::size_t last = text.rfind('\n');
  return last != text.npos && last > 0 && text[last - 1] == '\r' ? "\r\n" : "\n";
}

}  // namespace talus
