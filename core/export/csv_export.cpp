// A folder of tables: plain data for spreadsheets and scripts. docs/export-data.md says what the numbers
// mean.
#include <algorithm>

#include <talus/level/ground.h>
#include "../formats/text/append_number.h"
#include "export_targets.h"
#include "ground_polygons.h"
#include "plain_data.h"

namespace talus {
namespace {

// Whether a spreadsheet would run the text as a formula, quoted or not.
bool is_formula(std::string_view text) {
  constexpr std::string_view kStarts = "=+-@\t\r\n";
  if (text.empty()) return false;
  const bool is_wide = text.starts_with("\xef\xbc\x9d") || text.starts_with("\xef\xbc\x8b") ||  // = +
                       text.starts_with("\xef\xbc\x8d") || text.starts_with("\xef\xbc\xa0");    // - @
  return is_wide || kStarts.find(text.front()) != kStarts.npos;
}

// Rows of fields. A text is quoted if needed; one that would be a formula gets a ' before it.
class CsvTable {
 public:
  explicit CsvTable(std::string_view header) : text_(header) { text_ += '\n'; }
  CsvTable() = default;

  template <class Number>
  CsvTable& number(Number value) {
    append_number(field(), value);
    return *this;
  }
  CsvTable& truth(bool value) { return number(value ? 1 : 0); }
  CsvTable& word(std::string_view value) {
    const bool is_plain = value.find_first_of(",;\"\t\r\n") == std::string_view::npos;
    field() += is_plain ? "" : "\"";
    text_ += is_formula(value) ? "'" : "";
    for (const char c : value) text_.append(c == '"' ? "\"" : "").append(1, c);
    text_ += is_plain ? "" : "\"";
    return *this;
  }
  void end_row() {
    text_ += '\n';
    is_first_ = true;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string& field() {
    if (!is_first_) text_ += ',';
    is_first_ = false;
    return text_;
  }

  std::string text_;
  bool is_first_ = true;  // in its row
};

std::string map_table(const TileMap& map, const Progress& progress) {
  CsvTable table;
  for (Cell c; c.y < map.height() && progress.at(c.y, map.height()); ++c.y) {
    for (c.x = 0; c.x < map.width(); ++c.x) table.number(map.tile_at(c));
    table.end_row();
  }
  return table.take();
}

// One row for each tile; a wide shape has one more for each further column of cells.
std::string tile_table(const Level& level) {
  const int width = level.map.tile_size().width;
  std::string header = "tile,flags,kind,side,one_way,tiles,column";
  for (int x = 0; x < width; ++x) header += ",y" + std::to_string(x);
  CsvTable table(header);
  const std::vector<PlainShape> shapes = plain_shapes(ground_of(level));
  auto shape = shapes.begin();
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    const FlagSet flags = level.tile_flags(static_cast<TileNumber>(tile));
    if (shape == shapes.end() || shape->tile != tile) {
      table.number(tile).number(flags).word("none");
      for (int empty = 0; empty < width + 4; ++empty) table.word("");
      table.end_row();
      continue;
    }
    for (int column = 0; column < shape->tiles; ++column) {
      table.number(tile).number(flags).word(kind_word(shape->kind));
      table.word(shape->is_ceiling ? "ceiling" : "floor").truth(shape->one_way);
      table.number(shape->tiles).number(column);
      for (int x = 0; x < width; ++x) table.number(shape->columns[column * width + x]);
      table.end_row();
    }
    ++shape;
  }
  return table.take();
}

std::string sprite_table(const Level& level) {
  CsvTable table("sprite,flags");
  const Sheet& sprites = level.sheet(SheetId::sprites);
  for (int sprite = 0; sprite < sprites.count(); ++sprite) {
    table.number(sprite).number(sprites.flags[static_cast<std::size_t>(sprite)]);
    table.end_row();
  }
  return table.take();
}

FormatResult<std::string> polygon_table(const Level& level, const Progress& progress) {
  TerrainSource ground = ground_of(level);
  ground.progress = progress.part(0, 0.7).function();
  const FormatResult<std::vector<GroundPolygon>> found = ground_polygons(ground);
  if (!found) return tl::unexpected(found.error());
  const std::vector<GroundPolygon>& polygons = *found;
  const Progress writing = progress.part(0.7, 1);
  CsvTable table("polygon,hole,point,x,y");
  for (std::size_t n = 0; n < polygons.size() && writing.at(n, polygons.size()); ++n) {
    for (std::size_t i = 0; i < polygons[n].points.size(); ++i) {
      const Vec2 point = polygons[n].points[i];
      table.number(n).truth(polygons[n].is_hole).number(i).number(point.x).number(point.y).end_row();
    }
  }
  return table.take();
}

std::string line_table(const std::vector<PlainLine>& lines) {
  CsvTable table("line,kind,name,both_sides,point,x,y");
  for (std::size_t n = 0; n < lines.size(); ++n) {
    for (std::size_t i = 0; i < lines[n].points.size(); ++i) {
      const Vec2 point = lines[n].points[i];
      table.number(n).word(lines[n].is_curve ? "curve" : "one_way").word(lines[n].name);
      table.truth(lines[n].both_sides).number(i).number(point.x).number(point.y).end_row();
    }
  }
  return table.take();
}

std::string size_table(const TileMap& map) {
  CsvTable table("name,value,unit");
  table.word("width").number(map.width()).word("cells").end_row();
  table.word("height").number(map.height()).word("cells").end_row();
  table.word("tile_width").number(map.tile_size().width).word("px").end_row();
  table.word("tile_height").number(map.tile_size().height).word("px").end_row();
  return table.take();
}

std::string role_table(const FlagRoles& roles) {
  CsvTable table("role,flag");
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = roles.*info.flag;
    if (flag != FlagRoles::kUnused) table.word(info.key).number(flag).end_row();
  }
  return table.take();
}

bool has_flag_names(const Level& level) {
  return std::any_of(level.flag_names.begin(), level.flag_names.end(),
                     [](const std::string& name) { return !name.empty(); });
}

std::string flag_name_table(const Level& level) {
  CsvTable table("flag,name");
  for (std::size_t flag = 0; flag < level.flag_names.size(); ++flag)
    if (!level.flag_names[flag].empty()) table.number(flag).word(level.flag_names[flag]).end_row();
  return table.take();
}

std::string tuning_table(const Tuning& tuning) {
  CsvTable table("name,value,unit");
  table.word("solver").word(solver_name(tuning.solver)).word("").end_row();
  for (const TuningField& field : tuning_fields()) {
    table.word(field.path());
    if (field.words.empty())
      table.number(field.of(tuning));
    else
      table.word(field.word_of(tuning));
    table.word(field.unit).end_row();
  }
  return table.take();
}

std::string body_table(const Level& level) {
  CsvTable table("id,name,kind,tile,x,y,w,h,vx,vy,foot");
  const PlainBodies bodies(level);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const PlainBody body = bodies.at(i);
    const Spawn& spawn = body.start;
    table.number(body.id);
    table.word(spawn.name).word(traits_of(spawn.kind).word);
    table.word(body.tile < 0 ? "" : std::to_string(body.tile));
    table.number(spawn.position.x).number(spawn.position.y);
    table.number(spawn.size.x).number(spawn.size.y).number(spawn.velocity.x).number(spawn.velocity.y);
    table.word(foot_word(spawn.used_foot())).end_row();
  }
  return table.take();
}

}  // namespace

FormatResult<Exported> export_csv(const ExportRequest& request) {
  const Level& level = request.level;
  const Progress& progress = request.progress;
  Exported exported;
  const auto add = [&](const char* name, std::string bytes) {
    exported.files.push_back({name, std::move(bytes)});
  };
  add("map.csv", map_table(level.map, progress.part(0, 0.1)));
  add("flags.csv", tile_table(level));
  add("sprite_flags.csv", sprite_table(level));
  FormatResult<std::string> polygons = polygon_table(level, progress.part(0.1, 0.8));
  if (!polygons) return tl::unexpected(polygons.error());
  add("polygons.csv", *std::move(polygons));
  add("lines.csv", line_table(plain_lines(level, progress.part(0.8, 1))));
  add("bodies.csv", body_table(level));
  add("roles.csv", role_table(level.roles));
  if (has_flag_names(level)) add("flag_names.csv", flag_name_table(level));
  add("tuning.csv", tuning_table(level.tuning));
  add("sizes.csv", size_table(level.map));
  tell_body_pictures(level, exported.dropped);
  tell_conveyors(level, true, exported.dropped);
  return exported;
}

}  // namespace talus
