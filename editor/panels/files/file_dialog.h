// The dialogs for a file, which the application draws.
#pragma once

namespace talus {

enum class FileDialog {
  open,
  save_as,
  save_recording,
  import_png,
  new_from_tiles,
  add_tileset,
  export_tiles,
  export_sprites,
  export_palette,
  export_path  // of the preset that is shown
};

}  // namespace talus
