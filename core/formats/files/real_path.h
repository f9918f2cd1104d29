// Where a path leads when all symbolic links in it are followed.
#pragma once

#include <string>

#include <talus/formats/format.h>

namespace talus {

// The same place from the root, without links, "." and "..": dangling links are followed too, and what does
// not exist yet is kept as it is named. An error for links in a circle.
FormatResult<std::string> real_path(const std::string& path);

// Of the folder that a file is in: the file itself may be a link.
FormatResult<std::string> real_folder_of(const std::string& file);

// The last part of a path, as titles and sentences name a file.
std::string last_name(const std::string& path);

// Whether a place is the folder, or somewhere in it. Both as real_path() gives them.
bool is_within(const std::string& place, const std::string& folder);

// Whether both lead to one file that is there, by links or by another name of it.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace talus
