// Tiles whose pixels are in pictures of their own: painted after a question, and saved into these pictures.
#include <gmock/gmock.h>

#include <zlib.h>

#include "edit/sprite_shapes.h"
#include "folder_test.h"
#include "formats/pictures/png_patch.h"
#include "formats/pictures/png_picture.h"
#include "formats/tilesets/new_tileset.h"
#include "ldtk_text.h"
#include "level/picture_tiles.h"
#include "session/session.h"

namespace talus::paint_files_test {

using testing::HasSubstr;
namespace act = action;

constexpr Rgba kPink{250, 90, 180, 255};

// Noise, so that each pixel can be told from the others.
std::vector<std::uint8_t> noise(int width, int height, int channels) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < width * height; ++i) {
    const auto part = static_cast<std::uint8_t>(i * 37 % 251);
    bytes.insert(bytes.end(),
                 {part, static_cast<std::uint8_t>(255 - part), static_cast<std::uint8_t>(i % 200)});
    if (channels == 4) bytes.push_back(i % 5 == 0 ? 90 : 255);
  }
  return bytes;
}

std::string noise_png(int width, int height, int channels = 4) {
  return encode_png(width, height, channels, noise(width, height, channels).data());
}

// A chunk of a PNG.
std::string chunk(const std::string& type, const std::string& content) {
  const auto u32 = [](std::size_t value) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255);
    return text;
  };
  const std::string checked = type + content;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  return u32(content.size()) + checked + u32(sum);
}

class PaintFiles : public FolderTest {
 protected:
  void open(const std::string& name) {
    session_.apply(act::OpenFile{path(name)});
    session_.finish_reading();
    session_.apply(act::DismissMessage{});
  }
  // Paints a pixel of a tile.
  void paint(int tile, Cell pixel, Rgba color = kPink) {
    session_.apply(act::SelectTiles{{SheetId::tiles,
                                     {level().sheet(SheetId::tiles).layout().place_of(tile).x,
                                      level().sheet(SheetId::tiles).layout().place_of(tile).y, 1, 1}}});
    const PixelColor painted = is_in_rgba(level(), SheetId::tiles) ? pixel_color(color) : 9;
    session_.apply(act::EditLevel{draw_line(level(), session_.choices().area, pixel, pixel, {painted, 1})});
  }
  void allow() { session_.apply(act::AnswerQuestion{act::Answer::allow}); }
  const Level& level() const { return session_.level(); }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }
  std::string question() const { return session_.question() ? session_.question()->text : ""; }
  Rgba shown(int tile, Cell pixel) const {
    const Cell place = level().sheet(SheetId::tiles).layout().place_of(tile);
    return rgba_of(pixel_at(level(), cut_to_sheet(level(), {SheetId::tiles, {place.x, place.y, 1, 1}}),
                            pixel.x, pixel.y));
  }
  // The pixels of a picture that differ from the noise, by their places.
  static std::map<std::pair<int, int>, Rgba> painted(const std::string& png,
                                                     const std::vector<std::uint8_t>& before, int channels) {
    std::map<std::pair<int, int>, Rgba> found;
    const auto picture = read_rgba(png, 4096);
    EXPECT_TRUE(picture);
    for (int i = 0; picture && i < picture->width * picture->height; ++i) {
      const auto* now = reinterpret_cast<const std::uint8_t*>(picture->bytes.data()) + 4 * i;
      const std::uint8_t* then = &before[static_cast<std::size_t>(channels * i)];
      const std::uint8_t opacity = channels == 4 ? then[3] : std::uint8_t{255};
      if (!std::equal(now, now + 3, then) || now[3] != opacity)
        found[{i % picture->width, i / picture->width}] = {now[0], now[1], now[2], now[3]};
    }
    return found;
  }
  // A map of Tiled with one tileset: 3x2 tiles of 8x6 px with gaps of 1 px and a margin of 2 px.
  std::string put_map(const std::string& image = R"(<image source="t.png" width="30" height="17"/>)",
                      const std::string& cells = "1,2,3,6") const {
    return put("map.tmx", R"(<?xml version="1.0" encoding="UTF-8"?>
<map version="1.8" orientation="orthogonal" width="4" height="1" tilewidth="8" tileheight="6">
 <tileset firstgid="1" name="t" tilewidth="8" tileheight="6" spacing="1" margin="2" tilecount="6" columns="3">
  )" + image + R"(
 </tileset>
 <layer id="1" name="ground" width="4" height="1"><data encoding="csv">)" +
                              cells + R"(</data></layer>
</map>
)");
  }
  void put_noise() const { put("t.png", noise_png(30, 17)); }

  Session session_;
};

using Painted = std::map<std::pair<int, int>, Rgba>;

TEST_F(PaintFiles, OfTiledAreAskedForOnce) {
  put_noise();
  open(put_map().substr(path("").size()));
  const int tile = level().map.tile_at({1, 0});
  const Rgba before = shown(tile, {3, 2});
  paint(tile, {3, 2});
  EXPECT_EQ(question(), "t.png is a file of its own. Paint it, and save it with the level?");
  EXPECT_EQ(session_.question()->kind, Question::Kind::paint_file);
  session_.apply(act::AnswerQuestion{act::Answer::cancel});
  EXPECT_EQ(shown(tile, {3, 2}), before);
  EXPECT_FALSE(session_.modified());
  paint(tile, {3, 2});
  allow();
  EXPECT_EQ(shown(tile, {3, 2}), kPink);
  paint(tile, {4, 2});
  EXPECT_EQ(question(), "");
  EXPECT_EQ(shown(tile, {4, 2}), kPink);
}

TEST_F(PaintFiles, OfTiledAreSavedPixelByPixel) {
  put_noise();
  put_map();
  const std::string map = bytes_of("map.tmx");
  open("map.tmx");
  const int tile = level().map.tile_at({3, 0});  // the last one, in the second row
  paint(tile, {3, 2});
  allow();
  paint(tile, {0, 5}, {});
  session_.apply(act::SaveFile{});
  EXPECT_EQ(message(), "Saved map.tmx + t.png.");
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(bytes_of("map.tmx"), map);
  const Painted expected{{{2 + 2 * 9 + 3, 2 + 7 + 2}, kPink}, {{2 + 2 * 9, 2 + 7 + 5}, Rgba{}}};
  EXPECT_EQ(painted(bytes_of("t.png"), noise(30, 17, 4), 4), expected);
  session_.apply(act::DismissMessage{});
  session_.apply(act::CheckFile{});
  EXPECT_EQ(message(), "") << "its own file is no news";
  const Level saved = level();
  open("map.tmx");
  EXPECT_TRUE(level() == saved);
}

TEST_F(PaintFiles, AreLeftAloneWithoutAChange) {
  put_noise();
  put_map();
  open("map.tmx");
  paint(level().map.tile_at({0, 0}), {1, 1});
  allow();
  session_.apply(act::Undo{});
  session_.apply(act::EditLevel{
      Edit{"Paint tiles", {CellChange{{0, 0}, level().map.tile_at({0, 0}), level().map.tile_at({1, 0})}}}});
  const std::string before = bytes_of("t.png");
  session_.apply(act::SaveFile{});
  EXPECT_EQ(message(), "Saved map.tmx.");
  EXPECT_EQ(bytes_of("t.png"), before);
}

TEST_F(PaintFiles, KeepOpaqueRgbAndTheirClearColour) {
  put("t.png", noise_png(30, 17, 3));
  put_map(R"(<image source="t.png" trans="0aff14" width="30" height="17"/>)");
  open("map.tmx");
  const int tile = level().map.tile_at({0, 0});
  paint(tile, {1, 1}, {});
  allow();
  paint(tile, {2, 1}, {0x0a, 0xff, 0x14, 255});
  EXPECT_EQ(shown(tile, {2, 1}), (Rgba{0x0a, 0xff, 0x15, 255})) << "the clear colour cannot be opaque";
  session_.apply(act::SaveFile{});
  EXPECT_EQ(kind_of_png(bytes_of("t.png")), PngKind::rgb);
  const Painted expected{{{3, 3}, Rgba{0x0a, 0xff, 0x14, 255}}, {{4, 3}, Rgba{0x0a, 0xff, 0x15, 255}}};
  EXPECT_EQ(painted(bytes_of("t.png"), noise(30, 17, 3), 3), expected);
  open("map.tmx");
  EXPECT_EQ(shown(tile, {1, 1}).a, 0);
}

TEST_F(PaintFiles, OfANativeLevelAreSavedToo) {
  put("t.png", noise_png(35, 35));
  const auto read = read_rgba(noise_png(35, 35));
  ASSERT_TRUE(read);
  const TilePicture tiles{.picture = *read, .cut = {{16, 16}, 1, 1}, .name = "t", .link = path("t.png")};
  const auto made = level_of_tiles(tiles, 4, 3);
  ASSERT_TRUE(made);
  ASSERT_TRUE(save_level(*made, *find_format("native"), path("level.talus.json")));
  open("level.talus.json");
  const SheetLayout layout = level().sheet(SheetId::tiles).layout();
  const int tile = level().tilesets[0].first + layout.columns + 1;  // in the second row and column
  paint(tile, {15, 0});
  EXPECT_THAT(question(), HasSubstr("t.png is a file of its own"));
  allow();
  EXPECT_EQ(shown(tile, {15, 0}), kPink) << message();
  session_.apply(act::SaveFile{});
  EXPECT_EQ(message(), "Saved level.talus.json + t.png.");
  const Painted expected{{{18 + 15, 18}, kPink}};
  EXPECT_EQ(painted(bytes_of("t.png"), noise(35, 35, 4), 4), expected);
  session_.apply(act::Undo{});
  EXPECT_TRUE(session_.modified());
  session_.apply(act::SaveFile{});
  EXPECT_TRUE(painted(bytes_of("t.png"), noise(35, 35, 4), 4).empty());
}

TEST_F(PaintFiles, OfLdtkArePaintedWhereverTheyAreShown) {
  put("t.png", noise_png(32, 8));
  const std::string tiles = ldtk_tile(0, 0, 1) + "," + ldtk_tile(8, 0, 1, 1) + "," + ldtk_tile(16, 0, 2) +
                            "," + ldtk_tile(24, 0, 2) + "," + ldtk_tile(24, 0, 3);
  put("game.ldtk", ldtk_project(ldtk_level(ldtk_tiles(4, 2, tiles))));
  open("game.ldtk");
  if (session_.level_import()) session_.apply(act::ApplyLevelImport{});
  const int plain = level().map.tile_at({0, 0}), stacked = level().map.tile_at({3, 0});
  EXPECT_EQ(level().map.at({1, 0}), MapCell(static_cast<TileNumber>(plain), TileTurn::left_right));
  paint(plain, {2, 3});
  EXPECT_THAT(question(), HasSubstr("t.png is a file of its own")) << message();
  allow();
  EXPECT_EQ(shown(plain, {2, 3}), kPink);
  paint(stacked, {0, 0});
  EXPECT_THAT(message(), HasSubstr("it shows several tiles of LDtk over one another"));
  const std::string project = bytes_of("game.ldtk");
  session_.apply(act::SaveFile{});
  EXPECT_EQ(bytes_of("game.ldtk"), project);
  const Painted expected{{{8 + 2, 3}, kPink}};
  EXPECT_EQ(painted(bytes_of("t.png"), noise(32, 8, 4), 4), expected) << message();
  EXPECT_THAT(bytes_of("game.talus.json"), testing::Not(HasSubstr("\"picture\"")));
}

TEST_F(PaintFiles, OtherKindsAreAskedAboutOrRefused) {
  const std::string indexed = [] {
    std::string palette, pixels;
    for (int i = 0; i < 16; ++i) palette += std::string(3, static_cast<char>(15 * i));
    for (int i = 0; i < 17; ++i)
      pixels += std::string(31, static_cast<char>(i == 0 ? 0 : i % 16)).replace(0, 1, 1, '\0');
    std::string packed(compressBound(pixels.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(pixels.data()),
             pixels.size());
    packed.resize(size);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", std::string("\0\0\0\x1e\0\0\0\x11\x08\x03\0\0\0", 13)) +
           chunk("PLTE", palette) + chunk("IDAT", packed) + chunk("IEND", "");
  }();
  put("t.png", indexed);
  put_map();
  open("map.tmx");
  paint(level().map.tile_at({1, 0}), {3, 2});
  EXPECT_EQ(
      question(),
      "t.png is a file of its own, with a palette. Paint it, and save it with the level, in true colour?");
  session_.apply(act::AnswerQuestion{act::Answer::cancel});
  std::string deep = noise_png(30, 17);
  deep[24] = 16;
  put("t.png", deep);
  paint(level().map.tile_at({1, 0}), {3, 2});
  EXPECT_EQ(question(), "");
  EXPECT_THAT(message(), HasSubstr("t.png has 16 bits a channel"));
  put("t.png", "GIF89a");
  paint(level().map.tile_at({1, 0}), {3, 2});
  EXPECT_THAT(message(), HasSubstr("t.png is no PNG"));
}

TEST_F(PaintFiles, ChangedByOthersAreMerged) {
  put_noise();
  put_map();
  open("map.tmx");
  const int mine = level().map.tile_at({1, 0}), theirs = level().map.tile_at({2, 0});
  paint(mine, {3, 2});
  allow();
  const auto other = patch_png(bytes_of("t.png"), {{{2 + 18, 2}, {1, 2, 3, 255}}});
  ASSERT_TRUE(other);
  put("t.png", *other);
  session_.apply(act::CheckFile{});
  session_.finish_reading();
  EXPECT_EQ(shown(theirs, {0, 0}), (Rgba{1, 2, 3, 255})) << message();
  EXPECT_EQ(shown(mine, {3, 2}), kPink);
  session_.apply(act::SaveFile{});
  const Painted expected{{{20, 2}, Rgba{1, 2, 3, 255}}, {{14, 4}, kPink}};
  EXPECT_EQ(painted(bytes_of("t.png"), noise(30, 17, 4), 4), expected) << message();
  paint(mine, {0, 0});
  const auto same_tile = patch_png(bytes_of("t.png"), {{{11 + 7, 2 + 5}, {9, 9, 9, 255}}});
  put("t.png", *same_tile);
  session_.apply(act::CheckFile{});
  session_.finish_reading();
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::merge);
}

TEST_F(PaintFiles, TurnedAndEmptyTilesAreRefused) {
  put_noise();
  put_map(R"(<image source="t.png" width="30" height="17"/>)", "1,2,0,6");
  open("map.tmx");
  paint(level().map.tile_at({2, 0}), {0, 0});
  EXPECT_EQ(question(), "");
  EXPECT_THAT(message(), HasSubstr("cannot be painted: it is empty; choose another one on the sheet."));
}

TEST(PngPatch, KeepsNotesAndOtherPixels) {
  const std::string plain = noise_png(5, 4);
  const std::string with_text = plain.substr(0, 33) + chunk("gAMA", std::string("\0\0\xb1\x8f", 4)) +
                                plain.substr(33, plain.size() - 33 - 12) +
                                chunk("tEXt", std::string("Author\0me", 9)) + plain.substr(plain.size() - 12);
  const auto patched = patch_png(with_text, {{{4, 3}, {1, 2, 3, 4}}});
  ASSERT_TRUE(patched);
  EXPECT_THAT(*patched, HasSubstr("gAMA"));
  EXPECT_THAT(*patched, HasSubstr(std::string("tEXtAuthor\0me", 13)));
  EXPECT_EQ(read_rgba(*patched)->bytes.substr(0, 76), read_rgba(plain)->bytes.substr(0, 76));
  EXPECT_EQ(read_rgba(*patched)->bytes.substr(76), "\x01\x02\x03\x04");
  EXPECT_EQ(*patch_png(with_text, {}), with_text) << "nothing to do";
  EXPECT_FALSE(patch_png("GIF89a", {}));
}

}  // namespace talus::paint_files_test
