// When the keys of the players steer, and which are held.
#include "play_keys.h"

#include <algorithm>

#include "panels/commands/commands.h"

namespace talus {

bool has_players(const Session& session) {
  return session.scene().features.players && session.scene().tuning.solver == SolverKind::exact;
}

bool keys_steer(const Session& session, const View& view) {
  if (view.window.focus != Focus::map || view.canvas.cursor.on() || !has_players(session)) return false;
  const bool in_play = view.canvas.mode == CanvasMode::play ||
                       (view.canvas.mode == CanvasMode::both && view.canvas.play_active);
  return session.playback().running || in_play;
}

void let_keys_steer(const Session& session, View& view) {
  if (!has_players(session)) return;
  view.window.focus = Focus::map;
  view.canvas.play_active = true;
}

std::string play_keys_text(const KeyBindings& bindings) {
  const auto keys_for = [&](std::initializer_list<bool action::HoldKeys::*> held) {
    std::string names;
    for (const Command& command : commands()) {
      if (command.holds == nullptr || std::find(held.begin(), held.end(), command.holds) == held.end())
        continue;
      const std::string keys = keys_of(command, bindings);
      if (!keys.empty()) names += (names.empty() ? "" : ", ") + keys;
    }
    return names;
  };
  using Keys = action::HoldKeys;
  return "Run: " + keys_for({&Keys::left, &Keys::right}) + "   Jump: " + keys_for({&Keys::jump});
}

bool HeldPlayKeys::press(KeyChord chord, const KeyBindings& bindings) {
  chord.shift = false;
  release(chord.key);
  const std::size_t before = down_.size();
  for (const Command& command : commands()) {
    if (command.holds == nullptr) continue;
    for (KeyChord key : command_keys(command, bindings)) {
      key.shift = false;
      if (key && key == chord) down_.push_back({chord.key, command.holds});
    }
  }
  return down_.size() > before;
}

bool HeldPlayKeys::release(int key) {
  return std::erase_if(down_, [key](const Down& down) { return down.key == key; }) > 0;
}

action::HoldKeys HeldPlayKeys::held() const {
  action::HoldKeys keys;
  for (const Down& down : down_) keys.*down.held = true;
  return keys;
}

}  // namespace talus
