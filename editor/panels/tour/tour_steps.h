// The steps of the tour: what each asks for, where it points, and when it is done.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "overlay/overlay_table.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// How things were when a step of the tour began.
struct TourStart {
  std::int64_t frame = 0;
  std::int64_t last_frame = 0;  // the greatest since then
  std::uint64_t revision = 0;   // of the level
  OverlaySet overlays;
  double player_x = 0;  // px; 0 if there is no player
};
TourStart tour_start(const Session& session);

struct TourStep {
  std::string_view key;      // "run", for tests
  std::string_view heading;  // a few words
  // What to do, with the keys that the user has chosen for it.
  std::function<std::string(const Ui&)> text;
  // Brings what it points at into sight, when the step begins.
  std::function<void(const Session&, Actions&, Ui&)> show;
  // The widget that it points at now.
  std::function<std::string_view(const Ui&)> target;
  std::function<bool(const Session&, const Ui&, const TourStart&)> is_done;
};
// In order. A new step is a row here.
std::span<const TourStep> tour_steps();

}  // namespace talus
