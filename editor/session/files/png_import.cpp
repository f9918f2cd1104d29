// Finds what a picture would change: pixels, the size of the sheet, the palette.
#include "png_import.h"

#include <algorithm>
#include <set>

namespace talus {
namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height) + " px";
}

// px of a side of `size` that are used if there is `room`.
int fitted_side(int size, int room, PngFit fit) {
  if (fit == PngFit::cut_off) return std::min(size, room) / kCartTileSize * kCartTileSize;
  return in_whole_tiles(size);
}

// The part of the picture that goes on the sheet, in whole tiles; filled-up pixels are transparent.
tl::expected<PngPicture, std::string> fitted(const PngPicture& picture, const SheetLayout& sheet,
                                             const PngImportOptions& options) {
  if (options.tile >= sheet.count)
    return tl::unexpected("There is no tile " + std::to_string(options.tile) + ": the sheet has only " +
                          std::to_string(sheet.count) + ".");
  const Cell corner = sheet.place_of(options.tile);
  const int rows = sheet.count / sheet.columns;  // without a last row that is shorter
  const int room_x = (sheet.columns - corner.x) * kCartTileSize;
  const int room_y = std::max(rows - corner.y, 1) * kCartTileSize;
  const std::string size = size_text(picture.width, picture.height);
  PngPicture taken{fitted_side(picture.width, room_x, options.fit),
                   fitted_side(picture.height, room_y, options.fit),
                   {},
                   {},
                   picture.palette};
  if (options.fit == PngFit::exact && (taken.width != picture.width || taken.height != picture.height))
    return tl::unexpected("The picture is " + size + ", which is not a whole number of tiles of 8x8 px.");
  if (taken.width > room_x || taken.height > room_y)
    return tl::unexpected("The picture of " + size + " does not fit at tile " + std::to_string(options.tile) +
                          ", where " + size_text(room_x, room_y) + " are left.");
  if (taken.width == 0 || taken.height == 0)
    return tl::unexpected("The picture of " + size + " has no whole tile of 8x8 px to take.");
  for (int y = 0; y < taken.height; ++y) {
    for (int x = 0; x < taken.width; ++x) {
      const bool beyond = x >= picture.width || y >= picture.height;
      taken.pixels.push_back(beyond ? Rgb{} : picture.at(x, y));
      taken.transparent.push_back(beyond || picture.is_transparent(x, y));
    }
  }
  return taken;
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
  const SheetLayout layout = plan.sheet.layout();
  const Cell corner = layout.place_of(options.tile);
  std::set<int> tiles;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Cell place{corner.x + x / kCartTileSize, corner.y + y / kCartTileSize};
      if (!layout.contains(place)) continue;
      const int tile = layout.tile_at(place);
      const int pixel = y % kCartTileSize * kCartTileSize + x % kCartTileSize;
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

void draw_on_sheet(const PngPicture& picture, const PngImportOptions& options, PngImportPlan& plan) {
  const MatchedPicture matched = match_colors(picture, plan.palette);
  plan.width = picture.width;
  plan.height = picture.height;
  plan.approximated = matched.approximated;
  plan.largest_distance = matched.largest_distance;
  plan.farthest = matched.farthest;
  plan.farthest_from = picture.at(matched.farthest.x, matched.farthest.y);
  plan.farthest_to = plan.palette[matched.indices[picture.index(matched.farthest.x, matched.farthest.y)]];
  change_pixels(picture, matched, options, plan);
}

// The error says what is wrong with the picture.
tl::expected<void, std::string> take_palette(const Level& level, const FormatResult<Palette>& palette,
                                             PngImportPlan& plan) {
  if (!palette) return tl::unexpected("The picture " + palette.error().message + ".");
  plan.palette = *palette;
  change_palette(level, plan);
  return {};
}

}  // namespace

int in_whole_tiles(int side) { return (side + kCartTileSize - 1) / kCartTileSize * kCartTileSize; }

tl::expected<PngImportPlan, std::string> plan_png_import(const Level& level, const PngPicture& picture,
                                                         const PngImportOptions& options) {
  PngImportPlan plan;
  plan.palette = level.palette;
  plan.sheet = level.sheet(options.part == PngPart::sprites ? SheetId::sprites : SheetId::tiles);
  if (options.part == PngPart::palette) {
    plan.edit.label = "Import a palette";
    const auto palette = take_palette(level, palette_in(picture, level.palette), plan);
    if (!palette) return tl::unexpected(palette.error());
    return plan;
  }
  plan.edit.label = "Import a picture";
  const auto taken = fitted(picture, plan.sheet.layout(), options);
  if (!taken) return tl::unexpected(taken.error());
  if (options.take_palette) {
    const auto palette = take_palette(level, palette_for(*taken, level.palette), plan);
    if (!palette) return tl::unexpected(palette.error());
  }
  draw_on_sheet(*taken, options, plan);
  return plan;
}

}  // namespace talus
