// What the window knows of the tour inside the program.
#pragma once

namespace talus {

struct TourView {
  bool open = false;
  int step = 0;  // index in tour_steps(); its number of steps: the tour was gone through
};

}  // namespace talus
