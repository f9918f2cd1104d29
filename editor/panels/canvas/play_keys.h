// The keys of the players: when they steer, and which are held. player_commands() says which keys they are.
#pragma once

#include <string>
#include <vector>

#include "panels/commands/key_bindings.h"
#include "panels/view.h"
#include "session/session.h"

namespace talus {

// Whether the level has a player that keys can move: one of the exact solver.
bool has_players(const Session& session);
// Whether these keys only steer players: the keys go to the map, no cursor is shown there, and the simulation
// runs or the play view was used last.
bool keys_steer(const Session& session, const View& view);
// Gives the keys to the players, if there are any.
void let_keys_steer(const Session& session, View& view);

// "Run: Left, Right   Jump: Up, Space, Z", with the keys as the user has them.
std::string play_keys_text(const KeyBindings& bindings);

class HeldPlayKeys {
 public:
  // Holds what the commands of Scope::play hold by this key, whether Shift is held or not. Returns false if
  // there is no such command.
  // there is no such command.
  bool press(KeyChord chord, const KeyBindings& bindings);
  // Releases what the key holds. Returns false if it holds nothing.
  bool release(int key);
  void release_all() { down_.clear(); }
  action::HoldKeys held() const;

 private:
  struct Down {
    int key;
    bool action::HoldKeys::*held;
  };
  std::vector<Down> down_;  // a repeated key is in it only once
};

}  // namespace talus
