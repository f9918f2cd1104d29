// The table of sections, and the conversion between a cart's bytes and a level.
#include "cart_content.h"

#include <algorithm>
#include <cassert>

#include "../../level/tile_words.h"

namespace talus {
namespace {

constexpr std::array<SectionInfo, kSectionCount> kSections = {{
    {Section::tiles, "TILES", 1, 256, 32},
    {Section::sprites, "SPRITES", 2, 256, 32},
    {Section::map, "MAP", 4, kTicMapHeight, kTicMapWidth},
    {Section::waves, "WAVES", 10, 16, 16},
    {Section::sfx, "SFX", 9, 64, 66},
    {Section::patterns, "PATTERNS", 15, 60, 192},
    {Section::tracks, "TRACKS", 14, 8, 51},
    {Section::flags, "FLAGS", 6, 2, kCartTiles},
    {Section::screen, "SCREEN", 18, kTicMapHeight, 120},
    {Section::palette, "PALETTE", 12, 2, 3 * kColorCount},
}};

constexpr std::string_view kStub = R"(-- title:  level
-- desc:   drawn in Talus: shows its map, the arrow keys scroll it
-- script: lua

local x, y = 0, 0

function TIC()
  if btn(0) then y = math.max(y - 2, 0) end
  if btn(1) then y = math.min(y + 2, 119 * 8) end
  if btn(2) then x = math.max(x - 2, 0) end
  if btn(3) then x = math.min(x + 2, 210 * 8) end
  cls(0)
  map(x // 8, y // 8, 31, 18, -(x % 8), -(y % 8))
end
)";

constexpr std::size_t kPaletteBytes = 3 * kColorCount;

std::string bytes_of(const Palette& palette) {
  std::string bytes;
  for (const Rgb& color : palette) {
    bytes += static_cast<char>(color.r);
    bytes += static_cast<char>(color.g);
    bytes += static_cast<char>(color.b);
  }
  return bytes;
}

// DawnBringer's 16 colours, TIC-80's palette before carts had their own.
constexpr std::array<std::uint32_t, kColorCount> kDb16 = {
    0x140c1c, 0x442434, 0x30346d, 0x4e4a4e, 0x854c30, 0x346524, 0xd04648, 0x757161,
    0x597dce, 0xd27d2c, 0x8595a1, 0x6daa2c, 0xd2aa99, 0x6dc2ca, 0xdad45e, 0xdeeed6};

Palette palette_of(std::string_view bytes) {
  bytes = bytes.substr(0, kPaletteBytes);
  const bool empty = bytes.find_first_not_of('\0') == std::string_view::npos;
  Palette palette;
  for (int i = 0; i < kColorCount; ++i) {
    const auto channel = [&](int offset) {
      const std::size_t at = static_cast<std::size_t>(3 * i + offset);
      if (empty) return static_cast<std::uint8_t>(kDb16[i] >> (16 - 8 * offset));
      return at < bytes.size() ? static_cast<std::uint8_t>(bytes[at]) : std::uint8_t{0};
    };
    palette[i] = {channel(0), channel(1), channel(2)};
  }
  return palette;
}

std::string bytes_of(const Sheet& sheet) {
  std::string bytes;
  for (const TileImage& image : sheet.images) {
    for (std::size_t p = 0; p < image.size(); p += 2) {
      bytes += static_cast<char>((image[p] & 15) | (image[p + 1] & 15) << 4);
    }
  }
  return bytes;
}

void set_images(Sheet& sheet, std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    TileImage& image = sheet.images[i / 32];
    const auto byte = static_cast<std::uint8_t>(bytes[i]);
    image[i % 32 * 2] = byte & 15;
    image[i % 32 * 2 + 1] = byte >> 4;
  }
}

std::string flag_bytes(const Level& level) {
  std::string bytes;
  for (const Sheet& sheet : level.sheets)
    for (const FlagSet flags : sheet.flags) bytes += static_cast<char>(flags & kCartFlagSet);
  return bytes;
}

std::string map_bytes(const TileMap& map) {
  std::string bytes(section_info(Section::map).size(), '\0');
  for (int y = 0; y < map.height(); ++y) {
    const auto row = map.cells().tiles().begin() + static_cast<std::ptrdiff_t>(y) * map.width();
    std::copy_n(row, map.width(), bytes.begin() + static_cast<std::ptrdiff_t>(y) * kTicMapWidth);
  }
  return bytes;
}

std::string size_text(const TileMap& map) {
  return std::to_string(map.width()) + "x" + std::to_string(map.height());
}

}  // namespace

std::span<const SectionInfo, kSectionCount> section_infos() { return kSections; }
const SectionInfo& section_info(Section id) { return kSections[static_cast<std::size_t>(id)]; }

std::string_view default_palette_bytes() {
  static const std::string bytes = bytes_of(default_palette());
  return bytes;
}

std::string_view default_wave_bytes() {
  using namespace std::string_view_literals;
  return "\x00\x00\x00\x00\xff\xff\xff\xff\x00\x00\x00\x00\xff\xff\xff\xff"
         "\x10\x32\x54\x76\x98\xba\xdc\xfe\xef\xcd\xab\x89\x67\x45\x23\x01"
         "\x10\x32\x54\x76\x98\xba\xdc\xfe\x10\x32\x54\x76\x98\xba\xdc\xfe"sv;
}

CartContent new_cart() {
  CartContent cart;
  at(cart.banks[0], Section::palette) = default_palette_bytes();
  at(cart.banks[0], Section::waves) = default_wave_bytes();
  cart.code = kStub;
  return cart;
}

void trim_zeros(std::string& bytes) {
  const std::size_t last = bytes.find_last_not_of('\0');
  bytes.resize(last == std::string::npos ? 0 : last + 1);
}

std::string section_bytes(const Level& level, Section id) {
  std::string bytes;
  switch (id) {
    case Section::tiles:
      bytes = bytes_of(level.sheet(SheetId::tiles));
      break;
    case Section::sprites:
      bytes = bytes_of(level.sheet(SheetId::sprites));
      break;
    case Section::map:
      assert(map_fits_cart(level));
      bytes = map_bytes(level.map);
      break;
    case Section::flags:
      bytes = flag_bytes(level);
      break;
    case Section::palette:
      bytes = bytes_of(level.palette);
      break;
    default:
      assert(false && "a level has no such section");
  }
  trim_zeros(bytes);
  return bytes;
}

bool map_fits_cart(const Level& level) {
  return level.map.width() <= kTicMapWidth && level.map.height() <= kTicMapHeight;
}

Bank edited_bank(const Level& level, const Bank& before) {
  Bank bank = before;
  for (const Section id : kLevelSections) {
    if (id != Section::palette && (id != Section::map || map_fits_cart(level))) {
      at(bank, id) = section_bytes(level, id);
    }
  }
  std::string& palette = at(bank, Section::palette);
  if (palette_of(palette) != level.palette) {
    palette.resize(section_info(Section::palette).size());
    palette.replace(0, kPaletteBytes, bytes_of(level.palette));
    trim_zeros(palette);
  }
  return bank;
}

Level level_of_bank(const Bank& bank) {
  Level level;
  set_images(level.sheet(SheetId::tiles), at(bank, Section::tiles));
  set_images(level.sheet(SheetId::sprites), at(bank, Section::sprites));
  const std::string& flags = at(bank, Section::flags);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    level.sheets[i / kCartTiles].flags[i % kCartTiles] = static_cast<std::uint8_t>(flags[i]);
  }
  const std::string& map = at(bank, Section::map);
  std::transform(map.begin(), map.end(), level.map.cells().tiles().begin(),
                 [](char tile) { return static_cast<std::uint8_t>(tile); });
  level.palette = palette_of(at(bank, Section::palette));
  return level;
}

namespace {

// How many different tiles the map shows; tile 0 is an empty cell.
int count_shown(const Level& level) {
  const std::vector<std::size_t> counts = count_tiles(level);
  return static_cast<int>(
      std::count_if(counts.begin() + 1, counts.end(), [](std::size_t count) { return count > 0; }));
}

std::string size_problem(TileSize size, int shown) {
  const auto parts_of = [](int length, int part) { return (length + part - 1) / part; };
  const int parts = parts_of(size.width, TileSize().width) * parts_of(size.height, TileSize().height);
  const std::string px = " of " + std::to_string(size.width) + "x" + std::to_string(size.height) + " px";
  const std::string shows = "the map shows " + std::to_string(shown) + (shown == 1 ? " tile" : " tiles") + px;
  const std::string parts_text = std::to_string(shown * parts);
  if (shown * parts < kCartTiles)
    return shows + ", but a cart has tiles of 8x8 px: drawn with those, the map takes " + parts_text +
           " of its 256";
  return shows + ", which take " + parts_text + " tiles of 8x8 px, but a cart has only 256: room for " +
         std::to_string(kCartTiles / parts) + px;
}

}  // namespace

std::optional<std::string> tile_problem_of_cart(const Level& level) {
  const TileSize size = level.map.tile_size();
  if (size != TileSize()) return size_problem(size, count_shown(level));
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  if (sheet.count > kCartTiles) {
    const int shown = count_shown(level);
    return "the sheet has " + std::to_string(sheet.count) +
           " tiles, but that of a cart only 256; the map shows " + std::to_string(shown) +
           (shown < kCartTiles ? " of them, and a sheet of these alone would fit" : " of them");
  }
  if (sheet == SheetLayout()) return {};
  return "the sheet has " + std::to_string(sheet.columns) + " columns of " + std::to_string(sheet.count) +
         " tiles, but that of a cart has 16 columns of 256";
}

FormatResult<void> check_fits_cart(const Level& level) {
  if (auto problem = tile_problem_of_cart(level)) return tl::unexpected(FormatError{"", *std::move(problem)});
  if (map_fits_cart(level)) return {};
  return tl::unexpected(
      FormatError{"", "the map is " + size_text(level.map) + " cells, but a cart's map has at most 240x136"});
}

}  // namespace talus
