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
      const FlagSet before = level.sheet(area.sheet).flags[tile];
      const FlagSet after = flags_after(before);
      if (before != after) edit.changes.emplace_back(FlagsChange{area.sheet, tile, before, after});
    }
  }
  return edit;
}

}  // namespace

FlagLamp AreaFlags::lamp(int flag) const {
  assert(flag >= 0 && flag < kMaxFlags);
  if (has_flag(all, flag)) return FlagLamp::all;
  return has_flag(any, flag) ? FlagLamp::some : FlagLamp::none;
}

AreaFlags flags_in(const Level& level, const SpriteArea& area) {
  assert(area.lies_in_sheet(level));
  AreaFlags found{0, ~FlagSet{0}};
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x) {
      const FlagSet flags = level.sheet(area.sheet).flags[area.tile_at(level, x, y)];
      found.any |= flags;
      found.all &= flags;
    }
  }
  return found;
}

FlagLamp flag_lamp(const Level& level, const SpriteArea& area, int flag) {
  return flags_in(level, area).lamp(flag);
}

Edit set_flag(const Level& level, const SpriteArea& area, int flag, bool on) {
  assert(flag >= 0 && flag < kMaxFlags);
  const FlagSet bit = flag_bit(flag);
  return change_flags(level, area, (on ? "Set flag " : "Clear flag ") + std::to_string(flag),
                      [&](FlagSet flags) { return on ? flags | bit : flags & ~bit; });
}

Edit set_flags(const Level& level, const SpriteArea& area, const std::vector<FlagSet>& flags) {
  assert(flags.size() == static_cast<std::size_t>(area.tiles.w) * area.tiles.h);
  return change_flags(level, area, "Set flags", [next = flags.begin()](FlagSet) mutable { return *next++; });
}

Edit toggle_flag(const Level& level, const SpriteArea& area, int flag) {
  return set_flag(level, area, flag, flag_lamp(level, area, flag) == FlagLamp::none);
}

}  // namespace talus
