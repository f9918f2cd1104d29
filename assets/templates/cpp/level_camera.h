// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// Where a game looks in its level.
#pragma once

#include <optional>

#include <talus/sim/state.h>

#include "painter.h"

namespace game {

class Camera {
 public:
  explicit Camera(const talus::Level& level);
  // Looks at the first body that takes keys, or else the first one. The view rests while the body is in its
  // dead zone, and stays in the used area; an area smaller than the view is in its middle. A px is a square
  // of whole pixels of the screen, which shows about a screen of TIC-80, or all of a smaller area.
  void place(Painter& painter, const talus::State& state);

 private:
  talus::Rect area_;                  // px, what is used of the level, in whole screens of TIC-80
  talus::TileSize tile_;              // px
  std::optional<double> left_, top_;  // px, of the view before
};

}  // namespace game
