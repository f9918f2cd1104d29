#include "lua_level.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>

#include "../formats/number_text.h"
#include "../level/ground.h"
#include "lua_text.h"
#include "plain_data.h"

namespace talus {
namespace {

// Writes the members of a table: "key=value," each.
class LuaTable {
 public:
  explicit LuaTable(std::string& text) : text_(text) { text_ += '{'; }
  LuaTable(const LuaTable&) = delete;
  LuaTable& operator=(const LuaTable&) = delete;
  ~LuaTable() { text_ += '}'; }

  std::string& member(std::string_view key) {
    text_ += separator_;
    separator_ = ",";
    if (!key.empty()) text_.append(key) += '=';
    return text_;
  }
  void number(std::string_view key, double value) { append_number(member(key), value); }
  void word(std::string_view key, std::string_view value) { member(key).append("\"").append(value) += '"'; }
  void truth(std::string_view key) { member(key) += "true"; }
  template <class Range>
  void numbers(std::string_view key, const Range& values) {
    LuaTable list(member(key));
    for (const auto value : values) list.number("", value);
  }

 private:
  std::string& text_;
  const char* separator_ = "";
};

void write_shape(std::string& text, const TileShape& shape) {
  LuaTable table(text);
  table.word("kind", kind_word(shape.kind));
  if (shape.side == TileShape::Side::ceiling) table.word("side", "ceiling");
  if (shape.one_way) table.truth("one_way");
  if (shape.kind == TileShape::Kind::solid) return;
  if (shape.tiles != 1) table.number("tiles", shape.tiles);
  table.numbers("heights", shape.heights);
}

struct CurveWriter {
  LuaTable& table;
  void operator()(const Segment& s) const {
    table.word("kind", "segment");
    ends(s.from, s.to);
  }
  void operator()(const Arc& a) const {
    table.word("kind", "arc");
    table.number("x", a.center.x);
    table.number("y", a.center.y);
    table.number("radius", a.radius);
    sides(a.x0, a.x1);
    if (a.upper) table.truth("upper");
  }
  void operator()(const Parabola& p) const {
    table.word("kind", "parabola");
    ends(p.from, p.to);
    table.number("control_y", p.control_y);
  }
  void operator()(const Cubic& c) const {
    table.word("kind", "cubic");
    ends(c.from, c.to);
    table.number("slope0", c.from_slope);
    table.number("slope1", c.to_slope);
  }
  void operator()(const Sine& s) const {
    table.word("kind", "sine");
    sides(s.x0, s.x1);
    table.number("middle", s.middle);
    table.number("amplitude", s.amplitude);
    table.number("wavelength", s.wavelength);
    table.number("origin", s.origin);
  }
  void operator()(const Polyline& p) const {
    table.word("kind", "polyline");
    sides(p.x0, p.x1);
    table.numbers("ys", p.ys);
  }
  void sides(double x0, double x1) const {
    table.number("x0", x0);
    table.number("x1", x1);
  }
  void ends(Vec2 from, Vec2 to) const {
    table.number("x0", from.x);
    table.number("y0", from.y);
    table.number("x1", to.x);
    table.number("y1", to.y);
  }
};

void write_curve(std::string& text, const Curve& curve) {
  LuaTable table(text);
  std::visit(CurveWriter{table}, curve.form);
  if (curve.faces != Curve::Faces::up)
    table.word("faces", curve.faces == Curve::Faces::down ? "down" : "both");
}

void write_spawn(std::string& text, const Spawn& spawn) {
  LuaTable table(text);
  table.word("kind", body_word(spawn.kind));
  if (!spawn.name.empty()) table.member("name") += lua_string(spawn.name);
  table.number("x", spawn.position.x);
  table.number("y", spawn.position.y);
  table.number("w", spawn.size.x);
  table.number("h", spawn.size.y);
  table.number("vx", spawn.velocity.x);
  table.number("vy", spawn.velocity.y);
  table.word("foot", foot_word(spawn.used_foot()));
}

// The player's gravity has the name of the balls'.
std::string lua_key(const TuningField& field) {
  return field.group == "player" && field.key == "gravity" ? "player_gravity" : std::string(field.key);
}

// A line of Lua without the spaces that separate nothing. Two hyphens would begin a comment.
std::string without_spaces(const std::string& line) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::string kept;
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') is_quoted = !is_quoted;
    if (c != ' ' || is_quoted) {
      kept += c;
      continue;
    }
    const std::size_t next = line.find_first_not_of(' ', i);
    if (kept.empty() || next == std::string::npos) continue;
    const bool joins_words = is_word(kept.back()) && is_word(line[next]);
    const bool joins_hyphens = kept.back() == '-' && line[next] == '-';
    if (joins_words || joins_hyphens) kept += ' ';
    i = next - 1;
  }
  return kept;
}

bool is_stretch(const Curve& curve) {
  return !std::holds_alternative<Segment>(curve.form) && !std::holds_alternative<Polyline>(curve.form);
}

}  // namespace

std::string lua_level(const Level& level, bool with_tiles) {
  const TerrainSource ground = ground_of(level);
  std::string text = "return ";
  {
    LuaTable table(text);
    table.number("width", ground.width);
    table.number("height", ground.height);
    if (with_tiles) table.numbers("tiles", ground.cells);
    {
      LuaTable shapes(table.member("shapes"));
      for (int tile = 0; tile < kTileCount; ++tile) {
        if (ground.shapes[tile].kind == TileShape::Kind::none) continue;
        write_shape(shapes.member("[" + std::to_string(tile) + "]"), ground.shapes[tile]);
      }
    }
    {
      LuaTable balls(table.member("balls"));
      for (int tile = 0; tile < kTileCount; ++tile) {
        if (is_ball_tile(level, static_cast<std::uint8_t>(tile)))
          balls.truth("[" + std::to_string(tile) + "]");
      }
    }
    {
      LuaTable curves(table.member("curves"));
      for (const Curve& curve : ground.curves) write_curve(curves.member(""), curve);
    }
    {
      LuaTable spawns(table.member("spawns"));
      for (const Spawn& spawn : level.spawns) write_spawn(spawns.member(""), spawn);
    }
    LuaTable tuning(table.member("tuning"));
    for (const TuningField& field : tuning_fields()) tuning.number(lua_key(field), field.of(level.tuning));
  }
  return text + '\n';
}

std::vector<std::string> lua_runtime_parts(const Level& level, bool with_mouse) {
  const TerrainSource ground = ground_of(level);
  const std::set<std::uint8_t> used(ground.cells.begin(), ground.cells.end());
  const bool sloped = std::any_of(used.begin(), used.end(),
                                  [&](std::uint8_t tile) { return is_line_shape(ground.shapes[tile]); });
  const bool free = !ground.curves.empty();
  const bool curved = std::any_of(ground.curves.begin(), ground.curves.end(), is_stretch);
  const bool slopes = sloped || free;
  const auto is_player = [](const Spawn& spawn) { return spawn.kind == BodyKind::player; };
  const bool players = std::any_of(level.spawns.begin(), level.spawns.end(), is_player);
  const auto balls = std::count_if(ground.cells.begin(), ground.cells.end(), [&](std::uint8_t tile) {
    return is_ball_tile(level, static_cast<std::uint8_t>(tile));
  });
  const auto bodies = static_cast<std::size_t>(balls) + level.spawns.size();
  const bool pairs = level.tuning.article.balls_block != 0 && bodies > 1;

  const std::pair<const char*, bool> all[] = {
      {"base", true},          {"slopes", slopes},          {"curves", free},  {"stretches", curved},
      {"terrain", true},       {"details", slopes},         {"edit", true},    {"cast", true},
      {"cast_slopes", slopes}, {"cast_stretches", curved},  {"queries", true}, {"queries_slopes", slopes},
      {"mover", true},         {"mover_stretches", curved}, {"balls", true},   {"pairs", pairs},
      {"players", players},    {"mouse", with_mouse},       {"world", true}};
  std::vector<std::string> parts;
  for (const auto& [name, is_needed] : all) {
    if (is_needed) parts.emplace_back(name);
  }
  return parts;
}

std::string join_lua_parts(const std::vector<std::string>& texts) {
  std::string joined;
  bool is_head = true;  // the first comment of all says what the module is
  for (const std::string& text : texts) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const bool is_comment = line.compare(0, 2, "--") == 0;
      is_head = is_head && is_comment;
      const std::string kept = is_head ? line : without_spaces(line.substr(0, line.find("--")));
      if (!kept.empty()) joined += kept + '\n';
    }
  }
  return joined;
}

}  // namespace talus
