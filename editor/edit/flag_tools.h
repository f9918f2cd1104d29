// Tools for the flags of tiles and the level's fields of flags. Each makes an Edit and changes nothing
// itself.
#pragma once

#include <set>

#include "sprite_area.h"

namespace talus {

// Gives the tiles of an area, or single ones of a sheet, the flags of the pattern, or, with `on` false,
// clears the pattern's flags.
Edit paint_flags(const Level& level, const SpriteArea& area, FlagPattern pattern, bool on);
Edit paint_flags(const Level& level, SheetId sheet, const std::set<int>& tiles, FlagPattern pattern, bool on);
// Whether a stroke that begins on a tile with these flags sets the pattern: not where it would change
// nothing.
bool stroke_sets(FlagPattern pattern, std::uint8_t flags);
// All eight flags of the area's tiles.
Edit set_all_flags(const Level& level, const SpriteArea& area, std::uint8_t flags);

// What the tiles of an area have under the mask: nothing where they differ.
std::optional<std::uint8_t> common_flags(const Level& level, const SpriteArea& area, std::uint8_t mask);

// The field in the place of the one with this index; one past the last adds it, by its first flag. It must be
// possible (see problem_of) and share no flag with another (asserted).
Edit set_flag_field(const Level& level, std::size_t index, FlagField field);
// Its flags are single ones again; tiles stay as they are.
Edit remove_flag_field(const Level& level, std::size_t index);

}  // namespace talus
