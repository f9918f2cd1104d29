// CartContent: what a TIC-80 cart holds, independent of the file format. It stands between the two cart
// formats and levels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>
#include <talus/level/level.h>

namespace talus {

inline constexpr int kBankCount = 8;
inline constexpr std::size_t kBankBytes = 65'536;                   // of a piece of code or of BINARY
inline constexpr std::size_t kCodeLimit = 524'287;                  // bytes of code that TIC-80 can hold
inline constexpr std::size_t kMaxCartBytes = std::size_t{4} << 20;  // twice a full cart

// The binary sections, in the order of a text project.
enum class Section : std::uint8_t {
  tiles,
  sprites,
  map,
  waves,
  sfx,
  patterns,
  tracks,
  flags,
  screen,
  palette
};
inline constexpr int kSectionCount = 10;

struct SectionInfo {
  Section id;
  std::string_view tag;  // in a text project: "MAP"; banks 1..7 append their digit
  int chunk;             // its type in a .tic file
  int rows;              // in a text project
  int row_bytes;
  std::size_t size() const { return static_cast<std::size_t>(rows) * row_bytes; }
};
std::span<const SectionInfo, kSectionCount> section_infos();  // by Section
const SectionInfo& section_info(Section id);

// The sections that a level edits, all in bank 0. The second half of the palette section is a second palette,
// which a level does not have.
inline constexpr std::array kLevelSections = {Section::tiles, Section::sprites, Section::map, Section::flags,
                                              Section::palette};

// Bytes of each section, by Section, without trailing zeros, which the file formats do not keep apart.
using Bank = std::array<std::string, kSectionCount>;
inline std::string& at(Bank& bank, Section id) { return bank[static_cast<std::size_t>(id)]; }
inline const std::string& at(const Bank& bank, Section id) { return bank[static_cast<std::size_t>(id)]; }

struct CartContent {
  std::array<Bank, kBankCount> banks;
  std::string code;
  std::uint8_t lang = 0;
  std::vector<std::string>
      rest;  // what only this form of cart can hold, in phrases for WrittenLevel::dropped
};

// Default palette and sounds, and code that shows the map: for a level that did not come from a cart.
CartContent new_cart();

std::string_view default_palette_bytes();  // the meaning of the DEFAULT chunk of a .tic file
std::string_view default_wave_bytes();

void trim_zeros(std::string& bytes);

// Returns a section's bytes as the level has it, without trailing zeros. The map must fit a cart (asserted).
std::string section_bytes(const Level& level, Section id);
bool map_fits_cart(const Level& level);  // at most 240x136; a smaller map is padded with tile 0

// Puts the level's sections into bank 0. A section that a reader would see as equal keeps its bytes; so does
// the map if the level's map does not fit.
Bank edited_bank(const Level& level, const Bank& before);

// Returns the level that bank 0 of a cart shows, without its origin. A palette of zeros shows as DB16,
// TIC-80's palette for carts from before there were palettes.
Level level_of_bank(const Bank& bank);

// Why a cart cannot have the level's tiles: they do not have 8x8 px, or are not 256 in 16 columns; nothing if
// it can. Counts the different tiles that the map shows, and says what would fit.
std::optional<std::string> tile_problem_of_cart(const Level& level);
// Returns an error if the tiles or the map do not fit. Anything else that carts cannot hold goes into the
// companion.
FormatResult<void> check_fits_cart(const Level& level);

}  // namespace talus
