// Brushes and auto-tile sets as JSON.
#include "native_brushes.h"

#include <optional>
#include <utility>

#include "hex.h"
#include "native_objects.h"

namespace talus {
namespace {

// Reads one entry of the list, and remembers its first error.
class BrushReader {
 public:
  explicit BrushReader(std::string path) : path_(std::move(path)) {}

  FormatResult<Brush> read(Json& json) {
    if (!json.is_object()) return tl::unexpected(FormatError{"key " + path_, "must be an object"});
    take(json, "name", [this](const Json& name) {
      if (!name.is_string() || name.get_ref<const std::string&>().size() > kMaxBrushName)
        return fail("name", "must be a string of up to 1000 bytes");
      brush_.name = name.get<std::string>();
    });
    take(json, "random", [this](const Json& random) {
      if (!random.is_boolean()) return fail("random", "must be true or false");
      brush_.random = random.get<bool>();
    });
    if (!json.contains("rows")) fail("rows", "is missing");
    take(json, "rows", [this](const Json& rows) { read_rows(rows); });
    if (error_) return tl::unexpected(*error_);
    if (!json.empty()) brush_.extra = json.dump();
    return std::move(brush_);
  }

 private:
  void fail(const std::string& key, std::string message) {
    if (!error_) error_ = FormatError{"key " + path_ + "." + key, std::move(message)};
  }

  template <class Read>
  void take(Json& json, const char* key, Read read) {
    const auto found = json.find(key);
    if (found == json.end()) return;
    read(*found);
    json.erase(found);
  }

  void read_rows(const Json& rows) {
    const bool counted = rows.is_array() && !rows.empty() && rows.size() <= kMaxBrushSide;
    if (!counted) return fail("rows", "must be a list of 1 to 256 rows");
    brush_.tiles.clear();
    brush_.h = static_cast<int>(rows.size());
    for (const Json& row : rows) {
      const std::string text = row.is_string() ? row.get<std::string>() : "";
      if (text.empty() || text.size() % 2 != 0 || text.size() / 2 > kMaxBrushSide)
        return fail("rows", "must have rows of 1 to 256 cells, with two characters each");
      if (brush_.tiles.empty()) brush_.w = static_cast<int>(text.size() / 2);
      if (text.size() / 2 != static_cast<std::size_t>(brush_.w))
        return fail("rows", "must have rows of the same length");
      for (std::size_t i = 0; i < text.size(); i += 2) read_cell(text[i], text[i + 1]);
    }
  }

  void read_cell(char a, char b) {
    const int high = hex_value(a), low = hex_value(b);
    const bool is_empty = a == '.' && b == '.';
    if (!is_empty && (high < 0 || low < 0))
      return fail("rows", "has a cell that is no two hexadecimal digits");
    brush_.tiles.push_back(is_empty ? std::uint8_t{0} : static_cast<std::uint8_t>(high << 4 | low));
  }

  std::string path_;
  Brush brush_;
  std::optional<FormatError> error_;
};

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

}  // namespace

FormatResult<std::vector<Brush>> take_brushes(Json& list) {
  if (!list.is_array() || list.size() > kMaxBrushes)
    return tl::unexpected(FormatError{"key brushes", "must be a list of up to 1000 brushes"});
  std::vector<Brush> brushes;
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto brush = BrushReader("brushes[" + std::to_string(i) + "]").read(list[i]);
    if (!brush) return tl::unexpected(brush.error());
    brushes.push_back(*std::move(brush));
  }
  return brushes;
}

FormatResult<AutoTiles> take_auto_tiles(Json& json) {
  AutoTiles tiles;
  for (std::size_t i = 0; i < kGroundParts.size(); ++i) {
    const std::string key(kGroundParts[i].key);
    const auto found = json.find(key);
    if (found == json.end()) continue;
    if (!found->is_number_integer() || *found < 1 || *found >= kTileCount)
      return tl::unexpected(FormatError{"key auto_tiles." + key, "must be a tile number from 1 to 255"});
    tiles.tiles[i] = found->get<std::uint8_t>();
    json.erase(found);
  }
  return tiles;
}

FormatResult<Json> json_of(const std::vector<Brush>& brushes) {
  Json list = Json::array();
  for (const Brush& brush : brushes) {
    auto json = parse_extra(brush.extra);
    if (!json) return json;
    (*json)["name"] = brush.name;
    if (brush.random) (*json)["random"] = true;
    (*json)["rows"] = rows_of(brush);
    list.push_back(*std::move(json));
  }
  return list;
}

void put_auto_tiles(const AutoTiles& tiles, Json& json) {
  for (std::size_t i = 0; i < kGroundParts.size(); ++i)
    if (tiles.tiles[i] != 0) json[std::string(kGroundParts[i].key)] = tiles.tiles[i];
}

}  // namespace talus
