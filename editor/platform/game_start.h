// GameStart: exports the game of a level, and runs it in LÖVE when it is written.
#pragma once

#include <optional>
#include <string>

#include <talus/level/exports.h>
#include "open_copies.h"
#include "session/session.h"

namespace talus {

// The level's first preset that makes a game for LÖVE: an index; nothing: it has none.
std::optional<std::size_t> game_preset(const Level& level);

class GameStart {
 public:
  // Saves the level and exports its game, which follow() starts. False: the level has no preset of one.
  bool begin(Session& session, const ProgramCommands& commands);
  // To be called after each frame's actions: starts the game once it is written. What keeps it from being
  // written has been told by the session, and ends the wait.
  void follow(Session& session, const ProgramCommands& commands, OpenCopies& copies);

 private:
  std::optional<ExportPreset> waiting_;  // for its export
  bool is_exporting_ = false;            // it has been asked for
};

}  // namespace talus
