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

std::optional<std::string> problem_of(const std::vector<Tileset>& tilesets, const SheetLayout& sheet) {
  int next = 0;  // the first number that no tileset has yet
  for (std::size_t i = 0; i < tilesets.size(); ++i) {
    const Tileset& set = tilesets[i];
    const auto problem = [&](const std::string& text) { return "[" + std::to_string(i) + "] " + text; };
    if (set.first < 0 || set.count < 1 || set.first >= sheet.count || set.count > sheet.count - set.first)
      return problem("must have tiles of the sheet, which has " + std::to_string(sheet.count));
    if (set.first < next) return problem("must come after the tiles of the tileset before it");
    if (set.columns < 1 || set.columns > sheet.columns - sheet.place_of(set.first).x)
      return problem("must have at least one column, and not more than the sheet has from its first tile on");
    next = set.first + set.count;
  }
  return std::nullopt;
}

int tileset_with(const std::vector<Tileset>& tilesets, const SheetLayout& sheet, int tile) {
  const auto after = std::upper_bound(tilesets.begin(), tilesets.end(), tile,
                                      [](int number, const Tileset& set) { return number < set.first; });
  if (after == tilesets.begin()) return -1;
  const Tileset& set = *std::prev(after);
  const bool is_in_range = tile - set.first < set.count;
  const bool is_in_columns = (tile - set.first) % sheet.columns < set.columns;
  return is_in_range && is_in_columns ? static_cast<int>(std::prev(after) - tilesets.begin()) : -1;
}

}  // namespace talus
