// What the panels about the whole level show.
#pragma once

#include <cstddef>
#include <optional>

#include "level/lint/lint.h"

namespace talus {

// What the problems panel shows, besides the problems.
struct ProblemsView {
  const LintRule* kind = nullptr;  // the only listed rule; null: all rules
  std::optional<Problem> chosen;   // the problem that was gone to last
  std::size_t row = 0;             // its place in the list at that time
};

struct LevelView {
  ProblemsView problems;
  bool resize_open = false;      // the dialog of the map's size
  bool new_level_open = false;   // the dialog of a new level's size
  bool find_tiles_open = false;  // the window that finds and replaces tiles
  int find_tile = 0;             // of the level, the tile that it finds
  int replace_tile = 0;          // of the level, the tile that replaces it
};

}  // namespace talus
