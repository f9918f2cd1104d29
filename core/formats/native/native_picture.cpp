// Pictures of sheets as JSON.
#include "native_picture.h"

#include <string>
#include <utility>

#include "../pictures/png_picture.h"
#include "../text/base64.h"
#include "native_bytes.h"

namespace talus {
namespace {

tl::unexpected<FormatError> picture_error(std::string message) {
  return tl::unexpected(FormatError{"key picture", std::move(message)});
}

}  // namespace

FormatResult<std::shared_ptr<const SheetPicture>> take_picture(const Json& lines, const SheetLayout& layout,
                                                               int width, int height) {
  const auto text = base64_of(lines);
  if (!text) return picture_error("must be a list of strings with a PNG in Base64");
  const auto bytes = decode_base64(*text);
  if (!bytes) return picture_error("has a character that is not a digit of Base64");
  const auto rgba = read_rgba(*bytes, kMaxSheetPictureSide);
  if (!rgba) return picture_error(rgba.error().message);
  if (rgba->width != width || rgba->height != height)
    return picture_error("has " + std::to_string(rgba->width) + "x" + std::to_string(rgba->height) +
                         " px, but that of " + std::to_string(layout.columns) + "x" +
                         std::to_string(layout.rows()) + " tiles must have " + std::to_string(width) + "x" +
                         std::to_string(height) + " px");
  return shared_picture(*rgba);
}

FormatResult<Json> json_of(const SheetPicture& picture) {
  const std::string png = encode_png(picture.width, picture.height, 4, picture.rgba.data());
  if (png.empty())
    return tl::unexpected(FormatError{"", "there is not enough memory for the tiles' picture"});
  return json_of_bytes(png);
}

}  // namespace talus
