// What the dialogs and windows about files show.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <talus/level/tileset.h>

namespace talus {

// What the export window shows, besides what the session knows.
struct ExportView {
  bool open = false;
  std::size_t preset = 0;  // index of the shown preset; beyond the list: the last one
};

inline constexpr std::size_t kMaxKeptFolders = 12;

struct FilesView {
  ExportView exports;
  std::vector<std::string> recent_files;  // absolute paths, the latest first
  std::vector<std::string> kept_folders;  // absolute paths that the dialog lists; at most kMaxKeptFolders
  // Small pictures of their levels, by path; some may be missing.
  std::map<std::string, std::shared_ptr<const SheetPicture>> recent_pictures;
  std::vector<std::string> scenes;      // paths of the demo and other levels that come with the program
  std::vector<std::string> hard_cases;  // paths of the hard cases, in order
  std::string tour_level;               // path of the level that the tour goes through
};

}  // namespace talus
