// Carries out the actions of the debugger.
#include "debug_handler.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus {

template <>
void DebugHandler::carry_out(const action::SetBreakpoint& a) {
  debugger_.put(a.breakpoint);
}

template <>
void DebugHandler::carry_out(const action::RemoveBreakpoint& a) {
  debugger_.remove_breakpoint(a.breakpoint);
}

template <>
void DebugHandler::carry_out(const action::RunToBreakpoint& a) {
  prepare_search(a.direction == SearchDirection::forwards, "No breakpoint stops before this frame.");
  debugger_.search(run_.timeline(), a.direction);
}

template <>
void DebugHandler::carry_out(const action::FindLastStop& a) {
  prepare_search(false, "Nothing has stopped the body before this frame.");
  debugger_.search_last_stop(run_.timeline(), a.body);
}

template <>
void DebugHandler::carry_out(const action::FindParting& a) {
  prepare_search(false, "No body is further apart on the two sides, as far as both have been run.");
  debugger_.search_parting(a.threshold);
}

template <>
void DebugHandler::carry_out(const action::SetParting& a) {
  if (std::isfinite(a.threshold)) debugger_.set_parting(std::max(a.threshold, 0.0));
}

template <>
void DebugHandler::carry_out(const action::CancelSearch&) {
  debugger_.cancel_search();
}

template <>
void DebugHandler::carry_out(const action::SetPlot& a) {
  debugger_.put(a.index, a.plot);
}

template <>
void DebugHandler::carry_out(const action::RemovePlot& a) {
  debugger_.remove_plot(a.index);
}

template <>
void DebugHandler::carry_out(const action::CompareVariant& a) {
  debugger_.compare_with(a.variant);
}

void DebugHandler::apply(const DebugAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

void DebugHandler::prepare_search(bool plays_on, std::string nothing_found) {
  run_.refresh_scene();
  run_.set_running(false);
  plays_on_ = plays_on;
  nothing_found_ = std::move(nothing_found);
  follow();
}

void DebugHandler::play(double seconds) {
  follow();
  if (run_.simulation().playback().running && debugger_.still_stops_at(run_.timeline())) {
    run_.set_running(false);
    note_stop();
  }
  const auto may_step = [this] { return debugger_.may_step(run_.timeline()); };
  const auto stops = [this] {
    const bool stops_here = debugger_.stops_at(run_.timeline(), open_.level);
    if (stops_here) note_stop();
    return stops_here;
  };
  run_.advance(seconds, may_step, stops);
}

// Says why it stopped, and chooses the body that the stop is about if none is chosen.
void DebugHandler::note_stop() {
  const Stop& stop = *debugger_.stop();
  messages_.tell(text_of(stop));
  if (choices_.choices().body == 0) choices_.choose_body(stop.body);
}

void DebugHandler::advance() {
  const bool was_searching = debugger_.searching();
  if (const auto frame = debugger_.advance(run_.timeline(), open_.level, choices_.choices().body)) {
    run_.show_frame(*frame);
    note_stop();
  }
  if (!was_searching || debugger_.searching() || !debugger_.search_failed()) return;
  if (!plays_on_) return messages_.tell(nothing_found_);
  run_.show_frame(run_.timeline().last_frame());
  run_.set_running(true);
}

}  // namespace talus
