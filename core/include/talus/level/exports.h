// Export presets: what a level is exported to. They are kept with the level.
#pragma once

#include <cstddef>
#include <string>

namespace talus {

inline constexpr std::size_t kMaxExports = 100;      // of a level
inline constexpr std::size_t kMaxExportText = 4096;  // bytes of each text of a preset

// A target, and where it is written.
struct ExportPreset {
  std::string name;      // for people and for `talus export --preset`; may be empty or repeated
  std::string exporter;  // id, as for `talus export --to`: "love"; an id of a newer version is kept
  // Of the file or folder, with '/': absolute, or relative to the folder of the level's file.
  std::string path;
  // Parts of the Lua runtime besides those that the level uses (docs/runtime.md): "players, pairs"; often
  // empty.
  std::string parts = {};
  bool on_save = false;  // the editor exports it whenever it saves the level
  std::string extra;     // JSON object of keys that this version does not know, or empty
  friend bool operator==(const ExportPreset&, const ExportPreset&) = default;
};

}  // namespace talus
