// Reads and sets the flags of an area's tiles.
#include "flag_lamps.h"

#include <cassert>
#include <utility>

namespace talus {
namespace {

// Sets the flags of each tile of the area to flags_after(its flags).
template <class FlagsAfter>
Edit change_flags(const Level& level, const SpriteArea& area, std::string label, FlagsAfter flags_after) {
  assert(area.lies_in_sheet(level));
  Edit edit{std::move(label), {}};
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x) {
      const int tile = area.tile_at(level, x, y);
      const std::uint8_t before = level.sheet(area.sheet).flags[tile];
      const auto after = static_cast<std::uint8_t>(flags_after(before));
      if (before != after) edit.changes.emplace_back(FlagsChange{area.sheet, tile, before, after});
    }
  }
  return edit;
}

}  // namespace

FlagLamp flag_lamp(const Level& level, const SpriteArea& area, int flag) {
  assert(area.lies_in_sheet(level) && flag >= 0 && flag < kFlagCount);
  int set = 0;
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x)
      set += level.sheet(area.sheet).flags[area.tile_at(level, x, y)] >> flag & 1;
  }
  if (set == 0) return FlagLamp::none;
  return set == area.tiles.w * area.tiles.h ? FlagLamp::all : FlagLamp::some;
}

Edit set_flag(const Level& level, const SpriteArea& area, int flag, bool on) {
  assert(flag >= 0 && flag < kFlagCount);
  const int bit = 1 << flag;
  return change_flags(level, area, (on ? "Set flag " : "Clear flag ") + std::to_string(flag),
                      [&](std::uint8_t flags) { return on ? flags | bit : flags & ~bit; });
}

Edit set_flags(const Level& level, const SpriteArea& area, const std::vector<std::uint8_t>& flags) {
  assert(flags.size() == static_cast<std::size_t>(area.tiles.w) * area.tiles.h);
  return change_flags(level, area, "Set flags",
                      [next = flags.begin()](std::uint8_t) mutable { return *next++; });
}

Edit toggle_flag(const Level& level, const SpriteArea& area, int flag) {
  return set_flag(level, area, flag, flag_lamp(level, area, flag) == FlagLamp::none);
}

}  // namespace talus
