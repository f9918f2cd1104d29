// Levels with more tiles than a cart has, in the window: the sheet is moved, and all tiles are painted.
#include "harness.h"

namespace talus::sheet_size_ui_test {

constexpr int kColumns = 20, kTiles = 2000;

class UiSheetSize : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    Level level = test_level();
    level.set_tile_layout({kColumns, kTiles});
    Sheet& sheet = level.sheet(SheetId::tiles);
    for (std::size_t tile = 0; tile < sheet.images.size(); ++tile)
      sheet.images[tile].fill(static_cast<std::uint8_t>(tile * 7 % 16));
    ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
    start(path("level.talus.json"));
    ASSERT_EQ(this->level().tile_count(), kTiles);
  }
  int chosen_tile() { return session().choices().area.tile_at(level(), 0, 0); }
};

TEST_F(UiSheetSize, EachTileIsReached) {
  click(on_sheet(kColumns + 3));
  EXPECT_EQ(chosen_tile(), kColumns + 3);
  click(on_sheet(kTiles - 2));
  EXPECT_EQ(chosen_tile(), kTiles - 2);
  click(on_map({7, 3}));
  EXPECT_EQ(tile_at({7, 3}), kTiles - 2);
}

TEST_F(UiSheetSize, SeveralTilesArePaintedTogether) {
  on_sheet(kTiles - 1);
  const ImVec2 last = on_sheet(kTiles - kColumns - 2);
  drag(on_sheet(kTiles - 2 * kColumns - 3), last);
  ASSERT_EQ(session().choices().area.tiles, (CellRect{17, 97, 2, 2}));
  click(on_map({7, 3}));
  EXPECT_EQ(tile_at({8, 4}), kTiles - kColumns - 2);
}

TEST_F(UiSheetSize, ASmallerLevelCutsTheChoice) {
  click(on_sheet(kTiles - 1));
  drop(save_test_level("small.talus.json"));
  frames(3);
  EXPECT_EQ(chosen_tile(), 1) << "the first that is drawn";
  click(on_map({7, 3}));
  EXPECT_EQ(tile_at({7, 3}), 1);
}

}  // namespace talus::sheet_size_ui_test
