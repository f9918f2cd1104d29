// Makes a level of Talus from one of LDtk.
#pragma once

#include <talus/formats/format.h>
#include "ldtk_tiles.h"

namespace talus {

// The tiles that stand for its cells, with shapes and flags by the names of IntGrid values and enum tags, and
// bodies for entities. What is left out is added to `drops`.
FormatResult<Level> level_of_ldtk(const LdtkProject& project, const LdtkLevel& source,
                                  const LdtkPictures& pictures, const ImportChoices& choices,
                                  ImportDrops& drops, const Progress& progress);

}  // namespace talus
