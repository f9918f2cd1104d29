#include "tiled_parts.h"

#include <algorithm>
#include <string>

namespace talus {

LargeTiles TiledParts::large_tiles(const TiledTiles& tiles) {
  LargeTiles large;
  for (std::size_t n = 0; n < tiles.sources.size(); ++n) {
    const TiledSource& source = tiles.sources[n];
    if (source.tileset < 0) continue;
    const TiledPlace place = place_of_tile(map_, pictures_, source);
    if (place.is_in_cell) continue;
    const bool fits_grid = map_.tilesets[static_cast<std::size_t>(source.tileset)].fits_grid;
    const TileSize size = fits_grid ? map_.tile_size : place.size;
    if (size.width > kMaxLargeTileSide || size.height > kMaxLargeTileSide) continue;
    LargeTile tile{part_of(source), size};
    if (!fits_grid) tile.part.keeps_ratio = false;
    if (tile.part.picture != nullptr) large[static_cast<TileNumber>(n)] = std::move(tile);
  }
  return large;
}

void TiledParts::show(std::uint32_t gid, MapObject& object) {
  if (object.form != MapObject::Form::tile) return;
  const TiledSource source = source_of_gid(map_, gid);
  if (source.tileset < 0) return;
  const auto [known, is_new] = parts_.try_emplace(gid);
  if (is_new) known->second = part_of(source);
  object.picture = known->second;
  object.anchor = anchor_of_gid(map_, gid);
  if (object.size == Vec2()) object.size = size_of(gid);
}

Vec2 TiledParts::size_of(std::uint32_t gid) const {
  const TiledSource source = source_of_gid(map_, gid);
  if (source.tileset < 0) return {};
  const TileSize own = size_in_picture(map_, pictures_, source);
  return {1.0 * own.width, 1.0 * own.height};
}

LayerImage TiledParts::image_of(const TiledImage& image) {
  LayerImage made{.path = is_data_name(image.path) ? "" : image.path};
  made.repeats_x = image.repeats_x;
  made.repeats_y = image.repeats_y;
  if (image.picture == nullptr || image.picture->is_missing) return made;
  made.part.picture = picture_of(image.picture->rgba, image.transparent);
  if (made.part.picture == nullptr) return made;
  made.part.width = made.part.picture->width;
  made.part.height = made.part.picture->height;
  return made;
}

void TiledParts::tell_missing() {
  if (missing_ > 0)
    drops_.add(std::to_string(missing_) + " pictures of tiles, objects or layers, which have more than " +
               std::to_string(kMaxPartPixels) + " px together");
}

PicturePart TiledParts::part_of(const TiledSource& source) {
  const auto of = static_cast<std::size_t>(source.tileset);
  const TiledTileset& tileset = map_.tilesets[of];
  PicturePart part;
  if (pictures_[of] == nullptr || pictures_[of]->is_missing()) return part;
  const TileSize size = size_in_picture(map_, pictures_, source);
  if (tileset.is_collection) {
    const auto own = pictures_[of]->of_tiles.find(source.id);
    const TiledTile* const tile = find_tile(tileset, source.id);
    if (tile == nullptr || own == pictures_[of]->of_tiles.end() || own->second == nullptr) return part;
    part.picture = picture_of(*own->second, tileset.transparent);
    part.x = tile->image_x;
    part.y = tile->image_y;
  } else {
    part.picture = picture_of(pictures_[of]->file->rgba, tileset.transparent);
    const Cell place = grid_of(tileset).place_of(source.id);
    part.x = tileset.margin + place.x * (size.width + tileset.spacing);
    part.y = tileset.margin + place.y * (size.height + tileset.spacing);
  }
  if (part.picture == nullptr) return part;
  part.width = tileset.is_collection ? std::min(size.width, part.picture->width - part.x) : size.width;
  part.height = tileset.is_collection ? std::min(size.height, part.picture->height - part.y) : size.height;
  part.shift_x = tileset.offset_x;
  part.shift_y = tileset.offset_y;
  part.keeps_ratio = tileset.keeps_ratio;
  part.swaps_axes = (source.turn & kTiledFlipXY) != 0;
  part.mirrors_x = (source.turn & kTiledFlipX) != 0;
  part.mirrors_y = (source.turn & kTiledFlipY) != 0;
  return is_valid(part) ? part : PicturePart();
}

// Null if it is too large.
std::shared_ptr<const SheetPicture> TiledParts::picture_of(const RgbaPicture& rgba,
                                                           std::optional<Rgb> transparent) {
  const int color = transparent ? transparent->r << 16 | transparent->g << 8 | transparent->b : -1;
  const auto [known, is_new] = known_.try_emplace({&rgba, color});
  if (!is_new) return known->second;
  const std::size_t pixels = rgba.bytes.size() / 4;
  if (pixels == 0) return nullptr;
  if (pixels_ + pixels > kMaxPartPixels) {
    ++missing_;
    return nullptr;
  }
  pixels_ += pixels;
  SheetPicture picture{rgba.width, rgba.height, {rgba.bytes.begin(), rgba.bytes.end()}};
  for (std::size_t i = 0; transparent && i < picture.rgba.size(); i += 4) {
    if (*transparent == Rgb{picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]})
      std::fill_n(&picture.rgba[i], 4, std::uint8_t{0});
  }
  return known->second = std::make_shared<const SheetPicture>(std::move(picture));
}

}  // namespace talus
