// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
// A sheet of a level, of its tiles or of its sprites, as a picture.
#pragma once

#include <talus/level/level.h>

#include <memory>

namespace game {

struct Sheet {
  std::shared_ptr<const talus::SheetPicture> picture;
  talus::SheetLayout layout;
  talus::TileSize image;  // px of the picture

  // Images that lie side by side, from the one at their top left.
  talus::PicturePart part(int first, int columns = 1, int rows = 1) const {
    const talus::Cell at = layout.place_of(first);
    return {.picture = picture,
            .x = at.x * image.width,
            .y = at.y * image.height,
            .width = columns * image.width,
            .height = rows * image.height};
  }
};

// In 16 colours, colour 0 is clear. In true colour, the sheet says what is clear.
Sheet sheet_of(const talus::Level& level, talus::SheetId id);

}  // namespace game
