#include "map_png.h"

#include "../formats/pictures/png_picture.h"
#include "../level/tile_color.h"
#include "export_targets.h"

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
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(width * height) * 3);
  for (int y = 0; y < height; ++y) {
    if (!progress.at(kPaintShare * y / static_cast<double>(height))) return std::string();
    for (Cell c{0, y / tile.height}; c.x < level.map.width(); ++c.x) {
      const TileNumber shown = level.map.at(c);
      for (int x = 0; x < tile.width; ++x) {
        const Rgb color = color_on_map(level, shown, x, y % tile.height);
        bytes.insert(bytes.end(), {color.r, color.g, color.b});
      }
    }
  }
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
