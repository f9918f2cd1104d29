// Session: stopping, watching and comparing.
#include <algorithm>
#include <cmath>

#include "session/session_impl.h"

namespace talus {

void Session::Impl::carry_out(const action::RunToStop& a) {
  refresh_scene();
  simulation.set_running(false);
  plays_on = a.direction == SearchDirection::forwards;
  nothing_found = "No breakpoint stops before this frame.";
  debugger.follow(simulation.timeline(), level);
  debugger.search(simulation.timeline(), a.direction);
}

void Session::Impl::carry_out(const action::FindParting& a) {
  refresh_scene();
  simulation.set_running(false);
  plays_on = false;
  nothing_found = "As far as they have been run, no body is further from its other self.";
  debugger.follow(simulation.timeline(), level);
  debugger.search_parting(a.threshold);
}

void Session::Impl::carry_out(const action::SetParting& a) {
  if (std::isfinite(a.threshold)) debugger.set_parting(std::max(a.threshold, 0.0));
}

void Session::Impl::play(double seconds) {
  debugger.follow(simulation.timeline(), level);
  const auto may_step = [this] { return debugger.may_step(simulation.timeline()); };
  const auto stops = [this] {
    const bool stops_here = debugger.stops_at(simulation.timeline(), level);
    if (stops_here) note_stop();
    return stops_here;
  };
  simulation.advance(seconds, may_step, stops);
}

// Says why it stands still, and shows the body that it is about where none is chosen.
void Session::Impl::note_stop() {
  const Stop& stop = *debugger.stop();
  message = Message{text_of(stop), false};
  if (choices.body == 0) choices.body = stop.body;
}

void Session::Impl::debug() {
  const bool was_searching = debugger.searching();
  if (const auto frame = debugger.advance(simulation.timeline(), level, choices.body)) {
    simulation.seek(*frame);
    note_stop();
  }
  if (!was_searching || debugger.searching() || !debugger.search_failed()) return;
  if (!plays_on) {
    message = Message{nothing_found, false};
    return;
  }
  simulation.seek(simulation.timeline().last_frame());
  simulation.set_running(true);
}

}  // namespace talus
