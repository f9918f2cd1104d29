#include "shown_level.h"

namespace talus {

std::optional<std::string> window_problem(const Level& level) {
  const TileSize tile = level.map.tile_size();
  if (tile == TileSize()) return std::nullopt;
  return "has tiles of " + std::to_string(tile.width) + "x" + std::to_string(tile.height) +
         " px, but the window shows only tiles of 8x8 px so far: the commands without a window take it";
}

FormatResult<LoadedLevel> load_for_window(const std::string& path, const ImportChoices& choices,
                                          const Progress& progress) {
  FormatResult<LoadedLevel> loaded = load_level(path, choices, progress);
  if (!loaded) return loaded;
  if (auto problem = window_problem(loaded->level))
    return tl::unexpected(FormatError{"", *std::move(problem)});
  return loaded;
}

}  // namespace talus
