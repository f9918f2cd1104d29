// The commands of pictures: sheets and the palette as PNG files.
#include "command_table.h"

namespace talus {
namespace {

CommandRun ask_for_file(FileDialog dialog) {
  return [dialog](const Session&, Actions&, Ui& ui) { ui.ask(request::ShowFileDialog{dialog}); };
}

}  // namespace

std::vector<Command> picture_commands() {
  return {
      {.id = "picture/import",
       .label = "Import a picture...",
       .help = "Imports a PNG into a sheet or the palette, and first shows what it would change.",
       .key = ctrl('i'),
       .menu = menus::kFilePictures,
       .run = ask_for_file(FileDialog::import_png),
       .words = "png image load"},
      {.id = "picture/export_tiles",
       .label = "Export the tiles...",
       .help = "Saves the sheet of tiles as a PNG.",
       .menu = menus::kFilePictures,
       .run = ask_for_file(FileDialog::export_tiles)},
      {.id = "picture/export_sprites",
       .label = "Export the sprites...",
       .help = "Saves the sheet of sprites as a PNG.",
       .menu = menus::kFilePictures,
       .run = ask_for_file(FileDialog::export_sprites)},
      {.id = "picture/export_palette",
       .label = "Export the palette...",
       .help = "Saves the 16 colours as a PNG of 16x1 pixels.",
       .menu = menus::kFilePictures,
       .run = ask_for_file(FileDialog::export_palette)},
  };
}

}  // namespace talus
