#include "ground_names.h"

#include <talus/level/tile_turns.h>

namespace talus {

std::string GroundNames::text_of(MapCell cell) const {
  if (cell.tile >= own_tiles_) return "an object";
  const std::string turn = talus::text_of(cell.turn);
  return "tile " + std::to_string(cell.tile) + (turn.empty() ? "" : ", " + turn + ",");
}

std::string GroundNames::text_of(int number) const {
  const auto stack = static_cast<std::size_t>(number - stacks_at_);
  if (number < stacks_at_ || stack >= stacks_.size())
    return text_of(MapCell(static_cast<TileNumber>(number)));
  std::string text;
  for (const MapCell& cell : stacks_[stack]) text += (text.empty() ? "" : " with ") + text_of(cell);
  return text;
}

}  // namespace talus
