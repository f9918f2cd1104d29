// Opening a file of another program that holds more than a level can, with what comes of it told beforehand.
#pragma once

#include <string>
#include <vector>

#include "formats/tiled/tiled_format.h"

namespace talus {

// A file that was opened, until the user has chosen what of it becomes the level, or cancels it.
struct LevelImport {
  std::string path;
  std::vector<TiledLayerName> layers;  // of tiles
  ImportChoices choices;
  FormatResult<LoadedLevel> plan;  // with these choices, or why not
};

// Of a file that cannot be read without choices. Of several layers the one with the most tiles is chosen, and
// only the tiles that are used where it cannot be read otherwise, so that it can be opened at once.
LevelImport first_level_import(const std::string& path, const Progress& progress = {});

}  // namespace talus
