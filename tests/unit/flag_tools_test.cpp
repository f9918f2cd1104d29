// The tools of flags and of their fields.
#include "edit/flag_tools.h"

#include <gtest/gtest.h>

#include "panels/tiles/flag_brush.h"

namespace talus::flag_tools_test {

constexpr FlagSet kAllFlags = 0xff;

Level flagged_level() {
  Level level;
  level.sheet(SheetId::tiles).flags[0] = 0b0001;
  level.sheet(SheetId::tiles).flags[1] = 0b0101;
  return level;
}
const SpriteArea kTwoTiles{SheetId::tiles, {0, 0, 2, 1}};

FlagSet flags_after(Level level, const Edit& edit, int tile) {
  apply_edit(level, edit);
  return level.tile_flags(static_cast<std::uint8_t>(tile));
}

TEST(FlagTools, PaintAPatternAndLeaveTheOtherFlags) {
  const Level level = flagged_level();
  const FlagPattern down{0b1100, 0b1000};
  const Edit set = paint_flags(level, SheetId::tiles, {0, 1}, down, true);
  EXPECT_EQ(flags_after(level, set, 0), 0b1001);
  EXPECT_EQ(flags_after(level, set, 1), 0b1001);
  EXPECT_EQ(set.label, "Set flags");
  const Edit clear = paint_flags(level, kTwoTiles, down, false);
  ASSERT_EQ(clear.changes.size(), 1u) << "tile 0 has none of them";
  EXPECT_EQ(flags_after(level, clear, 1), 0b0001);
  EXPECT_EQ(paint_flags(level, kTwoTiles, pattern_of_flag(2), true).label, "Set flag 2");
}

TEST(FlagTools, TheFirstTileDecidesIfAStrokeSetsOrClears) {
  EXPECT_TRUE(stroke_sets(pattern_of_flag(2), 0b011));
  EXPECT_FALSE(stroke_sets(pattern_of_flag(2), 0b100));
  const FlagPattern none{0b1100, 0};
  EXPECT_TRUE(stroke_sets(none, 0b0000)) << "there is nothing else that it could do";
  EXPECT_TRUE(stroke_sets(none, 0b0100));
}

TEST(FlagTools, TheBrushSaysWhatItsStrokeDoes) {
  Session session(flagged_level());
  session.apply(action::SetFlagOverlay{pattern_of_flag(0)});
  FlagBrush brush;
  const auto text = [&](std::optional<int> tile) { return brush.text(session, SheetId::tiles, tile); };
  const auto stroke_at = [&](int tile, bool pressed) {
    Actions actions;
    brush.update(
        session, actions, SheetId::tiles, {tile, 0}, [](Cell c) { return std::optional(c.x); }, pressed,
        true);
    session.apply(actions);
  };
  EXPECT_EQ(text(1), "tile 1: clears flag 0  solid");
  EXPECT_EQ(text(2), "tile 2: sets flag 0  solid");
  EXPECT_EQ(text({}), "paints flag 0  solid");
  stroke_at(1, true);
  EXPECT_EQ(text(1), "tile 1: clears flag 0  solid") << "the text stays although the flag is clear by now";
  EXPECT_EQ(text(2), "tile 2: clears flag 0  solid");
  EXPECT_EQ(text({}), "clears flag 0  solid");
  stroke_at(0, false);
  EXPECT_EQ(session.level().tile_flags(0), 0);
  Actions actions;
  brush.cancel(session, actions);
  session.apply(actions);
  EXPECT_EQ(session.level(), flagged_level());
  EXPECT_FALSE(brush.active());
}

TEST(FlagTools, SayWhichFlagsTilesHaveInCommon) {
  const Level level = flagged_level();
  EXPECT_EQ(common_flags(level, kTwoTiles, 0b0011), 1);
  EXPECT_EQ(common_flags(level, kTwoTiles, 0b0100), std::nullopt);
  EXPECT_EQ(common_flags(level, {SheetId::tiles, {1, 0, 1, 1}}, kAllFlags), 0b0101);
}

TEST(FlagTools, SetAByteInAllTiles) {
  const Level level = flagged_level();
  const Edit edit = set_all_flags(level, kTwoTiles, 0xa5);
  EXPECT_EQ(flags_after(level, edit, 0), 0xa5);
  EXPECT_EQ(flags_after(level, edit, 1), 0xa5);
  EXPECT_EQ(flags_after(level, edit, 2), 0);
  EXPECT_TRUE(set_all_flags(level, {SheetId::tiles, {0, 0, 1, 1}}, 1).empty());
}

TEST(FlagTools, AddChangeAndRemoveFields) {
  Level level;
  apply_edit(level, set_flag_field(level, 0, {"late", 6, 2, {}, ""}));
  apply_edit(level, set_flag_field(level, 1, {"early", 0, 2, {}, ""}));
  ASSERT_EQ(level.flag_fields.size(), 2u);
  EXPECT_EQ(level.flag_fields[0].name, "early") << "by their flags";
  FlagField wider = level.flag_fields[0];
  wider.bits = 3;
  const Level before = level;
  const Edit edit = set_flag_field(level, 0, wider);
  apply_edit(level, edit);
  EXPECT_EQ(level.flag_fields[0].bits, 3);
  revert_edit(level, edit);
  EXPECT_EQ(level, before);
  EXPECT_TRUE(set_flag_field(level, 0, level.flag_fields[0]).empty());
  apply_edit(level, remove_flag_field(level, 0));
  ASSERT_EQ(level.flag_fields.size(), 1u);
  EXPECT_EQ(level.flag_fields[0].name, "late");
}

}  // namespace talus::flag_tools_test
