// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "sheet.h"

namespace game {
namespace {

constexpr int kSide = talus::kCartTileSize;  // px, of an image in 16 colours

talus::SheetPicture colored(const talus::Sheet& sheet, const talus::Palette& palette) {
  talus::SheetPicture made;
  made.width = sheet.layout().columns * kSide;
  made.height = sheet.layout().rows() * kSide;
  made.rgba.resize(4 * static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height));
  for (int number = 0; number < sheet.count(); ++number) {
    const talus::Cell at = sheet.layout().place_of(number);
    for (int i = 0; i < kSide * kSide; ++i) {
      const int x = at.x * kSide + i % kSide, y = at.y * kSide + i / kSide;
      const int color = sheet.images[static_cast<std::size_t>(number)][static_cast<std::size_t>(i)];
      const talus::Rgb rgb = palette[static_cast<std::size_t>(color)];
      std::uint8_t* pixel = &made.rgba[4 * (static_cast<std::size_t>(y) * made.width + x)];
      pixel[0] = rgb.r, pixel[1] = rgb.g, pixel[2] = rgb.b;
      pixel[3] = color == 0 ? 0 : 255;
    }
  }
  return made;
}

}  // namespace

Sheet sheet_of(const talus::Level& level, talus::SheetId id) {
  const talus::Sheet& sheet = level.sheet(id);
  if (sheet.picture != nullptr) return {sheet.picture, sheet.layout(), level.map.tile_size()};
  return {
      std::make_shared<talus::SheetPicture>(colored(sheet, level.palette)), sheet.layout(), {kSide, kSide}};
}

}  // namespace game
