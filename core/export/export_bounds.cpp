// The bounds are asked twice: when an export is planned, to tell the user, and when it is written, to be
// safe.
#include "export_bounds.h"

#include <filesystem>

#include "../formats/files/real_path.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// Contains no place at all: for a level without a file, and for links in a circle.
constexpr const char* kNowhere = "/dev/null";

ExportBounds bounds_at(const FormatResult<std::string>& folder, bool is_typed) {
  return {folder.value_or(kNowhere), !is_typed, is_typed};
}

}  // namespace

ExportBounds bounds_of_level(const std::string& level_file) {
  if (level_file.empty()) return {kNowhere, true};
  return bounds_at(real_folder_of(level_file), false);
}

ExportBounds bounds_of_output(const std::string& output, bool is_folder) {
  return bounds_at(is_folder ? real_path(output) : real_folder_of(output), true);
}

tl::expected<std::string, PlaceProblem> place_within(const ExportBounds& bounds, const std::string& path,
                                                     bool is_named) {
  if (!holds(bounds, is_named)) return path;
  const auto place = real_path(path);
  if (!place) return tl::unexpected(PlaceProblem{path + " " + place.error().message});
  if (!is_within(*place, bounds.folder)) {
    if (bounds.folder == kNowhere)
      return tl::unexpected(
          PlaceProblem{path + " is not in the folder of the level, which has no file yet", true});
    const bool by_link = *place != fs::path(path).lexically_normal();
    return tl::unexpected(PlaceProblem{
        path + (by_link ? " leads to " + *place + ", which" : "") + " is outside of " + bounds.folder, true});
  }
  std::error_code error;
  const auto kind = fs::symlink_status(*place, error).type();
  if (kind != fs::file_type::not_found && kind != fs::file_type::regular &&
      kind != fs::file_type::directory && kind != fs::file_type::none)
    return tl::unexpected(PlaceProblem{path + " is a device or a pipe, but must be a regular file"});
  return *place;
}

}  // namespace talus
