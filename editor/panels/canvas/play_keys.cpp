// When the keys of the players steer, and which are held.
#include "play_keys.h"

namespace talus {

bool has_players(const Session& session) {
  return session.scene().features.players && session.scene().tuning.solver == SolverKind::exact;
}

bool keys_steer(const Session& session, const View& view) {
  if (view.focus != Focus::map || view.cursor.on() || !has_players(session)) return false;
  const bool in_play =
      view.canvas == CanvasMode::play || (view.canvas == CanvasMode::both && view.play_active);
  return session.playback().running || in_play;
}

void let_keys_steer(const Session& session, View& view) {
  if (!has_players(session)) return;
  view.focus = Focus::map;
  view.play_active = true;
}

bool HeldPlayKeys::set(int key, bool down) {
  for (std::size_t i = 0; i < kPlayKeys.size(); ++i) {
    if (kPlayKeys[i].key != key) continue;
    down_[i] = down;
    return true;
  }
  return false;
}

action::HoldKeys HeldPlayKeys::held() const {
  action::HoldKeys keys;
  for (std::size_t i = 0; i < kPlayKeys.size(); ++i) keys.*kPlayKeys[i].held |= down_[i];
  return keys;
}

}  // namespace talus
