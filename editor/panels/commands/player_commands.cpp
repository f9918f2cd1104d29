// The commands that steer the players of the simulation while their keys are held.
#include "command_table.h"
#include "panels/canvas/play_keys.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;
using Keys = action::HoldKeys;

// A menu item cannot be held, so it gives the keys to the players.
void give_keys_to_players(S session, A, U ui) { let_keys_steer(session, ui.view); }

bool has_player(S session, const Ui&) { return has_players(session); }

Command player_command(std::string id, std::string label, KeyChord key, bool Keys::*holds) {
  return {.id = std::move(id),
          .label = std::move(label),
          .help =
              "Steers the players while the key is down, if the level plays or the play view was clicked "
              "last. The solver must be exact. A step by hand uses the keys that are held.",
          .key = key,
          .scope = Scope::play,
          .run = give_keys_to_players,
          .enabled = has_player,
          .holds = holds,
          .words = "player move walk steer character"};
}

}  // namespace

std::vector<Command> player_commands() {
  std::vector<Command> all = {player_command("player/left", "Run left", {kKeyLeft}, &Keys::left),
                              player_command("player/right", "Run right", {kKeyRight}, &Keys::right),
                              player_command("player/jump", "Jump", {kKeyUp}, &Keys::jump),
                              player_command("player/jump_more", "Jump, other keys", {' '}, &Keys::jump)};
  all.back().other_key = {'z'};
  return all;
}

}  // namespace talus
