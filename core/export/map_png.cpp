#include "map_png.h"

#include <algorithm>

#include "../formats/pictures/png_stream.h"
#include "export_targets.h"
#include "map_paint.h"

namespace talus {
namespace {

constexpr int kMaxInStrip = 1 << 22;  // px

std::string number(std::int64_t value) { return std::to_string(value); }

// Leaves three bytes of each four.
void drop_opacity(std::vector<std::uint8_t>& pixels) {
  std::size_t to = 0;
  for (std::size_t from = 0; from < pixels.size(); from += 4, to += 3)
    std::copy_n(&pixels[from], 3, &pixels[to]);
  pixels.resize(to);
}

}  // namespace

FormatResult<std::string> map_png(const Level& level, const Progress& progress, std::int64_t most) {
  const auto width = static_cast<std::int64_t>(level.map.px_width()),
             height = static_cast<std::int64_t>(level.map.px_height());
  const auto wrong = [](std::string why) { return tl::unexpected(FormatError{"", std::move(why)}); };
  if (width > kMaxPictureSide || height > kMaxPictureSide || width * height > most)
    return wrong("the map is " + number(width) + "x" + number(height) +
                 " px, but a picture may have at most " + number(kMaxPictureSide) + " px on each side and " +
                 number(most) + " px in all");
  const int channels = level.background ? 4 : 3;
  PngStream png(static_cast<int>(width), static_cast<int>(height), channels);
  const int strip = static_cast<int>(std::max<std::int64_t>(1, kMaxInStrip / width));
  const int all = static_cast<int>(height);
  for (int top = 0; top < all; top += strip) {
    const int rows = std::min(strip, all - top);
    const auto goes_on = [&](double done) { return progress.at((top + done * rows) / (1.0 * all)); };
    std::vector<std::uint8_t> pixels = map_pixels(level, top, rows, goes_on);
    if (channels == 3) drop_opacity(pixels);
    png.add(pixels);
    if (progress.stopped()) return std::string();
    if (png.size() > kMaxPictureBytes)
      return wrong("the picture of the map takes more than " + number(kMaxPictureBytes >> 20) + " MiB");
  }
  std::string bytes = png.finish();
  if (bytes.empty()) return wrong("there is not enough memory for the map's picture");
  return bytes;
}

FormatResult<Exported> export_png(const ExportRequest& request) {
  FormatResult<std::string> png = map_png(request.level, request.progress);
  if (!png) return tl::unexpected(png.error());
  return exported_file(*std::move(png));
}

}  // namespace talus
