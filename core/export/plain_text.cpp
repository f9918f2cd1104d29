#include "plain_text.h"

#include <algorithm>

#include "../formats/json_text.h"
#include "../formats/number_text.h"
#include "../level/ground.h"
#include "ground_polygons.h"
#include "lua_text.h"

namespace talus {
namespace {

OrderedJson number(double value) { return json_number(value); }

OrderedJson numbers(const std::vector<double>& values) {
  OrderedJson list = OrderedJson::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

OrderedJson coordinates(const std::vector<Vec2>& points) {
  OrderedJson list = OrderedJson::array();
  for (const Vec2 point : points) {
    list.push_back(number(point.x));
    list.push_back(number(point.y));
  }
  return list;
}

OrderedJson rows_of(const TileMap& map) {
  OrderedJson rows = OrderedJson::array();
  for (auto row = map.cells().begin(); row != map.cells().end(); row += map.width())
    rows.emplace_back(std::vector<int>(row, row + map.width()));
  return rows;
}

OrderedJson roles_of(const Level& level) {
  OrderedJson roles = OrderedJson::object();
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = level.roles.*info.flag;
    if (flag != FlagRoles::kUnused) roles[std::string(info.key)] = flag;
  }
  return roles;
}

OrderedJson shapes_of(const TerrainSource& ground) {
  OrderedJson shapes = OrderedJson::object();
  for (const PlainShape& shape : plain_shapes(ground)) {
    shapes[std::to_string(shape.tile)] = plain_shape_json(shape);
  }
  return shapes;
}

OrderedJson polygons_of(const TerrainSource& ground) {
  OrderedJson polygons = OrderedJson::array();
  for (const GroundPolygon& polygon : ground_polygons(ground))
    polygons.push_back({{"hole", polygon.is_hole}, {"points", coordinates(polygon.points)}});
  return polygons;
}

OrderedJson lines_of(const Level& level) {
  OrderedJson lines = OrderedJson::array();
  for (const PlainLine& line : plain_lines(level)) {
    lines.push_back({{"kind", line.is_curve ? "curve" : "one_way"},
                     {"name", line.name},
                     {"both_sides", line.both_sides},
                     {"points", coordinates(line.points)}});
  }
  return lines;
}

OrderedJson spawns_of(const Level& level) {
  OrderedJson spawns = OrderedJson::array();
  for (const Spawn& spawn : level.spawns) spawns.push_back(plain_spawn_json(spawn));
  return spawns;
}

// Lists of more tables are functions of so many each in Lua: LuaJIT takes no more than 65536 constants, of
// which each table of numbers is one, in a function.
constexpr std::size_t kMostEntries = 4096;

constexpr std::string_view kJoin =
    "local function join(parts)\n"
    " local all={}\n"
    " for _,part in ipairs(parts) do for _,entry in ipairs(part()) do all[#all+1]=entry end end\n"
    " return all\n"
    "end\n";

bool is_nested(const OrderedJson& list) {
  return std::any_of(list.begin(), list.end(),
                     [](const OrderedJson& entry) { return entry.is_structured(); });
}

bool is_long(const OrderedJson& list) {
  return list.is_array() && list.size() > kMostEntries && is_nested(list);
}

class PlainPrinter {
 public:
  explicit PlainPrinter(Dialect dialect) : is_lua_(dialect == Dialect::lua) {}

  void print(const OrderedJson& value, int depth) {
    if (value.is_number_float()) return append_number(text_, value.get<double>());
    if (value.is_string()) return print_string(value.get_ref<const std::string&>());
    if (value.is_primitive()) return void(text_ += value.dump());
    if (is_lua_ && is_long(value)) return print_long(value, depth);
    text_ += value.is_array() && !is_lua_ ? '[' : '{';
    const bool in_lines = depth == 0 || (depth == 1 && is_nested(value));
    bool first = true;
    for (auto entry = value.begin(); entry != value.end(); ++entry, first = false) {
      if (!first) text_ += ',';
      if (in_lines) print_line_break(depth + 1);
      if (value.is_object()) print_key(entry.key());
      print(*entry, depth + 1);
    }
    if (in_lines && !value.empty()) print_line_break(depth);
    text_ += value.is_array() && !is_lua_ ? ']' : '}';
  }

  std::string take() { return std::move(text_); }

 private:
  void print_string(const std::string& text) {
    text_ += is_lua_ ? lua_string(text)
                     : OrderedJson(text).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  }
  // Keys are names, but for the numbers of tiles.
  void print_key(const std::string& key) {
    const bool is_number = key.front() >= '0' && key.front() <= '9';
    if (!is_lua_)
      text_.append("\"").append(key).append("\":");
    else
      text_.append(is_number ? "[" : "").append(key).append(is_number ? "]=" : "=");
  }

  void print_line_break(int depth) { text_.append("\n").append(static_cast<std::size_t>(depth), ' '); }

  void print_long(const OrderedJson& list, int depth) {
    text_ += "join{";
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i % kMostEntries == 0) text_ += i == 0 ? "function() return {" : "} end,function() return {";
      if (i % kMostEntries != 0) text_ += ',';
      print_line_break(depth + 1);
      print(list[i], depth + 1);
    }
    print_line_break(depth);
    text_ += "} end}";
  }

  bool is_lua_;
  std::string text_;
};

}  // namespace

OrderedJson plain_shape_json(const PlainShape& shape) {
  return {{"kind", kind_word(shape.kind)},
          {"one_way", shape.one_way},
          {"tiles", shape.tiles},
          {shape.is_ceiling ? "ceiling" : "floor", numbers(shape.columns)}};
}

OrderedJson plain_spawn_json(const Spawn& spawn) {
  return {{"name", spawn.name},
          {"kind", body_word(spawn.kind)},
          {"x", number(spawn.position.x)},
          {"y", number(spawn.position.y)},
          {"w", number(spawn.size.x)},
          {"h", number(spawn.size.y)},
          {"vx", number(spawn.velocity.x)},
          {"vy", number(spawn.velocity.y)},
          {"foot", foot_word(spawn.used_foot())}};
}

OrderedJson plain_json(const Level& level) {
  const TerrainSource ground = ground_of(level);
  return {{"width", ground.width},
          {"height", ground.height},
          {"tile_size", kTileSide},
          {"map", rows_of(level.map)},
          {"flags",
           {{"tiles", level.sheet(SheetId::tiles).flags}, {"sprites", level.sheet(SheetId::sprites).flags}}},
          {"roles", roles_of(level)},
          {"shapes", shapes_of(ground)},
          {"polygons", polygons_of(ground)},
          {"lines", lines_of(level)},
          {"spawns", spawns_of(level)}};
}

std::string print_plain(const OrderedJson& value, Dialect dialect) {
  PlainPrinter printer(dialect);
  printer.print(value, 0);
  if (dialect == Dialect::json) return printer.take() + "\n";
  const bool joins = std::any_of(value.begin(), value.end(), is_long);
  return std::string(joins ? kJoin : "") + "return " + printer.take() + "\n";
}

}  // namespace talus
