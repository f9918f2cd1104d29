// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// Draws bodies. One with a picture shows the frame of what it does. Players are boxes with a face; crates,
// discs and marbles have looks of their own. Others have the picture of their tile, or of the level's first
// ball tile, and without any they are discs.
#pragma once

#include <talus/sim/state.h>

#include <map>

#include "painter.h"
#include "sheet.h"

namespace game {

class Bodies {
 public:
  // The level must stay alive.
  explicit Bodies(const talus::Level& level);
  // time: ms since the start, which animated tiles go by.
  void draw(Painter& painter, const talus::State& state, double time);

 private:
  bool draw_picture(Painter& painter, const talus::Body& body, std::int64_t frame);
  void draw_tile(Painter& painter, const talus::Body& body, double time) const;
  int tile_of(const talus::Body& body) const;  // -1: none

  const talus::Level& level_;
  Sheet tiles_, sprites_;
  int first_ball_ = -1;             // the first tile that is a ball; -1: none
  std::map<int, bool> looks_left_;  // by id, where a body went last
};

}  // namespace game
