// GameStart: exports the game of a level, and runs it in LÖVE once it is written.
#pragma once

#include <optional>
#include <string>

#include <talus/level/exports.h>
#include "open_copies.h"
#include "session/session.h"

namespace talus {

// Index of the level's first preset that makes a game for LÖVE; nothing if it has none.
std::optional<std::size_t> game_preset(const Level& level);

class GameStart {
 public:
  // Saves the level and exports its game, which follow() starts. Returns false if the level has no such
  // preset.
  bool begin(Session& session, const ProgramCommands& commands);
  // Call it after each frame's actions: starts the game once it is written. If the export fails, the session
  // has said why, and the wait ends.
  void follow(Session& session, const ProgramCommands& commands, OpenCopies& copies);

 private:
  std::optional<ExportPreset> waiting_;  // the preset whose export it waits for
  bool is_exporting_ = false;            // whether the export was requested
};

}  // namespace talus
