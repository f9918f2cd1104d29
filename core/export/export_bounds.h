// ExportBounds: where the files of an export may go. A level file may come from anybody: its presets write
// only into its own folder, even through links.
#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

namespace talus {

struct ExportBounds {
  // A folder, as real_path() returns it. All files stay in it after every link is followed, and replace only
  // regular files. Empty: there are no bounds.
  std::string folder = {};
  bool holds_named_file = true;  // false: the named file, which the user has typed, may be elsewhere
  // Whether the named file may be a pipe or a device, into which is written: it was typed as a command's
  // output.
  bool takes_pipe = false;
  friend bool operator==(const ExportBounds&, const ExportBounds&) = default;
};

// Whether a file has to stay in the folder. is_named: it is the file that the output names.
inline bool holds(const ExportBounds& bounds, bool is_named) {
  return !bounds.folder.empty() && (!is_named || bounds.holds_named_file);
}

// The bounds for the paths of a level's presets: the folder of the level's file. For an empty path nothing is
// within the bounds.
ExportBounds bounds_of_level(const std::string& level_file);
// The bounds for an output that the user has typed on a command line: it may be anywhere, also a pipe; what
// belongs to it is beside it or in it.
ExportBounds bounds_of_output(const std::string& output, bool is_folder);

// Why a path may not be written.
struct PlaceProblem {
  std::string message;      // one sentence without its full stop
  bool is_outside = false;  // the place is outside of the bounds: without bounds it would be written
};

// Returns the place that a path leads to; with bounds, without any link left in it. The error says why it may
// not be written. is_named: as in holds().
tl::expected<std::string, PlaceProblem> place_within(const ExportBounds& bounds, const std::string& path,
                                                     bool is_named);

}  // namespace talus
