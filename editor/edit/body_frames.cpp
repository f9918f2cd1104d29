#include "body_frames.h"

#include <algorithm>
#include <cmath>

#include "level/tile_color.h"

namespace talus {
namespace {

// As wide as the body, if the tiles are as high as it is; else the picture is larger than its box, and
// square.
int columns_for(const Spawn& spawn, CellRect tiles, TileSize tile) {
  const auto along = [](double px, int side) { return std::max(1, static_cast<int>(std::ceil(px / side))); };
  const int columns = along(spawn.size.y, tile.height) == tiles.h ? along(spawn.size.x, tile.width) : tiles.h;
  return columns <= tiles.w && tiles.w % columns == 0 ? columns : tiles.w;
}

}  // namespace

Spawn with_size(Spawn spawn, Vec2 size) {
  const auto side = [](double px) { return std::clamp(px, 1.0, kMaxBodySize); };
  size = {side(size.x), side(size.y)};
  spawn.position.x += (spawn.size.x - size.x) / 2;
  spawn.position.y += spawn.size.y - size.y;
  spawn.size = size;
  return spawn;
}

bool shows_nothing(const Level& level, const SpriteArea& area) {
  for (int y = 0; y < area.tiles.h; ++y)
    for (int x = 0; x < area.tiles.w; ++x)
      if (!is_blank(level, static_cast<TileNumber>(area.tile_at(level, x, y)), area.sheet)) return false;
  return true;
}

tl::expected<BodyPicture, std::string> with_frames(const Level& level, const Spawn& spawn, BodyAct act,
                                                   const SpriteArea& area) {
  const CellRect tiles = area.tiles;
  BodyPicture picture = spawn.picture;
  const bool is_first = picture.empty();
  if (!is_first && picture.sheet != area.sheet)
    return tl::unexpected(std::string("The frames of a body are on one sheet, and this one has ") +
                          (picture.sheet == SheetId::tiles ? "tiles." : "sprites."));
  const int columns = is_first ? columns_for(spawn, tiles, level.map.tile_size()) : picture.columns;
  const int rows = is_first ? tiles.h : picture.rows;
  if (columns > kMaxBodyPictureSide || rows > kMaxBodyPictureSide)
    return tl::unexpected("A frame has up to " + std::to_string(kMaxBodyPictureSide) + " tiles a side.");
  if (tiles.h != rows || tiles.w % columns != 0)
    return tl::unexpected("A frame of this body has " + std::to_string(columns) + "x" + std::to_string(rows) +
                          " tiles: choose one or more such frames, side by side.");
  if (tiles.w / columns > kMaxBodyFrames)
    return tl::unexpected("An act has up to " + std::to_string(kMaxBodyFrames) + " frames.");
  picture.columns = static_cast<std::uint8_t>(columns);
  picture.rows = static_cast<std::uint8_t>(rows);
  picture.sheet = area.sheet;
  picture[act] = {static_cast<TileNumber>(level.sheet(area.sheet).layout().tile_at({tiles.x, tiles.y})),
                  static_cast<std::uint8_t>(tiles.w / columns)};
  return picture;
}

BodyPicture with_columns(BodyPicture picture, int columns) {
  for (BodyFrames& frames : picture.acts) {
    if (frames.count == 0) continue;
    const int count = std::clamp(frames.count * picture.columns / columns, 1, kMaxBodyFrames);
    frames.count = static_cast<std::uint8_t>(count);
  }
  picture.columns = static_cast<std::uint8_t>(columns);
  return picture;
}

}  // namespace talus
