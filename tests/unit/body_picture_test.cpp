// Pictures of bodies: their frames, in files, in games, and where tiles get other numbers.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <talus/sim/body_act.h>
#include "edit/body_frames.h"
#include "export/exporter.h"
#include "export/lua_level.h"
#include "folder_test.h"
#include "level/merge.h"
#include "level/tile_renumber.h"
#include "paths.h"
#include "program_output.h"

namespace talus::body_picture_test {

using testing::ElementsAre;
using testing::HasSubstr;

BodyPicture walking() {
  BodyPicture picture;
  picture.columns = 2;
  picture.rows = 3;
  picture.steps = 4;
  picture[BodyAct::stand] = {32, 1};
  picture[BodyAct::run] = {34, 3};
  return picture;
}

BodyPicture walking_of_sprites() {
  BodyPicture picture = walking();
  picture.sheet = SheetId::sprites;
  return picture;
}

Level level_with(const BodyPicture& picture) {
  Level level;
  level.spawns.push_back({.name = "hero", .position = {8, 8}, .velocity = {}, .extra = ""});
  level.spawns[0].kind = BodyKind::player;
  level.spawns[0].picture = picture;
  return level;
}

TEST(BodyPicture, EachActHasItsFramesOrOthersInstead) {
  const BodyPicture picture = walking();
  EXPECT_FALSE(picture.empty());
  EXPECT_EQ(frame_tile(picture, BodyAct::stand, 100), 32);
  EXPECT_EQ(frame_tile(picture, BodyAct::run, 0), 34);
  EXPECT_EQ(frame_tile(picture, BodyAct::run, 3), 34);
  EXPECT_EQ(frame_tile(picture, BodyAct::run, 4), 36);
  EXPECT_EQ(frame_tile(picture, BodyAct::run, 11), 38);
  EXPECT_EQ(frame_tile(picture, BodyAct::run, 12), 34);
  EXPECT_EQ(frame_tile(picture, BodyAct::jump, 50), 32) << "as it stands";
  BodyPicture falling;
  falling[BodyAct::fall] = {7, 1};
  EXPECT_EQ(frame_tile(falling, BodyAct::stand, 0), 7) << "the only frames";
  EXPECT_TRUE(BodyPicture().empty());
}

TEST(BodyPicture, TilesAreThoseOnTheSheet) {
  BodyPicture picture;
  picture.rows = 2;
  picture[BodyAct::run] = {14, 4};  // two of them lie beside a sheet of 16 columns
  EXPECT_THAT(images_of(picture, {16, 256}), ElementsAre(14, 15, 30, 31));
  EXPECT_THAT(images_of(picture, {16, 20}), ElementsAre(14, 15));
  EXPECT_TRUE(images_of(picture, {4, 8}).empty());
}

TEST(BodyPicture, FollowsWhatTheBodyDoes) {
  Body body;
  EXPECT_EQ(act_of(body), BodyAct::stand);
  body.velocity = {-1, 0};
  EXPECT_EQ(act_of(body), BodyAct::run);
  body.velocity = {-1, 0.5};
  EXPECT_EQ(act_of(body), BodyAct::fall);
  body.gait.grounded = true;
  EXPECT_EQ(act_of(body), BodyAct::run) << "downhill";
  body.gait.grounded = false;
  body.velocity.y = -2;
  EXPECT_EQ(act_of(body), BodyAct::jump);
}

TEST(BodyPicture, FirstFramesAreAsWideAsTheBody) {
  Level level = level_with({});
  level.spawns[0].size = {12, 20};
  auto made = with_frames(level, level.spawns[0], BodyAct::run, {SheetId::tiles, {4, 2, 6, 3}});
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(made->columns, 2);
  EXPECT_EQ(made->rows, 3);
  EXPECT_EQ((*made)[BodyAct::run], (BodyFrames{2 * 16 + 4, 3}));
  level.spawns[0].picture = *made;
  made = with_frames(level, level.spawns[0], BodyAct::stand, {SheetId::tiles, {0, 2, 2, 3}});
  ASSERT_TRUE(made);
  EXPECT_EQ((*made)[BodyAct::stand], (BodyFrames{2 * 16, 1}));
  EXPECT_EQ((*made)[BodyAct::run].count, 3) << "it stays";
  made = with_frames(level, level.spawns[0], BodyAct::jump, {SheetId::tiles, {0, 2, 2, 2}});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error(),
            "A frame of this body has 2x3 tiles: choose one or more such frames, side by side.");
  level.spawns[0].picture = {};
  level.spawns[0].size = {12, 8};
  made = with_frames(level, level.spawns[0], BodyAct::jump, {SheetId::tiles, {0, 0, 3, 1}});
  EXPECT_EQ(made->columns, 3) << "no two frames of 2 columns";
  level.spawns[0].size = {8, 8};
  made = with_frames(level, level.spawns[0], BodyAct::stand, {SheetId::tiles, {0, 0, 2, 2}});
  EXPECT_EQ((*made)[BodyAct::stand].count, 1) << "a picture that is larger than its box";
  EXPECT_EQ(made->columns, 2);
  const BodyPicture narrow = with_columns(*made, 1);
  EXPECT_EQ(narrow[BodyAct::stand].count, 2);
  EXPECT_EQ(narrow.columns, 1);
}

TEST(BodyPicture, FramesAreOfOneSheet) {
  Level level = level_with({});
  auto made = with_frames(level, level.spawns[0], BodyAct::run, {SheetId::sprites, {3, 0, 2, 1}});
  ASSERT_TRUE(made) << made.error();
  EXPECT_EQ(made->sheet, SheetId::sprites);
  EXPECT_EQ((*made)[BodyAct::run], (BodyFrames{3, 2}));
  level.spawns[0].picture = *made;
  made = with_frames(level, level.spawns[0], BodyAct::stand, {SheetId::tiles, {0, 0, 1, 1}});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error(), "The frames of a body are on one sheet, and this one has sprites.");
}

TEST(BodyPicture, ABodyIsResizedOverWhereItStands) {
  Spawn spawn;
  spawn.position = {10, 20};
  spawn.size = {8, 8};
  const Spawn tall = with_size(spawn, {12, 16});
  EXPECT_EQ(tall.position, (Vec2{8, 12}));
  EXPECT_EQ(tall.size, (Vec2{12, 16}));
  EXPECT_EQ(with_size(spawn, {0, 5000}).size, (Vec2{1, kMaxBodySize}));
}

class BodyPictureFiles : public FolderTest {};

TEST_F(BodyPictureFiles, AreReadAsTheyWereWritten) {
  const Level level = level_with(walking());
  ASSERT_TRUE(save_level(level, *find_format("native"), path("a.talus.json")));
  EXPECT_EQ(load_level(path("a.talus.json"))->level.spawns, level.spawns);
  EXPECT_THAT(bytes_of("a.talus.json"), HasSubstr("\"picture\""));
  ASSERT_TRUE(save_level(level_with({}), *find_format("native"), path("b.talus.json")));
  EXPECT_THAT(bytes_of("b.talus.json"), testing::Not(HasSubstr("picture")));
  const Level sprites = level_with(walking_of_sprites());
  ASSERT_TRUE(save_level(sprites, *find_format("native"), path("c.talus.json")));
  EXPECT_EQ(load_level(path("c.talus.json"))->level.spawns, sprites.spawns);
}

TEST_F(BodyPictureFiles, WhatIsWrongIsSaidInOneSentence) {
  const std::string frames = "must be [tile, frames], with a tile from 0 to 65535 and 1 to 32 frames";
  const std::string size = "must be [columns, rows], each from 1 to 16 tiles";
  for (const auto& [picture, key, wrong] : std::vector<std::array<std::string, 3>>{
           {"7", "", "must be an object"},
           {R"({"stand": [3]})", ".stand", frames},
           {R"({"stand": [3, 0]})", ".stand", frames},
           {R"({"run": [3, 33]})", ".run", frames},
           {R"({"run": [70000, 1]})", ".run", frames},
           {R"({"size": [0, 1]})", ".size", size},
           {R"({"size": [17, 1]})", ".size", size},
           {R"({"steps": 0})", ".steps", "must be a whole number from 1 to 600"},
           {R"({"climb": [1, 1]})", "", "has the key \"climb\", which no picture of a body has"},
           {R"({"sheet": "walls"})", ".sheet", "must be \"sprites\"; without it, it is the tiles"}}) {
    put("w.talus.json", R"({"talus": 1, "spawns": [{"picture": )" + picture + "}]}");
    const auto loaded = load_level(path("w.talus.json"));
    ASSERT_FALSE(loaded) << picture;
    EXPECT_EQ(loaded.error().place, "key spawns[0].picture" + key) << picture;
    EXPECT_EQ(loaded.error().message, wrong) << picture;
  }
}

// A body is an object there; what Tiled has no place for is in the companion.
TEST_F(BodyPictureFiles, StayBesideAMapOfTiled) {
  put("m.tmx",
      "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">"
      "<tileset firstgid=\"1\" name=\"t\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"40\" columns=\"8\"/>"
      "<layer name=\"l\" width=\"2\" height=\"1\"><data encoding=\"csv\">1,0</data></layer></map>");
  LoadedLevel loaded = load_level(path("m.tmx")).value();
  loaded.level.spawns = level_with(walking()).spawns;
  ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
  EXPECT_EQ(load_level(path("m.tmx"))->level.spawns, loaded.level.spawns);
}

TEST(BodyPicture, FollowsItsTilesToOtherNumbers) {
  Level level = level_with(walking());
  std::vector<int> numbers(256);
  for (int i = 0; i < 256; ++i)
    numbers[static_cast<std::size_t>(i)] = i == 32 ? 40 : i == 34 ? -1 : i == 40 ? 32 : i;
  renumber_tiles(level, {16, 256}, numbers);
  EXPECT_EQ(level.spawns[0].picture[BodyAct::stand], (BodyFrames{40, 1}));
  EXPECT_EQ(level.spawns[0].picture[BodyAct::run], BodyFrames()) << "its first tile is gone";
  level.spawns[0].picture = walking_of_sprites();
  renumber_tiles(level, {16, 256}, numbers);
  EXPECT_EQ(level.spawns[0].picture, walking_of_sprites());
}

TEST(BodyPicture, IsMergedWithItsBody) {
  const Level base = level_with({}), mine = level_with(walking());
  Level theirs = base;
  theirs.map.set({3, 3}, 5);
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::theirs);
  EXPECT_TRUE(merged.conflicts.empty());
  EXPECT_EQ(merged.level.spawns, mine.spawns);
  EXPECT_EQ(merged.level.map.tile_at({3, 3}), 5);
}

// Tiled moved the body while it got a picture here.
TEST(BodyPicture, IsMergedWithAPlaceOfTheOtherSide) {
  const Level base = level_with({}), mine = level_with(walking());
  Level theirs = base;
  theirs.spawns[0].position = {99, 8};
  const MergedLevel merged = merge_levels(base, mine, theirs, MergeSide::theirs);
  EXPECT_TRUE(merged.conflicts.empty());
  EXPECT_EQ(merged.level.spawns[0].position, (Vec2{99, 8}));
  EXPECT_EQ(merged.level.spawns[0].picture, walking());
}

TEST(BodyPicture, FramesBesideTheSheetAreNotShown) {
  BodyPicture picture = walking();
  picture[BodyAct::jump] = {14, 3};
  picture[BodyAct::fall] = {60000, 1};
  const BodyPicture shown = on_sheet(picture, {16, 256});
  EXPECT_EQ(shown[BodyAct::stand], picture[BodyAct::stand]);
  EXPECT_EQ(shown[BodyAct::jump].count, 1) << "two columns have room for one frame of 2";
  EXPECT_EQ(shown[BodyAct::fall].count, 0);
  EXPECT_EQ(on_sheet(picture, {16, 48})[BodyAct::stand].count, 0) << "no third row";
  EXPECT_THAT(lua_level(level_with(picture)), HasSubstr("fall = {32, 1}"));
}

TEST(BodyPicture, IsInGamesInLua) {
  EXPECT_THAT(lua_level(level_with(walking())),
              HasSubstr("picture = {columns = 2, rows = 3, steps = 4, stand = {32, 1}, run = {34, 3}, "
                        "jump = {32, 1}, fall = {32, 1}}"));
}

TEST(BodyPicture, OfSpritesSaysSoInGamesInLua) {
  EXPECT_THAT(lua_level(level_with(walking_of_sprites())),
              HasSubstr("picture = {sheet = \"sprites\", columns = 2, rows = 3, steps = 4, stand = {32, 1}"));
}

TEST_F(BodyPictureFiles, GamesHaveTheSheetThatTheyShow) {
  const ReadAsset read = [](const std::string&) -> FormatResult<std::string> { return "return {}"; };
  const auto has_sprites = [&](const Level& level, const char* id) {
    const auto made = find_exporter(id)->make({level, "cave", read});
    EXPECT_TRUE(made) << id;
    return std::any_of(made->files.begin(), made->files.end(),
                       [](const ExportedFile& file) { return file.name == "sprites.png"; });
  };
  for (const char* id : {"love", "bump"}) {
    EXPECT_TRUE(has_sprites(level_with(walking_of_sprites()), id)) << id;
    EXPECT_FALSE(has_sprites(level_with(walking()), id)) << id;
  }
}

TEST_F(BodyPictureFiles, ExportsThatLeaveThemOutSaySo) {
  Level level = level_with(walking());
  level.map.set({3, 3}, 1);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  const ReadAsset read = [this](const std::string& asset) -> FormatResult<std::string> {
    return bytes_of(source_path("assets/") + asset);
  };
  for (const char* id : {"ldtk", "csv", "c", "sti"}) {
    const auto made = find_exporter(id)->make({level, "cave", read});
    ASSERT_TRUE(made) << id << ": " << made.error().message;
    EXPECT_THAT(made->dropped, testing::Contains("the picture of a body")) << id;
  }
}

TEST_F(BodyPictureFiles, PlainDataHaveTheirFrames) {
  const ReadAsset none = [](const std::string&) -> FormatResult<std::string> { return ""; };
  const auto body_of = [&](const BodyPicture& picture) {
    const auto made = find_exporter("json")->make({level_with(picture), "cave", none});
    EXPECT_TRUE(made->dropped.empty());
    return nlohmann::json::parse(made->files[0].bytes)["bodies"][0];
  };
  EXPECT_EQ(body_of(walking())["picture"],
            nlohmann::json::parse(R"({"columns": 2, "rows": 3, "steps": 4, "stand": [32, 1], "run": [34, 3],
                            "jump": [32, 1], "fall": [32, 1]})"));
  EXPECT_EQ(body_of(walking_of_sprites())["picture"]["sheet"], "sprites");
  EXPECT_FALSE(body_of({}).contains("picture"));
  BodyPicture beside;
  beside[BodyAct::stand] = {300, 1};
  EXPECT_FALSE(body_of(beside).contains("picture")) << "its frames leave the sheet";
}

// assets/templates/frames.lua chooses as the program does.
TEST_F(BodyPictureFiles, GamesInLuaShowTheSameFrames) {
  std::string script =
                  "local frames = dofile([[" + source_path("assets/templates/frames.lua") +
                  "]])\nlocal picture = {columns = 2, rows = 3, steps = 4, stand = {32, 1}, run = {34, 3}, "
                  "jump = {32, 1}, fall = {32, 1}}\nlocal body = {picture = picture}\n",
              wanted;
  const BodyPicture picture = walking();
  bool looks_left = false;
  int step = 0;
  for (const auto& [vx, vy, grounded] : std::vector<std::tuple<double, double, bool>>{
           {0, 0, true}, {-1.5, 0.75, true}, {0, 0, true}, {0.01, 3, false}, {2, -3, false}, {2, 0, false}}) {
    step += 5;
    Body body;
    body.velocity = {vx, vy};
    body.gait.grounded = grounded;
    if (vx != 0) looks_left = vx < 0;
    wanted += std::to_string(frame_tile(picture, act_of(body), step)) + (looks_left ? " left\n" : " right\n");
    script += "body.vx, body.vy, body.grounded = " + std::to_string(vx) + ", " + std::to_string(vy) + ", " +
              (grounded ? "true" : "false") + "\ndo local tile, left = frames(body, " + std::to_string(step) +
              ") print(string.format('%d %s', tile, left and 'left' or 'right')) end\n";
  }
  put("frames_test.lua", script);
  for (const char* const lua : {"lua5.3", "luajit"})
    EXPECT_EQ(output_of(std::string(lua) + " '" + path("frames_test.lua") + "'"), wanted) << lua;
}

}  // namespace talus::body_picture_test
