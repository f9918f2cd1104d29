// The tab of what a tile says: class, probability, properties and its animation.
#include "harness.h"

namespace talus::tile_panel_ui_test {

class UiTilePanel : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start(save_test_level("level.talus.json"), 1152, 700);
    session().apply(action::Pause{});
    click(on_sheet(3));
    click("tabs/tile");
    frames(2);
  }
  const TileNote& note(int tile) { return note_of(level().tile_notes, static_cast<TileNumber>(tile)); }
  const TileAnimation& frames_of(int tile) { return level().animations.at(static_cast<TileNumber>(tile)); }
  void put(const std::string& field, const std::string& text) {
    click(field);
    key(ctrl('a'));
    type(text);
    key(KeyChord{'\r'});
    frames(2);
  }
  void put_number(const std::string& field, const std::string& text) {
    click(field);
    put(field, text);
  }
};

TEST_F(UiTilePanel, ClassAndProbabilityAreTypedUndoneAndSaved) {
  put("tile/class", "door");
  put_number("tile/probability", "0.5");
  EXPECT_EQ(note(3), (TileNote{"door", 0.5, ""}));
  EXPECT_EQ(session().history().edits().size(), 2U);
  key(ctrl('s'));
  const auto saved = load_level(path("level.talus.json"));
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->level.tile_notes, level().tile_notes);
  click(on_sheet(1));
  frames(2);
  EXPECT_EQ(note(1), TileNote()) << "another tile is shown, and stays as it is";
  key(ctrl('z'));
  key(ctrl('z'));
  EXPECT_TRUE(level().tile_notes.empty());
}

TEST_F(UiTilePanel, AllSelectedTilesGetTheClass) {
  drag(on_sheet(3), on_sheet(5));
  put("tile/class", "slope");
  for (const int tile : {3, 4, 5}) EXPECT_EQ(note(tile).type, "slope") << tile;
}

TEST_F(UiTilePanel, PropertiesHaveAKindAreTypedAndRemoved) {
  click("tile/tile_new_kind");
  frames(2);
  click("tile/tile_new_kind_1");  // a whole number
  put("tile/tile_new_property", "cost");
  EXPECT_EQ(note(3).properties, R"({"cost":0})");
  put("tile/tile_property0", "7");
  EXPECT_EQ(note(3).properties, R"({"cost":7})");
  put("tile/tile_property0", "many");
  EXPECT_EQ(note(3).properties, R"({"cost":7})");
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Not changed: this property must be a whole number.");
  key(kKeyEscape);
  frames(2);
  click("tile/tile_property0_kind");
  frames(2);
  click("tile/tile_property0_kind_0");  // text
  frames(2);
  EXPECT_EQ(note(3).properties, R"({"cost":"7"})");
  click("tile/tile_property0_remove");
  EXPECT_TRUE(level().tile_notes.empty());
  key(ctrl('z'));
  EXPECT_EQ(note(3).properties, R"({"cost":"7"})");
}

TEST_F(UiTilePanel, FramesAreAddedOrderedTimedAndRemoved) {
  click("tile/add_frame");
  frames(2);
  EXPECT_EQ(frames_of(3), (TileAnimation{{3, 100}}));
  click(on_sheet(5));  // the tile of the panel stays
  frames(2);
  click("tile/add_frame");
  frames(2);
  EXPECT_EQ(frames_of(3), (TileAnimation{{3, 100}, {5, 100}}));
  put_number("tile/frame1_ms", "250");
  EXPECT_EQ(frames_of(3)[1], (AnimationFrame{5, 250}));
  click("tile/frame1_up");
  frames(2);
  EXPECT_EQ(frames_of(3), (TileAnimation{{5, 250}, {3, 100}}));
  put_number("tile/frame0_tile", "6");
  EXPECT_EQ(frames_of(3)[0], (AnimationFrame{6, 250}));
  click("tile/frame0_remove");
  frames(2);
  EXPECT_EQ(frames_of(3), (TileAnimation{{3, 100}}));
  click("tile/keep");
  frames(2);
  EXPECT_EQ(find("tile/preview"), nullptr) << "tile 5 is selected, which has none";
  for (int i = 0; i < 6; ++i) key(ctrl('z'));
  EXPECT_TRUE(level().animations.empty());
}

TEST_F(UiTilePanel, TheAnimationPlaysInThePanel) {
  click("tile/add_frame");
  frames(2);
  EXPECT_NE(find("tile/preview"), nullptr);
  EXPECT_TRUE(app().ui().wants_frames());
  click("tile/remove_animation");
  frames(80);  // no tooltip is due any more
  EXPECT_FALSE(app().ui().wants_frames());
}

}  // namespace talus::tile_panel_ui_test
