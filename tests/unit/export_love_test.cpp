// Games in Lua move by the exact solver, whatever solver the level has, and contain the code that draws them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "export/exporter.h"
#include "formats/files/atomic_file.h"
#include "formats/tic80/tic_cart.h"
#include "formats/tic80/tic_text.h"
#include "paths.h"

namespace talus::export_love_test {

FormatResult<std::string> read_asset(const std::string& name) {
  return read_file(source_path("assets/") + name);
}

Exported exported(const Level& level, std::string_view id) {
  const ReadAsset read = read_asset;
  return find_exporter(id)->write({level, "game", read}).value();
}

TEST(ExportLove, SaysThatTheGameMovesByExact) {
  Level level;
  level.map = TileMap(40, 20);  // the code of a cart also does something at this size
  level.map.set({39, 19}, 7);
  for (const char* id : {"love", "lua-runtime", "tic-playable", "tic-text-playable"}) {
    level.tuning.solver = SolverKind::exact;
    EXPECT_EQ(exported(level, id).dropped, std::vector<std::string>{}) << id;
    level.tuning.solver = SolverKind::article;
    EXPECT_EQ(exported(level, id).dropped,
              std::vector<std::string>{"the solver article: the game uses exact instead"})
        << id;
  }
}

TEST(ExportLove, ACartHasTheMapAtItsTopLeft) {
  Level level;
  level.map = TileMap(40, 20);
  level.map.set({39, 19}, 7);
  level.map.set({0, 1}, 5);
  const auto cart = read_level(exported(level, "tic-playable").files.front().bytes, {"tic"});
  ASSERT_TRUE(cart);
  TileMap map;
  map.set({39, 19}, 7);
  map.set({0, 1}, 5);
  EXPECT_EQ(cart->level.map, map);
}

TEST(ExportLove, WritesAFolderThatNeedsNothingElse) {
  std::vector<std::string> names;
  for (const ExportedFile& file : exported(Level(), "love").files) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"talus.lua", "level.lua", "sheet.png", "main.lua", "conf.lua",
                                             "rules.lua", "area.lua", "camera.lua", "controls.lua",
                                             "curve_points.lua", "frames.lua", "pictures.lua",
                                             "tile_bodies.lua", "trace.lua", "LICENSE-talus.txt"}));
}

// Data has no license: level.lua is the maker's.
TEST(ExportLove, AndOthersNameTheLicenseOfCode) {
  const std::string notice = "Copyright (c) 2026 the Talus authors";
  const auto first_line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
  for (const char* id : {"love", "bump", "cpp", "lua-runtime"}) {
    const Exported made = exported(Level(), id);
    for (const ExportedFile& file : made.files) {
      SCOPED_TRACE(std::string(id) + "/" + file.name);
      const bool is_code = file.name.ends_with(".lua") || file.name.ends_with(".cpp") ||
                           file.name.ends_with(".h") || file.name == "CMakeLists.txt";
      if (is_code && file.name != "level.lua") {
        EXPECT_THAT(first_line(file.bytes), testing::HasSubstr(notice));
      }
    }
    EXPECT_EQ(made.files.back().name, "LICENSE-talus.txt");
    EXPECT_EQ(made.files.back().bytes, read_file(source_path("LICENSE")).value());
  }
  EXPECT_THAT(first_line(exported(Level(), "c").files.front().bytes), testing::HasSubstr(notice));
  const std::string cart = exported(Level(), "tic-text-playable").files.front().bytes;
  EXPECT_THAT(cart.substr(0, 300), testing::HasSubstr("-- license: MIT, (c) 2026 the Talus authors\n"));
}

// A cart with sounds, music, a second bank, a binary chunk and code of its own.
std::string cart_with_everything() {
  std::string bytes;
  const auto add = [&](int type, int bank, std::string_view data) {
    append_tic_chunk(bytes, {.type = type, .bank = bank, .data = data});
  };
  add(17, 0, "");
  add(1, 0, "\x11");
  add(9, 0, "sound");
  add(14, 0, "tracks");
  add(15, 0, "patterns");
  add(4, 1, "\x05");
  add(kTicBinary, 0, "wasm");
  add(kTicCode, 0, "function TIC() end");
  return bytes;
}

TEST(ExportLove, ACartKeepsItsSoundAndSaysWhatIsRemoved) {
  for (const bool is_text : {false, true}) {
    Level level = read_level(cart_with_everything(), {"tic"})->level;
    if (is_text) level = read_level(exported(level, "tic-text").files[0].bytes, {"lua"})->level;
    for (const char* id : {"tic-playable", "tic-text-playable"}) {
      const Exported game = exported(level, id);
      std::vector<std::string> said = {"the cart's own code, 18 bytes: the game's code replaces it"};
      if (!is_text) said.push_back("the BINARY chunk of bank 0");
      EXPECT_EQ(game.dropped, said) << id;
      const auto cart = read_level(game.files[0].bytes, {id == std::string("tic-playable") ? "tic" : "lua"});
      ASSERT_TRUE(cart) << id;
      const CartOrigin& origin = *cart->level.cart;
      const auto content = origin.kind == CartOrigin::Kind::tic ? tic_content(origin.bytes)
                                                                : text_content(origin.bytes, origin.comment);
      EXPECT_EQ(at(content->banks[0], Section::sfx), "sound") << id;
      EXPECT_EQ(at(content->banks[0], Section::tracks), "tracks") << id;
      EXPECT_EQ(at(content->banks[0], Section::patterns), "patterns") << id;
      EXPECT_EQ(at(content->banks[0], Section::waves), default_wave_bytes().substr(0, 48)) << id;
      EXPECT_EQ(at(content->banks[1], Section::map), "\x05") << id;
      EXPECT_NE(content->code.find("talus=(function()"), std::string::npos) << id;
      EXPECT_EQ(game.code_bytes, content->code.size()) << id;
    }
  }
}

// A cart without curves does not need the code that draws them, and a cart has little room.
TEST(ExportLove, OnlyACartWithCurvesHasTheCodeThatDrawsThem) {
  Level level;
  const auto has_curves = [&] {
    return exported(level, "tic-text-playable").files.front().bytes.find("curve_points=(function()") !=
           std::string::npos;
  };
  EXPECT_FALSE(has_curves());
  level.curves.push_back({.name = "", .curve = {.form = Segment{{0, 8}, {16, 8}}}, .extra = ""});
  EXPECT_TRUE(has_curves());
}

}  // namespace talus::export_love_test
