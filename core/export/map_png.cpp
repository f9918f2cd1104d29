#include "map_png.h"

#include "../formats/pictures/png_picture.h"
#include "export_targets.h"
#include "map_paint.h"

namespace talus {
namespace {

constexpr double kPaintShare = 0.4;  // share of the time; the rest packs the picture without progress

}  // namespace

FormatResult<std::string> map_png(const Level& level, const Progress& progress) {
  const TileSize tile = level.map.tile_size();
  const std::int64_t width = std::int64_t{level.map.width()} * tile.width;
  const std::int64_t height = std::int64_t{level.map.height()} * tile.height;
  if (width > kMaxPictureSide || height > kMaxPictureSide || width * height > kMaxPicture) {
    return tl::unexpected(FormatError{"", "the map is " + std::to_string(width) + "x" +
                                              std::to_string(height) +
                                              " px, but a picture may have at most 16384 px on each side and "
                                              "33554432 px in all, such as 8192x4096"});
  }
  const auto goes_on = [&](double done) { return progress.at(kPaintShare * done); };
  const std::vector<std::uint8_t> bytes = map_pixels(level, goes_on);
  if (progress.stopped()) return std::string();
  std::string png = encode_png(static_cast<int>(width), static_cast<int>(height), 3, bytes.data());
  if (png.empty()) return tl::unexpected(FormatError{"", "there is not enough memory for the map's picture"});
  return png;
}

FormatResult<Exported> export_png(const ExportRequest& request) {
  FormatResult<std::string> png = map_png(request.level, request.progress);
  if (!png) return tl::unexpected(png.error());
  return exported_file(*std::move(png));
}

}  // namespace talus
