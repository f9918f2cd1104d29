// Pictures of files that are not open, for the file dialog.
#pragma once

#include <memory>
#include <string>

#include <talus/level/tileset.h>

namespace talus {

// Of a file that is a picture, that picture; of a level, its start, at most as large as RecentPictures keep
// it. Null if it is another file, if it is too large, or if reading takes long.
std::shared_ptr<const SheetPicture> picture_in_file(const std::string& path);

}  // namespace talus
