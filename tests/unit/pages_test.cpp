// The tables of the README and of docs/ match the program: formats, exports, sizes, parts and commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include <talus/formats/format.h>
#include "cli/cli.h"
#include "export/exporter.h"
#include "export/lua_parts.h"
#include "export/lua_runtime.h"
#include "formats/files/atomic_file.h"
#include "formats/native/native.h"
#include "formats/native/recording_file.h"
#include "paths.h"

namespace talus::pages_test {

const std::string kRoot = source_path("");

testing::AssertionResult page_has(const std::string& page, const std::string& text) {
  const bool has = read_file(kRoot + page).value().find(text) != std::string::npos;
  return (has ? testing::AssertionSuccess() : testing::AssertionFailure()) << page << " lacks: " << text;
}

// The part of a page from the heading to the next heading of the same rank.
std::string section_of(const std::string& page, const std::string& heading) {
  const std::string text = read_file(kRoot + page).value();
  const std::size_t from = text.find("\n## " + heading + "\n");
  EXPECT_NE(from, std::string::npos) << page << " lacks: " << heading;
  return from == std::string::npos ? "" : text.substr(from, text.find("\n## ", from + 1) - from);
}

// The first cells of the table's rows, if they are words in code style.
std::vector<std::string> named_rows(const std::string& text) {
  std::vector<std::string> names;
  const std::regex row("\n\\| `([a-z_0-9-]+)` \\|");
  for (std::sregex_iterator at(text.begin(), text.end(), row), end; at != end; ++at)
    names.push_back(at->str(1));
  std::sort(names.begin(), names.end());
  return names;
}

FormatResult<std::string> read_asset(const std::string& name) { return read_file(kRoot + "assets/" + name); }

Exported exported(const Level& level, std::string_view id) {
  const ReadAsset read = read_asset;
  return find_exporter(id)->write({level, "game", read}).value();
}

// 12345 gives "12,345".
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

// The row for a level in the table of sizes.
std::string size_row(const std::string& what, const Level& level) {
  const Exported runtime = exported(level, "lua-runtime");
  EXPECT_EQ(runtime.files.front().name, "talus.lua");
  const std::string& text = runtime.files.front().bytes;
  const std::size_t small = join_lua({"\n", text}).size();  // without the comment at its head
  const Exported cart = exported(level, "tic-text-playable");
  std::string readable = grouped(cart.code_bytes.value());
  std::smatch found;
  for (const std::string& phrase : cart.dropped)
    if (std::regex_search(phrase, found, std::regex("the code has ([0-9,]+) bytes"))) readable = found[1];
  return "| " + what + " | " + grouped(text.size()) + " | " + grouped(small) + " | " + readable + " | " +
         grouped(cart.code_bytes.value()) + " |\n";
}

Level level_at(const std::string& path) { return load_level(kRoot + "assets/" + path).value().level; }

Level full_tiles_and_a(BodyKind kind) {
  Level level;
  for (int x = 0; x < 30; ++x) level.map.set({x, 16}, 1);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  level.spawns.emplace_back().kind = kind;
  level.spawns.back().position = {40, 40};
  return level;
}

// The demo with a ledge, and a player instead of its balls.
Level demo_with_a_player() {
  Level level = level_at("demo.talus.json");
  for (TileNumber& tile : level.map.cells().tiles())
    if (body_kind_of_tile(level, tile)) tile = 0;
  level.tile_shapes[20] = {.kind = TileShape::Kind::slope, .one_way = true, .heights = {8, 8}};
  for (int x = 14; x < 18; ++x) level.map.set({x, 9}, 20);
  level.spawns.emplace_back().kind = BodyKind::player;
  level.spawns.back().position = {48, 88};
  return level;
}

TEST(Pages, StateTheSizesOfExports) {
  const std::string page = "docs/runtime.md";
  for (const std::string& row :
       {size_row("full tiles, a ball", full_tiles_and_a(BodyKind::ball)),
        size_row("full tiles, a player", full_tiles_and_a(BodyKind::player)),
        size_row("slopes, and balls that block one another (the demo)", level_at("demo.talus.json")),
        size_row("slopes, one-way ground, and a player", demo_with_a_player()),
        size_row("curves, and a player (hard case 38, quarter pipe)",
                 level_at("hard_cases/38-quarter-pipe.talus.json"))})
    EXPECT_TRUE(page_has(page, row)) << row;
  EXPECT_TRUE(page_has(page, grouped(kMaxTicCode) + " bytes of code"));
}

TEST(Pages, HaveARowForEachPartOfTheRuntime) {
  std::vector<std::string> parts;
  std::istringstream names(lua_part_names());
  for (std::string name; std::getline(names >> std::ws, name, ',');) parts.push_back(name);
  std::sort(parts.begin(), parts.end());
  EXPECT_EQ(named_rows(section_of("docs/runtime.md", "Parts")), parts);
}

TEST(Pages, HaveARowForEachExporter) {
  std::vector<std::string> ids;
  for (const Exporter& exporter : exporters()) ids.emplace_back(exporter.id);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(named_rows(section_of("docs/formats.md", "What is exported")), ids);
}

TEST(Pages, HaveARowForEachFormatWithItsExtension) {
  const std::string levels = section_of("docs/formats.md", "Levels");
  std::vector<std::string> ids;
  for (const Format& format : formats()) {
    ids.emplace_back(format.id);
    const std::string row = "| `" + ids.back() + "` | `." + std::string(format.extensions.front()) + "`";
    EXPECT_NE(levels.find(row), std::string::npos) << row;
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(named_rows(levels), ids);
}

TEST(Pages, StateTheVersionsOfFiles) {
  EXPECT_TRUE(
      page_has("docs/formats.md", "a level of Talus, version " + std::to_string(kNativeVersion) + ":"));
  EXPECT_TRUE(
      page_has("docs/formats.md", "| version " + std::to_string(kRecordingVersion) + ": a level, its edits"));
}

TEST(Pages, HaveALineForEachCommand) {
  std::ostringstream out, err;
  ASSERT_EQ(run_cli({"--help"}, out, err), 0);
  std::istringstream help(out.str().substr(out.str().find("Subcommands:")));
  std::string line;
  int count = 0;
  for (std::getline(help, line); std::getline(help, line) && line.starts_with("  "); ++count) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    EXPECT_TRUE(page_has("docs/command-line.md", "\n    talus " + (name == "edit" ? "[edit]" : name) + " "));
  }
  EXPECT_GE(count, 9);
}

}  // namespace talus::pages_test
