// Brushes and auto-tile sets as JSON.
#include "native_brushes.h"

#include <optional>
#include <utility>

#include "../text/hex.h"
#include "native_members.h"
#include "native_turns.h"

namespace talus {
namespace {

// Returns what is wrong with the rows.
std::optional<std::string> read_brush_rows(const Json& rows, int tile_count, Brush& brush) {
  const std::size_t digits = digits_of_tile(tile_count);
  const std::string digits_text = word_of_digits(digits);
  const bool counted = rows.is_array() && !rows.empty() && rows.size() <= kMaxBrushSide;
  if (!counted) return "must be a list of 1 to 256 rows";
  brush.tiles.clear();
  brush.h = static_cast<int>(rows.size());
  for (const Json& row : rows) {
    const std::string text = row.is_string() ? row.get<std::string>() : "";
    if (text.empty() || text.size() % digits != 0 || text.size() / digits > kMaxBrushSide)
      return "must have rows of 1 to 256 cells, with " + digits_text + " characters each";
    if (brush.tiles.empty()) brush.w = static_cast<int>(text.size() / digits);
    if (text.size() / digits != static_cast<std::size_t>(brush.w)) return "must have rows of the same length";
    for (std::size_t i = 0; i < text.size(); i += digits) {
      const auto tile = tile_of_digits(std::string_view(text).substr(i, digits));
      if (!tile) return "has a cell that is not " + digits_text + " hexadecimal digits";
      if (*tile >= tile_count)
        return "has tile " + std::to_string(*tile) + ", but there are only " + std::to_string(tile_count) +
               " tiles";
      brush.tiles.push_back(*tile);
    }
  }
  return std::nullopt;
}

// Returns what is wrong with the rows of turns.
std::optional<std::string> read_brush_turns(const Json& rows, Brush& brush) {
  if (!rows.is_array() || rows.size() > static_cast<std::size_t>(brush.h))
    return "must be a list of as many rows as the brush has, or fewer";
  for (std::size_t y = 0; y < rows.size(); ++y) {
    const std::string text = rows[y].is_string() ? rows[y].get<std::string>() : "";
    if (!rows[y].is_string() || text.size() > static_cast<std::size_t>(brush.w))
      return "must have strings of a digit for each cell of the row, or fewer";
    for (std::size_t x = 0; x < text.size(); ++x) {
      const auto turn = turn_of_digit(text[x]);
      if (!turn) return "has a cell that is not a digit from 0 to 7";
      brush.tiles[y * static_cast<std::size_t>(brush.w) + x].turn = *turn;
    }
  }
  return std::nullopt;
}

FormatResult<Brush> take_brush(Json& json, const std::string& path, int tile_count) {
  MemberTaker take(json, path);
  Brush brush;
  take.text("name", kMaxBrushName, brush.name);
  take.optional("random", brush.random);
  take.require("rows");
  take.member("rows", [&](const Json& rows) {
    if (auto problem = read_brush_rows(rows, tile_count, brush)) take.fail("rows", *std::move(problem));
  });
  take.member("turns", [&](const Json& rows) {
    if (auto problem = read_brush_turns(rows, brush)) take.fail("turns", *std::move(problem));
  });
  brush.extra = take.rest();
  return take.result(std::move(brush));
}

Json rows_of(const Brush& brush, int tile_count) {
  Json rows = Json::array();
  for (int y = 0; y < brush.h; ++y) {
    std::string row;
    for (int x = 0; x < brush.w; ++x) {
      append_tile(row, brush.tiles[static_cast<std::size_t>(y * brush.w + x)].tile,
                  digits_of_tile(tile_count));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

FormatResult<Json> put_brush(const Brush& brush, int tile_count) {
  auto json = parse_extra(brush.extra);
  if (!json) return json;
  (*json)["name"] = brush.name;
  if (brush.random) (*json)["random"] = true;
  (*json)["rows"] = rows_of(brush, tile_count);
  MapCells cells(brush.tiles.size());
  for (std::size_t i = 0; i < cells.size(); ++i) cells.set(i, brush.tiles[i]);
  put_turns(cells, brush.w, false, *json);
  return json;
}

}  // namespace

std::size_t digits_of_tile(int tile_count) { return tile_count <= 256 ? 2 : 4; }

std::string word_of_digits(std::size_t digits) { return digits == 2 ? "two" : "four"; }

void append_tile(std::string& text, TileNumber tile, std::size_t digits) {
  for (std::size_t digit = digits; digit-- > 0;) text += tile == 0 ? '.' : kHexDigits[tile >> 4 * digit & 15];
}

std::optional<TileNumber> tile_of_digits(std::string_view digits) {
  if (digits.find_first_not_of('.') == std::string_view::npos) return TileNumber{0};
  int tile = 0;
  for (const char c : digits) {
    const int value = hex_value(c);
    if (value < 0) return std::nullopt;
    tile = tile << 4 | value;
  }
  return static_cast<TileNumber>(tile);
}

FormatResult<std::vector<Brush>> take_brushes(Json& list, int tile_count) {
  const auto take = [&](Json& json, const std::string& path) { return take_brush(json, path, tile_count); };
  return take_list<Brush>(list, "brushes", take, kMaxBrushes, "must be a list of up to 1000 brushes");
}

FormatResult<AutoTiles> take_auto_tiles(Json& json, int tile_count) {
  AutoTiles tiles;
  for (std::size_t i = 0; i < kGroundParts.size(); ++i) {
    const std::string key(kGroundParts[i].key);
    const auto found = json.find(key);
    if (found == json.end()) continue;
    if (!is_whole(*found, 1, tile_count - 1))
      return tl::unexpected(FormatError{"key auto_tiles." + key,
                                        "must be a tile number from 1 to " + std::to_string(tile_count - 1)});
    tiles.tiles[i] = found->get<TileNumber>();
    json.erase(found);
  }
  return tiles;
}

FormatResult<Json> json_of(const std::vector<Brush>& brushes, int tile_count) {
  const auto put = [&](const Brush& brush, const std::string&) { return put_brush(brush, tile_count); };
  return put_list(brushes, "brushes", put);
}

void put_auto_tiles(const AutoTiles& tiles, Json& json) {
  for (std::size_t i = 0; i < kGroundParts.size(); ++i)
    if (tiles.tiles[i] != 0) json[std::string(kGroundParts[i].key)] = tiles.tiles[i];
}

}  // namespace talus
