// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// Where a game looks in its level.
#pragma once

#include <talus/sim/state.h>

#include "painter.h"

namespace game {

class Camera {
 public:
  explicit Camera(const talus::Level& level);
  // Puts the first body that takes keys, or else the first one, into the middle as far as the used area goes.
  // An area smaller than the view is in the middle, too. A px is a square of whole pixels of the screen: 22.5
  // tiles of them from top to bottom, or fewer for a small level.
  void place(Painter& painter, const talus::State& state) const;

 private:
  talus::Rect area_;    // px, what is used of the level, in whole screens of TIC-80
  double tile_height_;  // px
};

}  // namespace game
