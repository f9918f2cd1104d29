// A room for tests of playing and recording.
#pragma once

#include <talus/level/level.h>

namespace talus {

inline constexpr std::uint8_t kRoomSolid = 1, kRoomBall = 2;

// 30x17 cells: a ball at (16, 8), high above a floor in row `floor`.
inline Level ball_room(int floor = 12) {
  Level level;
  level.map = TileMap(30, 17);
  level.sheet(SheetId::tiles).flags[kRoomSolid] = 1 << 0;
  level.sheet(SheetId::tiles).flags[kRoomBall] = 1 << 1;
  level.map.set({2, 1}, kRoomBall);
  for (int x = 0; x < 30; ++x) level.map.set({x, floor}, kRoomSolid);
  return level;
}

}  // namespace talus
