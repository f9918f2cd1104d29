// Moving and pasting the map's selection, and its clipboard.
#include "edit/map_selection.h"

#include <gtest/gtest.h>

#include "edit/map_stroke.h"
#include "map_text.h"
#include "session/editing/map_clipboard.h"
#include "session/session.h"

namespace talus::map_selection_test {

using Tiles = SelectionChange::Tiles;

// A session on a small map with a selection.
class MapSelection : public ::testing::Test {
 protected:
  void open(const MapRows& rows, std::optional<CellRect> selection) {
    session_ = std::make_unique<Session>(level_of_rows(rows));
    session_->apply(action::SelectCells{selection});
  }
  void move(int dx, int dy, bool leave_copy = false) {
    const MovedCells moved =
        move_selection(session_->level(), session_->history(), *session_->choices().selection, {dx, dy},
                       session_->next_stroke(), leave_copy);
    session_->apply(action::EditLevel{moved.edit, moved.stroke});
  }
  void paste(Cell at, const Stamp& tiles) {
    session_->apply(action::EditLevel{
        paste_cells(session_->level(), at, tiles, session_->choices().selection), session_->next_stroke()});
  }
  MapRows rows() const { return rows_of(session_->level().map); }
  std::optional<CellRect> selection() const { return session_->choices().selection; }
  std::size_t entries() const { return session_->history().position(); }

  std::unique_ptr<Session> session_;
};

TEST_F(MapSelection, IsCutAtTheMapsEdge) {
  open({"...", "..."}, CellRect{1, -1, 9, 2});
  EXPECT_EQ(selection(), (CellRect{1, 0, 2, 1}));
  session_->apply(action::SelectCells{CellRect{3, 0, 1, 1}});
  EXPECT_EQ(selection(), std::nullopt);
}

TEST_F(MapSelection, MoveRestoresTheCellsThatItCrossed) {
  open({"abc.."}, CellRect{0, 0, 2, 1});
  move(1, 0);
  EXPECT_EQ(rows(), MapRows{".ab.."}) << "the c is covered";
  move(1, 0);
  EXPECT_EQ(rows(), MapRows{"..ab."});
  move(1, 0);
  EXPECT_EQ(rows(), MapRows{"..cab"}) << "and comes back";
  EXPECT_EQ(selection(), (CellRect{3, 0, 2, 1}));
  EXPECT_EQ(entries(), 1u);
  session_->apply(action::Undo{});
  EXPECT_EQ(rows(), MapRows{"abc.."});
  EXPECT_EQ(selection(), (CellRect{0, 0, 2, 1})) << "the selection goes back too";
  session_->apply(action::Redo{});
  EXPECT_EQ(rows(), MapRows{"..cab"});
  EXPECT_EQ(selection(), (CellRect{3, 0, 2, 1}));
}

TEST_F(MapSelection, MoveStopsAtTheMapsEdge) {
  open({"a..", "..."}, CellRect{0, 0, 2, 1});
  move(9, 9);
  EXPECT_EQ(rows(), (MapRows{"...", ".a."}));
  EXPECT_EQ(selection(), (CellRect{1, 1, 2, 1}));
}

TEST_F(MapSelection, MoveBackToTheStartLeavesNoEntry) {
  open({"a.."}, CellRect{0, 0, 1, 1});
  move(1, 0);
  move(-1, 0);
  EXPECT_EQ(entries(), 0u);
  EXPECT_FALSE(session_->modified());
}

TEST_F(MapSelection, AnotherEditDropsTheSelection) {
  open({"a.b."}, CellRect{0, 0, 1, 1});
  move(2, 0);
  session_->apply(action::EditLevel{paint_stamp(session_->level(), {3, 0}, {1, 1, {3}})});
  move(-1, 0);
  EXPECT_EQ(rows(), MapRows{".a.c"}) << "b was covered for good";
  EXPECT_EQ(entries(), 3u);
}

TEST_F(MapSelection, CopyLeavesTheOriginalAndMovesTheCopy) {
  open({"ab..."}, CellRect{0, 0, 2, 1});
  move(1, 0, true);
  EXPECT_EQ(rows(), MapRows{"aab.."});
  move(2, 0);
  EXPECT_EQ(rows(), MapRows{"ab.ab"});
  EXPECT_EQ(entries(), 1u);
}

TEST_F(MapSelection, PastedTilesAreSelectedAndRestoreWhatTheyCover) {
  open({"cccc", "...."}, std::nullopt);
  paste({1, 0}, {2, 1, {1, 2}});
  EXPECT_EQ(rows(), (MapRows{"cabc", "...."}));
  EXPECT_EQ(selection(), (CellRect{1, 0, 2, 1}));
  move(0, 1);
  EXPECT_EQ(rows(), (MapRows{"cccc", ".ab."}));
  EXPECT_EQ(entries(), 1u);
  session_->apply(action::Undo{});
  EXPECT_EQ(selection(), std::nullopt);
}

TEST_F(MapSelection, PasteIsCutAtTheEdge) {
  open({"..", ".."}, std::nullopt);
  paste({1, -1}, {2, 2, {1, 2, 3, 4}});
  EXPECT_EQ(rows(), (MapRows{".c", ".."}));
  EXPECT_EQ(selection(), (CellRect{1, 0, 1, 1}));
  EXPECT_FALSE(paste_cells(session_->level(), {5, 5}, {1, 1, {1}}, {}).selection);
}

// The edit is so large that it is a copy of the map. The cells under it must come back nevertheless.
TEST_F(MapSelection, LargeMovesRestoreCellsToo) {
  Level level;
  level.map = TileMap(60, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) level.map.set({x, y}, static_cast<TileNumber>(1 + (x + 7 * y) % 200));
  session_ = std::make_unique<Session>(level);
  session_->apply(action::SelectCells{CellRect{0, 0, 30, 40}});
  for (int i = 0; i < 30; ++i) move(1, 0);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 30; ++x) {
      ASSERT_EQ(session_->level().map.at({x, y}), 0);
      ASSERT_EQ(session_->level().map.tile_at({x + 30, y}), level.map.tile_at({x, y}));
    }
  }
  for (int i = 0; i < 30; ++i) move(-1, 0);
  EXPECT_EQ(session_->level().map, level.map);
  EXPECT_EQ(entries(), 0u);
}

TEST_F(MapSelection, AnotherLevelEndsItASmallerMapCutsIt) {
  open({"....", "...."}, CellRect{1, 0, 3, 2});
  session_->apply(action::EditLevel{Edit{"Resize", {MapChange{session_->level().map, TileMap(2, 1)}}}});
  EXPECT_EQ(selection(), (CellRect{1, 0, 1, 1}));
  session_->apply(action::NewLevel{});
  session_->apply(action::AnswerQuestion{action::Answer::discard});
  EXPECT_EQ(selection(), std::nullopt);
}

// A text as TIC-80 writes it: the low digit of each byte comes first.
TEST(MapClipboard, HasTheFormOfTic80) {
  EXPECT_EQ(text_of_cells({3, 2, {0, 1, 16, 255, 35, 2}}), "3020001001ff3220");
  EXPECT_EQ(cells_of_text("3020001001ff3220"), (Stamp{3, 2, {0, 1, 16, 255, 35, 2}}));
  EXPECT_EQ(cells_of_text(" 1010\n FF "), (Stamp{1, 1, {255}})) << "white space and capitals";
}

TEST(MapClipboard, LargerThanAByteHasALineOfItsOwn) {
  Stamp wide{300, 1, std::vector<MapCell>(300, 7)};
  wide.tiles[299] = 0x21;
  const std::string text = text_of_cells(wide);
  EXPECT_EQ(text.substr(0, 12), "map 300x1\n70");
  EXPECT_EQ(text.substr(text.size() - 2), "12");
  EXPECT_EQ(cells_of_text(text), wide);
  const Stamp most{255, 1, std::vector<MapCell>(255, 1)};
  EXPECT_EQ(text_of_cells(most).substr(0, 4), "ff10");
  EXPECT_EQ(cells_of_text(text_of_cells(most)), most);
}

TEST(MapClipboard, RefusesTextThatIsNoMap) {
  EXPECT_EQ(cells_of_text("").error(), "the clipboard is empty");
  EXPECT_EQ(cells_of_text(" \n").error(), "the clipboard is empty");
  for (const char* text : {"hello", "10", "1010", "101", "20100", "1010ff00", "0010ff", "map 3x",
                           "map 2x1\n1g00", "map -1x-1\n10", "map 99999999x99999999\n10", "map 2x1"})
    EXPECT_EQ(cells_of_text(text).error(), "the clipboard holds no tiles of a map") << text;
}

}  // namespace talus::map_selection_test
