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

constexpr int kMaxInAByte = 255;
constexpr std::string_view kLargeMap = "map ";          // two digits a cell
constexpr std::string_view kWideMap = "wide map ";      // four digits a cell
constexpr std::string_view kTurnedMap = "turned map ";  // six digits a cell
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
  const auto any = [&](auto is) { return std::any_of(tiles.tiles.begin(), tiles.tiles.end(), is); };
  const bool is_turned = any([](MapCell cell) { return cell.turn != TileTurn::none; });
  const bool is_wide = is_turned || any([](MapCell cell) { return cell.tile > kMaxInAByte; });
  text.reserve((is_wide ? 6 : 2) * tiles.tiles.size() + 24);
  if (is_wide) {
    text = std::string(is_turned ? kTurnedMap : kWideMap) + std::to_string(tiles.w) + "x" +
           std::to_string(tiles.h) + "\n";
  } else if (tiles.w > kMaxInAByte || tiles.h > kMaxInAByte) {
    text = std::string(kLargeMap) + std::to_string(tiles.w) + "x" + std::to_string(tiles.h) + "\n";
  } else {
    append_byte(text, tiles.w);
    append_byte(text, tiles.h);
  }
  for (const auto [tile, turn] : tiles.tiles) {
    append_byte(text, tile & kMaxInAByte);
    if (is_wide) append_byte(text, tile >> 8);
    if (is_turned) append_byte(text, static_cast<int>(turn));
  }
  return text;
}

tl::expected<Stamp, std::string> cells_of_text(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_space))
    return tl::unexpected(std::string("the clipboard is empty"));
  const auto no_tiles = tl::unexpected(std::string(kNoTiles));
  std::optional<Cell> size;
  std::size_t bytes_of_cell = 1;
  for (const std::string_view head : {kLargeMap, kWideMap, kTurnedMap}) {
    if (!text.starts_with(head)) continue;
    bytes_of_cell = head == kTurnedMap ? 3 : head == kWideMap ? 2 : 1;
    text.remove_prefix(head.size());
    size = take_size(text);
    if (!size) return no_tiles;
    break;
  }
  std::vector<std::uint8_t> bytes = bytes_of(text);
  if (!size) {
    if (bytes.size() < 3) return no_tiles;
    size = Cell{bytes[0], bytes[1]};
    bytes.erase(bytes.begin(), bytes.begin() + 2);
  }
  if (!is_terrain_size(size->x, size->y) ||
      static_cast<std::size_t>(size->x) * size->y * bytes_of_cell != bytes.size())
    return no_tiles;
  Stamp stamp{size->x, size->y, {}};
  for (std::size_t i = 0; i < bytes.size(); i += bytes_of_cell) {
    const int high = bytes_of_cell > 1 ? bytes[i + 1] : 0, turn = bytes_of_cell > 2 ? bytes[i + 2] : 0;
    if (turn >= kTileTurns) return no_tiles;
    stamp.tiles.emplace_back(static_cast<TileNumber>(bytes[i] | high << 8), static_cast<TileTurn>(turn));
  }
  return stamp;
}

}  // namespace talus
