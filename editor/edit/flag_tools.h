// Tools for the flags of tiles and the level's fields of flags. Each makes an Edit and changes nothing
// itself.
#pragma once

#include <set>

#include "sprite_area.h"

namespace talus {

// Gives the tiles of an area, or single ones of a sheet, the flags of the pattern. `on` false clears the
// pattern's flags.
Edit paint_flags(const Level& level, const SpriteArea& area, FlagPattern pattern, bool on);
Edit paint_flags(const Level& level, SheetId sheet, const std::set<int>& tiles, FlagPattern pattern, bool on);
// Whether a stroke that begins on a tile with these flags sets the pattern. If setting would change nothing,
// it clears the pattern.
bool stroke_sets(FlagPattern pattern, FlagSet flags);
// All flags of the area's tiles.
Edit set_all_flags(const Level& level, const SpriteArea& area, FlagSet flags);

// The flags under the mask that the tiles of an area have; nothing if they differ.
std::optional<FlagSet> common_flags(const Level& level, const SpriteArea& area, FlagSet mask);

// Replaces the field with this index; an index one past the last adds the field, sorted by its first flag.
// The field must be possible (see problem_of) and share no flag with another one (asserted).
Edit set_flag_field(const Level& level, std::size_t index, FlagField field);
// Its flags become single ones again; tiles stay as they are.
Edit remove_flag_field(const Level& level, std::size_t index);

}  // namespace talus
