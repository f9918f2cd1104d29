// The content of an opened file, as FileReader's thread reads it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <talus/formats/format.h>
#include "file_stamp.h"
#include "formats/native/recording_file.h"
#include "level_import.h"
#include "sim/timeline.h"

namespace talus {

struct OpenedFile {
  std::optional<LevelStamp> stamp;  // of the file before it was read; nothing: not possible
  // LevelImport: the user has to choose first.
  std::variant<FormatError, LoadedLevel, Recording, LevelImport> content;
  EndScenes scenes;  // for a recording
};

// has_choice: a file that cannot be read without choices becomes a LevelImport, and is no error. first:
// what is known of the choices.
OpenedFile read_for_opening(const std::string& path, bool has_choice, const ImportChoices& first,
                            const Progress& progress);

// The files that were not read for where they lie: LoadedLevel::refused.
std::vector<std::string> refused_in(const OpenedFile& opened);

}  // namespace talus
