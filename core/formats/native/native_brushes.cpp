// Brushes and auto-tile sets as JSON.
#include "native_brushes.h"

#include <optional>
#include <utility>

#include "../text/hex.h"
#include "native_members.h"

namespace talus {
namespace {

// Returns what is wrong with the rows.
std::optional<std::string> read_brush_rows(const Json& rows, Brush& brush) {
  const bool counted = rows.is_array() && !rows.empty() && rows.size() <= kMaxBrushSide;
  if (!counted) return "must be a list of 1 to 256 rows";
  brush.tiles.clear();
  brush.h = static_cast<int>(rows.size());
  for (const Json& row : rows) {
    const std::string text = row.is_string() ? row.get<std::string>() : "";
    if (text.empty() || text.size() % 2 != 0 || text.size() / 2 > kMaxBrushSide)
      return "must have rows of 1 to 256 cells, with two characters each";
    if (brush.tiles.empty()) brush.w = static_cast<int>(text.size() / 2);
    if (text.size() / 2 != static_cast<std::size_t>(brush.w)) return "must have rows of the same length";
    for (std::size_t i = 0; i < text.size(); i += 2) {
      const int high = hex_value(text[i]), low = hex_value(text[i + 1]);
      const bool is_empty = text[i] == '.' && text[i + 1] == '.';
      if (!is_empty && (high < 0 || low < 0)) return "has a cell that is not two hexadecimal digits";
      brush.tiles.push_back(is_empty ? std::uint8_t{0} : static_cast<std::uint8_t>(high << 4 | low));
    }
  }
  return std::nullopt;
}

FormatResult<Brush> take_brush(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  Brush brush;
  take.text("name", kMaxBrushName, brush.name);
  take.optional("random", brush.random);
  take.require("rows");
  take.member("rows", [&](const Json& rows) {
    if (auto problem = read_brush_rows(rows, brush)) take.fail("rows", *std::move(problem));
  });
  brush.extra = take.rest();
  return take.result(std::move(brush));
}

Json rows_of(const Brush& brush) {
  Json rows = Json::array();
  for (int y = 0; y < brush.h; ++y) {
    std::string row;
    for (int x = 0; x < brush.w; ++x) {
      const std::uint8_t tile = brush.tiles[static_cast<std::size_t>(y * brush.w + x)];
      row += tile == 0 ? '.' : kHexDigits[tile >> 4];
      row += tile == 0 ? '.' : kHexDigits[tile & 15];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

FormatResult<Json> put_brush(const Brush& brush, const std::string&) {
  auto json = parse_extra(brush.extra);
  if (!json) return json;
  (*json)["name"] = brush.name;
  if (brush.random) (*json)["random"] = true;
  (*json)["rows"] = rows_of(brush);
  return json;
}

}  // namespace

FormatResult<std::vector<Brush>> take_brushes(Json& list) {
  return take_list<Brush>(list, "brushes", take_brush, kMaxBrushes, "must be a list of up to 1000 brushes");
}

FormatResult<AutoTiles> take_auto_tiles(Json& json) {
  AutoTiles tiles;
  for (std::size_t i = 0; i < kGroundParts.size(); ++i) {
    const std::string key(kGroundParts[i].key);
    const auto found = json.find(key);
    if (found == json.end()) continue;
    if (!is_whole(*found, 1, kTileCount - 1))
      return tl::unexpected(FormatError{"key auto_tiles." + key, "must be a tile number from 1 to 255"});
    tiles.tiles[i] = found->get<std::uint8_t>();
    json.erase(found);
  }
  return tiles;
}

FormatResult<Json> json_of(const std::vector<Brush>& brushes) {
  return put_list(brushes, "brushes", put_brush);
}

void put_auto_tiles(const AutoTiles& tiles, Json& json) {
  for (std::size_t i = 0; i < kGroundParts.size(); ++i)
    if (tiles.tiles[i] != 0) json[std::string(kGroundParts[i].key)] = tiles.tiles[i];
}

}  // namespace talus
