// Another program makes the map larger or smaller at its left or top: what was added here stays over its
// ground.
#include <gmock/gmock.h>

#include <filesystem>

#include "folder_test.h"
#include "ldtk_text.h"
#include "level/merge.h"
#include "level/moved_ground.h"
#include "session/session.h"

namespace talus::moved_ground_test {

namespace act = action;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kChunk = R"(<chunk x="0" y="0" width="2" height="2">1,2,3,4</chunk>)";
constexpr const char* kLeft = R"(<chunk x="-2" y="0" width="2" height="2">1,2,3,4</chunk>)";
constexpr const char* kAbove = R"(<chunk x="0" y="-2" width="2" height="2">4,3,2,1</chunk>)";

std::string map_of(const std::string& size, const std::string& data, int object_x, const std::string& more,
                   int object_y = 5) {
  return "<map version=\"1.10\" orientation=\"orthogonal\" tilewidth=\"16\" tileheight=\"16\" " + size +
         more +
         "><tileset firstgid=\"1\" name=\"t\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"8\" "
         "columns=\"4\"/><layer id=\"1\" name=\"l\" " +
         size + "><data encoding=\"csv\">" + data +
         "</data></layer><objectgroup name=\"o\"><object id=\"3\" x=\"" + std::to_string(object_x) +
         "\" y=\"" + std::to_string(object_y) + "\" width=\"4\" height=\"4\"/></objectgroup></map>";
}
std::string infinite(const std::string& chunks) {
  return map_of(R"(width="4" height="4")", chunks, 40, R"( infinite="1")");
}
std::string finite(int width, int height, const std::string& cells, int object_x = 12, int object_y = 5) {
  return map_of("width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"", cells,
                object_x, "", object_y);
}

class MovedGround : public FolderTest {
 protected:
  void open(const std::string& name) {
    session_.apply(act::OpenFile{path(name)});
    if (session_.level_import()) session_.apply(act::ApplyLevelImport{});
    session_.apply(act::DismissMessage{});
  }
  void paint(Cell cell, TileNumber tile) {
    session_.apply(act::EditLevel{Edit{"Paint", {CellChange{cell, level().map.tile_at(cell), tile}}}});
  }
  // Saves a level with a body, a curve and other physics, which begins at the left of its map.
  void save_additions(const std::string& name) const {
    auto loaded = load_level(path(name));
    ASSERT_TRUE(loaded) << to_string(loaded.error(), name);
    Level& level = loaded->level;
    level.spawns.push_back({.name = "Bo", .position = {3.3, 2}, .velocity = {1, 0}, .extra = R"({"k":1})"});
    level.curves.push_back({"bump", {Segment{{0, 16}, {16, 8}}, Curve::Faces::up}, R"({"k":1})"});
    level.tuning.exact.gravity *= 2;
    ASSERT_TRUE(save_level(level, *loaded->format, path(name), loaded->companion));
  }
  LoadedLevel load(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
  }
  static void expect_moved(const Level& before, const Level& after, Cell by) {
    const Level there = with_moved_ground(before, by, before.map.width() + by.x, before.map.height() + by.y);
    EXPECT_EQ(after.spawns, there.spawns);
    EXPECT_EQ(after.curves, there.curves);
    EXPECT_EQ(after.objects, there.objects);
    EXPECT_EQ(after.tuning, there.tuning);
  }
  const Level& level() const { return session_.level(); }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }
  std::string question() const { return session_.question() ? session_.question()->text : ""; }

  Session session_;
};

TEST_F(MovedGround, UnsavedCellsMoveWithAnInfiniteMap) {
  put("m.tmx", infinite(kChunk));
  open("m.tmx");
  paint({0, 1}, level().map.tile_at({1, 0}));
  put("m.tmx", infinite(std::string(kChunk) + kLeft));
  session_.apply(act::SaveFile{});
  EXPECT_EQ(question(), "") << message();
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(R"(<chunk x="0" y="0" width="2" height="2">1,2,2,4</chunk>)"));
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(kLeft)) << "as Tiled wrote it";
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(R"(x="40" y="5")")) << "the object stays, too";
}

TEST_F(MovedGround, UnsavedCellsMoveUpAndDown) {
  put("m.tmx", infinite(kChunk));
  open("m.tmx");
  paint({0, 1}, level().map.tile_at({1, 0}));
  put("m.tmx", infinite(std::string(kChunk) + kAbove));
  session_.apply(act::SaveFile{});
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(R"(<chunk x="0" y="0" width="2" height="2">1,2,2,4</chunk>)"));
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(kAbove));
}

TEST_F(MovedGround, UndoAndRedoOfTheReadingKeepBoth) {
  put("m.tmx", infinite(kChunk));
  open("m.tmx");
  paint({0, 1}, level().map.tile_at({1, 0}));
  const Level painted = level();
  put("m.tmx", infinite(std::string(kChunk) + kLeft));
  session_.apply(act::CheckFile{});
  const Level both = level();
  EXPECT_EQ(both.map.width(), painted.map.width() + 2);
  session_.apply(act::Undo{});
  EXPECT_EQ(level(), painted);
  session_.apply(act::SaveFile{});
  EXPECT_THAT(message(), HasSubstr("Redo \"Read m.tmx again\""));
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(kLeft)) << "nothing is written into wrong cells";
  session_.apply(act::Redo{});
  EXPECT_EQ(level(), both);
  session_.apply(act::SaveFile{});
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,2,4"));
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(kLeft));
}

TEST_F(MovedGround, UnsavedCellsMoveWithAFiniteMap) {
  put("m.tmx", finite(2, 2, "1,2,3,4"));
  open("m.tmx");
  paint({0, 1}, level().map.tile_at({1, 0}));
  put("m.tmx", finite(4, 3, "0,0,0,0,5,0,1,2,6,0,3,4", 44, 21));
  session_.apply(act::SaveFile{});
  EXPECT_EQ(question(), "") << message();
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("0,0,0,0,5,0,1,2,6,0,2,4"));
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(R"(x="44" y="21")"));
}

TEST_F(MovedGround, ACellThatTheMapLosesIsAskedAbout) {
  put("m.tmx", finite(4, 2, "1,2,3,4,5,6,7,8"));
  open("m.tmx");
  paint({0, 1}, level().map.tile_at({1, 0}));
  put("m.tmx", finite(2, 2, "3,4,7,8"));
  session_.apply(act::CheckFile{});
  EXPECT_THAT(question(), HasSubstr("1 cell that the map no longer has"));
}

TEST_F(MovedGround, AMapThatGrowsAtItsRightStays) {
  put("m.tmx", finite(2, 2, "1,2,3,4"));
  open("m.tmx");
  paint({0, 1}, level().map.tile_at({1, 0}));
  put("m.tmx", finite(4, 2, "1,2,1,2,3,4,3,4"));
  session_.apply(act::SaveFile{});
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,1,2,2,4,3,4")) << message();
}

TEST_F(MovedGround, ACompanionMovesWithAnInfiniteMap) {
  put("m.tmx", infinite(kChunk));
  save_additions("m.tmx");
  const Level before = load("m.tmx").level;
  std::string text = bytes_of("m.tmx");
  text.insert(text.find(kChunk), std::string(kLeft) + kAbove);
  put("m.tmx", text);
  LoadedLevel after = load("m.tmx");
  EXPECT_EQ(after.note,
            "m.tmx begins 2 columns further left and 2 rows further up than it did, so what was added to it "
            "has moved with its ground");
  EXPECT_TRUE(after.companion.content) << "all of it was read";
  expect_moved(before, after.level, {2, 2});
  ASSERT_TRUE(save_level(after.level, *after.format, path("m.tmx"), after.companion));
  const LoadedLevel again = load("m.tmx");
  EXPECT_EQ(again.note, "");
  EXPECT_EQ(again.level, after.level);
}

TEST_F(MovedGround, ACompanionMovesWithAFiniteMap) {
  put("m.tmx", finite(3, 2, "1,2,3,0,4,5"));
  save_additions("m.tmx");
  const Level before = load("m.tmx").level;
  put("m.tmx", finite(5, 3, "0,0,0,0,0,7,0,1,2,3,0,0,0,4,5", 44, 21));
  const LoadedLevel after = load("m.tmx");
  EXPECT_THAT(after.note, HasSubstr("2 columns further left and 1 row further up"));
  expect_moved(before, after.level, {2, 1});
}

TEST_F(MovedGround, ALevelWithACompanionIsReadAgainInPlace) {
  put("m.tmx", infinite(kChunk));
  save_additions("m.tmx");
  open("m.tmx");
  const Level before = level();
  paint({0, 1}, level().map.tile_at({1, 0}));
  put("m.tmx", infinite(std::string(kChunk) + kLeft));
  session_.apply(act::SaveFile{});
  EXPECT_EQ(question(), "") << message();
  expect_moved(before, level(), {2, 0});
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,2,4"));
  EXPECT_EQ(load("m.tmx").level, level());
}

TEST_F(MovedGround, CurvesThatLeaveTheMapAreKeptAside) {
  put("m.tmx", finite(3, 2, "1,2,3,0,4,5"));
  save_additions("m.tmx");
  put("m.tmx", finite(2, 2, "2,3,4,5", 0));
  LoadedLevel after = load("m.tmx");
  EXPECT_THAT(after.note, HasSubstr("1 curve would leave the map and is left out"));
  ASSERT_EQ(after.level.spawns.size(), 1u) << "bodies may be beside the map";
  const auto saved = save_level(after.level, *after.format, path("m.tmx"), after.companion);
  ASSERT_TRUE(saved);
  EXPECT_THAT(saved->note, HasSubstr("kept as m.tmx.talus-kept1.json"));
}

// One of each form, within 32x32 px, of numbers that no file has in few digits.
std::vector<LevelCurve> exact_curves() {
  const double third = 1.0 / 3;
  const auto curve = [](const char* name, decltype(Curve::form) form) {
    return LevelCurve{name, {std::move(form), Curve::Faces::up}, ""};
  };
  return {curve("arc", Arc{{16 + third, 20 + third}, 11 + third, 6 + third, 24 + third, true}),
          curve("sine", Sine{third, 30 + third, 10 + third, 3 + third, 17 + third, 2 + third}),
          curve("line", Polyline{third, 24 + third, {20 + third, 12, 25 + third, 22}}),
          curve("parabola", Parabola{{third, 20 + third}, {20 + third, 18}, 8 + third}),
          curve("cubic", Cubic{{third, 16 + third}, {25 + third, 18}, third, -third}),
          curve("ramp", Segment{{third, 16 + third}, {16 + third, 8}})};
}

// In the map itself, and with a key that only a companion holds.
TEST_F(MovedGround, ExactCurvesMoveOnceWithAnInfiniteMap) {
  for (const std::string extra : {"", R"({"k":1})"}) {
    std::filesystem::remove(path("m.tmx.talus.json"));
    put("m.tmx", infinite(kChunk));
    LoadedLevel first = load("m.tmx");
    first.level.curves = exact_curves();
    first.level.curves[1].extra = extra;
    ASSERT_TRUE(save_level(first.level, *first.format, path("m.tmx"), first.companion));
    EXPECT_EQ(exists("m.tmx.talus.json"), !extra.empty());
    const Level before = load("m.tmx").level;
    ASSERT_EQ(before.curves, first.level.curves);
    std::string text = bytes_of("m.tmx");
    text.insert(text.find(kChunk), std::string(kLeft) + kAbove);
    put("m.tmx", text);
    LoadedLevel after = load("m.tmx");
    EXPECT_EQ(after.level.curves, with_moved_ground(before, {2, 2}, 4, 4).curves) << extra;
    EXPECT_EQ(after.dropped, first.dropped);
    EXPECT_EQ(after.companion.content.has_value(), !extra.empty()) << after.note;
    after.level.curves[0].name = "hill";
    ASSERT_TRUE(save_level(after.level, *after.format, path("m.tmx"), after.companion));
    EXPECT_EQ(load("m.tmx").level.curves, after.level.curves) << extra;
  }
}

// Other programs move the objects alone, and know nothing of their numbers.
TEST_F(MovedGround, ExactCurvesMoveWithTheirObjects) {
  put("m.tmx", finite(4, 2, "1,2,3,4,4,3,2,1"));
  LoadedLevel first = load("m.tmx");
  first.level.curves = exact_curves();
  ASSERT_TRUE(save_level(first.level, *first.format, path("m.tmx"), first.companion));
  std::string text = bytes_of("m.tmx");
  for (const LevelCurve& curve : first.level.curves) {
    const std::size_t at = text.find("name=\"" + curve.name + "\"");
    ASSERT_NE(at, text.npos);
    const std::size_t x = text.find(" x=\"", at) + 4, end = text.find('"', x);
    text.replace(x, end - x, std::to_string(std::stod(text.substr(x, end - x)) + 32));
  }
  put("m.tmx", text);
  EXPECT_EQ(load("m.tmx").level.curves, with_moved_ground(first.level, {2, 0}, 4, 2).curves);
}

// Sums of such numbers differ in their last bits from what the file says.
TEST_F(MovedGround, CurvesOfACompanionMoveOnce) {
  put("m.tmx", infinite(kChunk));
  LoadedLevel first = load("m.tmx");
  for (int i = 0; i < 20; ++i) {
    const double y = 2.1 + 1.37 * i;
    first.level.curves.push_back(
        {"c", {Polyline{0.1 + i * 0.07, 29.3, {y, y + 0.7 / 3, y - 1.1, y + 0.3}}, Curve::Faces::up}, ""});
    first.level.spawns.push_back({.name = "s", .position = {y, 30 - y / 3}, .velocity = {}, .extra = ""});
  }
  first.level.curves[3].extra = first.level.spawns[3].extra = R"({"k":1})";
  ASSERT_TRUE(save_level(first.level, *first.format, path("m.tmx"), first.companion));
  std::string text = bytes_of("m.tmx");
  text.insert(text.find(kChunk), std::string(kLeft) + kAbove);
  put("m.tmx", text);
  const LoadedLevel after = load("m.tmx");
  EXPECT_EQ(after.level.curves.size(), 20u) << after.note;
  EXPECT_EQ(after.level.spawns.size(), 20u) << after.note;
  EXPECT_TRUE(after.companion.content) << after.note;
}

// A map of 8x6 cells with a hill, whose cells another program moved by whole cells, as Tiled's Offset Map
// does.
std::string hill(Cell by, bool is_painted = false) {
  const std::vector<std::string> rows = {"00000000", "00100000", "00000200",
                                         "00345000", "06660000", "00000000"};
  std::string cells;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      const int from_x = x - by.x, from_y = y - by.y;
      const bool is_there = from_x >= 0 && from_x < 8 && from_y >= 0 && from_y < 6;
      const bool is_new = is_painted && from_x == 5 && from_y == 4;
      cells += cells.empty() ? "" : ",";
      cells += is_new     ? '6'
               : is_there ? rows[static_cast<std::size_t>(from_y)][static_cast<std::size_t>(from_x)]
                          : '0';
    }
  }
  return cells;
}

TEST_F(MovedGround, UnsavedCellsMoveInAMapOfTheSameSize) {
  for (const Cell by : {Cell{2, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{2, -1}}) {
    put("m.tmx", finite(8, 6, hill({0, 0})));
    Session session;
    session.apply(act::OpenFile{path("m.tmx")});
    session.apply(act::EditLevel{Edit{
        "Paint",
        {CellChange{{5, 4}, session.level().map.tile_at({5, 4}), session.level().map.tile_at({1, 4})}}}});
    put("m.tmx", finite(8, 6, hill(by), 12 + 16 * by.x, 5 + 16 * by.y));
    session.apply(act::SaveFile{});
    EXPECT_FALSE(session.question()) << session.question()->text;
    EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(">" + hill(by, true) + "<")) << by.x << ", " << by.y;
  }
}

TEST_F(MovedGround, ACompanionMovesInAMapOfTheSameSize) {
  put("m.tmx", finite(8, 6, hill({0, 0})));
  save_additions("m.tmx");
  const Level before = load("m.tmx").level;
  put("m.tmx", finite(8, 6, hill({2, -1}), 12 + 32, 5 - 16));
  const LoadedLevel after = load("m.tmx");
  EXPECT_THAT(after.note,
              HasSubstr("The ground of m.tmx lies 2 columns further right and 1 row further up than "
                        "it did, so what was added to it has moved with its ground"));
  EXPECT_EQ(after.level.map.width(), 8);
  EXPECT_EQ(after.level.spawns, with_moved_ground(before, {2, -1}, 8, 6).spawns);
}

std::string ldtk_of(int left, const std::string& rows) {
  std::string text = ldtk_project(ldtk_level(ldtk_grid(4 + left, 2, rows), "A",
                                             "\"iid\":\"a\",\"worldX\":" + std::to_string(-8 * left) + ","),
                                  R"({"value":1,"identifier":"wall"})");
  text.insert(1, R"("iid":"p",)");
  return text;
}

TEST_F(MovedGround, WhatWasAddedToLdtkMovesWithALevel) {
  put("g.ldtk", ldtk_of(0, "1,0,0,0,1,1,1,1"));
  LoadedLevel first = load("g.ldtk");
  first.level.map.set({2, 0}, first.level.map.tile_at({0, 0}));
  ASSERT_TRUE(save_level(first.level, *first.format, path("g.ldtk"), first.companion));
  save_additions("g.ldtk");
  const Level before = load("g.ldtk").level;
  put("g.ldtk", ldtk_of(2, "0,0,1,0,0,0,0,0,1,1,1,1"));
  const LoadedLevel after = load("g.ldtk");
  EXPECT_THAT(after.note, HasSubstr("2 columns further left"));
  EXPECT_TRUE(after.companion.content) << "all of it was read";
  expect_moved(before, after.level, {2, 0});
  EXPECT_EQ(after.level.map.at({4, 0}), before.map.at({2, 0}));
  EXPECT_EQ(after.level.map.at({2, 0}), before.map.at({0, 0}));
}

// LDtk moves all cells of a level that keeps its size, as it does with the arrow keys.
TEST_F(MovedGround, WhatWasAddedToLdtkMovesInALevelOfItsSize) {
  const auto project = [](Cell by) {
    std::string cells = hill(by);
    for (char& c : cells)
      if (c >= '2' && c <= '9') c = '1';
    return ldtk_project(ldtk_level(ldtk_grid(8, 6, cells), "A", "\"iid\":\"a\",\"worldX\":0,"),
                        R"({"value":1,"identifier":"wall"})")
        .insert(1, R"("iid":"p",)");
  };
  put("g.ldtk", project({0, 0}));
  LoadedLevel first = load("g.ldtk");
  first.level.map.set({5, 4}, first.level.map.tile_at({2, 3}));
  ASSERT_TRUE(save_level(first.level, *first.format, path("g.ldtk"), first.companion));
  save_additions("g.ldtk");
  const Level before = load("g.ldtk").level;
  put("g.ldtk", project({1, 0}));
  const LoadedLevel after = load("g.ldtk");
  EXPECT_THAT(after.note, HasSubstr("The ground of g.ldtk lies 1 column further right"));
  EXPECT_EQ(after.level.spawns, with_moved_ground(before, {1, 0}, 8, 6).spawns);
  EXPECT_EQ(after.level.map.cells().tiles(), with_moved_ground(before, {1, 0}, 8, 6).map.cells().tiles());
}

TEST_F(MovedGround, UnsavedChangesMoveWithALevelOfLdtk) {
  put("g.ldtk", ldtk_of(0, "1,0,0,0,1,1,1,1"));
  open("g.ldtk");
  const TileNumber wall = level().map.tile_at({0, 0});
  paint({2, 0}, wall);
  put("g.ldtk", ldtk_of(2, "0,0,1,0,0,0,0,0,1,1,1,1"));
  session_.apply(act::CheckFile{});
  EXPECT_EQ(question(), "") << message();
  const Level both = level();
  EXPECT_THAT(both.map.cells().tiles(), ElementsAre(0, 0, wall, 0, wall, 0, 0, 0, wall, wall, wall, wall));
  session_.apply(act::Undo{});
  session_.apply(act::SaveFile{});
  EXPECT_THAT(message(), HasSubstr("Redo")) << "its cells would be added at other places";
  session_.apply(act::Redo{});
  session_.apply(act::SaveFile{});
  EXPECT_EQ(load("g.ldtk").level, both);
}

TEST(GroundShift, IsFoundByTheSidesOfWhatIsPainted) {
  Level before;
  before.map = TileMap(40, 30);
  for (int x = 5; x < 30; ++x) before.map.set({x, 20}, 1);
  for (int x = 8; x < 12; ++x) before.map.set({x, 15}, 2);
  const GroundPlace place = ground_place(before);
  EXPECT_LE(place.marks.size(), kMaxGroundMarks);
  Level now = with_moved_ground(before, {3, 7}, 48, 40);
  now.map.set({47, 39}, 1);
  now.map.set({9 + 3, 15 + 7}, 3);  // which another program painted, too
  EXPECT_EQ(ground_shift(place, now), (Cell{3, 7}));
  EXPECT_EQ(ground_shift(place, with_moved_ground(before, {-2, -9}, 38, 21)), (Cell{-2, -9}));
  EXPECT_EQ(ground_shift(place, with_moved_ground(before, {0, 0}, 60, 60)), (Cell{0, 0}));
  Level other;
  other.map = TileMap(50, 40);
  EXPECT_EQ(ground_shift(place, other), (Cell{0, 0})) << "none of it is there";
}

TEST(GroundShift, IsFoundInAMapOfTheSameSize) {
  Level before;
  before.map = TileMap(40, 30);
  for (int x = 0; x < 40; ++x) before.map.set({x, 29}, 1);
  for (int x = 5; x < 30; ++x) before.map.set({x, 20}, x % 2 == 0 ? 1 : 2);
  for (int x = 8; x < 12; ++x) before.map.set({x, 15}, 2);
  const GroundPlace place = ground_place(before);
  for (const Cell by : {Cell{1, 0}, Cell{-4, -9}, Cell{8, 0}, Cell{-3, 2}})
    EXPECT_EQ(ground_shift(place, with_moved_ground(before, by, 40, 30)), by) << by.x << ", " << by.y;
}

// Cells that were painted anew are no shift, also where a pattern repeats itself.
TEST(GroundShift, IsNotSeenInWhatWasPaintedAnew) {
  Level before;
  before.map = TileMap(40, 30);
  for (Cell c{0, 20}; c.y < 30; ++c.y)
    for (c.x = 0; c.x < 40; ++c.x) before.map.set(c, (c.x + c.y) % 2 == 0 ? 1 : 2);
  const GroundPlace place = ground_place(before);
  Level now = before;
  for (int x = 3; x < 20; ++x) now.map.set({x, 19}, x % 2 == 0 ? 1 : 2);
  for (int y = 20; y < 26; ++y) now.map.set({30, y}, 0);
  EXPECT_EQ(ground_shift(place, now), (Cell{0, 0}));
}

TEST(GroundShift, IsSaidInWords) {
  EXPECT_EQ(words_for_shift({2, 0}), "2 columns further left");
  EXPECT_EQ(words_for_shift({-1, 3}), "1 column further right and 3 rows further up");
}

}  // namespace talus::moved_ground_test
