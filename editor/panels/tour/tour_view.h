// What the window knows of the tour inside the program.
#pragma once

namespace talus {

struct TourView {
  bool open = false;
  int opens_after = -1;  // number of the level after which the tour opens its own; -1: it opens none
  int step = 0;          // index in tour_steps(); its number of steps: the tour was gone through
};

}  // namespace talus
