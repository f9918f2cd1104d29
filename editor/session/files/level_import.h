// LevelImport: opens a file of another program that holds more than a level can, and shows the result
// beforehand.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "file_stamp.h"
#include "formats/ldtk/ldtk_format.h"
#include "formats/tiled/tiled_format.h"

namespace talus {

// An opened file, until the user has chosen which part of it becomes the level, or cancels.
struct LevelImport {
  std::string path;
  std::vector<TiledLayerName> layers;  // of tiles
  std::vector<LdtkLevelName> levels;   // of a project; empty: the file is none
  ImportChoices choices;
  FormatResult<LoadedLevel> plan;        // the result with these choices, or why there is none
  bool is_mapping = false;               // whether only the mapping of the open level is asked for
  std::optional<LevelStamp> stamp = {};  // of the file before the plan was read; nothing: not possible
  // By level of a project, what it looks like; null, or fewer than levels: not known.
  std::vector<std::shared_ptr<const SheetPicture>> pictures = {};
};

// Reads a level with its stamp, with its linked files in it.
FormatResult<LoadedLevel> load_with_stamp(const std::string& path, const ImportChoices& choices,
                                          const Progress& progress, std::optional<LevelStamp>& stamp);

// How to read the files of a level again, so that its tiles keep their numbers. first: as they were read.
ImportChoices choices_of(const Level& level, ImportChoices first = {});

// For a file that cannot be read without choices. Chooses all layers, or, if they are too many, the one
// with the most tiles; the level of a project that was saved last, or else the first; and only the used tiles
// if it cannot be read otherwise. So it can be opened at once. A project with one level whose mapping is
// remembered, or with nothing to map, leaves no choice.
bool leaves_choice(const LevelImport& import);
LevelImport first_level_import(const std::string& path, const ImportChoices& first = {},
                               const Progress& progress = {});

}  // namespace talus
