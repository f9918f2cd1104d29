// Actions: exports of the level's presets.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

namespace talus {
namespace action {

// Sets the path of a preset to what the user has typed or chosen: it may leave the folder of the level. Does
// nothing for an unknown preset.
struct SetExportPath {
  std::size_t preset = 0;  // index
  std::string path;        // as ExportPreset::path; the same path again counts as chosen, too
};
// Looks at what a preset of the level would write: see Session::exporting(). Does nothing for an unknown
// preset.
struct PreviewExport {
  std::size_t preset = 0;  // index
};
// Exports presets of the current level in the background; a message reports the result. Does nothing while
// another export runs. Asks first about presets that the user has not allowed, and about files that were not
// exported: see Session::question().
struct RunExports {
  std::optional<std::size_t> preset = {};  // index; nothing: all
};
// Exports the level as a game for LÖVE into a folder of the program's own, without a preset.
struct ExportGame {
  std::string folder;  // absolute
};
struct CancelExport {};

}  // namespace action

// The actions that ExportHandler carries out.
using ExportAction = std::variant<action::SetExportPath, action::PreviewExport, action::RunExports,
                                  action::ExportGame, action::CancelExport>;

}  // namespace talus
