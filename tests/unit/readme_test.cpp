// What the README says of exports is true: every format has its row, and the sizes are those that are
// written.
#include <gtest/gtest.h>

#include "export/exporter.h"
#include "export/lua_runtime.h"
#include "formats/atomic_file.h"
#include "formats/format.h"

namespace talus::readme_test {

const std::string kRoot = TALUS_SOURCE_DIR "/";

testing::AssertionResult readme_has(const std::string& text) {
  const bool has = read_file(kRoot + "README.md").value().find(text) != std::string::npos;
  return (has ? testing::AssertionSuccess() : testing::AssertionFailure()) << "README.md: " << text;
}

FormatResult<std::string> read_asset(const std::string& name) { return read_file(kRoot + "assets/" + name); }

Exported exported(const Level& level, std::string_view id) {
  const ReadAsset read = read_asset;
  return find_exporter(id)->write({level, "game", read}).value();
}

// 12345: "12,345".
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

// The row of the table of sizes for a level.
std::string size_row(const std::string& what, const Level& level) {
  const Exported runtime = exported(level, "lua-runtime");
  EXPECT_EQ(runtime.files.front().name, "talus.lua");
  const std::string& text = runtime.files.front().bytes;
  const std::size_t small = join_lua({"\n", text}).size();  // without its comment at the head, too
  const std::size_t cart = exported(level, "tic-text-playable").code_bytes.value();
  return "| " + what + " | " + grouped(text.size()) + " | " + grouped(small) + " | " + grouped(cart) + " |\n";
}

Level level_at(const std::string& path) { return load_level(kRoot + "assets/" + path).value().level; }

Level full_tiles_and_a_ball() {
  Level level;
  for (int x = 0; x < 30; ++x) level.map.set({x, 16}, 1);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  level.spawns.push_back({.name = "", .position = {40, 40}, .velocity = {}, .extra = ""});
  return level;
}

TEST(Readme, TellsTheSizesThatAreWritten) {
  EXPECT_TRUE(readme_has(size_row("full tiles, a ball", full_tiles_and_a_ball())));
  EXPECT_TRUE(readme_has(
      size_row("slopes, and balls that block one another (the demo)", level_at("demo.talus.json"))));
  EXPECT_TRUE(readme_has(size_row("curves, and a player (hard case 38, quarter pipe)",
                                  level_at("hard_cases/38-quarter-pipe.talus.json"))));
  EXPECT_TRUE(readme_has(grouped(kMostTicCode) + " bytes of code"));
}

TEST(Readme, HasARowForEveryExporter) {
  for (const Exporter& exporter : exporters())
    EXPECT_TRUE(readme_has("\n| `" + std::string(exporter.id) + "` | "));
}

}  // namespace talus::readme_test
