// OpenLevel: the level of a session with its history, its file, and what the user allows its exports.
// LevelHandler changes it, FileHandler its file; the others read it. Both may ask for another file.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <talus/level/level.h>
#include "edit/undo_stack.h"
#include "session/files/export_permissions.h"
#include "sheet_changes.h"

namespace talus {

inline constexpr const char* kUnnamed = "untitled";  // for titles, while the level has no file

struct Format;

struct OpenLevel {
  // permission_store: see ExportPermissions.
  OpenLevel(Level opened, std::string its_path, std::string permission_store)
      : level(std::move(opened)), path(std::move(its_path)), permissions(std::move(permission_store)) {}

  Level level;
  UndoStack history;
  SheetChanges sheet_changes;
  std::uint64_t revision = 0;  // grows with every change of the level, also by undo and opening
  int last_stroke = 0;         // the highest number of a stroke so far
  std::string path;            // of its file; empty: it has none
  // Of the file, as which saving writes it; null: there is none, or an unknown one.
  const Format* format = nullptr;
  bool wants_save_as = false;  // the user is to name a file: see Session::wants_save_as()
  ExportPermissions permissions;
};

}  // namespace talus
