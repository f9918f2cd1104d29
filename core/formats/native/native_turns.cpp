#include "native_turns.h"

#include <algorithm>
#include <utility>

#include "../text/base64.h"
#include "../text/unpack.h"
#include "native_bytes.h"

namespace talus {
namespace {

tl::unexpected<FormatError> turns_error(const std::string& key, std::string message) {
  return tl::unexpected(FormatError{"key " + key, std::move(message)});
}

// Without what is not turned at the end.
std::string row_of_turns(const MapCells& cells, std::size_t first, std::size_t count) {
  std::string row;
  for (std::size_t i = first; i < first + count; ++i) row += digit_of_turn(cells.turn_of(i));
  row.erase(row.find_last_not_of('.') + 1);
  return row;
}

}  // namespace

char digit_of_turn(TileTurn turn) {
  return turn == TileTurn::none ? '.' : static_cast<char>('0' + static_cast<int>(turn));
}

std::optional<TileTurn> turn_of_digit(char digit) {
  if (digit == '.') return TileTurn::none;
  if (digit < '0' || digit >= '0' + kTileTurns) return std::nullopt;
  return static_cast<TileTurn>(digit - '0');
}

FormatResult<void> take_turn_rows(const Json& rows, const std::string& path, int width, MapCells& cells) {
  const std::string key = path + ".turns";
  const auto row_length = static_cast<std::size_t>(width);
  if (!rows.is_array() || rows.size() > cells.size() / row_length)
    return turns_error(key, "must be a list of as many rows as the map has, or fewer");
  for (std::size_t y = 0; y < rows.size(); ++y) {
    const std::string* const row = rows[y].is_string() ? &rows[y].get_ref<const std::string&>() : nullptr;
    if (row == nullptr || row->size() > row_length)
      return turns_error(key + "[" + std::to_string(y) + "]",
                         "must be a string of a digit for each cell of the row, or fewer");
    for (std::size_t x = 0; x < row->size(); ++x) {
      const auto turn = turn_of_digit((*row)[x]);
      if (!turn)
        return turns_error(key + "[" + std::to_string(y) + "]",
                           "has a cell, number " + std::to_string(x) + ", that is not a digit from 0 to 7");
      const std::size_t i = y * row_length + x;
      cells.set(i, {cells.tiles()[i], *turn});
    }
  }
  return {};
}

FormatResult<void> take_packed_turns(const Json& lines, const std::string& path, MapCells& cells) {
  const std::string key = path + ".packed_turns";
  const auto text = base64_of(lines);
  const auto packed = text ? decode_base64(*text) : std::nullopt;
  if (!packed) return turns_error(key, "must be a list of strings in Base64");
  const auto turns = unpack_zlib(*packed, cells.size());
  if (!turns || turns->size() != cells.size())
    return turns_error(key,
                       "must be a zlib stream of " + std::to_string(cells.size()) + " cells, a byte each");
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto turn = static_cast<std::uint8_t>((*turns)[i]);
    if (turn >= kTileTurns)
      return turns_error(key, "has a cell, number " + std::to_string(i) + ", that is not from 0 to 7");
    cells.set(i, {cells.tiles()[i], static_cast<TileTurn>(turn)});
  }
  return {};
}

void put_turns(const MapCells& cells, int width, bool is_packed, Json& json) {
  if (!cells.has_turned()) return;
  if (is_packed) {
    std::string bytes;
    bytes.reserve(cells.size());
    for (const TileTurn turn : cells.turns()) bytes += static_cast<char>(turn);
    json["packed_turns"] = json_of_bytes(pack_zlib(bytes));
    return;
  }
  const auto row_length = static_cast<std::size_t>(width);
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < cells.size(); i += row_length)
    rows.push_back(row_of_turns(cells, i, row_length));
  while (rows.back().empty()) rows.pop_back();
  json["turns"] = std::move(rows);
}

bool has_turned_tiles(const Level& level) {
  for (int layer = 0; layer < level.layers.count(); ++layer)
    if (level.cells_of(layer).has_turned()) return true;
  return std::any_of(level.brushes.begin(), level.brushes.end(), [](const Brush& brush) {
    return std::any_of(brush.tiles.begin(), brush.tiles.end(),
                       [](MapCell cell) { return cell.turn != TileTurn::none; });
  });
}

}  // namespace talus
