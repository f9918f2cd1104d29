// What the dialogs and windows about files show.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace talus {

// The file dialog that is asked for.
enum class FileDialog {
  none,
  open,
  save_as,
  save_recording,
  import_png,
  export_tiles,
  export_sprites,
  export_palette,
  export_path  // of the preset that is shown
};

// What the export window shows, besides what the session knows.
struct ExportView {
  bool open = false;
  std::size_t preset = 0;  // index of the shown preset; beyond the list: the last one
};

struct FilesView {
  FileDialog dialog = FileDialog::none;
  ExportView exports;
  std::vector<std::string> recent_files;  // absolute paths, the latest first
  std::vector<std::string> hard_cases;    // paths of the levels that come with the program, in order
};

}  // namespace talus
