// A level with pictures besides its sheet: a large tile, an object and a layer of a picture.
#pragma once

#include <memory>

#include <talus/level/level.h>

namespace talus {

inline constexpr Rgb kTree = {200, 0, 0}, kSky = {0, 0, 200}, kRock = {0, 200, 0};

// A part with all of a picture in one colour.
inline PicturePart plain_part(int width, int height, Rgb color) {
  auto picture = std::make_shared<SheetPicture>(SheetPicture{width, height, {}});
  for (int i = 0; i < width * height; ++i)
    picture->rgba.insert(picture->rgba.end(), {color.r, color.g, color.b, 255});
  PicturePart part{std::move(picture)};
  part.width = width;
  part.height = height;
  return part;
}

// A map of 3x3 cells. Tile 1 is a tree of 8x16 px, at the bottom in the middle; the sky of 2x2 px is behind
// the tiles, at (4, 4); the rock of 8x8 px is in front, with its bottom left corner at (16, 8).
inline Level pictured_level() {
  Level level;
  level.map = TileMap(3, 3);
  level.map.set({1, 2}, 1);
  level.large_tiles[1] = {plain_part(8, 16, kTree), {8, 16}};
  ObjectLayer sky{.name = "sky", .offset = {4, 4}, .place = 0};
  sky.image = LayerImage{.path = "sky.png", .part = plain_part(2, 2, kSky)};
  ObjectLayer things{.name = "things"};
  things.objects.push_back({.form = MapObject::Form::tile, .position = {16, 8}, .size = {8, 8}});
  things.objects.back().picture = plain_part(4, 4, kRock);
  level.objects = {sky, things};
  return level;
}

}  // namespace talus
