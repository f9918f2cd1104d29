// The commands of pictures: sheets and palette as PNG.
#include "command_table.h"

namespace talus {
namespace {

template <FileDialog dialog>
void ask_for_file(const Session&, Actions&, Ui& ui) {
  ui.view.dialog = dialog;
}

}  // namespace

std::vector<Command> picture_commands() {
  return {
      also_called("png image load",
                  command("picture/import", ctrl('i'), "Import a picture...",
                          "Takes a PNG into a sheet or the palette; what it changes is shown first.",
                          ask_for_file<FileDialog::import_png>)),
      command("picture/export_tiles", {}, "Export the tiles...", "Saves the sheet of tiles as a PNG.",
              ask_for_file<FileDialog::export_tiles>),
      command("picture/export_sprites", {}, "Export the sprites...", "Saves the sheet of sprites as a PNG.",
              ask_for_file<FileDialog::export_sprites>),
      command("picture/export_palette", {}, "Export the palette...",
              "Saves the 16 colours as a PNG of 16x1 pixels.", ask_for_file<FileDialog::export_palette>),
  };
}

}  // namespace talus
