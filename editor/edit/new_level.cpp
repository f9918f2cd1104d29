// An empty level, and a first scene in it.
#include "new_level.h"

#include <algorithm>
#include <array>
#include <memory>

#include "level/tile_color.h"

namespace talus {
namespace {

enum FirstTile : TileNumber {
  kGrass = 1,
  kEarth,
  kUpSlope,
  kDownSlope,
  kBall,
  kUpLeft = kCartColumns + 1,  // halves of slopes of two tiles, in the next row of the sheet
  kUpRight,
  kDownLeft,
  kDownRight
};
constexpr std::array kFirstTiles = {kGrass,  kEarth,   kUpSlope,  kDownSlope, kBall,
                                    kUpLeft, kUpRight, kDownLeft, kDownRight};
// Of the usual palette.
constexpr std::uint8_t kLightGreen = 5, kGreen = 6, kTeal = 7, kOrange = 3, kYellow = 4;
constexpr int kFloor = 13;  // row of the grass

// depth: px under the surface, negative above it.
std::uint8_t color_of_ground(int depth) {
  return depth < 0 ? 0 : depth == 0 ? kLightGreen : depth == 1 ? kGreen : kTeal;
}

TileImage image_of_first_tile(FirstTile tile) {
  TileImage image{};
  for (int y = 0; y < kCartTileSize; ++y) {
    for (int x = 0; x < kCartTileSize; ++x) {
      std::uint8_t& pixel = image[static_cast<std::size_t>(y * kCartTileSize + x)];
      const int from_middle = (2 * x - 7) * (2 * x - 7) + (2 * y - 7) * (2 * y - 7);
      if (tile == kGrass) pixel = color_of_ground(y);
      if (tile == kEarth) pixel = (x + 3 * y) % 11 == 0 ? kGreen : kTeal;
      if (tile == kUpSlope) pixel = color_of_ground(y - (kCartTileSize - 1 - x));
      if (tile == kDownSlope) pixel = color_of_ground(y - x);
      // The pixels that the slope tool would draw, so that it takes these tiles.
      const int rise = (x + 1) / 2, half = kCartTileSize / 2;
      if (tile == kUpLeft) pixel = color_of_ground(y - (kCartTileSize - rise));
      if (tile == kUpRight) pixel = color_of_ground(y - (half - rise));
      if (tile == kDownLeft) pixel = color_of_ground(y - rise);
      if (tile == kDownRight) pixel = color_of_ground(y - (half + rise));
      if (tile == kBall && from_middle <= 58) pixel = from_middle <= 18 ? kYellow : kOrange;
    }
  }
  return image;
}

void put_first_tiles(Level& level) {
  Sheet& sheet = level.sheet(SheetId::tiles);
  for (const FirstTile tile : kFirstTiles) sheet.images[tile] = image_of_first_tile(tile);
  for (const FirstTile tile : {kGrass, kEarth}) sheet.flags[tile] = FlagSet{1} << level.roles.solid;
  sheet.flags[kUpSlope] = FlagSet{1} << level.roles.up_slope;
  sheet.flags[kDownSlope] = FlagSet{1} << level.roles.down_slope;
  sheet.flags[kBall] = FlagSet{1} << level.roles.ball;
  const double full = level.map.tile_size().height, half = full / 2;
  const auto set_slope = [&](FirstTile tile, double left, double right) {
    level.tile_shapes[tile] = {.kind = TileShape::Kind::slope, .heights = {left, right}};
  };
  set_slope(kUpLeft, 0, half);
  set_slope(kUpRight, half, full);
  set_slope(kDownLeft, full, half);
  set_slope(kDownRight, half, 0);
}

// So that the ground tool works at once.
void put_first_ground(AutoTiles& ground) {
  ground.of(GroundPart::inside) = kEarth;
  ground.of(GroundPart::top) = kGrass;
  ground.of(GroundPart::slope_up) = kUpSlope;
  ground.of(GroundPart::slope_down) = kDownSlope;
  ground.of(GroundPart::slope_up_left) = kUpLeft;
  ground.of(GroundPart::slope_up_right) = kUpRight;
  ground.of(GroundPart::slope_down_left) = kDownLeft;
  ground.of(GroundPart::slope_down_right) = kDownRight;
}

void put_if_inside(Level& level, Cell cell, TileNumber tile) {
  if (level.map.contains(cell)) level.map.set(cell, tile);
}

void cover_grass(Level& level, int x, int end) {
  for (; x < end; ++x) put_if_inside(level, {x, kFloor}, kEarth);
}

// A hill of so many cells of height, from a column on: up, a level top, and down.
void put_hill(Level& level, int x, int height, int top) {
  cover_grass(level, x, x + 2 * height + top);
  for (int step = 0; step < height; ++step) {
    const int y = kFloor - 1 - step, right = x + 2 * height + top - 1 - step;
    put_if_inside(level, {x + step, y}, kUpSlope);
    for (int inner = x + step + 1; inner < right; ++inner)
      put_if_inside(level, {inner, y}, step == height - 1 ? kGrass : kEarth);
    put_if_inside(level, {right, y}, kDownSlope);
  }
}

// One cell high: a slope of two tiles up, a level top, and one down.
void put_low_hill(Level& level, int x, int top) {
  cover_grass(level, x, x + top + 4);
  put_if_inside(level, {x++, kFloor - 1}, kUpLeft);
  put_if_inside(level, {x++, kFloor - 1}, kUpRight);
  for (const int end = x + top; x < end; ++x) put_if_inside(level, {x, kFloor - 1}, kGrass);
  put_if_inside(level, {x++, kFloor - 1}, kDownLeft);
  put_if_inside(level, {x, kFloor - 1}, kDownRight);
}

void put_first_scene(Level& level) {
  for (int y = kFloor; y < level.map.height(); ++y)
    for (int x = 0; x < level.map.width(); ++x) level.map.set({x, y}, y == kFloor ? kGrass : kEarth);
  put_low_hill(level, 8, 3);
  put_hill(level, 17, 2, 3);
  for (int x = 25; x < 30; ++x) put_if_inside(level, {x, kFloor - 5}, kGrass);
  put_if_inside(level, {26, kFloor - 10}, kBall);  // it stays on the ledge, out of the player's way
  const TileSize tile = level.map.tile_size();
  level.tuning.shared.slope_width = tile.width;  // else a slope is two tiles wide
  level.tuning.shared.slope_height = tile.height;
  level.tuning.exact.gravity = level.tuning.player.gravity;  // all bodies fall alike, by the closed form
  level.tuning.exact.rebound = 1;
  Spawn& player = level.spawns.emplace_back();
  player.kind = BodyKind::player;
  player.size = {1.0 * tile.width, 1.0 * tile.height};
  player.position = {4.0 * tile.width, (kFloor - 1.0) * tile.height};
}

// Large tiles are fewer, so that their picture is at most 16 MB.
SheetLayout layout_of_pictures(TileSize tile) {
  constexpr int kMaxPixels = 4'194'304;
  const int rows =
      std::clamp(kMaxPixels / (kCartColumns * tile.width * tile.height), 1, kCartTiles / kCartColumns);
  return {kCartColumns, rows * kCartColumns};
}

// The images at the size of the map's tiles; colour 0 is clear.
std::shared_ptr<const SheetPicture> picture_of_first_tiles(const Level& level) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const SheetLayout layout = sheet.layout();
  const TileSize tile = level.map.tile_size();
  SheetPicture picture{layout.columns * tile.width, layout.rows() * tile.height, {}};
  picture.rgba.resize(4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  for (const FirstTile number : kFirstTiles) {
    const Cell place = layout.place_of(number);
    for (int y = 0; y < tile.height; ++y) {
      for (int x = 0; x < tile.width; ++x) {
        const std::uint8_t index = color_at(sheet.images[number], tile, x, y);
        const Rgb color = level.palette[index];
        const auto at = 4 * (static_cast<std::size_t>(place.y * tile.height + y) * picture.width +
                             static_cast<std::size_t>(place.x * tile.width + x));
        if (index == 0) continue;
        picture.rgba[at] = color.r, picture.rgba[at + 1] = color.g, picture.rgba[at + 2] = color.b;
        picture.rgba[at + 3] = 255;
      }
    }
  }
  return std::make_shared<const SheetPicture>(std::move(picture));
}

}  // namespace

Level new_level(TileSize tile, int width, int height, NewContent content) {
  Level level;
  level.map = TileMap(width, height, tile);
  level.tuning = new_tuning(tile);
  if (content.plays) {
    put_first_tiles(level);
    put_first_ground(level.auto_tiles);
    put_first_scene(level);
  }
  if (content.in_true_colour || tile != TileSize{}) {
    level.set_tile_layout(layout_of_pictures(tile));
    level.sheet(SheetId::tiles).picture = picture_of_first_tiles(level);
  }
  return level;
}

}  // namespace talus
