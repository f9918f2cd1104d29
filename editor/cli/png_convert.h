// A picture into a level, for `talus import`.
#pragma once

#include "command.h"
#include "session/files/png_import.h"

namespace talus {

struct PngIntoLevel {
  std::string picture;         // PNG
  std::string level;           // file of the level that it is taken into
  std::string part = "tiles";  // one of png_part_names()
  int tile = 0;                // 0..255
  bool take_palette = false;
  std::string output;  // in the format of its name; "-": native, on standard output
};

// The names of PngPart, in order.
std::vector<std::string> png_part_names();

// Says what has changed, unless the level goes to standard output.
void import_png(CommandContext& context, const PngIntoLevel& import);

}  // namespace talus
