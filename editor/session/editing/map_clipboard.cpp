// Reads and writes the text of the clipboard.
#include "map_clipboard.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <talus/level/tile_map.h>
#include "formats/text/hex.h"

namespace talus {
namespace {

constexpr int kMostInAByte = 255;
constexpr std::string_view kLargeMap = "map ";      // two digits a cell
constexpr std::string_view kWideMap = "wide map ";  // four digits a cell
constexpr const char* kNoTiles = "the clipboard holds no tiles of a map";

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

void append_byte(std::string& text, int byte) {
  text += kHexDigits[static_cast<std::size_t>(byte & 15)];
  text += kHexDigits[static_cast<std::size_t>(byte >> 4)];
}

// Takes "300x20" and the end of its line off the front; nothing if there is no such line.
std::optional<Cell> take_size(std::string_view& text) {
  Cell size{0, 0};
  const char* const end = text.data() + text.size();
  const auto [x, x_error] = std::from_chars(text.data(), end, size.x);
  if (x_error != std::errc() || x == end || *x != 'x') return std::nullopt;
  const auto [rest, y_error] = std::from_chars(x + 1, end, size.y);
  if (y_error != std::errc() || rest == end || !is_space(*rest)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return size;
}

// The bytes of the digits, without white space; empty if there is another character, or a digit is left over.
std::vector<std::uint8_t> bytes_of(std::string_view text) {
  std::string digits(text);
  std::erase_if(digits, is_space);
  std::vector<std::uint8_t> bytes;
  if (digits.size() % 2 != 0) return bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const int low = hex_value(digits[i]), high = hex_value(digits[i + 1]);
    if (low < 0 || high < 0) return {};
    bytes.push_back(static_cast<std::uint8_t>(high * 16 + low));
  }
  return bytes;
}

}  // namespace

std::string text_of_cells(const Stamp& tiles) {
  std::string text;
  const bool is_wide =
      std::any_of(tiles.tiles.begin(), tiles.tiles.end(), [](int tile) { return tile > kMostInAByte; });
  text.reserve((is_wide ? 4 : 2) * tiles.tiles.size() + 24);
  if (is_wide) {
    text = std::string(kWideMap) + std::to_string(tiles.w) + "x" + std::to_string(tiles.h) + "\n";
  } else if (tiles.w > kMostInAByte || tiles.h > kMostInAByte) {
    text = std::string(kLargeMap) + std::to_string(tiles.w) + "x" + std::to_string(tiles.h) + "\n";
  } else {
    append_byte(text, tiles.w);
    append_byte(text, tiles.h);
  }
  for (const TileNumber tile : tiles.tiles) {
    append_byte(text, tile & kMostInAByte);
    if (is_wide) append_byte(text, tile >> 8);
  }
  return text;
}

tl::expected<Stamp, std::string> cells_of_text(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_space))
    return tl::unexpected(std::string("the clipboard is empty"));
  const auto no_tiles = tl::unexpected(std::string(kNoTiles));
  std::optional<Cell> size;
  const bool is_wide = text.starts_with(kWideMap);
  if (is_wide || text.starts_with(kLargeMap)) {
    text.remove_prefix(is_wide ? kWideMap.size() : kLargeMap.size());
    size = take_size(text);
    if (!size) return no_tiles;
  }
  std::vector<std::uint8_t> bytes = bytes_of(text);
  if (!size) {
    if (bytes.size() < 3) return no_tiles;
    size = Cell{bytes[0], bytes[1]};
    bytes.erase(bytes.begin(), bytes.begin() + 2);
  }
  const std::size_t bytes_of_cell = is_wide ? 2 : 1;
  if (!is_terrain_size(size->x, size->y) ||
      static_cast<std::size_t>(size->x) * size->y * bytes_of_cell != bytes.size())
    return no_tiles;
  Stamp stamp{size->x, size->y, {}};
  for (std::size_t i = 0; i < bytes.size(); i += bytes_of_cell)
    stamp.tiles.push_back(static_cast<TileNumber>(is_wide ? bytes[i] | bytes[i + 1] << 8 : bytes[i]));
  return stamp;
}

}  // namespace talus
