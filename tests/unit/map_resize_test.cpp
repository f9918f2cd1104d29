// The map is made larger and smaller and shifted, with its bodies and curves.
#include "edit/map_resize.h"

#include <gtest/gtest.h>

#include "map_text.h"
#include "session/session.h"

namespace talus::map_resize_test {

Spawn spawn_at_px(Vec2 position) {
  Spawn spawn;
  spawn.position = position;
  return spawn;
}

LevelCurve segment_curve(Vec2 from, Vec2 to) { return {"", {Segment{from, to}, Curve::Faces::up}, ""}; }

std::vector<Vec2> positions(const std::vector<Spawn>& spawns) {
  std::vector<Vec2> all;
  for (const Spawn& spawn : spawns) all.push_back(spawn.position);
  return all;
}

TEST(MapResize, GrowsAndShifts) {
  Level level = level_of_rows({"ab", "cd"});
  level.spawns = {spawn_at_px({1.5, 2})};
  level.curves = {segment_curve({0, 4}, {16, 8})};
  const ResizedMap larger = resized(level, {4, 3, {1, 1}, false});
  EXPECT_EQ(rows_of(larger.map), (MapRows{"....", ".ab.", ".cd."}));
  EXPECT_EQ(positions(larger.spawns), (std::vector<Vec2>{{9.5, 10}}));
  EXPECT_EQ(larger.curves, (std::vector<LevelCurve>{segment_curve({8, 12}, {24, 16})}));
  EXPECT_FALSE(larger.loses());
}

TEST(MapResize, CutsAndCountsWhatIsLost) {
  Level level = level_of_rows({"ab.", "c.d"});
  level.spawns = {spawn_at_px({0, 0}), spawn_at_px({16, 8}), spawn_at_px({15, 8})};
  level.curves = {segment_curve({0, 4}, {16, 4}), segment_curve({0, 4}, {17, 4})};
  const ResizedMap smaller = resized(level, {2, 2, {0, 0}, false});
  EXPECT_EQ(rows_of(smaller.map), (MapRows{"ab", "c."}));
  EXPECT_EQ(smaller.lost_tiles, 1u);
  EXPECT_EQ(positions(smaller.spawns), (std::vector<Vec2>{{0, 0}, {15, 8}})) << "one px of it is on the map";
  EXPECT_EQ(smaller.lost_spawns, 1u);
  EXPECT_EQ(smaller.curves.size(), 1u);
  EXPECT_EQ(smaller.lost_curves, 1u);
  EXPECT_TRUE(smaller.loses());
  EXPECT_EQ(resized(level, {3, 2, {-1, 0}, false}).lost_tiles, 2u);
}

TEST(MapResize, WrappingLosesNothing) {
  Level level = level_of_rows({"abc", "def"});
  level.spawns = {spawn_at_px({16, 8}), spawn_at_px({4, 0})};
  level.curves = {segment_curve({17, 1}, {23, 2})};
  const ResizedMap round = resized(level, {3, 2, {1, -1}, true});
  EXPECT_EQ(rows_of(round.map), (MapRows{"fde", "cab"}));
  EXPECT_EQ(positions(round.spawns), (std::vector<Vec2>{{0, 0}, {12, 8}}));
  EXPECT_EQ(round.curves, (std::vector<LevelCurve>{segment_curve({1, 9}, {7, 10})}));
  EXPECT_FALSE(round.loses());
  EXPECT_EQ(resized(level, {3, 2, {301, -201}, true}).map, round.map);
  EXPECT_EQ(rows_of(resized(level, {5, 2, {3, 0}, true}).map), (MapRows{"c..ab", "f..de"}));
}

TEST(MapResize, CurveThatWouldBeTornByWrappingIsCounted) {
  Level level = level_of_rows({"...", "..."});
  level.curves = {segment_curve({0, 4}, {24, 4})};
  EXPECT_EQ(resized(level, {3, 2, {1, 0}, true}).lost_curves, 1u);
}

TEST(MapResize, BodiesBesideTheMapStayBesideIt) {
  Level level = level_of_rows({"a."});
  level.spawns = {spawn_at_px({-80, -80}), spawn_at_px({-3, 0})};
  const ResizedMap same = resized(level, {2, 1, {0, 0}, true});
  EXPECT_EQ(positions(same.spawns), (std::vector<Vec2>{{-80, -80}, {-3, 0}}));
  EXPECT_FALSE(same.loses());
}

TEST(MapResize, IsOneEntryWithTheSelection) {
  Level level = level_of_rows({"ab", "cd"});
  level.spawns = {spawn_at_px({0, 0})};
  level.curves = {segment_curve({0, 4}, {16, 8})};
  Session session(level);
  session.apply(action::SelectCells{CellRect{1, 1, 1, 1}});
  const MapFrame frame{3, 3, {1, 0}, false};
  session.apply(action::EditLevel{resize_map(session.level(), frame, session.choices().selection)});
  EXPECT_EQ(rows_of(session.level().map), (MapRows{".ab", ".cd", "..."}));
  EXPECT_EQ(session.level().spawns[0].position, (Vec2{8, 0}));
  EXPECT_EQ(session.choices().selection, (CellRect{2, 1, 1, 1}));
  EXPECT_EQ(session.history().edits().size(), 1u);
  EXPECT_EQ(session.history().edits()[0].label, "Resize map");
  session.apply(action::Undo{});
  EXPECT_EQ(session.level(), level);
  EXPECT_EQ(session.choices().selection, (CellRect{1, 1, 1, 1}));
}

TEST(MapResize, TheSameSizeGivesAnEmptyEdit) {
  const Level level = level_of_rows({"a."});
  EXPECT_TRUE(resize_map(level, {2, 1, {0, 0}, false}, {}).empty());
  EXPECT_EQ(resize_map(level, {2, 1, {1, 0}, false}, {}).label, "Shift map");
}

}  // namespace talus::map_resize_test
