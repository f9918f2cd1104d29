// Levels as JSON. Reading takes every known key out of the document. The unknown ones that remain are kept in
// their places, and written again with the level.
#include "native.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <talus/level/limits.h>
#include <talus/level/placed_picture.h>
#include "../import/hex_color.h"
#include "../text/hex.h"
#include "../text/json_text.h"
#include "../text/utf8_text.h"
#include "../tilesets/tileset_pixels.h"
#include "hard_case_file.h"
#include "native_animations.h"
#include "native_brushes.h"
#include "native_cart.h"
#include "native_color.h"
#include "native_document.h"
#include "native_exports.h"
#include "native_flags.h"
#include "native_groups.h"
#include "native_layers.h"
#include "native_members.h"
#include "native_notes.h"
#include "native_object_layers.h"
#include "native_objects.h"
#include "native_picture.h"
#include "native_pictures.h"
#include "native_tilesets.h"
#include "native_turns.h"

namespace talus {
namespace {

constexpr std::array<const char*, 2> kSheetKeys = {"tiles", "sprites"};  // by SheetId

std::string values_text(const TuningField& field) {
  if (!field.words.empty()) return choice_text(field.words);
  return range_text(field.min, field.max, field.unit, field.whole);
}

std::string no_tile_of(int count) { return "must be a tile number from 0 to " + std::to_string(count - 1); }

// Goes on after an error, which does no harm, and remembers the first one.
class Reader {
 public:
  explicit Reader(Progress progress) : progress_(std::move(progress)) {}

  FormatResult<Level> read(Json document) {
    read_version(document);
    if (error_) return tl::unexpected(*error_);  // nothing else in a file of a newer version can be trusted
    take(document, "tile_size", [this](Json& v) { read_tile_size(v); });
    take(document, "sheet_size", [this](Json& v) { read_sheet_size(v); });
    if (error_) return tl::unexpected(*error_);  // the numbers of tiles cannot be judged
    take(document, "palette", [this](Json& v) { read_palette(v); });
    take(document, "background", [this](const Json& v) { read_background(v); });
    take(document, "flag_names",
         [this](const Json& v) { keep(take_flag_names(v, "flag_names"), level_.flag_names); });
    take(document, "flag_fields",
         [this](Json& v) { keep(take_flag_fields(v, "flag_fields"), level_.flag_fields); });
    take_object(document, "roles", "roles", [this](Json& v) { read_roles(v); });
    take_object(document, "tuning", "tuning", [this](Json& v) { read_tuning(v); });
    take(document, "spawns", [this](Json& v) { keep(take_spawns(v, "spawns"), level_.spawns); });
    take(document, "brushes",
         [this](Json& v) { keep(take_brushes(v, level_.tile_count()), level_.brushes); });
    take_object(document, "auto_tiles", "auto_tiles",
                [this](Json& v) { keep(take_auto_tiles(v, level_.tile_count()), level_.auto_tiles); });
    take(document, "exports", [this](Json& v) { keep(take_exports(v), level_.exports); });
    take_object(document, "flag_shapes", "flag_shapes", [this](Json& v) {
      read_shapes(v, "flag_shapes", "must be a flag from 0 to 31", level_.flag_shapes);
    });
    take_object(document, "tile_shapes", "tile_shapes", [this](Json& v) {
      read_shapes(v, "tile_shapes", no_tile_of(level_.tile_count()), level_.tile_shapes);
    });
    for (std::size_t i = 0; i < kSheetKeys.size(); ++i) {
      take_object(document, kSheetKeys[i], kSheetKeys[i],
                  [&](Json& v) { read_sheet(v, kSheetKeys[i], level_.sheets[i]); });
    }
    shape_conveyors();
    take(document, "picture", [this](const Json& v) { read_picture(v); });
    take(document, "tilesets",
         [this](Json& v) { keep(take_tilesets(v, level_.sheet(SheetId::tiles).layout()), level_.tilesets); });
    take(document, "animations",
         [this](const Json& v) { keep(take_animations(v, level_.tile_count()), level_.animations); });
    take(document, "tile_notes",
         [this](Json& v) { keep(take_notes(v, level_.tile_count()), level_.tile_notes); });
    take_object(document, "map", "map", [this](Json& v) { read_map(v); });
    take(document, "layers", [this](Json& v) { read_layers(v); });
    take(document, "curves", [this](Json& v) { keep(take_curves(v, "curves", level_.map), level_.curves); });
    NativePictures pictures;
    take(document, "pictures", [&](Json& v) { keep(take_pictures(v), pictures); });
    take(document, "large_tiles",
         [&](Json& v) { keep(take_large_tiles(v, pictures, level_.tile_count()), level_.large_tiles); });
    take(document, "render_order", [this](const Json& v) { read_render_order(v); });
    take(document, "objects",
         [&](Json& v) { keep(take_object_layers(v, "objects", pictures), level_.objects); });
    take(document, "groups", [&](Json& v) { keep(take_groups(v), level_.layers.groups); });
    if (const auto good = check_groups(level_); !good) fail(good.error().place, good.error().message);
    take_object(document, "cart", "cart", [this](Json& v) { read_cart(v); });
    if (error_) return tl::unexpected(*error_);
    if (document.size() > kMaxUnknownKeys) return tl::unexpected(FormatError{"", too_many_unknown()});
    if (!document.empty()) level_.extra = document.dump();
    if (auto problem = problem_of_amounts(level_))
      return tl::unexpected(FormatError{"", *std::move(problem)});
    return std::move(level_);
  }

 private:
  void fail(std::string place, std::string message) {
    if (!error_) error_ = FormatError{std::move(place), std::move(message)};
  }
  void fail_key(const std::string& key, std::string message) { fail("key " + key, std::move(message)); }

  template <class Value>
  void keep(FormatResult<Value> read, Value& out) {
    if (!read) return fail(read.error().place, read.error().message);
    out = *std::move(read);
  }

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
      if (value.size() > kMaxUnknownKeys) return fail_key(path, too_many_unknown());
      if (!value.empty()) object[key] = std::move(value);
    });
  }

  void read_version(Json& document) {
    if (!document.is_object()) return fail("", "is JSON, but not a Talus level");
    if (!document.contains("talus")) return fail_key("talus", "is missing, so this is not a Talus level");
    take(document, "talus", [this](const Json& value) {
      constexpr std::int64_t kNewest = std::numeric_limits<std::int64_t>::max();
      if (!is_whole(value, 1, kNewest))
        return fail_key("talus", "must be the version, a whole number from 1");
      if (value > kNativeVersion) {
        fail_key("talus", "has version " + value.dump() + ", but this Talus reads only up to version " +
                              std::to_string(kNativeVersion));
      }
    });
  }

  // Shapes, map and curves depend on it.
  void read_tile_size(const Json& size) {
    const auto is_side = [](const Json& side) { return is_whole(side, 1, kMaxTileSide); };
    const bool good = size.is_array() && size.size() == 2 && std::all_of(size.begin(), size.end(), is_side);
    if (!good) return fail_key("tile_size", "must be [width, height], whole numbers from 1 to 256 px");
    tile_size_ = {size[0].get<int>(), size[1].get<int>()};
    level_.map = TileMap(kTicMapWidth, kTicMapHeight, tile_size_);
  }

  // Of the sheet of tiles. Flags, shapes, cells and brushes depend on it.
  void read_sheet_size(const Json& size) {
    const bool good = size.is_array() && size.size() == 2 && is_whole(size[0], 1, kMaxSheetSide) &&
                      is_whole(size[1], 1, kMaxTiles) && size[1] <= size[0].get<int>() * kMaxSheetSide;
    if (!good)
      return fail_key("sheet_size",
                      "must be [columns, tiles]: 1 to 2048 columns, 1 to 65536 tiles, and at "
                      "most 2048 rows");
    level_.set_tile_layout({size[0].get<int>(), size[1].get<int>()});
  }

  void read_background(const Json& json) {
    const std::string text = json.is_string() ? json.get<std::string>() : "";
    const bool is_long = text.size() == 7 || text.size() == 9;
    if (is_long && text[0] == '#') level_.background = rgba_of_hex(text);
    if (!level_.background)
      fail_key("background",
               "must be a colour such as \"#1a1c2c\" or, with its opacity first, \"#801a1c2c\"");
  }
  void read_palette(const Json& colors) {
    if (!colors.is_array() || colors.size() != kColorCount)
      return fail_key("palette", "must be a list of 16 colours");
    for (int i = 0; i < kColorCount; ++i) {
      const auto color = color_of(colors[i]);
      if (!color) return fail_key("palette[" + std::to_string(i) + "]", kColorText);
      level_.palette[i] = *color;
    }
  }

  void read_roles(Json& roles) {
    for (const FlagRoleInfo& info : flag_role_infos()) {
      const std::string key(info.key);
      take(roles, key, [&](const Json& flag) {
        if (!flag.is_null() && !is_whole(flag, 0, kMaxFlags - 1)) {
          return fail_key("roles." + key, "must be a flag from 0 to 31, or null");
        }
        level_.roles.*info.flag = flag.is_null() ? FlagRoles::kUnused : flag.get<int>();
      });
    }
  }

  void read_tuning(Json& tuning) {
    take(tuning, "solver", [this](const Json& json) {
      const auto solver = solver_of_name(json.is_string() ? json.get<std::string>() : "");
      if (!solver) return fail_key("tuning.solver", R"(must be "article", "bump" or "exact")");
      level_.tuning.solver = *solver;
    });
    // Until 0.1.0: whether bodies block one another, as a number.
    take(tuning, "balls_block", [this](const Json& json) {
      const double value = json.is_number() ? json.get<double>() : -1;
      if (!(value >= 0 && value <= 1)) return fail_key("tuning.balls_block", range_text(0, 1, ""));
      level_.tuning.shared.bodies = value != 0 ? 1 : 0;
    });
    read_numbers(tuning, "");
    for (const std::string_view group : kTuningGroups) {
      take_object(tuning, std::string(group), "tuning." + std::string(group),
                  [&](Json& numbers) { read_numbers(numbers, group); });
    }
  }

  void read_numbers(Json& numbers, std::string_view group) {
    for (const TuningField& field : tuning_fields()) {
      if (field.group != group) continue;
      take(numbers, std::string(field.key), [&](const Json& json) {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        double value = json.is_number() && field.words.empty() ? json.get<double>() : kNone;
        if (json.is_string()) value = field.of_word(json.get_ref<const std::string&>()).value_or(kNone);
        if (!field.accepts(value)) return fail_key("tuning." + field.path(), values_text(field));
        field.in(level_.tuning) = value;
      });
    }
  }

  // Shapes by number. Other keys belong to a newer version and stay.
  void read_shapes(Json& shapes, const std::string& path, const std::string& no_number,
                   std::span<TileShape> out) {
    for (const std::size_t i : numbers_in(shapes, out.size())) {
      const std::string key = std::to_string(i), entry = path + "." + key;
      take_object(shapes, key, entry, [&](Json& json) { keep(take_shape(json, entry, tile_size_), out[i]); });
    }
    check_numbers(shapes, path, no_number, out.size());
  }

  // A tile's shape without a kind is that of its flags, which may be a conveyor on this tile alone.
  void shape_conveyors() {
    for (std::size_t tile = 0; tile < level_.tile_shapes.size(); ++tile) {
      TileShape& own = level_.tile_shapes[tile];
      if (own.conveyor == 0 || own.kind != TileShape::Kind::none) continue;
      TileShape shape = shape_of_flags(level_, level_.tile_flags(static_cast<TileNumber>(tile)));
      if (shape.kind == TileShape::Kind::none)
        return fail_key("tile_shapes." + std::to_string(tile),
                        "has a conveyor, but neither a \"kind\" nor flags that give it a shape");
      shape.conveyor = own.conveyor;
      own = std::move(shape);
    }
    for (std::size_t flag = 0; flag < level_.flag_shapes.size(); ++flag) {
      const TileShape& shape = level_.flag_shapes[flag];
      if (shape.conveyor != 0 && shape.kind == TileShape::Kind::none)
        fail_key("flag_shapes." + std::to_string(flag), "has a conveyor, but no \"kind\"");
    }
  }

  void read_sheet(Json& tiles, const std::string& path, Sheet& sheet) {
    const auto count = static_cast<std::size_t>(sheet.count());
    for (const std::size_t tile : numbers_in(tiles, count)) {
      const std::string key = std::to_string(tile), entry = path + "." + key;
      take_object(tiles, key, entry, [&](Json& json) {
        take(json, "flags",
             [&](const Json& flags) { keep(take_flags(flags, entry + ".flags"), sheet.flags[tile]); });
        take(json, "pixels",
             [&](const Json& rows) { read_pixels(rows, entry + ".pixels", sheet.images[tile]); });
      });
    }
    check_numbers(tiles, path, no_tile_of(sheet.count()), count);
  }

  // The keys that are such numbers, ascending.
  static std::vector<std::size_t> numbers_in(const Json& object, std::size_t count) {
    std::vector<std::size_t> numbers;
    for (auto it = object.begin(); it != object.end(); ++it) {
      if (const auto number = number_of_key(it.key(), count)) numbers.push_back(*number);
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }

  // The remaining keys may belong to a newer version, but must not be numbers out of range or in another
  // spelling.
  void check_numbers(const Json& object, const std::string& path, const std::string& message,
                     std::size_t count) {
    for (auto it = object.begin(); it != object.end(); ++it) {
      const std::string& key = it.key();
      const bool is_number = !key.empty() && key.find_first_not_of("0123456789") == std::string::npos;
      if (is_number && !number_of_key(key, count)) fail_key(path + "." + key.substr(0, 8), message);
    }
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

  void read_picture(const Json& lines) {
    Sheet& sheet = level_.sheet(SheetId::tiles);
    const SheetLayout layout = sheet.layout();
    keep(take_picture(lines, layout, layout.columns * tile_size_.width, layout.rows() * tile_size_.height),
         sheet.picture);
  }

  void read_map(Json& map) {
    int width = kTicMapWidth, height = kTicMapHeight;
    const auto take_side = [&](const std::string& key, int& side) {
      take(map, key, [&](const Json& value) {
        if (!is_whole(value, 1, kMaxTerrainSide))
          return fail_key("map." + key, "must be a whole number from 1 to 2097152");
        side = value.get<int>();
      });
    };
    take_side("width", width);
    take_side("height", height);
    if (error_) return;
    if (!is_terrain_size(width, height)) return fail_key("map", "has more than 16777216 cells");
    if (!is_terrain_size(width, height, tile_size_)) return fail_key("map", "is longer than 16777216 px");
    level_.map = TileMap(width, height, tile_size_);
    take(map, "rows", [this](const Json& rows) {
      keep(read_rows(rows, "map.rows", "map row ", level_, progress_), level_.map.cells().tiles());
    });
    take(map, "turns", [this](const Json& rows) {
      const auto good = take_turn_rows(rows, "map", level_.map.width(), level_.map.cells());
      if (!good) fail(good.error().place, good.error().message);
    });
  }

  void read_layers(Json& layers) {
    const auto good = take_layers(layers, level_, progress_);
    if (!good) fail(good.error().place, good.error().message);
  }

  void read_render_order(const Json& word) {
    const auto found = std::find(kRenderOrders.begin(), kRenderOrders.end(), word);
    if (found == kRenderOrders.end()) return fail_key("render_order", choice_text(kRenderOrders));
    level_.layers.order = static_cast<RenderOrder>(found - kRenderOrders.begin());
  }

  void read_cart(Json& json) {
    if (!json.contains("kind")) return;  // unknown keys that outlived their cart
    auto cart = take_cart(json, level_);
    if (!cart) return fail(cart.error().place, cart.error().message);
    level_.cart = *std::move(cart);
  }

  Level level_;
  TileSize tile_size_;
  std::optional<FormatError> error_;
  Progress progress_;
};

// ---- Writing ----

// Returns the member; makes it an object if it is not one.
Json& object_in(Json& parent, const std::string& key) {
  Json& member = parent[key];
  if (!member.is_object()) member = Json::object();
  return member;
}

Json json_of(const Palette& palette) {
  Json colors = Json::array();
  for (const Rgb& color : palette) colors.push_back(text_of(color));
  return colors;
}

std::string pixel_rows(const TileImage& image) {
  std::string text;
  for (std::size_t p = 0; p < image.size(); ++p) {
    if (p > 0 && p % kCartTileSize == 0) text += ' ';
    text += image[p] == 0 ? '.' : kHexDigits[image[p] & 15];
  }
  return text;
}

void put_sheet(const Sheet& sheet, const std::string& key, Json& document) {
  for (std::size_t tile = 0; tile < sheet.images.size(); ++tile) {
    const bool drawn = sheet.images[tile] != TileImage{};
    if (!drawn && sheet.flags[tile] == 0) continue;
    Json& json = object_in(object_in(document, key), std::to_string(tile));
    if (drawn) json["pixels"] = pixel_rows(sheet.images[tile]);
    if (sheet.flags[tile] != 0) json["flags"] = json_of_flags(sheet.flags[tile]);
  }
}

// rows: whether the cells stand here, or with the layers.
void put_map(const Level& level, bool rows, Json& json) {
  json["width"] = level.map.width();
  json["height"] = level.map.height();
  if (!rows) return;
  json["rows"] = json_of_rows(level.map.cells().tiles(), level);
  put_turns(level.map.cells(), level.map.width(), false, json);
}

FormatResult<void> put_numbers(const Tuning& tuning, std::string_view group, Json& json) {
  for (const TuningField& field : tuning_fields()) {
    if (field.group != group) continue;
    const double value = field.of(tuning);
    if (!field.accepts(value)) {
      return tl::unexpected(FormatError{"key tuning." + field.path(), values_text(field)});
    }
    auto& member = json[std::string(field.key)];
    if (field.words.empty())
      member = json_number(value);
    else
      member = field.word_of(tuning);
  }
  return {};
}

bool is_standard(const Tuning& tuning, std::string_view group) {
  const auto fields = tuning_fields();
  return std::all_of(fields.begin(), fields.end(), [&](const TuningField& field) {
    return field.group != group || field.of(tuning) == field.standard();
  });
}

FormatResult<void> put_tuning(const Tuning& tuning, Json& json) {
  json["solver"] = solver_name(tuning.solver);
  if (const auto good = put_numbers(tuning, "", json); !good) return good;
  for (const std::string_view group : kTuningGroups) {
    if (is_standard(tuning, group)) continue;
    if (const auto good = put_numbers(tuning, group, object_in(json, std::string(group))); !good) return good;
  }
  return {};
}

FormatResult<void> put_shapes(std::span<const TileShape> shapes, const std::string& key, TileSize tile,
                              Json& document) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i] == TileShape()) continue;
    const std::string number = std::to_string(i);
    Json& json = object_in(object_in(document, key), number);
    if (const auto good = put_shape(shapes[i], key + "." + number, tile, json); !good) return good;
  }
  return {};
}

// Sets a member to a list or an object; does nothing if that is empty.
FormatResult<void> put_list(FormatResult<Json> list, const std::string& key, Json& document) {
  if (!list) return tl::unexpected(list.error());
  if (!list->empty()) document[key] = *std::move(list);
  return {};
}

void put_roles(const FlagRoles& roles, Json& json) {
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = roles.*info.flag;
    const std::string key(info.key);
    if (flag != FlagRoles::kUnused)
      json[key] = flag;
    else if (FlagRoles().*info.flag != FlagRoles::kUnused)
      json[key] = nullptr;
  }
}

// Checks a level for errors, in the order of the file.
FormatResult<void> put_physics(const Level& level, Json& document) {
  const TileSize tile = level.map.tile_size();
  put_roles(level.roles, object_in(document, "roles"));
  if (auto good = put_shapes(level.flag_shapes, "flag_shapes", tile, document); !good) return good;
  if (auto good = put_tuning(level.tuning, object_in(document, "tuning")); !good) return good;
  if (auto good = put_list(json_of(level.spawns, "spawns"), "spawns", document); !good) return good;
  if (auto good = put_list(json_of(level.curves, "curves", level.map), "curves", document); !good)
    return good;
  return put_shapes(level.tile_shapes, "tile_shapes", tile, document);
}

// What is drawn besides the sheet, and the layers that are not of tiles.
FormatResult<void> put_pictures(const Level& level, const NativePictures& pictures, Json& document) {
  if (level.layers.order != RenderOrder()) document["render_order"] = word_of(level.layers.order);
  if (auto good = put_list(json_of(pictures), "pictures", document); !good) return good;
  if (auto good = put_list(json_of(level.large_tiles, pictures), "large_tiles", document); !good) return good;
  return put_list(json_of(level.objects, "objects", pictures), "objects", document);
}

// Whether a tile or a flag stands for a polygon or a group, which came with version 3.
bool has_shapes_with_parts(const Level& level) {
  return std::any_of(level.tile_shapes.begin(), level.tile_shapes.end(), has_parts) ||
         std::any_of(level.flag_shapes.begin(), level.flag_shapes.end(), has_parts);
}

// For all objects at once: no two of them want a pair of keys in different orders.
std::vector<std::string_view> key_order() {
  std::vector<std::string_view> order = {
      "talus",       "companion",   "file",    "with",     "palette",    "background", "flag_names",
      "flag_fields", "name",        "first",   "bits",     "values",     "kind",       "side",
      "faces",       "roles",       "solid",   "up_slope", "down_slope", "ball",       "one_way",
      "ceiling",     "flag_shapes", "tuning",  "spawns",   "curves",     "brushes",    "auto_tiles",
      "exports",     "tile_shapes", "tiles",   "random",   "heights",    "points",     "sprites",
      "tile_size",   "sheet_size",  "picture", "tilesets", "animations", "tile_notes", "map",
      "layers",      "groups",      "objects", "cart",     "solver"};
  for (const TuningField& field : tuning_fields()) order.push_back(field.key);
  order.insert(
      order.end(),
      {"x",          "y",          "vx",           "vy",         "size",      "foot",        "from",
       "to",         "from_slope", "to_slope",     "center",     "radius",    "x0",          "x1",
       "upper",      "middle",     "amplitude",    "wavelength", "origin",    "ys",          "flags",
       "pixels",     "width",      "height",       "rows",       "turns",     "comment",     "chunks",
       "lines",      "chunk",      "bank",         "reserved",   "code",      "data",        "path",
       "parts",      "on_save",    "conveyor",     "count",      "columns",   "image",       "ground",
       "visible",    "locked",     "spacing",      "margin",     "opacity",   "offset",      "parallax",
       "tint",       "packed",     "packed_turns", "form",       "class",     "probability", "rotation",
       "tile",       "properties", "place",        "by_y",       "rect",      "shift",       "keeps_ratio",
       "swaps_axes", "mirrors_x",  "mirrors_y",    "repeats_x",  "repeats_y", "anchor",      "group"});
  for (const GroundPartInfo& part : kGroundParts) order.push_back(part.key);
  const auto hard_case = hard_case_keys();
  order.insert(order.end(), hard_case.begin(), hard_case.end());
  return order;
}

}  // namespace

bool accepts_native(std::string_view bytes, const FormatContext& context) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || bytes[first] != '{') return false;
  return context.extension == "json" || bytes.find("\"talus\"") != std::string_view::npos;
}

namespace {

// The tilesets as a file of a folder stores them. Links that would lead out of the folder are listed, and
// left out: their pixels are stored. Without a folder those go whose pixels were read.
std::vector<Tileset> stored_tilesets(const Level& level, const std::string& folder,
                                     std::vector<std::string>& dropped) {
  std::vector<Tileset> sets = level.tilesets;
  for (Tileset& set : sets) {
    const bool is_unread = set.link && folder.empty() && !set.link->path.starts_with('/');
    if (!set.link || is_unread) continue;
    std::string path = folder.empty() ? "" : stored_link(folder, set.link->path);
    if (!path.empty()) {
      set.link->path = std::move(path);
      continue;
    }
    if (!folder.empty())
      dropped.push_back("the link of a tileset to " + set.link->path +
                        ", which is not in the folder of the level: its pixels are stored");
    set.link.reset();
  }
  return sets;
}

}  // namespace

FormatResult<Json> native_document(const Level& level) {
  std::vector<std::string> dropped;
  return native_document(level, "", dropped);
}

FormatResult<Json> native_document(const Level& level, const std::string& folder,
                                   std::vector<std::string>& dropped) {
  if (auto problem = problem_of_amounts(level)) return tl::unexpected(FormatError{"", *std::move(problem)});
  auto parsed = parse_extra(level.extra);
  if (!parsed) return parsed;
  Json& document = *parsed;
  const TileSize tile = level.map.tile_size();
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  const bool has_other_tiles = tile != TileSize(), has_other_sheet = sheet != SheetLayout();
  const std::vector<Tileset> sets = stored_tilesets(level, folder, dropped);
  const bool has_links =
      std::any_of(sets.begin(), sets.end(), [](const Tileset& set) { return set.link.has_value(); });
  const Sheet tiles =
      has_links && !folder.empty() ? without_linked_pixels(level, sets) : level.sheet(SheetId::tiles);
  const auto& picture = tiles.picture;
  auto layers = json_of_layers(level);
  if (!layers) return layers;
  auto groups = json_of_groups(level);
  if (!groups) return groups;
  const bool has_layers = !layers->empty(), has_tilesets = !sets.empty() || !level.objects.empty();
  const NativePictures pictures = pictures_of(level);
  const bool has_notes = has_more_flags(level) || has_turned_tiles(level) || !level.tile_notes.empty() ||
                         !pictures.empty() || has_new_objects(level.objects);
  document["talus"] = level.background   ? kNativeVersion
                      : !groups->empty() ? kGroupVersion
                      : has_notes        ? kNoteVersion
                      : has_tilesets     ? kTilesetVersion
                      : has_layers       ? kLayerVersion
                      : has_other_sheet || picture != nullptr || has_shapes_with_parts(level) ? kSheetVersion
                      : has_other_tiles ? kTileSizeVersion
                                        : 1;
  if (has_other_tiles) document["tile_size"] = {tile.width, tile.height};
  if (has_other_sheet) document["sheet_size"] = {sheet.columns, sheet.count};
  document["palette"] = json_of(level.palette);
  if (level.background) document["background"] = hex_of(*level.background);
  const bool named =
      std::any_of(level.flag_names.begin(), level.flag_names.end(), [](const auto& n) { return !n.empty(); });
  if (named) document["flag_names"] = json_of(level.flag_names);
  if (const auto good = put_list(json_of(level.flag_fields, "flag_fields"), "flag_fields", document); !good)
    return tl::unexpected(good.error());
  if (const auto good = put_physics(level, document); !good) return tl::unexpected(good.error());
  if (const auto good = put_list(json_of(level.brushes, level.tile_count()), "brushes", document); !good)
    return tl::unexpected(good.error());
  if (!level.auto_tiles.empty()) put_auto_tiles(level.auto_tiles, object_in(document, "auto_tiles"));
  if (const auto good = put_list(json_of(level.exports), "exports", document); !good)
    return tl::unexpected(good.error());
  put_sheet(tiles, kSheetKeys[0], document);
  put_sheet(level.sheet(SheetId::sprites), kSheetKeys[1], document);
  if (picture != nullptr) {
    auto lines = json_of(*picture);
    if (!lines) return lines;
    document["picture"] = *std::move(lines);
  }
  if (const auto good = put_list(json_of(sets, sheet), "tilesets", document); !good)
    return tl::unexpected(good.error());
  if (const auto good = put_list(json_of(level.animations, level.tile_count()), "animations", document);
      !good)
    return tl::unexpected(good.error());
  if (const auto good = put_list(json_of(level.tile_notes, level.tile_count()), "tile_notes", document);
      !good)
    return tl::unexpected(good.error());
  if (auto good = put_pictures(level, pictures, document); !good) return tl::unexpected(good.error());
  if (!layers->empty()) document["layers"] = *std::move(layers);
  if (!groups->empty()) document["groups"] = *std::move(groups);
  put_map(level, !has_layers, object_in(document, "map"));
  if (level.cart) put_cart(level, object_in(document, "cart"));
  if (depth_of(document) > kMaxJsonDepth)
    return tl::unexpected(FormatError{
        "", "has unknown keys that are nested deeper than " + std::to_string(kMaxJsonDepth) + " levels"});
  return parsed;
}

FormatResult<Level> level_of_document(Json document, const Progress& progress) {
  return Reader(progress).read(std::move(document));
}

namespace {

// The place of the first text or key that is not UTF-8, as "key tilesets[0].name"; empty if all are.
std::string place_of_wrong_text(const Json& json, const std::string& place) {
  if (json.is_string()) return is_utf8(json.get_ref<const std::string&>()) ? "" : place;
  std::string found;
  for (std::size_t i = 0; json.is_array() && found.empty() && i < json.size(); ++i)
    found = place_of_wrong_text(json[i], place + "[" + std::to_string(i) + "]");
  if (!json.is_object()) return found;
  for (auto at = json.begin(); found.empty() && at != json.end(); ++at) {
    const std::string inner = place + (place == "key " ? "" : ".") + printable(at.key());
    found = is_utf8(at.key()) ? place_of_wrong_text(*at, inner) : inner;
  }
  return found;
}

}  // namespace

FormatResult<std::string> print_document(const Json& document) {
  try {
    std::string text = print_json(document, key_order());
    if (auto problem = problem_of_size(text)) return tl::unexpected(FormatError{"", *std::move(problem)});
    return text;
  } catch (const Json::exception&) {
    return tl::unexpected(FormatError{place_of_wrong_text(document, "key "), "is not valid UTF-8"});
  }
}

FormatResult<Level> read_native(std::string_view bytes, const FormatContext& context) {
  constexpr double kParsed = 0.8;  // share of the time
  auto document = parse_json(bytes, context.progress.part(0, kParsed));
  if (!document) return tl::unexpected(document.error());
  if (document->is_object() && document->contains("companion"))
    return tl::unexpected(FormatError{
        "", "is not a level, but the companion of a cart: put it beside the cart, and open the cart"});
  auto level = level_of_document(*std::move(document), context.progress.part(kParsed, 1));
  if (!level) return level;
  tidy_groups(level->layers, level->objects);
  if (const auto read = read_linked_tilesets(context, *level); !read) return tl::unexpected(read.error());
  return level;
}

FormatResult<WrittenLevel> write_native(const Level& level, const FormatContext& context) {
  std::vector<std::string> dropped;
  const auto document = native_document(level, context.folder, dropped);
  if (!document) return tl::unexpected(document.error());
  auto text = print_document(*document);
  if (!text) return tl::unexpected(text.error());
  return WrittenLevel{*std::move(text), std::move(dropped)};
}

}  // namespace talus
