#include <talus/level/tileset.h>

namespace talus {

Palette default_palette() {
  constexpr std::array<std::uint32_t, kColorCount> kSweetie16 = {
      0x1a1c2c, 0x5d275d, 0xb13e53, 0xef7d57, 0xffcd75, 0xa7f070, 0x38b764, 0x257179,
      0x29366f, 0x3b5dc9, 0x41a6f6, 0x73eff7, 0xf4f4f4, 0x94b0c2, 0x566c86, 0x333c57};
  Palette palette;
  for (int i = 0; i < kColorCount; ++i) {
    const std::uint32_t c = kSweetie16[i];
    palette[i] = {static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8),
                  static_cast<std::uint8_t>(c)};
  }
  return palette;
}

bool operator==(const Sheet& a, const Sheet& b) {
  const bool same_picture =
      a.picture == b.picture || (a.picture != nullptr && b.picture != nullptr && *a.picture == *b.picture);
  return a.columns == b.columns && a.images == b.images && a.flags == b.flags && same_picture;
}

}  // namespace talus
