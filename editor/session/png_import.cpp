// Plans of imports.
#include "png_import.h"

#include <algorithm>
#include <set>

namespace talus {
namespace {

std::string size_text(const PngPicture& picture) {
  return std::to_string(picture.width) + "x" + std::to_string(picture.height) + " px";
}

// Why the picture cannot go there, or nothing.
std::string misfit(const PngPicture& picture, int tile) {
  if (picture.width % kTileSize != 0 || picture.height % kTileSize != 0)
    return "The picture is " + size_text(picture) + ", which is no whole number of tiles of 8x8 px.";
  const int x = tile % kSheetColumns, y = tile / kSheetColumns;
  const int room_x = kSheetColumns - x, room_y = kSheetColumns - y;
  if (picture.width / kTileSize > room_x || picture.height / kTileSize > room_y) {
    return "The picture of " + size_text(picture) + " does not fit at tile " + std::to_string(tile) +
           ", where " + std::to_string(room_x * kTileSize) + "x" + std::to_string(room_y * kTileSize) +
           " px are left.";
  }
  return {};
}

void change_palette(const Level& level, PngImportPlan& plan) {
  for (int color = 0; color < kColorCount; ++color) {
    const Rgb before = level.palette[static_cast<std::size_t>(color)];
    const Rgb after = plan.palette[static_cast<std::size_t>(color)];
    if (before != after) plan.edit.changes.emplace_back(ColorChange{color, before, after});
  }
  plan.colors = static_cast<int>(plan.edit.changes.size());
  for (const Sheet& sheet : level.sheets) {
    plan.tiles_recolored +=
        static_cast<int>(std::count_if(sheet.images.begin(), sheet.images.end(), [&](const TileImage& image) {
          return std::any_of(image.begin(), image.end(),
                             [&](std::uint8_t color) { return level.palette[color] != plan.palette[color]; });
        }));
  }
}

void change_pixels(const PngPicture& picture, const MatchedPicture& matched, const PngImportOptions& options,
                   PngImportPlan& plan) {
  const SheetId sheet = options.part == PngPart::tiles ? SheetId::tiles : SheetId::sprites;
  std::set<int> tiles;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int tile = options.tile + y / kTileSize * kSheetColumns + x / kTileSize;
      const int pixel = y % kTileSize * kTileSize + x % kTileSize;
      std::uint8_t& now = plan.sheet.images[static_cast<std::size_t>(tile)][static_cast<std::size_t>(pixel)];
      const std::uint8_t before = now, after = matched.indices[picture.index(x, y)];
      if (before == after) continue;
      plan.edit.changes.emplace_back(PixelChange{sheet, tile, pixel, before, after});
      now = after;
      ++plan.pixels;
      tiles.insert(tile);
    }
  }
  plan.tiles = static_cast<int>(tiles.size());
}

}  // namespace

tl::expected<PngImportPlan, std::string> plan_png_import(const Level& level, const PngPicture& picture,
                                                         const PngImportOptions& options) {
  PngImportPlan plan;
  plan.palette = level.palette;
  plan.sheet = level.sheet(options.part == PngPart::sprites ? SheetId::sprites : SheetId::tiles);
  const bool is_palette = options.part == PngPart::palette;
  plan.edit.label = is_palette ? "Import a palette" : "Import a picture";
  if (is_palette || options.take_palette) {
    auto palette = is_palette ? palette_in(picture, level.palette) : palette_for(picture, level.palette);
    if (!palette) return tl::unexpected("The picture " + palette.error().message + ".");
    plan.palette = *palette;
    change_palette(level, plan);
  }
  if (is_palette) return plan;
  if (std::string wrong = misfit(picture, options.tile); !wrong.empty()) return tl::unexpected(wrong);
  const MatchedPicture matched = match_colors(picture, plan.palette);
  plan.largest_distance = matched.largest_distance;
  plan.farthest = matched.farthest;
  change_pixels(picture, matched, options, plan);
  return plan;
}

}  // namespace talus
