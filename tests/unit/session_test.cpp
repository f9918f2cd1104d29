// Session: edits and their history, choices and messages.
#include "session/session.h"
#include "edit/flag_lamps.h"
#include "edit/map_stroke.h"

#include <gtest/gtest.h>

namespace talus::session_test {

namespace act = action;

act::EditLevel painted(const Session& session, Cell at, TileNumber tile, int stroke = 0) {
  return {paint_stamp(session.level(), at, {1, 1, {tile}}), stroke};
}

TEST(Session, BeginsUnmodifiedAndWithoutAName) {
  const Session session;
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(session.file_name(), "untitled");
  EXPECT_EQ(session.path(), "");
  EXPECT_FALSE(session.message() || session.question() || session.wants_save_as() || session.wants_quit());
}

TEST(Session, KnowsItsFileName) {
  const Session session(Level(), "levels/demo.talus.json");
  EXPECT_EQ(session.file_name(), "demo.talus.json");
  EXPECT_EQ(session.path(), "levels/demo.talus.json");
}

TEST(Session, EditUndoRedo) {
  Session session;
  session.apply(painted(session, {1, 1}, 5));
  EXPECT_EQ(session.level().map.at({1, 1}), 5);
  EXPECT_TRUE(session.modified());
  session.apply(act::Undo{});
  EXPECT_EQ(session.level().map.at({1, 1}), 0);
  EXPECT_FALSE(session.modified());
  session.apply(act::Redo{});
  EXPECT_EQ(session.level().map.at({1, 1}), 5);
  EXPECT_EQ(session.history().edits().at(0).label, "Paint tiles");
}

TEST(Session, UndoAndRedoWithoutHistoryDoNothing) {
  Session session;
  session.apply({act::Undo{}, act::Redo{}});
  EXPECT_EQ(session.revision(), 0u);
}

TEST(Session, TheRevisionGrowsWithEveryChange) {
  Session session;
  session.apply(painted(session, {1, 1}, 5));
  EXPECT_EQ(session.revision(), 1u);
  session.apply(act::Undo{});
  EXPECT_EQ(session.revision(), 2u);
  session.apply(act::Redo{});
  EXPECT_EQ(session.revision(), 3u);
  session.apply(painted(session, {1, 1}, 5));
  EXPECT_EQ(session.revision(), 3u) << "nothing changed";
  session.apply({act::Play{}, act::SetGrid{false}});
  EXPECT_EQ(session.revision(), 3u);
  session.apply(act::NewLevel{});
  session.apply(act::AnswerQuestion{act::Answer::discard});
  EXPECT_EQ(session.revision(), 4u);
}

TEST(Session, EachStrokeGetsANumberOfItsOwn) {
  Session session;
  const int first = session.next_stroke();
  EXPECT_GT(first, 0);
  session.apply(painted(session, {1, 1}, 5, first));
  session.apply(painted(session, {2, 1}, 5, first));
  const int second = session.next_stroke();
  EXPECT_NE(second, first);
  session.apply(painted(session, {3, 1}, 5, second));
  EXPECT_EQ(session.history().edits().size(), 2u);
  EXPECT_NE(session.next_stroke(), second);
}

// Ctrl+Z during a stroke: the tool saw the level before the undo, and the undo is carried out first.
TEST(Session, AnEditAfterAnUndoInTheSameBatchIsAdapted) {
  Session session;
  session.apply(painted(session, {1, 1}, 5));
  const act::EditLevel over_five = painted(session, {1, 1}, 6);
  session.apply({act::Undo{}, over_five});
  EXPECT_EQ(session.level().map.at({1, 1}), 6);
  session.apply(act::Undo{});
  EXPECT_EQ(session.level().map.at({1, 1}), 0);
}

TEST(Session, ProblemsFollowTheLevel) {
  Session session;
  const std::vector<Problem>* problems = &session.problems();
  EXPECT_EQ(problems->size(), lint(session.level()).size());
  Edit edit = set_flag(session.level(), {SheetId::tiles, {1, 0, 1, 1}}, 2, true);
  edit.changes.emplace_back(CellChange{{5, 5}, 0, 1});  // an up-slope without its other half
  session.apply(act::EditLevel{edit, 0});
  const std::vector<Problem> expected = lint(session.level());
  ASSERT_FALSE(expected.empty());
  ASSERT_EQ(session.problems().size(), expected.size());
  EXPECT_EQ(session.problems()[0].message, expected[0].message);
}

TEST(Session, ChoicesAreStored) {
  Session session;
  const Stamp stamp{1, 2, {3, 4}};
  session.apply({act::SetStamp{stamp}, act::SetMapTool{MapTool::fill}, act::SetSpriteTool{SpriteTool::pick},
                 act::SetColor{7, false}, act::SetColor{8, true}, act::SetOverlay{&overlay::normals, true},
                 act::SetFlagOverlay{pattern_of_flag(2)}, act::SetGrid{false}, act::SetScreenBorders{false}});
  const Choices& choices = session.choices();
  EXPECT_EQ(choices.stamp, stamp);
  EXPECT_EQ(choices.map_tool, MapTool::fill);
  EXPECT_EQ(choices.sprite_tool, SpriteTool::pick);
  EXPECT_EQ(choices.color, 7);
  EXPECT_EQ(choices.secondary_color, 8);
  EXPECT_TRUE(choices.overlays.has(overlay::normals));
  EXPECT_EQ(choices.flag_overlay, pattern_of_flag(2));
  EXPECT_FALSE(choices.grid);
  EXPECT_FALSE(choices.screen_borders);
  EXPECT_FALSE(session.modified());
}

TEST(Session, SelectedTilesBecomeTheStamp) {
  Session session;
  session.apply(act::SelectTiles{{SheetId::tiles, {2, 1, 2, 2}}});
  EXPECT_EQ(session.choices().area.tiles, (CellRect{2, 1, 2, 2}));
  EXPECT_EQ(session.choices().stamp, (Stamp{2, 2, {18, 19, 34, 35}}));
  session.apply(act::SelectTiles{{SheetId::sprites, {5, 5, 1, 1}}});
  EXPECT_EQ(session.choices().area.sheet, SheetId::sprites);
  EXPECT_EQ(session.choices().stamp, (Stamp{2, 2, {18, 19, 34, 35}}))
      << "sprites cannot be painted on the map";
}

TEST(Session, AMessageStaysUntilReplacedOrDismissed) {
  Session session;
  session.apply(act::ShowMessage{"No gamepad.", true});
  ASSERT_TRUE(session.message());
  EXPECT_EQ(session.message()->text, "No gamepad.");
  EXPECT_TRUE(session.message()->is_error);
  session.apply(act::ShowMessage{"Hello.", false});
  EXPECT_EQ(session.message()->text, "Hello.");
  session.apply(act::DismissMessage{});
  EXPECT_FALSE(session.message());
}

}  // namespace talus::session_test
