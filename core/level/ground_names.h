// What the tiles of ground_level() are called, and why it may have none.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ground_cells.h"

namespace talus {

class GroundNames {
 public:
  GroundNames() = default;  // every number is that of a tile
  // own_tiles: those of the level, from 0. The numbers from there to stacks_at are of objects that are
  // ground, and those from stacks_at on are of these stacks, whose tiles have numbers, too.
  GroundNames(int own_tiles, int stacks_at, std::vector<TileStack> stacks)
      : own_tiles_(own_tiles), stacks_at_(stacks_at), stacks_(std::move(stacks)) {}

  // "tile 12", "tile 12, mirrored,", "tile 3 with tile 12", "an object".
  std::string text_of(int number) const;
  // Says why ground_level() has no ground though the level has, as ground_problem(); else nothing.
  const std::optional<std::string>& problem() const { return problem_; }
  void set_problem(std::optional<std::string> problem) { problem_ = std::move(problem); }
  friend bool operator==(const GroundNames&, const GroundNames&) = default;

 private:
  std::string text_of(MapCell cell) const;

  int own_tiles_ = kMaxTiles, stacks_at_ = kMaxTiles;
  std::vector<TileStack> stacks_;
  std::optional<std::string> problem_;
};

}  // namespace talus
