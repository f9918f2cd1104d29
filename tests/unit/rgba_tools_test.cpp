// The pixel tools on tiles in true colour: they paint what they paint on 16 colours, and undo it.
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

#include "edit/flag_lamps.h"
#include "edit/picture_palette.h"
#include "edit/sprite_clear.h"
#include "edit/sprite_clipboard.h"
#include "edit/sprite_fill.h"
#include "edit/sprite_shapes.h"
#include "edit/sprite_turn.h"
#include "level/tile_look.h"
#include "session/session.h"

namespace talus::rgba_tools_test {

using testing::ElementsAre;

constexpr Rgba kRed{200, 0, 0, 255}, kGlass{10, 20, 30, 128};

// `columns` tiles in two rows, all clear.
Level clear_level(TileSize size, int columns) {
  Level level;
  level.map = TileMap(2, 2, size);
  level.set_tile_layout({columns, 2 * columns});
  SheetPicture picture{columns * size.width, 2 * size.height, {}};
  picture.rgba.resize(4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  return level;
}

// Opaque colours that stand for 0 to 15; 0 is clear.
PixelColor color_for(int index) {
  return index == 0 ? 0 : pixel_color({static_cast<std::uint8_t>(16 * index), 5, 7, 255});
}

// The same canvas of 2x2 tiles of 8x8 px in 16 colours and in true colour.
struct Twins {
  Level indexed, rgba = clear_level({8, 8}, 4);
  SpriteArea area{SheetId::tiles, {1, 0, 2, 2}};

  Twins() {
    indexed.set_tile_layout({4, 8});
    PixelBlock plain{16, 16, {}}, colored{16, 16, {}, true};
    for (int i = 0; i < 256; ++i) {
      const int index = (i / 16 * 7 + i % 16 * 3) % 5;
      plain.colors.push_back(index);
      colored.colors.push_back(color_for(index));
    }
    apply_edit(indexed, put_pixels(indexed, area, plain, {0, 0}, "Paint"));
    apply_edit(rgba, put_pixels(rgba, area, colored, {0, 0}, "Paint"));
  }
  void expect_alike(const std::string& what) const {
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        ASSERT_EQ(pixel_at(rgba, area, x, y), color_for(pixel_at(indexed, area, x, y)))
            << what << " at " << x << "," << y;
  }
};

TEST(RgbaTools, PaintWhatTheyPaintIn16Colours) {
  using Tool = std::function<Edit(const Level&, const SpriteArea&, PixelColor, PixelColor)>;
  const std::vector<std::pair<std::string, Tool>> tools = {
      {"line",
       [](const Level& l, const SpriteArea& a, PixelColor c, PixelColor) {
         return draw_line(l, a, {-2, 1}, {13, 9}, {c, 3});
       }},
      {"rectangle",
       [](const Level& l, const SpriteArea& a, PixelColor c, PixelColor) {
         return draw_rectangle(l, a, {3, 2}, {20, 11}, {c, 2}, false);
       }},
      {"filled rectangle",
       [](const Level& l, const SpriteArea& a, PixelColor c, PixelColor) {
         return draw_rectangle(l, a, {5, 5}, {9, 12}, {c, 1}, true);
       }},
      {"ellipse",
       [](const Level& l, const SpriteArea& a, PixelColor c, PixelColor) {
         return draw_ellipse(l, a, {1, 1}, {14, 10}, {c, 1}, false);
       }},
      {"filled ellipse",
       [](const Level& l, const SpriteArea& a, PixelColor c, PixelColor) {
         return draw_ellipse(l, a, {-4, 3}, {10, 18}, {c, 4}, true);
       }},
      {"fill",
       [](const Level& l, const SpriteArea& a, PixelColor c, PixelColor) {
         return fill_pixels(l, a, {8, 8}, c);
       }},
      {"replace", [](const Level& l, const SpriteArea& a, PixelColor c,
                     PixelColor other) { return replace_color(l, a, other, c); }},
      {"rotate", [](const Level& l, const SpriteArea& a, PixelColor,
                    PixelColor) { return turn_pixels(l, a, PixelTurn::rotate); }},
      {"flip", [](const Level& l, const SpriteArea& a, PixelColor,
                  PixelColor) { return turn_pixels(l, a, PixelTurn::flip_horizontal); }},
      {"shift", [](const Level& l, const SpriteArea& a, PixelColor,
                   PixelColor) { return turn_pixels(l, a, PixelTurn::shift_up); }},
      {"clear", [](const Level& l, const SpriteArea& a, PixelColor c, PixelColor) {
         return clear_pixels(l, a, {6, 7, 4, 20}, c);
       }}};
  for (const auto& [name, tool] : tools) {
    Twins twins;
    const Level before = twins.rgba;
    const Edit edit = tool(twins.rgba, twins.area, color_for(9), color_for(2));
    apply_edit(twins.indexed, tool(twins.indexed, twins.area, 9, 2));
    apply_edit(twins.rgba, edit);
    EXPECT_FALSE(twins.rgba == before) << name;
    twins.expect_alike(name);
    revert_edit(twins.rgba, edit);
    EXPECT_TRUE(twins.rgba == before) << name << ", undone";
  }
}

TEST(RgbaTools, PaintTilesOfAnySize) {
  Level level = clear_level({18, 12}, 2);
  const SpriteArea area = cut_to_sheet(level, {SheetId::tiles, {0, 0, 2, 1}});
  EXPECT_EQ(area.width(), 36);
  EXPECT_EQ(area.height(), 12);
  const Edit edit = draw_line(level, area, {10, 11}, {25, 11}, {pixel_color(kGlass), 1});
  EXPECT_EQ(edit.changes.size(), 2u) << "two tiles";
  apply_edit(level, edit);
  EXPECT_EQ(rgba_of(pixel_at(level, area, 25, 11)), kGlass);
  EXPECT_EQ(pixel_at(level, area, 26, 11), 0);
  const std::uint8_t* const pixel = level.sheet(SheetId::tiles).picture->at(25, 11);
  EXPECT_THAT((std::vector<int>{pixel[0], pixel[1], pixel[2], pixel[3]}), ElementsAre(10, 20, 30, 128));
}

TEST(RgbaTools, KeepTheImagesIn16Colours) {
  Level level = clear_level({16, 16}, 2);
  const SpriteArea area = cut_to_sheet(level, {});
  apply_edit(level, draw_rectangle(level, area, {0, 0}, {15, 15}, {pixel_color(kRed), 1}, true));
  EXPECT_EQ(level.sheet(SheetId::tiles).images[0][0], nearest_color({200, 0, 0}, level.palette));
  apply_edit(level, clear_pixels(level, area, area.canvas(), pixel_color({1, 2, 3, 0})));
  EXPECT_EQ(level.sheet(SheetId::tiles).images[0][0], 0);
  EXPECT_EQ(pixel_at(level, area, 0, 0), 0) << "the eraser has no colour";
}

TEST(RgbaTools, LeaveCopiesOfALevelAlone) {
  Level level = clear_level({8, 8}, 2);
  const Level copy = level;
  const SpriteArea area = cut_to_sheet(level, {});
  apply_edit(level, draw_line(level, area, {0, 0}, {0, 0}, {pixel_color(kRed), 1}));
  EXPECT_EQ(pixel_at(copy, area, 0, 0), 0);
  EXPECT_NE(pixel_at(level, area, 0, 0), 0);
}

TEST(RgbaTools, AStrokeCopiesTilesAndNotThePicture) {
  Session session(clear_level({16, 16}, 128));
  session.apply(action::SelectTiles{{SheetId::tiles, {3, 1, 1, 1}}});
  const SpriteArea area = session.choices().area;
  const int stroke = session.next_stroke();
  const auto paint = [&](int x) {
    session.apply(action::EditLevel{
        draw_line(session.level(), area, {x, 3}, {x + 1, 3}, {pixel_color(kRed), 1}), stroke});
  };
  paint(0);
  const SheetPicture* const picture = session.level().sheet(SheetId::tiles).picture.get();
  for (int x = 1; x < 15; ++x) paint(x);
  EXPECT_EQ(session.level().sheet(SheetId::tiles).picture.get(), picture) << "the same memory";
  ASSERT_EQ(session.history().edits().size(), 1u);
  EXPECT_LT(memory_of(session.history().edits()[0]), 8192u) << "a tile before and after";
  session.apply(action::Undo{});
  EXPECT_EQ(pixel_at(session.level(), area, 5, 3), 0);
  session.apply(action::Redo{});
  EXPECT_EQ(rgba_of(pixel_at(session.level(), area, 15, 3)), kRed);
}

TEST(RgbaTools, MoveSelectedPixels) {
  Session session(clear_level({8, 8}, 2));
  const SpriteArea area = session.choices().area;
  EXPECT_EQ(area.width(), 8);
  session.apply(action::EditLevel{draw_line(session.level(), area, {1, 1}, {2, 1}, {pixel_color(kRed), 1})});
  session.apply(action::SetSpriteTool{SpriteTool::select});
  session.apply(action::SelectPixels{CellRect{1, 1, 2, 1}});
  session.apply(action::MovePixels{{3, 4}});
  EXPECT_EQ(pixel_at(session.level(), area, 1, 1), 0) << "the right button's colour is clear at first";
  EXPECT_EQ(rgba_of(pixel_at(session.level(), area, 5, 5)), kRed);
  session.apply(action::TurnPixels{PixelTurn::rotate});
  EXPECT_TRUE(session.choices().pixels.floats(session.level(), area));
  session.apply(action::Undo{});
  session.apply(action::Undo{});
  EXPECT_EQ(rgba_of(pixel_at(session.level(), area, 1, 1)), kRed);
}

TEST(RgbaTools, PastePixelsOfBothKinds) {
  const PixelBlock glass{2, 1, {pixel_color(kGlass), pixel_color(kRed)}, true};
  const std::string text = pixels_to_text(glass);
  EXPECT_EQ(text, "rgba 2x1\n0a141e80c80000ff");
  ASSERT_TRUE(pixels_from_text(text));
  EXPECT_EQ(*pixels_from_text(text), glass);
  EXPECT_FALSE(pixels_from_text("rgba 2x1\n0a141e80c80000"));
  Session session(clear_level({8, 8}, 2));
  session.apply(action::PastePixels{{2, 1, {0, 3}}, {0, 0}});
  const Rgb three = session.level().palette[3];
  EXPECT_EQ(rgba_of(pixel_at(session.level(), session.choices().area, 1, 0)),
            (Rgba{three.r, three.g, three.b, 255}));
  session.apply(action::SelectTiles{{SheetId::sprites, {0, 0, 1, 1}}});
  session.apply(action::PastePixels{glass, {0, 0}});
  EXPECT_EQ(pixel_at(session.level(), session.choices().area, 0, 0),
            nearest_color({10, 20, 30}, session.level().palette));
}

TEST(RgbaTools, CopyWholeTilesWithTheirFlags) {
  Session session(clear_level({16, 12}, 4));
  const SpriteArea from{SheetId::tiles, {0, 0, 2, 1}, {16, 12}}, to{SheetId::tiles, {2, 1, 2, 1}, {16, 12}};
  session.apply(action::SelectTiles{from});
  session.apply(action::PastePixels{{2, 1, {pixel_color(kGlass), pixel_color(kRed)}, true}, {0, 0}});
  session.apply(action::EditLevel{set_flags(session.level(), from, {1u << 31 | 2u, 4u})});
  const std::string text = tiles_to_text(session.level(), from);
  EXPECT_TRUE(text.starts_with("tiles 2x1 rgba 32x12\n0a141e80c80000ff")) << text.substr(0, 60);
  EXPECT_TRUE(text.ends_with("2000000840000000")) << "the flags, each with its low digit first";
  ASSERT_TRUE(has_tiles_for(session.level(), to, text));
  EXPECT_FALSE(has_tiles_for(session.level(), {SheetId::tiles, {0, 0, 1, 1}, {16, 12}}, text));
  const auto pasted = paste_tiles(session.level(), to, text);
  ASSERT_TRUE(pasted);
  session.apply(action::EditLevel{*pasted});
  EXPECT_EQ(rgba_of(pixel_at(session.level(), to, 1, 0)), kRed);
  EXPECT_EQ(session.level().tile_flags(static_cast<TileNumber>(to.tile_at(session.level(), 0, 0))),
            1u << 31 | 2u);
  session.apply(action::Undo{});
  EXPECT_EQ(session.level().tile_flags(static_cast<TileNumber>(to.tile_at(session.level(), 0, 0))), 0u);
  ASSERT_TRUE(tile_pixels_from_text(text));
  EXPECT_EQ(tile_pixels_from_text(text)->w, 32) << "pasted elsewhere they are pixels";
  const Level plain;
  EXPECT_FALSE(paste_tiles(plain, {SheetId::tiles, {0, 0, 2, 1}}, text)) << "it has 16 colours";
}

TEST(RgbaTools, PickWhatTheyPainted) {
  Session session(clear_level({8, 8}, 2));
  const SpriteArea area = session.choices().area;
  session.apply(action::SetRgba{kGlass, false});
  EXPECT_EQ(session.choices().paint(session.level(), false), pixel_color(kGlass));
  EXPECT_EQ(session.choices().paint(session.level(), true), 0);
  session.apply(action::SelectTiles{{SheetId::sprites, area.tiles}});
  EXPECT_EQ(session.choices().paint(session.level(), false), 12) << "sprites have 16 colours";
}

TEST(PicturePalette, HasTheColoursOfTheTilesFirst) {
  Level level = clear_level({64, 64}, 2);
  const SpriteArea area = cut_to_sheet(level, {});
  PixelBlock block{64, 64, {}, true};
  for (int i = 0; i < 64 * 64; ++i)
    block.colors.push_back(
        pixel_color({static_cast<std::uint8_t>(i % 64 * 4), static_cast<std::uint8_t>(i / 64),
                     static_cast<std::uint8_t>(i / 64 * 4), 255}));
  apply_edit(level, put_pixels(level, {SheetId::tiles, {1, 0, 1, 1}, {64, 64}}, block, {0, 0}, "Paint"));
  apply_edit(level, draw_rectangle(level, area, {0, 0}, {63, 63}, {pixel_color(kRed), 1}, true));
  const std::vector<Rgba> colors = picture_palette(level, area);
  EXPECT_GT(colors.size(), 10u);
  EXPECT_LE(colors.size(), kMaxPictureColors);
  EXPECT_THAT(colors, testing::Contains(kRed));
  const auto is_bright = [](Rgba c) { return c.r > 128 && c.b > 128; };
  const auto is_dark = [](Rgba c) { return c.r < 96 && c.b < 96; };
  EXPECT_TRUE(std::any_of(colors.begin(), colors.end(), is_bright)) << "all of the picture is there";
  EXPECT_TRUE(std::any_of(colors.begin(), colors.end(), is_dark));
  EXPECT_THAT(picture_palette(level, {SheetId::sprites, {}}), testing::IsEmpty());
}

TEST(PicturePalette, IsSortedByHueAndLightness) {
  Level level = clear_level({8, 8}, 1);
  const SpriteArea area = cut_to_sheet(level, {});
  const std::vector<Rgba> shuffled = {{0, 0, 255, 255}, {255, 255, 255, 255}, {120, 0, 0, 255},
                                      {255, 0, 0, 255}, {20, 20, 20, 255},    {0, 200, 0, 255}};
  for (int i = 0; i < 6; ++i)
    apply_edit(level, draw_line(level, area, {i, 0}, {i, 0},
                                {pixel_color(shuffled[static_cast<std::size_t>(i)]), 1}));
  EXPECT_THAT(picture_palette(level, area),
              ElementsAre(shuffled[4], shuffled[1], shuffled[2], shuffled[3], shuffled[5], shuffled[0]));
  EXPECT_EQ(hex_text(kRed), "#c80000");
  EXPECT_EQ(hex_text(kGlass), "#0a141e80");
}

TEST(SheetChanges, NamePaintedTilesAlone) {
  Session session(clear_level({8, 8}, 4));
  session.apply(action::SelectTiles{{SheetId::tiles, {2, 0, 1, 1}}});
  const std::uint64_t before = session.revision();
  session.apply(action::EditLevel{
      draw_line(session.level(), session.choices().area, {0, 0}, {0, 0}, {pixel_color(kRed), 1})});
  EXPECT_THAT(*session.sheet_changes().tiles_since(before), ElementsAre(2));
  const std::uint64_t painted = session.revision();
  session.apply(action::EditLevel{Edit{"Paint tiles", {CellChange{{0, 0}, 0, 1}}}});
  EXPECT_THAT(*session.sheet_changes().tiles_since(painted), testing::IsEmpty()) << "the map is no sheet";
  session.apply(action::Undo{});
  session.apply(action::Undo{});
  EXPECT_THAT(*session.sheet_changes().tiles_since(painted), ElementsAre(2));
  session.apply(action::EditLevel{Edit{"Colour", {ColorChange{3, session.level().palette[3], {1, 2, 3}}}}});
  EXPECT_FALSE(session.sheet_changes().tiles_since(painted));
}

}  // namespace talus::rgba_tools_test
