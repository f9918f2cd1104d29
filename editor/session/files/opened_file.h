// What a file holds that is to be opened, as FileReader's thread reads it.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include <talus/formats/format.h>
#include "file_stamp.h"
#include "formats/native/recording_file.h"
#include "level_import.h"
#include "sim/timeline.h"

namespace talus {

struct OpenedFile {
  std::optional<LevelStamp> stamp;  // as the file was before it was read; nothing: it could not be
  // LevelImport: there is something to choose of it first.
  std::variant<FormatError, LoadedLevel, Recording, LevelImport> content;
  EndScenes scenes;  // of a recording
};

// has_choice: a file that cannot be read without choices is a LevelImport, and no error.
OpenedFile read_for_opening(const std::string& path, bool has_choice, const Progress& progress);

}  // namespace talus
