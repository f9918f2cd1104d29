// Levels as JSON. Reading takes every key that it knows out of the document; what remains is kept as it is,
// in its place, and put back when the level is written.
#include "native.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "hex.h"
#include "json_text.h"
#include "native_cart.h"

namespace talus {
namespace {

constexpr double kMaxSpawnNumber = 1'000'000;  // px and px/frame; 30 times the largest map

struct SpawnField {
  const char* key;
  Vec2 Spawn::*vector;
  double Vec2::*part;
};
constexpr std::array<SpawnField, 4> kSpawnFields = {{{"x", &Spawn::position, &Vec2::x},
                                                     {"y", &Spawn::position, &Vec2::y},
                                                     {"vx", &Spawn::velocity, &Vec2::x},
                                                     {"vy", &Spawn::velocity, &Vec2::y}}};

constexpr std::array<const char*, 2> kSheetKeys = {"tiles", "sprites"};  // by SheetId

// Whole numbers print as such: a range of -64 to 64, not of -64.000000.
std::string text_of(double value) { return json_number(value).dump(); }

std::string range_text(double min, double max, std::string_view unit) {
  std::string text = "must be a number from " + text_of(min) + " to " + text_of(max);
  return unit.empty() ? text : text + " " + std::string(unit);
}

// Reads on after an error, which harms nothing, and remembers the first.
class Reader {
 public:
  FormatResult<Level> read(Json document) {
    read_version(document);
    if (error_) return tl::unexpected(*error_);  // of a newer file nothing else can be trusted
    take(document, "palette", [this](Json& v) { read_palette(v); });
    take(document, "flag_names", [this](Json& v) { read_flag_names(v); });
    take_object(document, "roles", "roles", [this](Json& v) { read_roles(v); });
    take_object(document, "tuning", "tuning", [this](Json& v) { read_tuning(v); });
    take(document, "spawns", [this](Json& v) { read_spawns(v); });
    for (std::size_t i = 0; i < kSheetKeys.size(); ++i) {
      take_object(document, kSheetKeys[i], kSheetKeys[i],
                  [&](Json& v) { read_sheet(v, kSheetKeys[i], level_.sheets[i]); });
    }
    take_object(document, "map", "map", [this](Json& v) { read_map(v); });
    take_object(document, "cart", "cart", [this](Json& v) { read_cart(v); });
    if (error_) return tl::unexpected(*error_);
    if (!document.empty()) level_.extra = document.dump();
    return std::move(level_);
  }

 private:
  void fail(std::string place, std::string message) {
    if (!error_) error_ = FormatError{std::move(place), std::move(message)};
  }
  void fail_key(const std::string& key, std::string message) { fail("key " + key, std::move(message)); }

  // Calls read(value) if the key is there, and takes the key away.
  template <class Read>
  void take(Json& object, const std::string& key, Read read) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    Json value = std::move(*found);
    object.erase(found);
    read(value);
  }

  // The same for an object, whose unknown members stay where they are.
  template <class Read>
  void take_object(Json& object, const std::string& key, const std::string& path, Read read) {
    take(object, key, [&](Json& value) {
      if (!value.is_object()) return fail_key(path, "must be an object");
      read(value);
      if (!value.empty()) object[key] = std::move(value);
    });
  }

  void take_number(Json& object, const std::string& key, const std::string& path, double min, double max,
                   std::string_view unit, double& out) {
    take(object, key, [&](const Json& value) {
      const double number =
          value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
      if (!(number >= min && number <= max)) return fail_key(path, range_text(min, max, unit));
      out = number;
    });
  }

  static bool is_whole(const Json& value, int min, int max) {
    return value.is_number_integer() && value >= min && value <= max;
  }

  void read_version(Json& document) {
    if (!document.is_object()) return fail("", "is JSON, but no Talus level");
    if (!document.contains("talus")) return fail_key("talus", "is missing, so this is no Talus level");
    take(document, "talus", [this](const Json& value) {
      if (!value.is_number_integer() || value < 1)
        return fail_key("talus", "must be the version, a whole number from 1");
      if (value > kNativeVersion) {
        fail_key("talus", "this level has version " + value.dump() + ", and this Talus reads up to version " +
                              std::to_string(kNativeVersion));
      }
    });
  }

  void read_palette(const Json& colors) {
    if (!colors.is_array() || colors.size() != kColorCount)
      return fail_key("palette", "must be a list of 16 colours");
    for (int i = 0; i < kColorCount; ++i) {
      const std::string text = colors[i].is_string() ? colors[i].get<std::string>() : "";
      const bool good =
          text.size() == 6 && std::all_of(text.begin(), text.end(), [](char c) { return hex_value(c) >= 0; });
      if (!good) return fail_key("palette[" + std::to_string(i) + "]", "must be a colour such as \"1a1c2c\"");
      const auto channel = [&](int at) {
        return static_cast<std::uint8_t>(hex_value(text[at]) << 4 | hex_value(text[at + 1]));
      };
      level_.palette[i] = {channel(0), channel(2), channel(4)};
    }
  }

  void read_flag_names(const Json& names) {
    const bool good =
        names.is_array() && names.size() <= kFlagCount &&
        std::all_of(names.begin(), names.end(), [](const Json& name) { return name.is_string(); });
    if (!good) return fail_key("flag_names", "must be a list of up to 8 strings");
    for (std::size_t i = 0; i < names.size(); ++i) level_.flag_names[i] = names[i].get<std::string>();
  }

  void read_roles(Json& roles) {
    for (const FlagRoleInfo& info : flag_role_infos()) {
      const std::string key(info.key);
      take(roles, key, [&](const Json& flag) {
        if (!flag.is_null() && !is_whole(flag, 0, kFlagCount - 1)) {
          return fail_key("roles." + key, "must be a flag from 0 to 7, or null");
        }
        level_.roles.*info.flag = flag.is_null() ? FlagRoles::kUnused : flag.get<int>();
      });
    }
  }

  void read_tuning(Json& tuning) {
    take(tuning, "solver", [this](const Json& solver) {
      const std::string_view known = solver_name(SolverKind::article);
      if (solver != known) fail_key("tuning.solver", "must be \"" + std::string(known) + "\"");
    });
    for (const TuningField& field : tuning_fields()) {
      const std::string key(field.key);
      take_number(tuning, key, "tuning." + key, field.min, field.max, field.unit,
                  level_.tuning.article.*field.value);
    }
  }

  void read_spawns(Json& spawns) {
    if (!spawns.is_array()) return fail_key("spawns", "must be a list");
    for (std::size_t i = 0; i < spawns.size(); ++i)
      read_spawn(spawns[i], "spawns[" + std::to_string(i) + "]");
  }

  void read_spawn(Json& json, const std::string& path) {
    if (!json.is_object()) return fail_key(path, "must be an object");
    Spawn& spawn = level_.spawns.emplace_back();
    take(json, "name", [&](const Json& name) {
      if (!name.is_string()) return fail_key(path + ".name", "must be a string");
      spawn.name = name.get<std::string>();
    });
    for (const SpawnField& field : kSpawnFields) {
      take_number(json, field.key, path + "." + field.key, -kMaxSpawnNumber, kMaxSpawnNumber, "",
                  spawn.*field.vector.*field.part);
    }
    if (!json.empty()) spawn.extra = json.dump();
  }

  void read_sheet(Json& tiles, const std::string& path, Sheet& sheet) {
    for (int tile = 0; tile < kTileCount; ++tile) {
      const std::string key = std::to_string(tile), entry = path + "." + key;
      take_object(tiles, key, entry, [&](Json& json) {
        take(json, "flags",
             [&](const Json& flags) { read_flags(flags, entry + ".flags", sheet.flags[tile]); });
        take(json, "pixels",
             [&](const Json& rows) { read_pixels(rows, entry + ".pixels", sheet.images[tile]); });
      });
    }
    for (auto it = tiles.begin(); it != tiles.end(); ++it) {
      if (!is_number(it.key()) || is_tile_number(it.key()))
        continue;  // a key, or a tile with keys, of the future
      fail_key(path + "." + it.key().substr(0, 8), "is no tile number from 0 to 255");
    }
  }

  static bool is_number(const std::string& key) {
    return !key.empty() && key.find_first_not_of("0123456789") == std::string::npos;
  }
  static bool is_tile_number(const std::string& number) {
    return number.size() <= 3 && std::stoi(number) < kTileCount &&
           std::to_string(std::stoi(number)) == number;
  }

  void read_flags(const Json& flags, const std::string& path, std::uint8_t& out) {
    const bool good = flags.is_array() && std::all_of(flags.begin(), flags.end(), [](const Json& flag) {
                        return is_whole(flag, 0, kFlagCount - 1);
                      });
    if (!good) return fail_key(path, "must be a list of flags from 0 to 7");
    for (const Json& flag : flags) out = static_cast<std::uint8_t>(out | 1 << flag.get<int>());
  }

  void read_pixels(const Json& rows, const std::string& path, TileImage& image) {
    std::string text = rows.is_string() ? rows.get<std::string>() : "";
    std::erase(text, ' ');
    const bool good = text.size() == image.size() && std::all_of(text.begin(), text.end(), [](char c) {
                        return c == '.' || hex_value(c) >= 0;
                      });
    if (!good) return fail_key(path, "must be eight rows of eight hexadecimal digits");
    std::transform(text.begin(), text.end(), image.begin(),
                   [](char c) { return static_cast<std::uint8_t>(c == '.' ? 0 : hex_value(c)); });
  }

  void read_map(Json& map) {
    int width = kTicMapWidth, height = kTicMapHeight;
    const auto take_side = [&](const std::string& key, int& side) {
      take(map, key, [&](const Json& value) {
        if (!is_whole(value, 1, kMaxMapSide))
          return fail_key("map." + key, "must be a whole number from 1 to 4096");
        side = value.get<int>();
      });
    };
    take_side("width", width);
    take_side("height", height);
    level_.map = TileMap(width, height);
    take(map, "rows", [this](const Json& rows) { read_map_rows(rows); });
  }

  void read_map_rows(const Json& rows) {
    TileMap& map = level_.map;
    if (!rows.is_array()) return fail_key("map.rows", "must be a list");
    if (rows.size() > static_cast<std::size_t>(map.height())) {
      return fail_key("map.rows", "has " + std::to_string(rows.size()) +
                                      " rows, more than the map's height of " + std::to_string(map.height()));
    }
    for (int y = 0; y < static_cast<int>(rows.size()) && !error_; ++y) read_map_row(rows[y], y);
  }

  void read_map_row(const Json& row, int y) {
    const std::string place = "map row " + std::to_string(y);
    if (!row.is_string()) return fail(place, "must be a string");
    const std::string& text = row.get_ref<const std::string&>();
    if (text.size() > 2 * static_cast<std::size_t>(level_.map.width())) {
      return fail(place,
                  "is longer than the map's width of " + std::to_string(level_.map.width()) + " cells");
    }
    if (text.size() % 2 != 0) return fail(place, "must have two characters a cell");
    for (int x = 0; 2 * x < static_cast<int>(text.size()); ++x) {
      const char a = text[2 * x], b = text[2 * x + 1];
      if (a == '.' && b == '.') continue;
      const int high = hex_value(a), low = hex_value(b);
      if (high < 0 || low < 0)
        return fail(place, "has a cell, number " + std::to_string(x) + ", that is no two hexadecimal digits");
      level_.map.set({x, y}, static_cast<std::uint8_t>(high << 4 | low));
    }
  }

  void read_cart(Json& json) {
    if (!json.contains("kind")) return;  // unknown keys that outlived their cart
    auto cart = take_cart(json, level_);
    if (!cart) return fail(cart.error().place, cart.error().message);
    level_.cart = *std::move(cart);
  }

  Level level_;
  std::optional<FormatError> error_;
};

// ---- Writing ----

// The member, made an object if it is none.
Json& object_in(Json& parent, const std::string& key) {
  Json& member = parent[key];
  if (!member.is_object()) member = Json::object();
  return member;
}

// Unknown keys as the level keeps them; an object in any case.
FormatResult<Json> parse_extra(const std::string& extra) {
  if (extra.empty()) return Json::object();
  auto json = parse_json(extra);
  if (!json || !json->is_object())
    return tl::unexpected(FormatError{"", "the level's unknown keys are no JSON object"});
  return json;
}

Json json_of(const Palette& palette) {
  Json colors = Json::array();
  for (const Rgb& c : palette) {
    const std::array<char, 3> bytes = {static_cast<char>(c.r), static_cast<char>(c.g),
                                       static_cast<char>(c.b)};
    colors.push_back(to_hex({bytes.data(), bytes.size()}));
  }
  return colors;
}

std::string pixel_rows(const TileImage& image) {
  std::string text;
  for (std::size_t p = 0; p < image.size(); ++p) {
    if (p > 0 && p % kTileSize == 0) text += ' ';
    text += image[p] == 0 ? '.' : kHexDigits[image[p] & 15];
  }
  return text;
}

void put_sheet(const Sheet& sheet, const std::string& key, Json& document) {
  for (int tile = 0; tile < kTileCount; ++tile) {
    const bool drawn = sheet.images[tile] != TileImage{};
    if (!drawn && sheet.flags[tile] == 0) continue;
    Json& json = object_in(object_in(document, key), std::to_string(tile));
    if (drawn) json["pixels"] = pixel_rows(sheet.images[tile]);
    for (int flag = 0; flag < kFlagCount; ++flag) {
      if ((sheet.flags[tile] >> flag & 1) != 0) json["flags"].push_back(flag);
    }
  }
}

std::string map_row(std::span<const std::uint8_t> cells) {
  while (!cells.empty() && cells.back() == 0) cells = cells.first(cells.size() - 1);
  std::string row;
  row.reserve(2 * cells.size());
  for (const std::uint8_t tile : cells) {
    row += tile == 0 ? '.' : kHexDigits[tile >> 4];
    row += tile == 0 ? '.' : kHexDigits[tile & 15];
  }
  return row;
}

void put_map(const TileMap& map, Json& json) {
  json["width"] = map.width();
  json["height"] = map.height();
  Json& rows = json["rows"] = Json::array();
  std::span<const std::uint8_t> cells = map.cells();
  while (!cells.empty() && cells.back() == 0) cells = cells.first(cells.size() - 1);
  const auto width = static_cast<std::size_t>(map.width());
  for (; !cells.empty(); cells = cells.subspan(std::min(width, cells.size()))) {
    rows.push_back(map_row(cells.first(std::min(width, cells.size()))));
  }
}

FormatResult<void> put_tuning(const Tuning& tuning, Json& json) {
  json["solver"] = solver_name(tuning.solver);
  for (const TuningField& field : tuning_fields()) {
    const double value = tuning.article.*field.value;
    if (!(value >= field.min && value <= field.max)) {
      return tl::unexpected(
          FormatError{"key tuning." + std::string(field.key), range_text(field.min, field.max, field.unit)});
    }
    json[std::string(field.key)] = json_number(value);
  }
  return {};
}

FormatResult<Json> json_of(const Spawn& spawn, std::size_t number) {
  auto json = parse_extra(spawn.extra);
  if (!json) return json;
  (*json)["name"] = spawn.name;
  for (const SpawnField& field : kSpawnFields) {
    const double value = spawn.*field.vector.*field.part;
    if (!(std::abs(value) <= kMaxSpawnNumber)) {
      return tl::unexpected(FormatError{"key spawns[" + std::to_string(number) + "]." + field.key,
                                        range_text(-kMaxSpawnNumber, kMaxSpawnNumber, "")});
    }
    (*json)[field.key] = json_number(value);
  }
  return json;
}

FormatResult<void> put_spawns(const std::vector<Spawn>& spawns, Json& document) {
  if (spawns.empty()) return {};
  Json list = Json::array();
  for (const Spawn& spawn : spawns) {
    auto json = json_of(spawn, list.size());
    if (!json) return tl::unexpected(json.error());
    list.push_back(*std::move(json));
  }
  document["spawns"] = std::move(list);
  return {};
}

FormatResult<Json> document_of(const Level& level) {
  auto parsed = parse_extra(level.extra);
  if (!parsed) return parsed;
  Json& document = *parsed;
  document["talus"] = kNativeVersion;
  document["palette"] = json_of(level.palette);
  const bool named =
      std::any_of(level.flag_names.begin(), level.flag_names.end(), [](const auto& n) { return !n.empty(); });
  if (named) document["flag_names"] = level.flag_names;
  Json& roles = object_in(document, "roles");
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = level.roles.*info.flag;
    roles[std::string(info.key)] = flag == FlagRoles::kUnused ? Json() : Json(flag);
  }
  if (const auto good = put_tuning(level.tuning, object_in(document, "tuning")); !good)
    return tl::unexpected(good.error());
  if (const auto good = put_spawns(level.spawns, document); !good) return tl::unexpected(good.error());
  for (std::size_t i = 0; i < kSheetKeys.size(); ++i) put_sheet(level.sheets[i], kSheetKeys[i], document);
  put_map(level.map, object_in(document, "map"));
  if (level.cart) put_cart(level, object_in(document, "cart"));
  return parsed;
}

std::vector<std::string_view> key_order() {
  std::vector<std::string_view> order = {"talus",  "palette",  "flag_names", "roles", "tuning",
                                         "spawns", "tiles",    "sprites",    "map",   "cart",
                                         "solid",  "up_slope", "down_slope", "ball",  "solver"};
  for (const TuningField& field : tuning_fields()) order.push_back(field.key);
  order.insert(order.end(),
               {"name", "x", "y", "vx", "vy", "flags", "pixels", "width", "height", "rows", "kind", "comment",
                "chunks", "lines", "chunk", "bank", "reserved", "code", "data"});
  return order;
}

}  // namespace

bool accepts_native(std::string_view bytes, const FormatContext& context) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || bytes[first] != '{') return false;
  return context.extension == "json" || bytes.find("\"talus\"") != std::string_view::npos;
}

FormatResult<Level> read_native(std::string_view bytes, const FormatContext&) {
  auto document = parse_json(bytes);
  if (!document) return tl::unexpected(document.error());
  return Reader().read(*std::move(document));
}

FormatResult<WrittenLevel> write_native(const Level& level, const FormatContext&) {
  const auto document = document_of(level);
  if (!document) return tl::unexpected(document.error());
  try {
    return WrittenLevel{print_json(*document, key_order()), {}};
  } catch (const Json::exception&) {
    return tl::unexpected(FormatError{"", "a name of a flag or spawn is not valid UTF-8"});
  }
}

}  // namespace talus
