// The commands of players: they place the first one, and steer those of the simulation while their keys are
// held.
#include "command_table.h"
#include "edit/spawn_tools.h"
#include "panels/canvas/opening_area.h"
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

// Where the level opens, as nobody is there yet to be followed.
void place_player(S session, A actions, U ui) {
  const Level& level = session.level();
  const Vec2 place = opening_area(level, session.state()).area.center();
  const Spawn player = player_near(level, session.scene().ground.get(), place);
  actions.push_back(action::EditLevel{add_spawn(level, player)});
  actions.push_back(action::SelectSpawn{static_cast<int>(level.spawns.size())});
  actions.push_back(action::ResetPlay{});
  actions.push_back(action::Play{});
  let_keys_steer(session, ui.view);
}

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
  all.push_back({.id = "player/place",
                 .label = "Place a player and play",
                 .help =
                     "Puts a player on the ground, in the middle of what the level shows when it opens, and "
                     "plays it. One undo takes it back.",
                 .menu = menus::kPlayRun,
                 .run = place_player,
                 .enabled = [](S session, const Ui&) { return !has_players(session); },
                 .words = "add new first body character test"});
  return all;
}

}  // namespace talus
