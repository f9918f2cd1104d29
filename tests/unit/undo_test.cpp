// The undo stack, and that every tool can be undone.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "edit/flag_lamps.h"
#include "edit/level_settings.h"
#include "edit/map_fill.h"
#include "edit/map_rectangle.h"
#include "edit/map_stroke.h"
#include "edit/shape_tools.h"
#include "edit/sprite_clear.h"
#include "edit/sprite_fill.h"
#include "edit/sprite_shapes.h"
#include "edit/sprite_turn.h"
#include "edit/undo_stack.h"

namespace talus::undo_test {

Edit paint(const Level& level, int x, TileNumber tile) { return paint_stamp(level, {x, 0}, {1, 1, {tile}}); }

TEST(UndoStack, UndoesAndRedoes) {
  Level level;
  UndoStack stack;
  stack.push(level, paint(level, 0, 1));
  stack.push(level, paint(level, 0, 2));
  EXPECT_EQ(stack.position(), 2u);
  EXPECT_FALSE(stack.can_redo());
  stack.undo(level);
  EXPECT_EQ(level.map.at({0, 0}), 1);
  stack.undo(level);
  EXPECT_EQ(level.map.at({0, 0}), 0);
  EXPECT_FALSE(stack.can_undo());
  stack.redo(level);
  stack.redo(level);
  EXPECT_EQ(level.map.at({0, 0}), 2);
}

TEST(UndoStack, AnEditAfterAnUndoDropsWhatWasUndone) {
  Level level;
  UndoStack stack;
  stack.push(level, paint(level, 0, 1));
  stack.push(level, paint(level, 0, 2));
  stack.undo(level);
  stack.push(level, paint(level, 0, 3));
  EXPECT_FALSE(stack.can_redo());
  EXPECT_EQ(stack.edits().size(), 2u);
  stack.undo(level);
  EXPECT_EQ(level.map.at({0, 0}), 1);
}

TEST(UndoStack, AStrokeIsOneEntry) {
  Level level;
  UndoStack stack;
  for (int x = 0; x < 5; ++x) stack.push(level, paint(level, x, 1), 7);
  stack.push(level, paint(level, 9, 1), 8);
  EXPECT_EQ(stack.edits().size(), 2u);
  stack.undo(level);
  stack.undo(level);
  EXPECT_TRUE(level == Level());
}

TEST(UndoStack, StrokeZeroNeverMerges) {
  Level level;
  UndoStack stack;
  stack.push(level, paint(level, 0, 1));
  stack.push(level, paint(level, 1, 1));
  EXPECT_EQ(stack.edits().size(), 2u);
}

TEST(UndoStack, AStrokeThatEndsWhereItBeganLeavesNoEntry) {
  Level level;
  UndoStack stack;
  stack.push(level, paint(level, 0, 1));
  stack.push(level, paint(level, 0, 2), 7);
  stack.push(level, paint(level, 0, 1), 7);
  EXPECT_EQ(stack.edits().size(), 1u);
  stack.push(level, paint(level, 0, 4), 7);
  EXPECT_EQ(stack.edits().size(), 2u) << "the entry before the stroke must not take its later edits";
}

TEST(UndoStack, IgnoresEmptyEdits) {
  Level level;
  UndoStack stack;
  stack.push(level, Edit{"Nothing", {}});
  EXPECT_FALSE(stack.can_undo());
}

TEST(UndoStack, KnowsTheSavedState) {
  Level level;
  UndoStack stack;
  EXPECT_TRUE(stack.is_saved());
  stack.push(level, paint(level, 0, 1));
  EXPECT_FALSE(stack.is_saved());
  stack.mark_saved();
  EXPECT_TRUE(stack.is_saved());
  stack.undo(level);
  EXPECT_FALSE(stack.is_saved());
  stack.redo(level);
  EXPECT_TRUE(stack.is_saved());
  stack.undo(level);
  stack.push(level, paint(level, 0, 2));
  EXPECT_FALSE(stack.is_saved()) << "the saved state was dropped with what was undone";
}

TEST(UndoStack, AStrokeContinuedAfterSavingIsModified) {
  Level level;
  UndoStack stack;
  stack.push(level, paint(level, 0, 1), 7);
  stack.mark_saved();
  stack.push(level, paint(level, 1, 1), 7);
  EXPECT_FALSE(stack.is_saved());
  stack.undo(level);
  EXPECT_TRUE(stack.is_saved());
  EXPECT_EQ(level.map.at({0, 0}), 1);
}

// A tool and its gesture as small numbers. Each number is brought into the range that the tool allows.
struct Gesture {
  int tool, a, b, c, d, stroke;
};

Edit made_by(const Gesture& g, const Level& level) {
  const Stamp stamp{2, 1, {static_cast<TileNumber>(g.c), static_cast<TileNumber>(g.d)}};
  const auto color = static_cast<std::uint8_t>(g.c % 16);
  const SpriteArea area{g.d % 2 == 0 ? SheetId::tiles : SheetId::sprites, {g.a % 14, g.b % 14, 2, 2}};
  const Cell at{g.a % 16, g.b % 16}, to{g.c % 16, g.d % 16};
  switch (g.tool) {
    case 0:
      return paint_stamp(level, at, stamp);
    case 1:
      return paint_stroke(level, {0, 0}, at, to, stamp);
    case 2:
      return fill_rect(level, spanned(at, to), stamp);
    case 3:
      return flood_fill(level, at, stamp);
    case 4:
      return erase_cells(level, spanned(at, to));
    case 5:
      return draw_line(level, area, at, to, {color});
    case 6:
      return fill_pixels(level, area, at, color);
    case 7:
      return replace_color(level, area, static_cast<std::uint8_t>(g.a % 16), color);
    case 8:
      return turn_pixels(level, area, PixelTurn::flip_horizontal);
    case 9:
      return turn_pixels(level, area, PixelTurn::flip_vertical);
    case 10:
      return turn_pixels(level, area, PixelTurn::rotate);
    case 11:
      return clear_area(level, area, color);
    case 12:
      return set_flag(level, area, g.c % 8, g.a % 2 == 0);
    case 13:
      return toggle_flag(level, area, g.c % 8);
    case 14:
      return set_color(level, g.a % 16, {color, color, color});
    case 15:
      return rename_flag(level, g.a % 8, std::to_string(g.b));
    case 16:
      return set_roles(level, {g.a % 8, g.b % 8, g.c % 8, g.d % 8});
    case 17: {
      Tuning tuning = level.tuning;
      tuning.shared.fall_speed = g.a;
      return set_tuning(level, tuning);
    }
    case 18:
      return set_spawns(level, std::vector<Spawn>(g.a % 3, Spawn{"s", {1.0 * g.b, 2}, {}, ""}), "Place");
    case 19:
      return set_tile_shape(level, g.a, {.kind = TileShape::Kind::solid, .tiles = g.b % 8 + 1});
    case 20:
      return set_flag_shape(level, g.a % 8, {.kind = TileShape::Kind::solid, .tiles = g.b % 8 + 1});
    case 21: {
      const LevelCurve curve{"c", {Segment{{0, 0}, {1.0 * g.b, 2}}, Curve::Faces::up}, ""};
      return set_curves(level, std::vector<LevelCurve>(g.a % 3, curve), "Bend");
    }
    case 22: {
      const auto tiles =
          slope_tiles(level, {1.0 * (g.a % 100), 1.0 * (g.b % 72)}, {1.0 * (g.c % 100), 1.0 * (g.d % 72)});
      return tiles ? put_slope_tiles(level, *tiles) : Edit();
    }
    default:
      return Edit{"Resize", {MapChange{level.map, TileMap(g.a % 20 + 1, g.b % 20 + 1)}}};
  }
}

rc::Gen<Gesture> gestures() {
  const auto number = rc::gen::inRange(0, 256);
  return rc::gen::map(
      rc::gen::tuple(rc::gen::inRange(0, 24), number, number, number, number, rc::gen::inRange(0, 4)),
      [](const auto& t) { return std::apply([](auto... n) { return Gesture{n...}; }, t); });
}

// Undoes everything and then redoes everything, over any sequence of tools and strokes.
RC_GTEST_PROP(UndoStackProperty, GivesEveryStateBackBitForBit, ()) {
  const auto sequence = *rc::gen::container<std::vector<Gesture>>(gestures());
  Level level;
  level.map = TileMap(12, 9);
  const Level original = level;
  UndoStack stack;
  std::vector<Level> states = {level};  // by history position
  for (const Gesture& gesture : sequence) {
    stack.push(level, made_by(gesture, level), gesture.stroke);
    states.resize(stack.position());
    states.push_back(level);
  }
  for (std::size_t i = stack.position(); i-- > 0;) {
    stack.undo(level);
    RC_ASSERT(level == states[i]);
  }
  RC_ASSERT(level == original);
  while (stack.can_redo()) {
    stack.redo(level);
    RC_ASSERT(level == states[stack.position()]);
  }
}

}  // namespace talus::undo_test
