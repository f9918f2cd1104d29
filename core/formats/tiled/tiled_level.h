// The level that a map of Tiled is.
#pragma once

#include "tiled_tiles.h"

namespace talus {

// pictures: one for each tileset of the map. What the level cannot hold is named in `drops`; an error where
// it cannot be made without a choice (see ImportChoices), or the map's own `talus_level` cannot be read.
//
// Flags: the int `flags`, and then each bool with the name of a flag (tiled_flag_names); other bools that are
// true name a flag that the same tiles have by number, or else one that nothing is known of. Shapes: the
// first outline of a tile that tile_shape_of knows or else what comes nearest, one-way where `shape_one_way`
// or, without that word, `one_way` of the outline is true; `collidable` without an outline is a solid tile.
// The picture's colours become the palette where they are 16 at most. progress: told how much is made.
FormatResult<Level> level_of_tiled(const TiledMap& map, const TiledPictures& pictures,
                                   const ImportChoices& choices, TiledDrops& drops,
                                   const Progress& progress = {});

}  // namespace talus
