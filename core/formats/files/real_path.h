// Where a path leads when all symbolic links in it are followed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <talus/formats/format.h>

namespace talus {

// Returns the absolute path without links, "." and "..". Dangling links are followed, too; parts that do not
// exist yet keep their names. Links in a circle are an error.
FormatResult<std::string> real_path(const std::string& path);

// The same for the folder that a file is in: the file itself may be a link.
FormatResult<std::string> real_folder_of(const std::string& file);

// Returns the last part of a path, which titles and sentences show: "maps" for "a/maps/", "/" for "/".
std::string last_name(const std::string& path);

// Whether a place is the folder or inside of it. Both must come from real_path().
bool is_within(const std::string& place, const std::string& folder);

// What all names of one existing file have in common, also links to it. Nothing: there is no file.
using FileNumber = std::pair<std::uint64_t, std::uint64_t>;
std::optional<FileNumber> file_number(const std::string& path);

// Whether both lead to the same existing file, also by links or other names of it.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace talus
