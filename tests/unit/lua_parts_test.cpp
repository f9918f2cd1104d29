// The parts of the Lua runtime that a level ships, how they are written, and what a module says of missing
// parts.
#include "export/lua_parts.h"

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include <talus/formats/format.h>
#include "export/exporter.h"
#include "export/lua_level.h"
#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "paths.h"
#include "unit/program_output.h"

namespace talus::lua_parts_test {

FormatResult<std::string> read_asset(const std::string& name) {
  return read_file(source_path("assets/") + name);
}

Exported exported(const Level& level, std::string_view id, std::string_view parts = {}) {
  const ReadAsset read = read_asset;
  return find_exporter(id)->write({level, "game", read, parts}).value();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + " ";
  return text;
}

// A floor of full tiles, and a ball or a player.
Level flat_level(BodyKind kind = BodyKind::ball) {
  Level level;
  level.map = TileMap(8, 4);
  level.sheet(SheetId::tiles).flags[1] = 1;  // solid
  for (int x = 0; x < 8; ++x) level.map.set({x, 3}, 1);
  level.spawns.emplace_back().kind = kind;
  level.spawns.back().position = {16, 8};
  return level;
}

Level with_slope(Level level, bool one_way = false) {
  level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .one_way = one_way, .heights = {0, 8}};
  level.map.set({2, 2}, 2);
  return level;
}

Level with_curve(Level level, decltype(Curve::form) form) {
  level.curves.push_back({"", {std::move(form), Curve::Faces::up}, ""});
  return level;
}

const Arc kHill{{30, 20}, 8, 24, 36, true};

std::string parts_of(const Level& level, std::string_view more = {}) {
  return joined(lua_parts(level, more).value());
}

TEST(LuaParts, ALevelShipsThePartsThatItUses) {
  EXPECT_EQ(parts_of(Level()), "");
  EXPECT_EQ(parts_of(flat_level()), "balls ");
  EXPECT_EQ(parts_of(flat_level(BodyKind::player)), "walk players ");
  EXPECT_EQ(parts_of(with_slope(flat_level())), "slopes balls sides ");
  EXPECT_EQ(parts_of(with_slope(flat_level(), true)), "slopes one_way balls sides ");
  EXPECT_EQ(parts_of(with_curve(flat_level(), Segment{{8, 8}, {16, 8}})), "slopes segments balls sides ");
  EXPECT_EQ(parts_of(with_curve(flat_level(), kHill)), "slopes segments curves balls sides ");
  Level level = flat_level();
  level.spawns.push_back(flat_level(BodyKind::player).spawns[0]);
  EXPECT_EQ(parts_of(level), "balls walk players pairs ");
  level.tuning.shared.bodies = 0;
  EXPECT_EQ(parts_of(level), "balls walk players ");
  Level on_centre = flat_level();
  on_centre.spawns[0].foot = Foot::centre;
  EXPECT_EQ(parts_of(on_centre), "balls ");
  EXPECT_EQ(parts_of(with_slope(on_centre)), "slopes balls sides walk ");
}

TEST(LuaParts, WalkingHasCodeForSlopesAndCurvesOnlyWithThem) {
  const auto files_of_walk = [](const std::vector<std::string>& parts) {
    std::vector<std::string> walks;
    for (const std::string& file : lua_part_files(parts))
      if (file.starts_with("walk")) walks.push_back(file);
    return joined(walks);
  };
  EXPECT_EQ(files_of_walk({"slopes", "curves"}), "");
  EXPECT_EQ(files_of_walk({"walk"}), "walk ");
  EXPECT_EQ(files_of_walk({"slopes", "walk"}), "walk walk_slopes ");
  EXPECT_EQ(files_of_walk({"slopes", "segments", "curves", "walk"}), "walk walk_slopes walk_curves ");
}

TEST(LuaParts, OtherPartsCanBeChosen) {
  EXPECT_EQ(parts_of(flat_level(), "pairs,  players"), "balls walk players pairs ");
  EXPECT_EQ(parts_of(flat_level(), ",balls,"), "balls ");
  EXPECT_EQ(parts_of(Level(), "curves"), "slopes segments curves ");
  const auto wrong = lua_parts(flat_level(), "pairs,plyers");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(
      wrong.error().message,
      "\"plyers\" is not a part of the runtime; the parts are slopes, one_way, polygons, segments, curves, "
      "balls, sides, flight, walk, players, pairs, mouse, meet, round, conveyors, events, steer, data");
}

// Words that occur in the code of one part only.
const std::map<std::string, std::string> kMarks = {
    {"slopes", "slope|profile|height_at|foot_offset"},
    {"one_way", "one_way"},
    {"segments", "segment|polyline|cutter|curves"},
    {"curves", "curve_|stretch|tangent|bends|\\barc\\b|sine|newton"},
    {"balls", "bounce|friction"},
    {"walk", "floor_leads_over|look_ahead"},
    {"players", "players?\\b|jump|coyote"},
    {"pairs", "block_cells|near\\b"},
    {"mouse", "mouse|drag|grab"}};

// The code of talus.lua, without comments and without the texts of its errors.
std::string code_of(const Level& level, std::string_view parts = {}) {
  std::string code = join_lua({"--\n", exported(level, "lua-runtime", parts).files.front().bytes});
  return std::regex_replace(code.substr(code.find("\nlocal")), std::regex("\"[^\"\n]{20,}\""), "\"\"");
}

// The different words of a code, as the same few hundred come again and again, and std::regex is slow.
std::string words_of(const std::string& code) {
  std::set<std::string> words;
  std::string word;
  for (const char c : code + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, ""));
    }
  }
  return joined({words.begin(), words.end()});
}

TEST(LuaParts, TheCodeOfAPartIsLeftOutUnlessItIsUsed) {
  const Level levels[] = {Level(),
                          flat_level(),
                          flat_level(BodyKind::player),
                          with_slope(flat_level()),
                          with_slope(flat_level(), true),
                          with_curve(flat_level(), Segment{{8, 8}, {16, 8}}),
                          with_curve(flat_level(BodyKind::player), kHill)};
  for (const Level& level : levels) {
    const std::string code = words_of(code_of(level)), has = parts_of(level);
    for (const auto& [part, words] : kMarks) {
      std::smatch found;
      const bool is_there = std::regex_search(code, found, std::regex(words));
      EXPECT_EQ(is_there, has.find(part + " ") != std::string::npos)
          << part << " in a module of " << has << found.str();
    }
  }
  for (const auto& [part, words] : kMarks)
    EXPECT_TRUE(std::regex_search(words_of(code_of(Level(), part)), std::regex(words))) << part;
}

TEST(LuaParts, HardCase02OfFullTilesHasNoCodeOfCurves) {
  const auto loaded = load_level(source_path("assets/hard_cases/02-floor-of-tiles.talus.json"));
  ASSERT_TRUE(loaded);
  EXPECT_FALSE(std::regex_search(code_of(loaded->level), std::regex("curve|stretch|slope")));
}

// ---- How it is written ----

TEST(LuaParts, SmallCodeHasNoCommentsAndIndents) {
  EXPECT_EQ(
      join_lua({"-- Head.\nlocal a = 1  -- px\n", "\n-- More.\nif a then\n  a = 2 - -a * \"b  c\"\nend\n"}),
      "-- Head.\nlocal a=1\nif a then\na=2- -a*\"b  c\"\nend\n");
}

TEST(LuaParts, BriefCodeHasAShortLineForEachComment) {
  EXPECT_EQ(
      brief_lua(
          {"-- ---- Title ----\n-- More.\n\nlocal a = 1  -- px\n",
           "-- What it is, and\n-- what e.g. not. Another one.\nif a then\n    -- Deep\n    a = 2\nend\n"}),
      "-- ---- Title ----\n\nlocal a = 1  -- px\n-- What it is, and what e.g. not.\nif a then\n  -- Deep\n  "
      "a = 2\nend\n");
}

TEST(LuaParts, ACartIsToBeReadAsFarAsItFits) {
  const std::string runtime =
      "\n-- Whether the box is inside of the ground by more than rounding.\nlocal function "
      "overlaps_ground(terrain, x, y, w, h, is_centre)\n local forgiven = ";
  const std::string game =
      "\n-- The top left corner of what is shown.\nlocal function view()\n local bodies = ";
  const std::string small_game = "\nlocal function view()\nlocal bodies=";
  const Level curves = load_level(source_path("assets/hard_cases/38-quarter-pipe.talus.json"))->level;
  const auto has = [&](const Level& level, std::initializer_list<std::string> texts,
                       const std::string& dropped, std::string_view parts = {}) {
    const Exported cart = exported(level, "tic-text-playable", parts);
    EXPECT_LE(cart.code_bytes, kMaxTicCode);
    for (const std::string& text : {runtime, game, small_game})
      EXPECT_EQ(cart.files.front().bytes.find(text) != std::string::npos,
                std::find(texts.begin(), texts.end(), text) != texts.end())
          << text;
    EXPECT_EQ(cart.dropped.empty() ? "" : cart.dropped.front().substr(0, dropped.size()), dropped);
  };
  has(flat_level(), {runtime, game}, "");
  has(flat_level(BodyKind::player), {runtime, game}, "");
  has(with_slope(flat_level()), {game},
      "comments, indentation and long names of what moves the bodies: with them");
  has(curves, {small_game}, "comments, indentation and long names of the code: with them the code has ",
      "mouse");
}

TEST(LuaParts, ACartHasTheMouseOnlyForBodiesWithoutKeys) {
  const auto has_mouse = [](const Level& level, std::string_view parts = {}) {
    const std::string cart = exported(level, "tic-text-playable", parts).files.front().bytes;
    const bool has = cart.find("grabbed") != std::string::npos;
    EXPECT_EQ(cart.find("local function take_mouse(") != std::string::npos, has);
    EXPECT_EQ(cart.find("the mouse drags") != std::string::npos, has);
    return has;
  };
  EXPECT_FALSE(has_mouse(Level()));
  EXPECT_FALSE(has_mouse(flat_level(BodyKind::player)));
  EXPECT_TRUE(has_mouse(flat_level(BodyKind::player), "mouse"));
  EXPECT_TRUE(has_mouse(flat_level()));
  Level tiles = flat_level(BodyKind::player);
  tiles.roles.ball = 1;
  tiles.sheet(SheetId::tiles).flags[5] = 2;
  tiles.map.set({5, 0}, 5);
  EXPECT_TRUE(has_mouse(tiles));
}

TEST(LuaParts, FoldersHaveTheModuleInReadableForm) {
  for (const char* id : {"love", "lua-runtime"}) {
    const std::string text = exported(with_slope(flat_level()), id).files.front().bytes;
    const std::string parts = std::string(id) == "love"
                                  ? "slopes, balls, sides, pairs, mouse, events, steer, data"
                                  : "slopes, balls, sides, events, steer, data";
    EXPECT_NE(text.find("\n--\n-- The parts of this module: " + parts + ".\n\n"), std::string::npos) << id;
    for (const char* file : {"terrain", "cast", "slopes", "balls", "module"}) {
      const std::string part = read_asset("runtime/" + std::string(file) + ".lua").value();
      EXPECT_EQ(part.find("-- ---- "), 0U) << file;
      EXPECT_NE(text.find("\n\n\n" + part), std::string::npos) << file;
    }
  }
}

TEST(LuaLevel, HasALineForEachRowTileAndBody) {
  Level level = with_slope(flat_level());
  level.map.set({7, 0}, 200);
  level.curves.push_back({"", {Segment{{8, 8}, {16, 8.5}}, Curve::Faces::both}, ""});
  level.spawns[0].name = "a \"b\"\n";
  const std::string text = lua_level(level);
  const std::string begin =
      "-- A level made with Talus, for talus.lua or bump_slopes.lua. Lengths in px.\n"
      "return {\n"
      "  width = 8,\n"
      "  height = 4,\n"
      "  background = {26, 28, 44, 255},\n"
      "  tiles = {\n"
      "    0,0,0,0,0,0,0,200,\n"
      "    0,0,0,0,0,0,0,0,\n"
      "    0,0,2,0,0,0,0,0,\n"
      "    1,1,1,1,1,1,1,1,\n"
      "  },\n"
      "  shapes = {\n"
      "    [1] = {kind = \"solid\"},\n"
      "    [2] = {kind = \"slope\", heights = {0, 8}},\n"
      "  },\n"
      "  balls = {},\n"
      "  curves = {\n"
      "    {kind = \"segment\", x0 = 8, y0 = 8, x1 = 16, y1 = 8.5, faces = \"both\"},\n"
      "  },\n"
      "  spawns = {\n"
      "    {kind = \"ball\", name = \"a \\034b\\034\\010\", x = 16, y = 8, w = 8, h = 8, vx = 0, vy = 0, "
      "foot = "
      "\"box\"},\n"
      "  },\n"
      "  kinds = {\n"
      "    [\"ball\"] = {rule = \"fall\", w = 8, h = 8, foot = \"box\", look = \"tile\"},\n"
      "    [\"player\"] = {rule = \"run\", takes_keys = true, w = 8, h = 8, foot = \"centre\", look = "
      "\"figure\"},\n"
      "    [\"crate\"] = {rule = \"fall\", w = 8, h = 8, foot = \"box\", look = \"crate\"},\n"
      "    [\"disc\"] = {rule = \"fall\", w = 8, h = 8, foot = \"box\", look = \"wheel\", round = true},\n"
      "    [\"marble\"] = {rule = \"fall\", w = 8, h = 8, foot = \"box\", look = \"marble\", round = true},\n"
      "  },\n"
      "  tuning = {\n";
  EXPECT_EQ(text.substr(0, begin.size()), begin);
  EXPECT_NE(text.find("\n    fall_speed = 5,\n"), std::string::npos);
  const std::string end =
      "\n  },\n  objects = {},\n  roles = {solid = 0, up_slope = 2, down_slope = 3, ball = 1},\n"
      "  parts = {\"slopes\", \"segments\", \"balls\", \"sides\"},\n}\n";
  EXPECT_EQ(text.substr(text.size() - end.size()), end);
}

TEST(LuaLevel, IsOneLineInACart) {
  const std::string text = lua_level(with_slope(flat_level()), LuaForm::small);
  EXPECT_EQ(
      text.find(
          "return {width=8,height=4,shapes={[1]={kind=\"solid\"},[2]={kind=\"slope\",heights={0,8}}},balls"),
      0U)
      << text;
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  EXPECT_NE(text.find(",spawns={{kind=\"ball\",x=16,y=8}},"), std::string::npos) << text;
  EXPECT_EQ(text.find("parts"), std::string::npos);
}

// ---- What a module says of missing parts ----

class LuaModule : public FolderTest {
 protected:
  // The output of a game with the level's module and the chosen parts.
  std::string run(const Level& level, const std::string& game, std::string_view parts = {}) {
    for (const ExportedFile& file : exported(level, "lua-runtime", parts).files) put(file.name, file.bytes);
    put("game.lua",
        "local talus, level = require 'talus', require 'level'\nlocal world = talus.new(level)\n"
        "local function try(what, ...) print(select(2, pcall(what, ...))) end\n" +
            game);
    return output_of("cd '" + folder_.string() + "' && lua5.3 game.lua 2>&1");
  }
};

TEST_F(LuaModule, AnUnknownKindOfBodyIsAnError) {
  const std::string add = "try(world.add, world, {kind = 'plyer', x = 8, y = 8})";
  EXPECT_EQ(run(flat_level(), add), "no kind \"plyer\"; this level has ball, crate, disc, marble, player\n");
}

TEST_F(LuaModule, ABodyWhosePartIsLeftOutIsAnError) {
  const std::string add =
      "level.tuning.bodies = 'pass'\nworld = talus.new(level)\n"
      "try(world.add, world, {kind = 'player', x = 40, y = 8})\nprint(#world.bodies)";
  EXPECT_EQ(run(flat_level(), add),
            "no part of this module moves bodies of the kind \"player\": name it in the export\n1\n");
  EXPECT_EQ(run(flat_level(), add, "players").substr(0, 6), "table:");
}

TEST_F(LuaModule, ASecondBodyNeedsThePartThatBlocksBodies) {
  const std::string game =
      "try(function() world:add {kind = 'ball', x = 16, y = -8} end)\n"
      "for _ = 1, 200 do world:step() end\n"
      "for _, b in ipairs(world.bodies) do print(b.y) end";
  EXPECT_EQ(
      run(flat_level(), game),
      "game.lua:4: a second body takes the part pairs, as bodies block one another here: name it in the "
      "export, or set bodies in the level's tuning to pass\n16.0\n");
  EXPECT_EQ(run(flat_level(), game, "pairs"), "\n16.0\n8.0\n");
}

TEST_F(LuaModule, ALevelWithoutItsPartsIsAnError) {
  const std::string game =
      "level.parts = {'balls', 'curves'}\ntry(talus.new, level)\nprint(talus.parts.balls)";
  EXPECT_EQ(run(flat_level(), game), "the level needs a part that is not in this module: curves\ntrue\n");
}

}  // namespace talus::lua_parts_test
