// The keys of the players: which they are, when they steer, and which are held.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "panels/commands/keys.h"
#include "panels/view.h"
#include "session/session.h"

namespace talus {

struct PlayKey {
  int key;
  bool action::HoldKeys::*held;
};
inline constexpr std::array<PlayKey, 5> kPlayKeys = {{{kKeyLeft, &action::HoldKeys::left},
                                                      {kKeyRight, &action::HoldKeys::right},
                                                      {kKeyUp, &action::HoldKeys::jump},
                                                      {' ', &action::HoldKeys::jump},
                                                      {'z', &action::HoldKeys::jump}}};
// For the tooltips, the help and the play view.
inline constexpr std::string_view kRunKeys = "Left, Right", kJumpKeys = "Up, Space, Z";

// Whether the level has a player that keys can move: one of the exact solver's.
bool has_players(const Session& session);
// Whether these keys steer players and nothing else: the keys go to the map and to no cursor there, and the
// simulation runs or the play view was used last.
bool keys_steer(const Session& session, const View& view);
// Gives the keys to the players, if there are any.
void let_keys_steer(const Session& session, View& view);

class HeldPlayKeys {
 public:
  // False: the key is none of the players'.
  bool set(int key, bool down);
  void release_all() { down_ = {}; }
  action::HoldKeys held() const;

 private:
  std::array<bool, kPlayKeys.size()> down_{};
};

}  // namespace talus
