// Finds the part of a picture for each tile, as picture_of_ldtk_cell() draws it.
#include "ldtk_picture_tiles.h"

#include <algorithm>

namespace talus {
namespace {

TileSource source_in_picture(const LdtkTiles& tiles, const LdtkCell& cell, const LdtkPictures& pictures,
                             PictureTiles& found) {
  TileSource part;
  const auto is_seen = [](const LdtkPart& its) { return !its.is_hidden; };
  const auto seen = std::count_if(cell.parts.begin(), cell.parts.end(), is_seen);
  part.problem = seen == 0 ? "it is empty; choose another one on the sheet"
                           : "it shows several tiles of LDtk over one another";
  if (seen != 1) return part;
  const LdtkPart& shown = *std::find_if(cell.parts.begin(), cell.parts.end(), is_seen);
  const LdtkSource& source = tiles.sources[shown.source];
  part.problem = "it shows a colour, and no tile of a tileset";
  if (source.tileset < 0) return part;
  const auto& picture = pictures[static_cast<std::size_t>(source.tileset)];
  part.problem = "its picture is missing";
  if (picture == nullptr || picture->is_missing) return part;
  part.problem = "LDtk shows it with an opacity of its own";
  if (source.opacity != 255) return part;
  part.problem = nullptr;
  part.file = found.file_at(picture->path, std::nullopt);
  part.part = {source.x, source.y, source.side, source.side};
  part.corner = {shown.x, shown.y};
  part.flips_x = (source.flips & 1) != 0;
  part.flips_y = (source.flips & 2) != 0;
  return part;
}

}  // namespace

PictureTiles picture_tiles_of(const LdtkTiles& tiles, const LdtkPictures& pictures) {
  PictureTiles found;
  found.tiles.reserve(tiles.cells.size());
  for (const LdtkCell& cell : tiles.cells)
    found.tiles.push_back(source_in_picture(tiles, cell, pictures, found));
  return found;
}

}  // namespace talus
