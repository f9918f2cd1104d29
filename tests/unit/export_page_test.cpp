// docs/export-data.md has what exports of plain data hold, and nothing else.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "formats/files/atomic_file.h"
#include "paths.h"
#include "unit/exported_level.h"

namespace talus::export_page_test {

using Json = nlohmann::json;
using Words = std::set<std::string>;

// The rows of the table after the words that lead to it.
std::vector<std::string> rows_on_page(const std::string& lead) {
  const std::string page = read_file(source_path("docs/export-data.md")).value();
  std::istringstream lines(page.substr(page.find("\n" + lead + "\n")));
  std::vector<std::string> rows;
  bool in_table = false;
  for (std::string line; std::getline(lines, line) && !(in_table && line.empty());) {
    in_table = in_table || line.starts_with("| ---");
    if (in_table && line.starts_with("| `")) rows.push_back(line);
  }
  return rows;
}

std::string first_column(const std::string& row) { return row.substr(0, row.find(" |", 2)); }

// All that a pattern finds in a text.
Words found(const std::string& text, const char* pattern) {
  const std::regex words(pattern);
  Words all;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), words); at != std::sregex_iterator(); ++at)
    all.insert((*at)[1]);
  return all;
}

Words members_on_page(const std::string& lead) {
  Words members;
  for (const std::string& row : rows_on_page(lead)) members.merge(found(first_column(row), "`([^`]*)`"));
  return members;
}

Words members_of(const Json& list) {
  Words members;
  for (const Json& entry : list)
    for (const auto& [key, value] : entry.items()) members.insert(key);
  return members;
}

// With each member that an export may leave out.
Level level_with_all() {
  Level level = level_of_shapes({"1.67", "11.."});
  level.flag_names[2] = "ladder";
  level.sheet(SheetId::tiles).flags[60] = 2;  // a ball
  level.map.set({2, 1}, 60);
  level.tile_shapes[1].conveyor = 1;
  level.tile_shapes[4] = {.kind = TileShape::Kind::polygon, .points = {{0, 8}, {8, 0}, {8, 8}}};
  level.tile_notes[3] = {"lava", 1, ""};
  level.animations[3] = {{3, 100}, {2, 50}};
  level.tilesets = {Tileset{.name = "cave", .count = 16, .columns = 16}};
  level.map.cells().set(4, {1, TileTurn::left_right});
  level.curves.push_back({"bow", {Segment{{0, 4}, {4, 2.5}}, Curve::Faces::both, 2}, ""});
  level.spawns.emplace_back().picture[BodyAct::stand] = {1, 1};
  ObjectLayer sky{.visible = false, .opacity = 0.5, .offset = {1, 2}, .parallax = {2, 3}, .tint = {1, 2, 3}};
  sky.image = LayerImage{"sky.png", {}, true, true};
  ObjectLayer things{.is_ground = true};
  things.objects = {{.rotation = 5, .visible = false, .one_way = true},
                    {.form = MapObject::Form::polyline, .points = {{0, 0}, {2, 0}}},
                    {.form = MapObject::Form::tile, .size = {4, 6}, .tile = 0xA0000007}};
  level.objects = {sky, things};
  return level;
}

std::vector<ExportedFile> files_of(const char* id) {
  const ReadAsset none = [](const std::string&) -> FormatResult<std::string> { return ""; };
  return find_exporter(id)->make({level_with_all(), "cave.h", none}).value().files;
}

TEST(ExportPage, HasTheMembersOfPlainData) {
  const Json data = Json::parse(files_of("json")[0].bytes);
  EXPECT_EQ(members_on_page("## JSON and Lua"), members_of(Json::array({data})));
  for (const auto& [key, lead] : {std::pair{"layers", "A layer has"},
                                  {"objects", "An object has"},
                                  {"shapes", "A shape has"},
                                  {"lines", "A line has"},
                                  {"bodies", "A body has"}})
    EXPECT_EQ(members_on_page(lead), members_of(data[key])) << lead;
}

TEST(ExportPage, HasTheColumnsOfTables) {
  Words names;
  const std::vector<std::string> rows = rows_on_page("## CSV");
  for (const ExportedFile& file : files_of("csv")) {
    if (file.name == "map.csv") continue;  // which has no heading line
    names.insert(file.name);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const std::string& each) {
      return first_column(each) == "| `" + file.name + "`";
    });
    ASSERT_NE(row, rows.end()) << file.name;
    const std::string heading = file.bytes.substr(0, file.bytes.find('\n'));
    for (const std::string& column : found(heading, "([a-z_]+0?)(?=,|$)"))
      EXPECT_TRUE(row->find("`" + column + "`") != row->npos) << file.name << " " << column;
  }
  EXPECT_EQ(members_on_page("## CSV"), names);
}

TEST(ExportPage, HasTheNamesOfTheHeaderInC) {
  const std::string header = files_of("c")[0].bytes;
  std::string table, names;
  for (const std::string& row : rows_on_page("## C")) {
    table += row + "\n";
    names += first_column(row) + "\n";
  }
  const Words on_page = found(table, "\\b((cave|CAVE)_\\w+)"),
              in_header = found(header, "\\b((cave|CAVE)_\\w+)");
  for (const std::string& name : on_page)
    EXPECT_TRUE(name == "CAVE_FLAG_WIN_ZONE" || in_header.contains(name)) << name;
  for (const std::string& name : in_header) {
    const bool has_many = name.starts_with("CAVE_FLAG_") || name.starts_with("CAVE_TUNING_");
    EXPECT_TRUE(has_many || name == "CAVE_INCLUDED" || on_page.contains(name)) << name;
  }
  for (const char* const type : {"cave_shape", "cave_body"}) {
    const std::size_t begin = header.find("typedef struct " + std::string(type)),
                      from = header.find('{', begin);
    const std::string members = header.substr(from, header.find('}', from) - from);
    const std::size_t at = table.find("`" + std::string(type) + "`");
    ASSERT_NE(at, table.npos) << type;
    const std::string row = table.substr(at, table.find('\n', at) - at);
    for (const std::string& member : found(members, "(\\w+)(?=[,;])"))
      EXPECT_TRUE(row.find("`" + member + "`") != row.npos) << type << " " << member;
  }
}

}  // namespace talus::export_page_test
