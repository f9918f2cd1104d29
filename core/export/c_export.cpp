// A C99 header: the level as tables, lengths in 24.8 fixed point.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string_view>

#include <talus/level/ground.h>
#include "../formats/text/append_number.h"
#include "export_targets.h"
#include "plain_data.h"

namespace talus {
namespace {

constexpr int kMaxPx = 1 << 23;  // in 24.8

// A part of a name, in small letters, with one _ in place of other characters than C allows in names.
std::string c_word(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte) != 0)
      name += static_cast<char>(std::tolower(byte));
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (name.ends_with('_')) name.pop_back();
  return name;
}

// The prefix of names, by the file's name.
std::string c_name(const std::string& stem) {
  const std::string name = c_word(stem);
  if (name.empty()) return "level";
  return name.front() >= 'a' && name.front() <= 'z' ? name : "level_" + name;
}

std::string upper(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

constexpr double kMaxFixed = std::numeric_limits<std::int32_t>::max();

// In 24.8 fixed point. A number that does not fit becomes the largest or smallest one. The smallest is that
// of int32_t plus 1, since C has no literal for the smallest.
std::int64_t fixed(double px) {
  const double rounded = std::round(px * 256);
  return std::isnan(rounded) ? 0 : static_cast<std::int64_t>(std::clamp(rounded, -kMaxFixed, kMaxFixed));
}

bool is_fixed(double px) { return std::abs(std::round(px * 256)) <= kMaxFixed; }

// Phrases on bodies whose numbers the header cannot hold.
std::vector<std::string> dropped_numbers(const std::vector<Spawn>& spawns) {
  const auto is_within = [](const Spawn& spawn) {
    return is_fixed(spawn.position.x) && is_fixed(spawn.position.y) && is_fixed(spawn.velocity.x) &&
           is_fixed(spawn.velocity.y);
  };
  const auto count = std::count_if(spawns.begin(), spawns.end(), std::not_fn(is_within));
  if (count == 0) return {};
  return {"places and speeds over 8388607 px, of " + std::to_string(count) +
          (count == 1 ? " body" : " bodies")};
}

// A string literal of C. Bytes that are not printable ASCII become \ooo; so does ?, which could begin a
// trigraph.
std::string c_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte >= 32 && byte < 127 && c != '"' && c != '\\' && c != '?';
    if (is_plain) {
      quoted += c;
    } else {
      for (const int shift : {6, 3, 0})
        quoted.append(shift == 6 ? "\\" : "").append(1, char('0' + (byte >> shift & 7)));
    }
  }
  return quoted + '"';
}

// "{1,2,3}", over several lines.
template <class Range>
std::string c_list(const Range& values) {
  std::string text = "{";
  std::size_t line = 0;
  const char* separator = "";
  for (const auto value : values) {
    text += separator;
    separator = ",";
    if (text.size() - line > 96) {
      text += '\n';
      line = text.size();
    }
    append_number(text, +value);
  }
  return text + '}';
}

// The smallest type of C for the numbers below a count.
std::string number_type(std::size_t count) { return count <= 256 ? "uint8_t" : "uint16_t"; }

// The floors of a shape's tile, or of a further column of it: 24.8 numbers, or `none`.
std::string floor_row(const PlainShape& shape, int column, const std::string& none) {
  const auto width = static_cast<int>(shape.columns.size()) / shape.tiles;  // px
  std::string text = "{";
  for (int x = 0; x < width; ++x) {
    if (x > 0) text += ',';
    const double y = shape.columns[static_cast<std::size_t>(column * width + x)];
    if (shape.has_floor_at(y))
      append_number(text, fixed(shape.is_ceiling ? 0 : y));
    else
      text += none;
  }
  return text + '}';
}

bool is_same(const PlainShape& a, const PlainShape& b) {
  return a.kind == b.kind && a.is_ceiling == b.is_ceiling && a.one_way == b.one_way && a.tiles == b.tiles &&
         a.ys == b.ys;
}

class CHeader {
 public:
  CHeader(const Level& level, std::string name)
      : level_(level),
        bodies_(level),
        name_(std::move(name)),
        macro_(upper(name_)),
        shapes_(plain_shapes(ground_of(level))),
        by_tile_(static_cast<std::size_t>(level.tile_count())) {
    for (const PlainShape& shape : shapes_) {
      const auto same = std::find_if(distinct_.begin(), distinct_.end(),
                                     [&](const PlainShape* other) { return is_same(*other, shape); });
      by_tile_[static_cast<std::size_t>(shape.tile)] = static_cast<int>(same - distinct_.begin()) + 1;
      if (same == distinct_.end()) distinct_.push_back(&shape);
    }
  }

  std::string take() {
    put_head();
    put_map();
    put_shapes();
    put_floors();
    put_bodies();
    put_tuning();
    put_functions();
    line("#endif");
    return std::move(text_);
  }

 private:
  // Adds a line; @ stands for the name, ^ for the name in capitals.
  void line(std::string_view text) {
    for (const char c : text) {
      if (c == '@')
        text_ += name_;
      else if (c == '^')
        text_ += macro_;
      else
        text_ += c;
    }
    text_ += '\n';
  }
  void define(std::string_view name, std::int64_t value) {
    line("#define ^_" + std::string(name) + " " + std::to_string(value));
  }

  void put_head();
  void put_flags();
  void put_map();
  void put_shapes();
  void put_floors();
  void put_bodies();
  void put_tuning();
  void put_functions();

  const Level& level_;
  TileSize tile_ = level_.map.tile_size();
  PlainBodies bodies_;
  std::string name_, macro_;
  std::vector<PlainShape> shapes_;
  std::vector<const PlainShape*> distinct_;  // tiles with the same shape share the first one's
  std::vector<int> by_tile_;                 // from 1; 0: no shape
  std::string text_;
};

void CHeader::put_head() {
  line(
      R"(/* Copyright (c) 2026 the Talus authors. SPDX-License-Identifier: MIT */
/* A level exported by Talus, in C99. Lengths are px in 24.8 fixed point (256 is 1 px), x to the right,
   y down. The floor of a tile is measured from the tile's top. */
#ifndef ^_INCLUDED
#define ^_INCLUDED

#include <stdint.h>
)");
  define("WIDTH", level_.map.width());
  define("HEIGHT", level_.map.height());
  define("TILE_WIDTH", tile_.width);
  define("TILE_HEIGHT", tile_.height);
  if (tile_.width == tile_.height) define("TILE_SIZE", tile_.width);
  define("BODIES", static_cast<std::int64_t>(bodies_.size()));
  put_flags();
  int widest = 1;
  double highest = tile_.height;
  for (const PlainShape& shape : shapes_) {
    widest = std::max(widest, shape.tiles);
    for (const double y : shape.ys) highest = std::max(highest, tile_.height - y);
  }
  define("WIDEST", widest);                                                         // tiles
  define("HIGHEST", static_cast<std::int64_t>(std::ceil(highest / tile_.height)));  // tiles
  line("#define ^_NO_FLOOR INT32_MAX");
  line("");
}

// Flags with a role, and then those with a name. A name that another flag has is left out.
void CHeader::put_flags() {
  std::set<std::string> taken = {""};
  const auto put = [&](const std::string& name, int flag) {
    if (taken.insert(name).second) define("FLAG_" + upper(name), flag);
  };
  for (const FlagRoleInfo& info : flag_role_infos())
    if (const int flag = level_.roles.*info.flag; flag != FlagRoles::kUnused)
      put(std::string(info.key), flag);
  for (int flag = 0; flag < kMaxFlags; ++flag)
    put(c_word(level_.flag_names[static_cast<std::size_t>(flag)]), flag);
}

void CHeader::put_map() {
  line("/* Tile numbers, and flags by tile and by sprite: bit n is flag n, of ^_FLAG_SOLID and the like. */");
  const bool has_more_flags = (used_flags(level_) & ~kCartFlagSet) != 0;
  const std::string flag_type = has_more_flags ? "uint32_t " : "uint8_t ";
  line("static const " + number_type(static_cast<std::size_t>(level_.tile_count())) +
       " @_map[^_HEIGHT][^_WIDTH] = {");
  const std::vector<TileNumber>& cells = level_.map.cells().tiles();
  for (auto row = cells.begin(); row != cells.end(); row += level_.map.width())
    text_ += c_list(std::vector<TileNumber>(row, row + level_.map.width())) + ",\n";
  line("};");
  text_ += "static const " + flag_type + name_ + "_flags[" + std::to_string(level_.tile_count()) +
           "] = " + c_list(level_.sheet(SheetId::tiles).flags) + ";\n";
  text_ += "static const " + flag_type + name_ + "_sprite_flags[" +
           std::to_string(level_.sheet(SheetId::sprites).count()) +
           "] = " + c_list(level_.sheet(SheetId::sprites).flags) + ";\n\n";
}

void CHeader::put_shapes() {
  line(
      R"(/* Shapes; tile t has @_shapes[@_shape_of[t]]. kind: 0 none, 1 solid, 2 slope, 3 profile. is_ceiling:
   ground is above the line, from the tile's top; else below it, to its bottom. one_way: the line alone stops
   bodies. tiles: its width; what is beyond the first tile reaches over the cells to the right. row: of
   @_floors, for its first tile, which those of the others follow. The line goes through heights at equal
   distances, @_ys[first] to @_ys[first + parts]. A slope is also y = y0 + (slope * x >> 8), x from the tile's
   left side: both numbers are rounded, so that it is off by up to 1/512 px for each px of x; @_line_y is not.
   ^_WIDEST and ^_HIGHEST: how many tiles a shape reaches over, at most. */
typedef struct @_shape {
  uint8_t kind, is_ceiling, one_way, tiles;
  uint16_t row, first, parts;
  int32_t slope, y0;
} @_shape;)");
  text_ += "static const " + number_type(distinct_.size() + 1) + " " + name_ + "_shape_of[" +
           std::to_string(level_.tile_count()) + "] = " + c_list(by_tile_) + ";\n";
  line("static const @_shape @_shapes[" + std::to_string(distinct_.size() + 1) + "] = {");
  line("{0,0,0,0,0,0,0,0,0},");
  std::size_t row = 1, first = 0;
  std::vector<std::int64_t> ys;
  for (const PlainShape* shape : distinct_) {
    const double width = shape->tiles * tile_.width;
    const bool is_slope = shape->kind == TileShape::Kind::slope;
    const double slope = is_slope ? (shape->ys.back() - shape->ys.front()) / width : 0;
    line(c_list(std::vector<std::int64_t>{
             static_cast<int>(std::min(shape->kind, TileShape::Kind::profile)), shape->is_ceiling,
             shape->one_way, shape->tiles, static_cast<std::int64_t>(row), static_cast<std::int64_t>(first),
             static_cast<std::int64_t>(shape->ys.size()) - 1, fixed(slope), fixed(shape->ys.front())}) +
         ",");
    row += static_cast<std::size_t>(shape->tiles);
    first += shape->ys.size();
    for (const double y : shape->ys) ys.push_back(fixed(y));
  }
  line("};");
  if (ys.empty()) ys.push_back(0);
  text_ += "static const int32_t " + name_ + "_ys[] = " + c_list(ys) + ";\n\n";
}

void CHeader::put_floors() {
  std::string rows;
  std::size_t count = 1;
  const std::string none = macro_ + "_NO_FLOOR";
  for (const PlainShape* shape : distinct_) {
    for (int column = 0; column < shape->tiles; ++column, ++count)
      rows += floor_row(*shape, column, none) + ",\n";
  }
  line(
      R"(/* Where bodies can stand, in the middle of each column of pixels: first of tiles without a shape, then of
   each tile that a shape reaches over to the right, see `row`. ^_NO_FLOOR: nowhere. */)");
  line("static const int32_t @_floors[" + std::to_string(count) + "][" + std::to_string(tile_.width) +
       "] = {");
  std::string no_floors = none;
  for (int x = 1; x < tile_.width; ++x) no_floors += "," + none;
  text_ += "{" + no_floors + "},\n";
  text_ += rows;
  line("};\n");
}

void CHeader::put_bodies() {
  line(
      R"(/* All bodies at their start: the top left corner, the size, the velocity in px a frame. kind: its word, such as
   "ball". tile: of the map, that is the body and is not to be drawn then; -1: none. stands_on_centre: the middle
   of its bottom side stands on slopes; else all of it. */
typedef struct @_body {
  const char *name, *kind;
  int32_t tile, stands_on_centre, x, y, w, h, vx, vy;
} @_body;
static const @_body @_bodies[^_BODIES + 1] = { /* the last one is empty */)");
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const PlainBody body = bodies_.at(i);
    const Spawn& s = body.start;
    const std::vector<std::int64_t> numbers = {body.tile,           s.used_foot() == Foot::centre,
                                               fixed(s.position.x), fixed(s.position.y),
                                               fixed(s.size.x),     fixed(s.size.y),
                                               fixed(s.velocity.x), fixed(s.velocity.y)};
    const std::string words = c_string(s.name) + "," + c_string(traits_of(s.kind).word);
    text_ += "{" + words + "," + c_list(numbers).substr(1) + ",\n";
  }
  line("{\"\",\"\",-1,0,0,0,0,0,0,0}};\n");
}

void CHeader::put_tuning() {
  line(
      "/* The numbers of the physics; px, and frames of 1/60 s. ^_SOLVER is what the level was played by. "
      "*/");
  line("#define ^_SOLVER " + c_string(solver_name(level_.tuning.solver)));
  for (const TuningField& field : tuning_fields()) {
    std::string name = upper(field.path()), value;
    std::replace(name.begin(), name.end(), '.', '_');
    if (field.words.empty()) {
      append_number(value, field.of(level_.tuning));
      if (value.find_first_of(".e") == std::string::npos) value += ".0";
    } else {
      value = c_string(field.word_of(level_.tuning));
    }
    line("#define ^_TUNING_" + name + " " + value);
  }
  line("");
}

void CHeader::put_functions() {
  line(R"(/* The line of a shape, 0 <= x <= its width from its left side: its y from the tile's top. */
static inline int32_t @_line_y(const @_shape *shape, int32_t x) {
  const int32_t width = shape->tiles * ^_TILE_WIDTH * 256, at = x * shape->parts, part = at / width;
  const int32_t *ys = @_ys + shape->first + part;
  int64_t rise, half = width / 2;
  if (part >= shape->parts) return ys[0];
  rise = (int64_t)(ys[1] - ys[0]) * (at % width);
  return ys[0] + (int32_t)((rise < 0 ? rise - half : rise + half) / width);
}

/* The first floor of a tile at or below a point of the map that is not in the ground; ^_NO_FLOOR: there is
   none. */
static inline int32_t @_floor_below(int32_t x, int32_t y) {
  const int32_t width = ^_TILE_WIDTH * 256, height = ^_TILE_HEIGHT * 256;
  int32_t best = ^_NO_FLOOR, row, left;
  if (x < 0 || x >= ^_WIDTH * width) return best;
  for (row = y < 0 ? 0 : y / height; row < ^_HEIGHT && best > (row + 1 - ^_HIGHEST) * height; ++row) {
    for (left = 0; left < ^_WIDEST && left <= x / width; ++left) {
      const @_shape *shape = &@_shapes[@_shape_of[@_map[row][x / width - left]]];
      int32_t line, floor;
      if (left >= shape->tiles) continue;
      line = @_line_y(shape, x % width + left * width);
      if (shape->is_ceiling ? shape->one_way || line <= 0 : !shape->one_way && line >= height) continue;
      floor = row * height + (shape->is_ceiling ? 0 : line);
      if (floor >= y && floor < best) best = floor;
    }
  }
  return best;
}
)");
}

}  // namespace

FormatResult<Exported> export_c(const ExportRequest& request) {
  const TileMap& map = request.level.map;
  const auto [tile_width, tile_height] = map.tile_size();
  const int columns = kMaxPx / tile_width - 1, rows = kMaxPx / tile_height - 1;  // a cell to spare
  if (map.width() > columns || map.height() > rows)
    return tl::unexpected(FormatError{"", "the map is longer than " +
                                              std::to_string(map.width() > columns ? columns : rows) +
                                              " cells, the most that 24.8 fixed point can hold"});
  std::vector<std::string> dropped = dropped_curves(request.level);
  for (std::string& phrase : dropped_polygons(request.level)) dropped.push_back(std::move(phrase));
  for (std::string& phrase : dropped_numbers(request.level.spawns)) dropped.push_back(std::move(phrase));
  tell_body_pictures(request.level, dropped);
  tell_conveyors(request.level, false, dropped);
  return exported_file(CHeader(request.level, c_name(request.stem())).take(), std::move(dropped));
}

}  // namespace talus
