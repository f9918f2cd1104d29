// Where the files of an export may go. A level is not the user: what it asks for stays in a folder, whatever
// links lie there.
#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

namespace talus {

struct ExportBounds {
  // As real_path() gives it: all files stay in it after every link is followed, and replace regular files
  // alone. Empty: they go where their paths lead.
  std::string folder = {};
  bool holds_named_file = true;  // false: the file that is named, which the user has typed, may be elsewhere
  friend bool operator==(const ExportBounds&, const ExportBounds&) = default;
};

// Whether a file has to stay in the folder. is_named: it is the one that the output names.
inline bool holds(const ExportBounds& bounds, bool is_named) {
  return !bounds.folder.empty() && (!is_named || bounds.holds_named_file);
}

// What the paths of a level's presets get: the folder of the level's file. Empty: it has none, and nothing is
// within the bounds.
ExportBounds bounds_of_level(const std::string& level_file);
// What an output gets that the user has typed: it may be anywhere, what belongs to it is beside it or in it.
ExportBounds bounds_of_output(const std::string& output, bool is_folder);

// Why nothing is written to a path.
struct PlaceProblem {
  std::string message;      // one sentence without its full stop
  bool is_outside = false;  // the place is outside of the bounds: without bounds it would be written
};

// The place that is written for a path, which has no link in it any more where there are bounds; or why it
// may not be. is_named: as of holds().
tl::expected<std::string, PlaceProblem> place_within(const ExportBounds& bounds, const std::string& path,
                                                     bool is_named);

}  // namespace talus
