// The lamps of flags: whether the tiles of an area have each flag, and what a click does.
#pragma once

#include "sprite_area.h"

namespace talus {

// Whether a flag is set in none, some or all of the area's tiles.
enum class FlagLamp { none, some, all };
// The flags that any and that all of an area's tiles have.
struct AreaFlags {
  FlagSet any = 0, all = 0;
  FlagLamp lamp(int flag) const;  // flag: 0..31 (asserted)
};
AreaFlags flags_in(const Level& level, const SpriteArea& area);
FlagLamp flag_lamp(const Level& level, const SpriteArea& area, int flag);
Edit set_flag(const Level& level, const SpriteArea& area, int flag, bool on);
// The flags of each tile of the area, row by row.
Edit set_flags(const Level& level, const SpriteArea& area, const std::vector<FlagSet>& flags);
// TIC-80's click: clears the flag if any tile has it, else sets it in all.
Edit toggle_flag(const Level& level, const SpriteArea& area, int flag);

}  // namespace talus
