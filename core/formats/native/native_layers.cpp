#include "native_layers.h"

#include <algorithm>
#include <span>
#include <utility>

#include <talus/level/limits.h>
#include "../text/base64.h"
#include "../text/unpack.h"
#include "native_brushes.h"
#include "native_bytes.h"
#include "native_turns.h"

namespace talus {
namespace {

tl::unexpected<FormatError> layer_error(std::string place, std::string message) {
  return tl::unexpected(FormatError{std::move(place), std::move(message)});
}

// Reads a row into the cells from `out` on.
FormatResult<void> read_row(const Json& row, const std::string& place, const Level& level,
                            std::span<TileNumber> out) {
  if (!row.is_string()) return layer_error(place, "must be a string");
  const std::string& text = row.get_ref<const std::string&>();
  const std::size_t digits = digits_of_tile(level.tile_count());
  if (text.size() > digits * out.size())
    return layer_error(place, "is longer than the map's width of " + std::to_string(out.size()) + " cells");
  const std::string digits_text = word_of_digits(digits);
  if (text.size() % digits != 0)
    return layer_error(place, "must have " + digits_text + " characters for each cell");
  for (std::size_t x = 0; digits * x < text.size(); ++x) {
    const auto tile = tile_of_digits(std::string_view(text).substr(digits * x, digits));
    if (!tile)
      return layer_error(place, "has a cell, number " + std::to_string(x) + ", that is not " + digits_text +
                                    " hexadecimal digits");
    if (*tile >= level.tile_count())
      return layer_error(place, "has a cell, number " + std::to_string(x) + ", with tile " +
                                    std::to_string(*tile) + ", but there are only " +
                                    std::to_string(level.tile_count()) + " tiles");
    out[x] = *tile;
  }
  return {};
}

std::string row_text(std::span<const TileNumber> cells, std::size_t digits) {
  while (!cells.empty() && cells.back() == 0) cells = cells.first(cells.size() - 1);
  std::string row;
  row.reserve(digits * cells.size());
  for (const TileNumber tile : cells) append_tile(row, tile, digits);
  return row;
}

// Larger layers are packed, as text of all rows would be larger than a file may be.
constexpr std::size_t kMaxCellsAsText = std::size_t{1} << 20;

std::string packed(const std::vector<TileNumber>& cells) {
  std::string bytes;
  bytes.reserve(2 * cells.size());
  for (const TileNumber tile : cells) {
    bytes += static_cast<char>(tile & 0xff);
    bytes += static_cast<char>(tile >> 8);
  }
  return pack_zlib(bytes);
}

FormatResult<std::vector<TileNumber>> read_packed(const Json& lines, const std::string& key,
                                                  const Level& level) {
  const std::size_t count = level.map.cells().size();
  const auto text = base64_of(lines);
  const auto bytes = text ? decode_base64(*text) : std::nullopt;
  if (!bytes) return layer_error("key " + key, "must be a list of strings in Base64");
  const auto cells_as_bytes = unpack_zlib(*bytes, 2 * count);
  if (!cells_as_bytes || cells_as_bytes->size() != 2 * count)
    return layer_error("key " + key,
                       "must be a zlib stream of " + std::to_string(count) + " cells, two bytes each");
  std::vector<TileNumber> cells(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto low = static_cast<std::uint8_t>((*cells_as_bytes)[2 * i]);
    const auto high = static_cast<std::uint8_t>((*cells_as_bytes)[2 * i + 1]);
    cells[i] = static_cast<TileNumber>(high << 8 | low);
    if (cells[i] >= level.tile_count())
      return layer_error("key " + key, "has a cell, number " + std::to_string(i) + ", with tile " +
                                           std::to_string(cells[i]) + ", but there are only " +
                                           std::to_string(level.tile_count()) + " tiles");
  }
  return cells;
}

FormatResult<TileLayer> take_layer(Json& json, const std::string& path, const Level& level,
                                   const Progress& progress) {
  MemberTaker take(json, path);
  TileLayer layer;
  take.optional("name", layer.name);
  take.optional("ground", layer.is_ground);
  take.optional("group", layer.group);
  take_looks(take, layer);
  Json rows = Json::array(), bytes, turns, packed_turns;
  take.member("rows", [&](const Json& its) { rows = its; });
  take.member("packed", [&](const Json& its) { bytes = its; });
  take.member("turns", [&](const Json& its) { turns = its; });
  take.member("packed_turns", [&](const Json& its) { packed_turns = its; });
  if (const auto good = take.result(true); !good) return tl::unexpected(good.error());
  auto cells = bytes.is_null() ? read_rows(rows, path + ".rows", path + " row ", level, progress)
                               : read_packed(bytes, path + ".packed", level);
  if (!cells) return tl::unexpected(cells.error());
  MapCells all(*std::move(cells));
  FormatResult<void> good;
  if (!turns.is_null()) good = take_turn_rows(turns, path, level.map.width(), all);
  if (good && !packed_turns.is_null()) good = take_packed_turns(packed_turns, path, all);
  if (!good) return tl::unexpected(good.error());
  layer.cells = std::make_shared<const MapCells>(std::move(all));
  layer.extra = take.rest();
  return layer;
}

FormatResult<Json> json_of_layer(const TileLayer& layer, const MapCells& cells, const std::string& path,
                                 const Level& level) {
  if (const auto good = check_looks(layer, path); !good) return tl::unexpected(good.error());
  auto parsed = parse_extra(layer.extra);
  if (!parsed) return parsed;
  Json& json = *parsed;
  if (!layer.name.empty()) json["name"] = layer.name;
  if (!layer.is_ground) json["ground"] = false;
  if (layer.group >= 0) json["group"] = layer.group;
  put_looks(layer, json);
  const bool is_packed = cells.size() > kMaxCellsAsText;
  if (is_packed)
    json["packed"] = json_of_bytes(packed(cells.tiles()));
  else
    json["rows"] = json_of_rows(cells.tiles(), level);
  put_turns(cells, level.map.width(), is_packed, json);
  return parsed;
}

}  // namespace

bool is_pair_within(Vec2 pair, double most) {
  const auto is_good = [most](double number) { return number >= -most && number <= most; };
  return is_good(pair.x) && is_good(pair.y);
}

std::string pair_text(double most) {
  const std::string number = std::to_string(static_cast<int>(most));
  return "must be [x, y], each from -" + number + " to " + number;
}

void take_pair(MemberTaker& take, const char* key, double most, Vec2& value) {
  take.optional(key, value);
  if (!is_pair_within(value, most)) take.fail(key, pair_text(most));
}

FormatResult<std::vector<TileNumber>> read_rows(const Json& rows, const std::string& key,
                                                const std::string& row, const Level& level,
                                                const Progress& progress) {
  const TileMap& map = level.map;
  if (!rows.is_array()) return layer_error("key " + key, "must be a list");
  if (rows.size() > static_cast<std::size_t>(map.height()))
    return layer_error("key " + key, "has " + std::to_string(rows.size()) +
                                         " rows, more than the map's height of " +
                                         std::to_string(map.height()));
  const auto width = static_cast<std::size_t>(map.width());
  std::vector<TileNumber> cells(map.cells().size());
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (!progress.at(y, rows.size())) return was_cancelled();
    const auto good =
        read_row(rows[y], row + std::to_string(y), level, std::span(cells).subspan(y * width, width));
    if (!good) return tl::unexpected(good.error());
  }
  return cells;
}

Json json_of_rows(const std::vector<TileNumber>& cells, const Level& level) {
  const std::size_t digits = digits_of_tile(level.tile_count());
  const auto width = static_cast<std::size_t>(level.map.width());
  std::span<const TileNumber> rest = cells;
  while (!rest.empty() && rest.back() == 0) rest = rest.first(rest.size() - 1);
  Json rows = Json::array();
  for (; !rest.empty(); rest = rest.subspan(std::min(width, rest.size())))
    rows.push_back(row_text(rest.first(std::min(width, rest.size())), digits));
  return rows;
}

FormatResult<void> take_layers(Json& list, Level& level, const Progress& progress) {
  if (!list.is_array() || list.empty() || list.size() > kMaxLayers)
    return layer_error("key layers", "must be a list of 1 to " + std::to_string(kMaxLayers) + " layers");
  if (list.size() > 1 && list.size() * level.map.cells().size() > kMaxLayerCells)
    return layer_error("key layers",
                       "has layers with more than " + std::to_string(kMaxLayerCells) + " cells");
  std::size_t read = 0;
  auto layers = take_list<TileLayer>(list, "layers", [&](Json& json, const std::string& path) {
    const auto done = static_cast<double>(read++), all = static_cast<double>(list.size());
    return take_layer(json, path, level, progress.part(done / all, (done + 1) / all));
  });
  if (!layers) return tl::unexpected(layers.error());
  const auto ground = std::find_if(layers->begin(), layers->end(), [](const auto& l) { return l.is_ground; });
  const auto chosen = ground == layers->end() ? layers->begin() : ground;
  level.map.cells() = *chosen->cells;
  chosen->cells = nullptr;
  level.layers.chosen = static_cast<int>(chosen - layers->begin());
  level.layers.list = *std::move(layers);
  return {};
}

FormatResult<Json> json_of_layers(const Level& level) {
  Json list = Json::array();
  if (level.layers.is_plain() && level.layers.list.front().name.empty()) return list;
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const std::string path = "layers[" + std::to_string(layer) + "]";
    auto json =
        json_of_layer(level.layers.list[static_cast<std::size_t>(layer)], level.cells_of(layer), path, level);
    if (!json) return json;
    list.push_back(*std::move(json));
  }
  return list;
}

}  // namespace talus
