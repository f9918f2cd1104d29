// Draws and reads linked tilesets.
#include "tileset_pixels.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "../../level/tile_color.h"
#include "../import/linked_files.h"
#include "../import/numbered_box.h"
#include "../import/sheet_images.h"
#include "../pictures/png_sheet.h"
#include "tile_cut.h"

namespace talus {
namespace {

namespace fs = std::filesystem;
using Pixel = std::array<std::uint8_t, 4>;
constexpr std::uint8_t kOpaque = 255;

// The picture of a sheet that may have none. Colour 0 is clear, as on layers.
SheetPicture picture_of(const Level& level) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  if (sheet.picture != nullptr) return *sheet.picture;
  const TileSize tile = level.map.tile_size();
  const SheetLayout layout = sheet.layout();
  SheetPicture picture{layout.columns * tile.width, layout.rows() * tile.height, {}};
  picture.rgba.reserve(4 * static_cast<std::size_t>(picture.width) *
                       static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Cell place{x / tile.width, y / tile.height};
      const std::uint8_t color = layout.contains(place)
                                     ? color_at(sheet.images[static_cast<std::size_t>(layout.tile_at(place))],
                                                tile, x % tile.width, y % tile.height)
                                     : std::uint8_t{0};
      const Rgb rgb = level.palette[color];
      const Pixel rgba = color == 0 ? Pixel{} : Pixel{rgb.r, rgb.g, rgb.b, kOpaque};
      picture.rgba.insert(picture.rgba.end(), rgba.begin(), rgba.end());
    }
  }
  return picture;
}

Pixel color_in(const RgbaPicture& picture, int x, int y) {
  if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return {};
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(x));
  Pixel rgba;
  std::copy_n(picture.bytes.begin() + static_cast<std::ptrdiff_t>(at), rgba.size(), rgba.begin());
  return rgba;
}

// The colour of the tile at `place` of a tileset, of the pixel in the middle of that part of the cell.
Pixel color_of(const ShownTileset& shown, const Tileset& set, Cell place, TileSize tile, int x, int y) {
  if (shown.picture == nullptr) {
    const int number = place.y * set.columns + place.x;
    const Rgb box = color_of_box(number, x * kCartTileSize / tile.width, y * kCartTileSize / tile.height);
    return {box.r, box.g, box.b, kOpaque};
  }
  const TileCut& cut = shown.cut;
  const int in_x = (2 * x + 1) * cut.tile.width / (2 * tile.width) - cut.offset_x;
  const int in_y = (2 * y + 1) * cut.tile.height / (2 * tile.height) - cut.offset_y;
  if (in_x < 0 || in_y < 0 || in_x >= cut.tile.width || in_y >= cut.tile.height) return {};
  return color_in(*shown.picture, cut.margin + place.x * (cut.tile.width + cut.spacing) + in_x,
                  cut.margin + place.y * (cut.tile.height + cut.spacing) + in_y);
}

// The tiles of a tileset, each with its place in it.
template <class Use>
void for_each_tile(const Tileset& set, const SheetLayout& layout, Use use) {
  for (int tile = set.first; tile < set.first + set.count; ++tile) {
    const Cell place{(tile - set.first) % layout.columns, (tile - set.first) / layout.columns};
    if (place.x < set.columns) use(tile, place);
  }
}

// Gives tiles of a sheet with a picture their images in 16 colours.
void take_images(const std::vector<int>& tiles, Level& level) {
  Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  constexpr int kPixels = kCartTileSize * kCartTileSize;
  PngPicture strip{kPixels, static_cast<int>(tiles.size()), {}, {}, {}};
  for (const int tile : tiles) {
    const Cell place = sheet.layout().place_of(tile);
    for (int i = 0; i < kPixels; ++i) {
      const int x = pixel_of_side(i % kCartTileSize, size.width);
      const int y = pixel_of_side(i / kCartTileSize, size.height);
      const std::uint8_t* pixel = sheet.picture->at(place.x * size.width + x, place.y * size.height + y);
      const bool is_clear = pixel[3] < kHalfOpaque;
      strip.transparent.push_back(is_clear);
      strip.pixels.push_back(is_clear ? Rgb{} : Rgb{pixel[0], pixel[1], pixel[2]});
    }
  }
  const MatchedPicture matched = match_colors(strip, level.palette);
  for (std::size_t i = 0; i < tiles.size(); ++i)
    std::copy_n(matched.indices.begin() + static_cast<std::ptrdiff_t>(i * kPixels), kPixels,
                sheet.images[static_cast<std::size_t>(tiles[i])].begin());
}

void clear_pixels(const SheetLayout& layout, int tile, TileSize size, SheetPicture& picture) {
  const Cell place = layout.place_of(tile);
  for (int y = place.y * size.height; y < (place.y + 1) * size.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
    const auto from = picture.rgba.begin() +
                      static_cast<std::ptrdiff_t>(4 * (row + static_cast<std::size_t>(place.x * size.width)));
    std::fill_n(from, 4 * size.width, std::uint8_t{0});
  }
}

// The name of a linked picture for LinkedFiles, which decides whether it is read; empty for absolute paths
// that lead out of the folder.
std::string linked_name(const std::string& folder, const std::string& path) {
  std::string inside = linked_path_in(folder, path);
  return inside.empty() && fs::path(path).is_relative() ? path : inside;
}

// The path of a picture that was read: without "..", or, where it leads out of the folder, with the folder in
// front of it.
std::string read_link(const std::string& folder, const std::string& path) {
  std::error_code failure;
  if (!linked_path_in(folder, path).empty())
    return fs::weakly_canonical(fs::path(folder) / path, failure).string();
  return (fs::weakly_canonical(folder, failure) / path).string();
}

// With the rows that a picture has more than before, if the tileset is the last thing on the sheet.
void grow_last(const RgbaPicture& picture, Level& level) {
  Tileset& set = level.tilesets.back();
  const SheetLayout layout = level.sheet(SheetId::tiles).layout();
  const TileCut& cut = set.link->cut;
  if (!problem_of(cut, picture.width, picture.height).empty()) return;
  const CutGrid grid = grid_of(cut, picture.width, picture.height);
  const bool is_last = set.first + set.count == layout.count && layout.place_of(set.first).x == 0;
  const int count = (grid.rows - 1) * layout.columns + set.columns;
  const SheetLayout after{layout.columns, set.first + count};
  if (!is_last || grid.columns != set.columns || count <= set.count || after.count > kMaxTiles ||
      after.rows() > kMaxSheetSide)
    return;
  const auto before = std::exchange(level.sheet(SheetId::tiles).picture, nullptr);
  level.set_tile_layout(after);
  level.tilesets.back().count = count;
  if (before == nullptr) return;
  SheetPicture larger = *before;
  larger.height = after.rows() * level.map.tile_size().height;
  larger.rgba.resize(4 * static_cast<std::size_t>(larger.width) * static_cast<std::size_t>(larger.height));
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(larger));
}

}  // namespace

FormatResult<void> draw_tilesets(std::span<const ShownTileset> shown, Level& level) {
  if (shown.empty()) return {};
  Sheet& sheet = level.sheet(SheetId::tiles);
  const SheetLayout layout = sheet.layout();
  const TileSize tile = level.map.tile_size();
  const std::int64_t wide = std::int64_t{layout.columns} * tile.width;
  const std::int64_t high = std::int64_t{layout.rows()} * tile.height;
  if (wide > kMaxSheetPictureSide || high > kMaxSheetPictureSide || wide * high > kMaxSheetPicturePixels)
    return tl::unexpected(FormatError{
        "", "has too many tiles of that size for a picture: " + std::to_string(wide) + "x" +
                std::to_string(high) + " px, but at most " + std::to_string(kMaxSheetPictureSide) +
                " px a side and " + std::to_string(kMaxSheetPicturePixels) + " px in all can be shown"});
  SheetPicture picture = picture_of(level);
  std::vector<int> tiles;
  for (const ShownTileset& each : shown) {
    const Tileset& set = level.tilesets[static_cast<std::size_t>(each.tileset)];
    for_each_tile(set, layout, [&](int number, Cell place) {
      tiles.push_back(number);
      const Cell corner = layout.place_of(number);
      for (int y = 0; y < tile.height; ++y) {
        for (int x = 0; x < tile.width; ++x) {
          const Pixel color = color_of(each, set, place, tile, x, y);
          const std::size_t row =
              static_cast<std::size_t>(corner.y * tile.height + y) * static_cast<std::size_t>(picture.width);
          std::copy(color.begin(), color.end(),
                    &picture.rgba[4 * (row + static_cast<std::size_t>(corner.x * tile.width + x))]);
        }
      }
    });
  }
  sheet.picture = std::make_shared<const SheetPicture>(std::move(picture));
  take_images(tiles, level);
  return {};
}

Sheet without_linked_pixels(const Level& level, const std::vector<Tileset>& tilesets) {
  Sheet sheet = level.sheet(SheetId::tiles);
  if (sheet.picture == nullptr) return sheet;
  const TileSize size = level.map.tile_size();
  auto picture = std::make_shared<SheetPicture>(*sheet.picture);
  for (const Tileset& set : tilesets) {
    if (!set.link) continue;
    for_each_tile(set, sheet.layout(), [&](int tile, Cell) {
      sheet.images[static_cast<std::size_t>(tile)] = {};
      clear_pixels(sheet.layout(), tile, size, *picture);
    });
  }
  Level rest;
  rest.map = TileMap(1, 1, size);
  rest.palette = level.palette;
  rest.sheet(SheetId::tiles) = sheet;
  const bool is_needed = !images_show(*picture, rest);
  sheet.picture = is_needed ? std::shared_ptr<const SheetPicture>(std::move(picture)) : nullptr;
  return sheet;
}

std::string linked_path_in(const std::string& folder, const std::string& path) {
  std::error_code failure;
  const fs::path root = fs::weakly_canonical(folder.empty() ? "." : folder, failure);
  const fs::path given(path);
  const fs::path file = fs::weakly_canonical(given.is_absolute() ? given : root / given, failure);
  if (failure || root.empty() || file.empty()) return "";
  const fs::path inside = file.lexically_relative(root);
  if (inside.empty() || *inside.begin() == ".." || inside == ".") return "";
  return inside.generic_string();
}

std::string stored_link(const std::string& folder, const std::string& path) {
  if (std::string inside = linked_path_in(folder, path); !inside.empty()) return inside;
  if (fs::path(path).is_relative()) return path;
  std::error_code failure;
  const std::string root = fs::weakly_canonical(folder.empty() ? "." : folder, failure).string() + "/";
  return path.starts_with(root + "../") ? path.substr(root.size()) : "";
}

FormatResult<void> read_linked_tilesets(const FormatContext& context, Level& level) {
  const bool has_links = std::any_of(level.tilesets.begin(), level.tilesets.end(),
                                     [](const Tileset& set) { return set.link.has_value(); });
  if (!has_links || context.folder.empty()) return {};
  ImportDrops drops;
  LinkedFiles files(context, drops);
  std::vector<std::shared_ptr<const LinkedPicture>> pictures;
  std::vector<ShownTileset> shown;
  for (std::size_t i = 0; i < level.tilesets.size(); ++i) {
    Tileset& set = level.tilesets[i];
    if (!set.link) continue;
    TilesetLink& link = *set.link;
    const std::string of = "the picture of the tileset " + quoted_name(set.name);
    const std::string name = linked_name(context.folder, link.path);
    if (!name.empty()) {
      pictures.push_back(files.picture(name, of));
    } else {
      drops.add(of + ", file " + link.path + ": lies outside of the folder of the level");
      files.note_missing(link.path);
    }
    link.is_missing = name.empty() || pictures.back()->is_missing;
    const RgbaPicture* const picture = link.is_missing ? nullptr : &pictures.back()->rgba;
    const bool is_inside = !linked_path_in(context.folder, link.path).empty();
    if (is_inside || !link.is_missing) link.path = read_link(context.folder, link.path);
    if (picture != nullptr && i + 1 == level.tilesets.size()) grow_last(*picture, level);
    shown.push_back({static_cast<int>(i), level.tilesets[i].link->cut, picture});
  }
  if (context.dropped != nullptr)
    for (std::string& phrase : drops.phrases()) context.dropped->push_back(std::move(phrase));
  return draw_tilesets(shown, level);
}

}  // namespace talus
