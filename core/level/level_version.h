// What the physics sees of a level, kept for each of its edits: versions share what is equal in them, so that
// thousands of edits of a map take little memory.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <talus/level/level.h>

namespace talus {

struct LevelVersion {
  struct Tiles {
    std::array<std::uint8_t, kTileCount> flags{};
    FlagRoles roles;
    std::array<TileShape, kTileCount> tile_shapes;
    std::array<TileShape, kFlagCount> flag_shapes;
    friend bool operator==(const Tiles&, const Tiles&) = default;
  };
  using Row = std::vector<std::uint8_t>;  // tiles of a row of the map, left to right

  // None of the pointers is null.
  std::shared_ptr<const Tiles> tiles;
  std::shared_ptr<const std::vector<LevelCurve>> curves;
  std::shared_ptr<const std::vector<Spawn>> spawns;
  Tuning tuning;
  std::vector<std::shared_ptr<const Row>> rows;  // of the map, from the top; all of one length
};

// The version that a level is. before: the one whose equal parts are shared; null: none.
LevelVersion version_of(const Level& level, const LevelVersion* before = nullptr);
// The same for a level that differs from `before` in these cells of the map, by whose number it takes time,
// and otherwise in its spawns and its tuning alone.
LevelVersion version_of(const Level& level, const LevelVersion& before, std::span<const Cell> changed);

// The memory, in bytes, that a version takes besides what it shares with `before`; null: it shares nothing.
std::size_t memory_of(const LevelVersion& version, const LevelVersion* before);

// Gives a level what the version has; pictures, names and carts stay.
void put_version(const LevelVersion& version, Level& level);
// A level that is that version and has no pictures.
Level level_of(const LevelVersion& version);

// The cells of the map in which two versions differ, row by row; nothing when they differ in more than that,
// or in more than `most` cells.
std::optional<std::vector<Cell>> changed_cells(const LevelVersion& a, const LevelVersion& b,
                                               std::size_t most);

}  // namespace talus
