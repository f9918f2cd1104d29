// The numbers of images of the two sheets on screen.
#pragma once

#include <talus/level/level.h>

namespace talus {

// As in TIC-80: tiles are 0 to 255, sprites 256 to 511.
inline int number_on_screen(SheetId sheet, int image) {
  return sheet == SheetId::tiles ? image : kTileCount + image;
}

}  // namespace talus
