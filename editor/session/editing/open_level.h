// OpenLevel: the level of a session with its history and its file. LevelHandler changes it, FileHandler its
// file; the others read it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <talus/level/level.h>
#include "edit/undo_stack.h"

namespace talus {

inline constexpr const char* kUnnamed = "untitled";  // for titles, while the level has no file

struct OpenLevel {
  OpenLevel(Level opened, std::string its_path) : level(std::move(opened)), path(std::move(its_path)) {}

  Level level;
  UndoStack history;
  std::uint64_t revision = 0;  // grows with every change of the level, also by undo and opening
  int last_stroke = 0;         // the highest number of a stroke so far
  std::string path;            // of its file; empty: it has none
};

}  // namespace talus
