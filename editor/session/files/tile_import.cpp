#include "tile_import.h"

#include <filesystem>
#include <utility>

#include "formats/tilesets/tile_cut.h"

namespace talus {

FormatResult<TileImport> read_tile_import(const std::string& path, bool adds, TileSize wanted) {
  auto file = read_tile_picture(path);
  if (!file) return tl::unexpected(file.error());
  TileImport import{path, adds, std::make_shared<const TileFile>(*std::move(file)), {}, {}};
  const RgbaPicture& picture = import.file->picture;
  import.shown.picture = std::make_shared<const SheetPicture>(SheetPicture{picture.width,
                                                                           picture.height,
                                                                           { picture.bytes.begin(),
                                                                             picture.bytes.end() }});
  import.guess = guess_cut(picture, wanted);
  return import;
}

std::string problem_of(const TileImport& import, const action::ApplyTiles& order) {
  std::string problem = problem_of(order.cut, import.width(), import.height());
  if (!problem.empty() || import.adds) return problem;
  if (order.width < 1 || order.height < 1 || !is_terrain_size(order.width, order.height, order.cut.tile))
    return "A map has at least one cell, and at most 16777216 cells and 16777216 px a side.";
  return "";
}

FormatResult<Level> level_with(const TileImport& import, const action::ApplyTiles& order, const Level& open) {
  const std::string path = std::filesystem::absolute(import.path).lexically_normal().string();
  const TilePicture tiles{.picture = import.file->picture,
                          .palette = import.file->palette,
                          .cut = order.cut,
                          .name = std::filesystem::path(import.path).stem().string(),
                          .link = order.is_linked ? path : ""};
  return import.adds ? with_tileset(open, tiles) : level_of_tiles(tiles, order.width, order.height);
}

}  // namespace talus
