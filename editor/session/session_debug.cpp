// Session: stopping, watching and comparing.
#include "session_impl.h"

namespace talus {

void Session::Impl::carry_out(const action::RunToStop& a) {
  refresh_scene();
  player.set_running(false);
  plays_on = a.direction == SearchDirection::forwards;
  debugger.follow(player.timeline(), level);
  debugger.search(player.timeline(), a.direction);
}

void Session::Impl::carry_out(const action::FindParting& a) {
  refresh_scene();
  player.set_running(false);
  plays_on = false;
  debugger.follow(player.timeline(), level);
  debugger.search_parting(a.threshold);
}

void Session::Impl::play(double seconds) {
  debugger.follow(player.timeline(), level);
  const auto may_step = [this] { return debugger.may_step(player.timeline()); };
  const auto stops = [this] { return debugger.stops_at(player.timeline(), level); };
  player.advance(seconds, may_step, stops);
}

void Session::Impl::debug() {
  const bool was_searching = debugger.searching();
  if (const auto frame = debugger.advance(player.timeline(), level, choices.body)) player.seek(*frame);
  if (!was_searching || debugger.searching() || !debugger.search_failed() || !plays_on) return;
  player.seek(player.timeline().last_frame());
  player.set_running(true);
}

}  // namespace talus
