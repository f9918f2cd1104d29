// Pictures of sheets as JSON.
#include "native_picture.h"

#include <algorithm>
#include <string>
#include <utility>

#include "../pictures/png_picture.h"
#include "../text/base64.h"

namespace talus {
namespace {

constexpr std::size_t kLine = 96;  // characters

tl::unexpected<FormatError> picture_error(std::string message) {
  return tl::unexpected(FormatError{"key picture", std::move(message)});
}

}  // namespace

FormatResult<std::shared_ptr<const SheetPicture>> take_picture(const Json& lines, const SheetLayout& layout,
                                                               int width, int height) {
  const bool is_text = lines.is_array() && std::all_of(lines.begin(), lines.end(),
                                                       [](const Json& line) { return line.is_string(); });
  if (!is_text) return picture_error("must be a list of strings with a PNG in Base64");
  std::string text;
  for (const Json& line : lines) text += line.get_ref<const std::string&>();
  const auto bytes = decode_base64(text);
  if (!bytes) return picture_error("has a character that is not a digit of Base64");
  const auto rgba = read_rgba(*bytes, kMaxSheetPictureSide);
  if (!rgba) return picture_error(rgba.error().message);
  if (rgba->width != width || rgba->height != height)
    return picture_error("has " + std::to_string(rgba->width) + "x" + std::to_string(rgba->height) +
                         " px, but that of " + std::to_string(layout.columns) + "x" +
                         std::to_string(layout.rows()) + " tiles must have " + std::to_string(width) + "x" +
                         std::to_string(height) + " px");
  return std::make_shared<const SheetPicture>(
      SheetPicture{width, height, {rgba->bytes.begin(), rgba->bytes.end()}});
}

FormatResult<Json> json_of(const SheetPicture& picture) {
  const std::string png = encode_png(picture.width, picture.height, 4, picture.rgba.data());
  if (png.empty())
    return tl::unexpected(FormatError{"", "there is not enough memory for the tiles' picture"});
  const std::string text = encode_base64(png);
  Json lines = Json::array();
  for (std::size_t at = 0; at < text.size(); at += kLine) lines.push_back(text.substr(at, kLine));
  return lines;
}

}  // namespace talus
