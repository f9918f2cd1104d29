// Small levels from text, for the tests of the lint and of its fixes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "level/lint/lint.h"

namespace talus {

// '.' empty, '#' solid, 'a' and 'b' the halves of an up-slope with their own shapes, 'c' and 'd' those of a
// down-slope, 'e' 5 px high, '^' a ceiling that hangs down by 3 px at its right, 'o' a ball, '/' the left
// half of a flagged up-slope and '-' its right half. The number of a tile is its place in this list.
inline constexpr std::string_view kSlopeSigns = ".#abcde^o/-";
inline constexpr std::uint8_t kSolidSign = 1, kSlopeA = 2, kSlopeB = 3, kBlockE = 6, kHangingSign = 7,
                              kBallSign = 8, kFlaggedSlope = 9, kFlaggedHalf = 10;

inline Level slope_level(const std::vector<std::string>& rows) {
  using Kind = TileShape::Kind;
  Level level;
  level.map = TileMap(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < level.map.height(); ++y) {
    for (int x = 0; x < level.map.width(); ++x) {
      const char sign = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      level.map.set({x, y}, static_cast<TileNumber>(kSlopeSigns.find(sign)));
    }
  }
  Sheet& tiles = level.sheet(SheetId::tiles);
  for (std::size_t tile = 1; tile < kSlopeSigns.size(); ++tile) tiles.images[tile].fill(1);
  tiles.flags[kSolidSign] = 1;
  tiles.flags[kBallSign] = 2;
  tiles.flags[kFlaggedSlope] = 4;
  // The upper left half of the left tile is clear, and only a corner of the right tile.
  for (std::size_t i = 0; i < 32; ++i) tiles.images[kFlaggedSlope][i] = 0;
  tiles.images[kFlaggedHalf][0] = 0;
  level.tile_shapes[kSlopeA] = {.kind = Kind::slope, .heights = {0, 4}};
  level.tile_shapes[kSlopeB] = {.kind = Kind::slope, .heights = {4, 8}};
  level.tile_shapes[4] = {.kind = Kind::slope, .heights = {8, 4}};
  level.tile_shapes[5] = {.kind = Kind::slope, .heights = {4, 0}};
  level.tile_shapes[kBlockE] = {.kind = Kind::slope, .heights = {5, 5}};
  level.tile_shapes[kHangingSign] = {
      .kind = Kind::slope, .side = TileShape::Side::ceiling, .heights = {0, 3}};
  return level;
}

// The problems that lint finds, each as "code: message".
inline std::vector<std::string> lint_lines(const Level& level, const LintOptions& options = {}) {
  std::vector<std::string> lines;
  for (const Problem& problem : lint(level, options))
    lines.push_back(std::string(problem.rule->code) + ": " + problem.message);
  return lines;
}

}  // namespace talus
