// Pictures of a map of Tiled that a level shows besides its sheet: large tiles, objects, image layers.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <talus/level/object_layer.h>
#include "tiled_tiles.h"

namespace talus {

// All must outlive it. Pictures are shared, and those beyond the limits of a level are dropped.
class TiledParts {
 public:
  TiledParts(const TiledMap& map, const TiledPictures& pictures, ImportDrops& drops)
      : map_(map), pictures_(pictures), drops_(drops) {}

  // Those tiles of the level that reach beyond their cells, or are not drawn in their own size.
  LargeTiles large_tiles(const TiledTiles& tiles);
  // Gives an object the picture of its tile, if it has one, and where its position is in it.
  void show(std::uint32_t gid, MapObject& object);
  // px, of the tile of a number; 0 if no tileset has it.
  Vec2 size_of(std::uint32_t gid) const;
  LayerImage image_of(const TiledImage& image);
  // Says what was dropped, once.
  void tell_missing();

 private:
  // Without a picture if it is not known.
  PicturePart part_of(const TiledSource& source);
  std::shared_ptr<const SheetPicture> picture_of(const RgbaPicture& rgba, std::optional<Rgb> transparent);

  const TiledMap& map_;
  const TiledPictures& pictures_;
  ImportDrops& drops_;
  using Key = std::pair<const RgbaPicture*, int>;  // with the colour that is transparent; -1: none
  std::map<Key, std::shared_ptr<const SheetPicture>> known_;
  std::map<std::uint32_t, PicturePart> parts_;  // by number in cells
  std::size_t pixels_ = 0;                      // of known_
  int missing_ = 0;                             // pictures that are too much
};

}  // namespace talus
