// GameStart: exports the game of a level, and runs it in LÖVE once it is written.
#pragma once

#include <optional>
#include <string>

#include <talus/level/exports.h>
#include "session/session.h"

namespace talus {

// Index of the level's first preset that makes a game for LÖVE; nothing if it has none.
std::optional<std::size_t> game_preset(const Level& level);

class GameStart {
 public:
  // Exports the level's game as it is now, saved or not, and follow() starts it. By its preset, which asks
  // for a file if the level has none, or else into a folder of Talus's own state. Returns false if the level
  // has no such preset, but a game is in the folder of its file.
  bool begin(Session& session, const ProgramCommands& commands);
  // Call it after each frame's actions: starts the game once it is written. If the export fails, the session
  // has said why, and the wait ends.
  void follow(Session& session, const ProgramCommands& commands);

 private:
  std::optional<ExportPreset> waiting_;  // the preset whose export it waits for
  std::string own_folder_;               // absolute, for a level without a preset; empty: it has one
  bool is_exporting_ = false;            // whether the export was requested
};

}  // namespace talus
