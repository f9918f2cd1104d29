// Actions: exports of the level's presets.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

namespace talus {
namespace action {

// The path of a preset, as the user has typed or chosen it: it may leave the folder of the level. Of no such
// preset: nothing happens.
struct SetExportPath {
  std::size_t preset = 0;  // index
  std::string path;        // as ExportPreset::path; the one that it has already is chosen by that
};
// Looks at what a preset of the level would write: see Session::exporting(). Of none: nothing happens.
struct PreviewExport {
  std::size_t preset = 0;  // index
};
// Exports presets of the level as it is now, in the background; a message tells what came of it. While that
// goes on, nothing happens. Presets that the user has not allowed, and files that no export wrote, are asked
// about first: see Session::question().
struct RunExports {
  std::optional<std::size_t> preset = {};  // index; nothing: all
};
struct CancelExport {};

}  // namespace action

// What ExportHandler carries out.
using ExportAction =
    std::variant<action::SetExportPath, action::PreviewExport, action::RunExports, action::CancelExport>;

}  // namespace talus
