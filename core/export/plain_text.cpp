#include "plain_text.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <talus/level/ground.h>
#include "../formats/text/append_number.h"
#include "../formats/text/json_text.h"
#include "ground_polygons.h"
#include "lua_text.h"
#include "plain_layers.h"

namespace talus {
namespace {

OrderedJson number(double value) { return json_number(value); }

OrderedJson numbers(const std::vector<double>& values) {
  OrderedJson list = OrderedJson::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

// As in the level's file.
OrderedJson tuning_of(const Tuning& tuning) {
  OrderedJson members = {{"solver", solver_name(tuning.solver)}};
  for (const TuningField& field : tuning_fields()) {
    const std::string group(field.group), key(field.key);
    OrderedJson& member = group.empty() ? members[key] : members[group][key];
    if (field.words.empty())
      member = number(field.of(tuning));
    else
      member = field.word_of(tuning);
  }
  return members;
}

OrderedJson shapes_of(const TerrainSource& ground) {
  OrderedJson shapes = OrderedJson::object();
  for (const PlainShape& shape : plain_shapes(ground)) {
    shapes[std::to_string(shape.tile)] = plain_shape_json(shape);
  }
  return shapes;
}

bool is_nested(const OrderedJson& list) {
  return std::any_of(list.begin(), list.end(),
                     [](const OrderedJson& entry) { return entry.is_structured(); });
}

// A text of members, one after the other. Large parts are written at once, without a JSON value for each
// number.
class PlainPrinter {
 public:
  explicit PlainPrinter(Dialect dialect) : is_lua_(dialect == Dialect::lua) {}

  void put(const char* key, const OrderedJson& value) {
    begin_member(key);
    print(value, 1);
  }

  void put_if_any(const char* key, const OrderedJson& value) {
    if (!value.empty()) put(key, value);
  }

  // A list with one entry on each line. entry(i) writes the entry number i.
  template <class Entry>
  void put_list(const char* key, std::size_t count, const Progress& progress, const Entry& entry) {
    begin_member(key);
    print_list(1, count, kMaxLuaEntries, progress, entry);
  }

  // All layers with their own tiles.
  void put_layers(const Level& level, const Progress& progress) {
    begin_member("layers");
    const std::vector<LayerInOrder> layers = layers_in_order(level);
    const std::size_t rows = 2 * static_cast<std::size_t>(level.map.height()) + 1;
    print_list(1, layers.size(), std::max<std::size_t>(1, kMaxLuaEntries / rows), progress,
               [&](std::size_t i) { print_layer(level, layers[i]); });
  }

  // Entries of such a list.
  void print(const OrderedJson& value, int depth) {
    if (value.is_number_float()) return append_number(text_, value.get<double>());
    if (value.is_string()) return print_string(value.get_ref<const std::string&>());
    if (value.is_null() && is_lua_) return void(text_ += "nil");
    if (value.is_primitive()) return void(text_ += value.dump());
    text_ += value.is_array() && !is_lua_ ? '[' : '{';
    const bool in_lines = depth == 1 && is_nested(value);
    bool first = true;
    for (auto entry = value.begin(); entry != value.end(); ++entry, first = false) {
      if (!first) text_ += ',';
      if (in_lines) print_line_break(depth + 1);
      if (value.is_object()) print_key(entry.key(), depth == 1);
      print(*entry, depth + 1);
    }
    if (in_lines && !value.empty()) print_line_break(depth);
    text_ += value.is_array() && !is_lua_ ? ']' : '}';
  }
  void print(std::span<const TileNumber> row) {
    open_list();
    for (const TileNumber& tile : row) {
      if (&tile != row.data()) text_ += ',';
      append_number(text_, tile);
    }
    close_list();
  }
  void print(const GroundPolygon& polygon) {
    text_ += '{';
    print_key("hole");
    text_ += polygon.is_hole ? "true," : "false,";
    print_points(polygon.points);
    text_ += '}';
  }
  void print(const PlainLine& line) {
    text_ += '{';
    print_key("kind");
    print_string(line.is_curve ? "curve" : "one_way");
    text_ += ',';
    print_key("name");
    print_string(line.name);
    text_ += ',';
    print_key("both_sides");
    text_ += line.both_sides ? "true," : "false,";
    if (line.conveyor != 0) {
      print_key("conveyor");
      print_number(line.conveyor);
      text_ += ',';
    }
    print_points(line.points);
    text_ += '}';
  }

  std::string take() {
    text_ += text_.empty() ? "{}\n" : "\n}\n";
    if (is_lua_) text_.insert(0, std::string(joins_ ? kLuaJoin : "") + "return ");
    return std::move(text_);
  }

 private:
  void begin_member(const std::string& key) {
    text_ += text_.empty() ? '{' : ',';
    print_line_break(1);
    print_key(key);
  }
  // depth: of the list's key. most: entries of a table.
  template <class Entry>
  void print_list(int depth, std::size_t count, std::size_t most, const Progress& progress,
                  const Entry& entry) {
    const bool in_parts = is_lua_ && count > most;
    joins_ = joins_ || in_parts;
    if (in_parts)
      text_ += "join{";
    else
      open_list();
    for (std::size_t i = 0; i < count; ++i) {
      if (!progress.at(i, count)) return;
      const bool begins_part = in_parts && i % most == 0;
      if (begins_part) text_ += i == 0 ? "function() return {" : "} end,function() return {";
      if (i > 0 && !begins_part) text_ += ',';
      print_line_break(depth + 1);
      entry(i);
    }
    if (count > 0) print_line_break(depth);
    if (in_parts)
      text_ += "} end}";
    else
      close_list();
  }

  void print_layer(const Level& level, LayerInOrder layer) {
    print(plain_layer_json(level, layer), 2);
    if (!layer.has_tiles) return;
    text_.pop_back();  // the brace: the cells follow
    const MapCells& cells = level.cells_of(layer.index);
    print_rows("map", cells.tiles(), level.map.width());
    std::vector<TileNumber> turns;
    if (cells.has_turned())
      for (const TileTurn turn : cells.turns()) turns.push_back(static_cast<TileNumber>(turn));
    if (!turns.empty()) print_rows("turns", turns, level.map.width());
    text_ += '}';
  }
  // A member of an entry of a list.
  void print_rows(const char* key, std::span<const TileNumber> cells, int columns) {
    const auto width = static_cast<std::size_t>(columns);
    text_ += ',';
    print_key(key);
    print_list(2, cells.size() / width, kMaxLuaEntries, {},
               [&](std::size_t row) { print(cells.subspan(row * width, width)); });
  }

  void open_list() { text_ += is_lua_ ? '{' : '['; }
  void close_list() { text_ += is_lua_ ? '}' : ']'; }

  void print_string(const std::string& text) {
    text_ += is_lua_ ? lua_string(text)
                     : OrderedJson(text).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  }
  // may_be_number: whether digits are the number of a tile or a flag; else users may call properties so.
  void print_key(const std::string& key, bool may_be_number = false) {
    const bool is_number = may_be_number && key.find_first_not_of("0123456789") == key.npos;
    if (!is_lua_) {
      print_string(key);
      text_ += ':';
    } else if (is_lua_name(key)) {
      text_.append(key).append("=");
    } else {
      text_.append("[").append(is_number ? key : lua_string(key)).append("]=");
    }
  }

  void print_points(const std::vector<Vec2>& points) {
    print_key("points");
    open_list();
    for (const Vec2& point : points) {
      if (&point != points.data()) text_ += ',';
      print_number(point.x);
      text_ += ',';
      print_number(point.y);
    }
    close_list();
  }
  // As json_number has it: whole numbers have no exponent.
  void print_number(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    if (static_cast<double>(whole) == value && !(value == 0 && std::signbit(value)))
      append_number(text_, whole);
    else
      append_number(text_, value);
  }

  void print_line_break(int depth) { text_.append("\n").append(static_cast<std::size_t>(depth), ' '); }

  bool is_lua_;
  bool joins_ = false;  // whether a list is written in parts
  std::string text_;
};

}  // namespace

OrderedJson plain_shape_json(const PlainShape& shape) {
  OrderedJson json = {{"kind", kind_word(shape.kind)},
                      {"one_way", shape.one_way},
                      {"tiles", shape.tiles},
                      {shape.is_ceiling ? "ceiling" : "floor", numbers(shape.columns)}};
  if (shape.conveyor != 0) json["conveyor"] = number(shape.conveyor);
  for (const PlainShape::Outline& outline : shape.outlines) {
    OrderedJson points = OrderedJson::array();
    for (const Vec2 point : outline.points) points.push_back({point.x, point.y});
    OrderedJson part = {{"one_way", outline.one_way}};
    if (outline.one_way) part["side"] = outline.is_ceiling ? "ceiling" : "floor";
    part["points"] = std::move(points);
    json["parts"].push_back(std::move(part));
  }
  return json;
}

OrderedJson plain_body_json(const PlainBody& body) {
  const Spawn& start = body.start;
  OrderedJson members = {{"id", body.id},
                         {"name", start.name},
                         {"kind", traits_of(start.kind).word},
                         {"x", number(start.position.x)},
                         {"y", number(start.position.y)},
                         {"w", number(start.size.x)},
                         {"h", number(start.size.y)},
                         {"vx", number(start.velocity.x)},
                         {"vy", number(start.velocity.y)},
                         {"foot", foot_word(start.used_foot())}};
  if (body.tile >= 0) members["tile"] = body.tile;
  if (!start.picture.empty()) members["picture"] = plain_body_picture(start.picture);
  return members;
}

FormatResult<std::string> plain_text(const Level& level, const Level& whole, Dialect dialect,
                                     const Progress& progress) {
  TerrainSource ground = ground_of(level);
  const std::span<const TileNumber> cells = ground.cells;
  const auto width = static_cast<std::size_t>(ground.width);
  PlainPrinter printer(dialect);
  printer.put("width", ground.width);
  printer.put("height", ground.height);
  if (ground.tile.width == ground.tile.height) printer.put("tile_size", ground.tile.width);
  printer.put("tile_width", ground.tile.width);
  printer.put("tile_height", ground.tile.height);
  if (const auto [r, g, b, a] = background_of(level); a > 0) printer.put("background", {r, g, b, a});
  printer.put_list("map", static_cast<std::size_t>(ground.height), progress.part(0, 0.1),
                   [&](std::size_t y) { printer.print(cells.subspan(y * width, width)); });
  printer.put("flags", {{"tiles", level.sheet(SheetId::tiles).flags},
                        {"sprites", level.sheet(SheetId::sprites).flags}});
  printer.put_if_any("flag_names", plain_flag_names(level));
  printer.put("roles", plain_roles(level.roles));
  printer.put("shapes", shapes_of(ground));
  printer.put_if_any("tile_notes", plain_notes(level));
  printer.put_if_any("animations", plain_animations(whole));
  printer.put_if_any("tilesets", plain_tilesets(whole));
  if (has_plain_layers(whole)) printer.put_layers(whole, progress.part(0.1, 0.15));
  const std::vector<ObjectPlace> objects = objects_in_order(whole);
  printer.put_list("objects", objects.size(), {},
                   [&](std::size_t i) { printer.print(plain_object_json(whole, objects[i]), 2); });
  ground.progress = progress.part(0.15, 0.6).function();
  const FormatResult<std::vector<GroundPolygon>> polygons = ground_polygons(ground);
  if (!polygons) return tl::unexpected(polygons.error());
  printer.put_list("polygons", polygons->size(), progress.part(0.6, 0.8),
                   [&](std::size_t i) { printer.print((*polygons)[i]); });
  const std::vector<PlainLine> lines = plain_lines(level, progress.part(0.8, 0.95));
  printer.put_list("lines", lines.size(), progress.part(0.95, 1),
                   [&](std::size_t i) { printer.print(lines[i]); });
  const PlainBodies bodies(level);
  printer.put_list("bodies", bodies.size(), {},
                   [&](std::size_t i) { printer.print(plain_body_json(bodies.at(i)), 2); });
  printer.put("tuning", tuning_of(level.tuning));
  return printer.take();
}

}  // namespace talus
