// LevelVersion: what the physics sees of a level. One is kept for each edit. Versions share equal parts, so
// that thousands of edits of a map take little memory.
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
    std::vector<FlagSet> flags;
    FlagRoles roles;
    std::vector<TileShape> tile_shapes;  // as many as flags
    std::array<TileShape, kMaxFlags> flag_shapes;
    friend bool operator==(const Tiles&, const Tiles&) = default;
  };
  // A row of a layer: `width` of these cells, from the one with the index `first`.
  struct Row {
    std::shared_ptr<const MapCells> cells;  // never null
    std::size_t first = 0;
    MapCell at(int x) const { return (*cells)[first + static_cast<std::size_t>(x)]; }
    friend bool operator==(const Row&, const Row&) = default;  // they share their cells
  };
  struct Layer {
    TileLayer looks;        // without cells
    std::vector<Row> rows;  // from the top
  };

  // No pointer is null.
  std::shared_ptr<const Tiles> tiles;
  std::shared_ptr<const std::vector<LevelCurve>> curves;
  std::shared_ptr<const std::vector<ObjectLayer>> objects;
  std::shared_ptr<const std::vector<Spawn>> spawns;
  Tuning tuning;
  TileSize tile_size;         // of the map
  int width = 0;              // cells, of the map
  std::vector<Layer> layers;  // all of one size
  int chosen_layer = 0;
  LayerGroups groups;  // of the layers, also of those of objects
};

// Returns the version of a level. before: the version to share equal parts with; null: there is none.
LevelVersion version_of(const Level& level, const LevelVersion* before = nullptr);
// The same for a level that differs from `before` only in these cells of its layers, in its spawns and in its
// tuning. Takes time by the number of cells.
LevelVersion version_of(const Level& level, const LevelVersion& before, std::span<const Cell> changed);

// Returns the memory in bytes that a version takes besides what it shares with `before`; null: it shares
// nothing.
std::size_t memory_of(const LevelVersion& version, const LevelVersion* before);

// Puts a version into a level; its pictures, names and cart stay. Pictures of tiles that the version lacks
// are removed, and blank ones are added for others.
void put_version(const LevelVersion& version, Level& level);
// Returns a level with that version and no pictures.
Level level_of(const LevelVersion& version);

// Returns the cells of the map in which two versions differ, row by row; nothing if they differ in anything
// else but the looks of layers, or in more than `most` cells.
std::optional<std::vector<Cell>> changed_cells(const LevelVersion& a, const LevelVersion& b,
                                               std::size_t most);

}  // namespace talus
