// The numbers of images of the two sheets on screen.
#pragma once

#include <talus/level/level.h>

namespace talus {

// As in TIC-80: tiles count from 0, sprites from 256.
inline int number_on_screen(SheetId sheet, int image) {
  return sheet == SheetId::tiles ? image : kCartTiles + image;
}

}  // namespace talus
