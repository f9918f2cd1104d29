// Cartridges chunk by chunk: what is kept, what an edit changes, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/tic80/tic_cart.h"
#include "zipped.h"

namespace talus::tic_test {

using testing::ElementsAre;
using testing::HasSubstr;

std::string chunk(int type, const std::string& data, int bank = 0, std::uint8_t reserved = 0) {
  std::string bytes;
  append_tic_chunk(bytes, {.type = type, .bank = bank, .reserved = reserved, .data = data});
  return bytes;
}

Level read(const std::string& bytes) { return read_tic(bytes, {}).value(); }
std::string write(const Level& level) { return write_tic(level, {}).value().bytes; }
FormatError error_of(const std::string& bytes) { return read_tic(bytes, {}).error(); }

constexpr int kTiles = 1, kSprites = 2, kMap = 4, kCode = 5, kFlags = 6, kSamples = 9, kWaves = 10,
              kPalette = 12;

const std::string kSomePalette(48, 'p');

TEST(Tic, DecodesTheSectionsOfBankZero) {
  const Level level =
      read(chunk(kTiles, std::string(32, '\0') + "\x21\x43") + chunk(kSprites, "\x0f") +
           chunk(kMap, std::string(240, '\0') + "\x07") + chunk(kFlags, std::string("\0\x05", 2)) +
           chunk(kPalette, "\x01\x02\x03") + chunk(kMap, "xxxx", 1));
  EXPECT_EQ(level.sheet(SheetId::tiles).images[1][0], 1);  // the low half of a byte is the left pixel
  EXPECT_EQ(level.sheet(SheetId::tiles).images[1][1], 2);
  EXPECT_EQ(level.sheet(SheetId::tiles).images[1][3], 4);
  EXPECT_EQ(level.sheet(SheetId::sprites).images[0][0], 15);
  EXPECT_EQ(level.map.at({0, 1}), 7);
  EXPECT_EQ(level.map.at({0, 0}), 0);
  EXPECT_EQ(level.tile_flags(1), 5);
  EXPECT_EQ(level.palette[0], (Rgb{1, 2, 3}));
  EXPECT_EQ(level.palette[1], (Rgb{0, 0, 0}));
}

TEST(Tic, FlagsAfterThoseOfTilesBelongToSprites) {
  std::string flags(257, '\0');
  flags.back() = '\x80';
  const Level level = read(chunk(kFlags, flags));
  EXPECT_EQ(level.sheet(SheetId::sprites).flags[0], 0x80);
  EXPECT_EQ(level.tile_flags(0), 0);
}

TEST(Tic, ShowsTheDefaultPaletteForADefaultChunk) {
  EXPECT_EQ(read(chunk(17, "")).palette, default_palette());
}

TEST(Tic, ShowsDb16ForACartWithoutPalette) {
  EXPECT_EQ(read(chunk(kTiles, "x")).palette[0], (Rgb{0x14, 0x0c, 0x1c}));
  EXPECT_EQ(write(read(chunk(kTiles, "x"))), chunk(kTiles, "x"));
}

TEST(Tic, KeepsEveryByteOfAnUntouchedCart) {
  const std::string odd = chunk(27, "unknown", 3, 9) + chunk(kMap, std::string("a\0\0", 3)) + chunk(0, "") +
                          chunk(kMap, "b") + chunk(kCode, std::string(65536, '-'), 1) + chunk(kCode, "tail") +
                          chunk(19, std::string("\0\1\2", 3), 2) + chunk(17, "", 7) + chunk(3, "GIF89a") +
                          chunk(20, "\1");
  EXPECT_EQ(write(read(odd)), odd);
}

TEST(Tic, AnEditReplacesItsChunkInPlace) {
  const std::string before = chunk(kFlags, "f") + chunk(27, "unknown");
  const std::string after = chunk(kSamples, "s") + chunk(kMap, "m", 2);
  Level level = read(before + chunk(kMap, "a") + after);
  level.map.set({1, 0}, 'b');
  EXPECT_EQ(write(level), before + chunk(kMap, "ab") + after);
}

TEST(Tic, AnEditReplacesAllChunksOfItsSection) {
  Level level = read(chunk(kMap, "abc") + chunk(kTiles, "t") + chunk(kMap, "x"));
  EXPECT_EQ(level.map.at({0, 0}), 'x');
  EXPECT_EQ(level.map.at({1, 0}), 'b');
  level.map.set({1, 0}, 'y');
  EXPECT_EQ(write(level), chunk(kMap, "xyc") + chunk(kTiles, "t"));
}

TEST(Tic, ANewSectionGoesWhereTic80WritesIt) {
  Level level = read(chunk(17, "") + chunk(kTiles, "t") + chunk(kFlags, "f") + chunk(kTiles, "t", 1) +
                     chunk(kCode, "c"));
  level.map.set({0, 0}, 'm');
  level.sheet(SheetId::sprites).images[0][0] = 1;
  EXPECT_EQ(write(level), chunk(17, "") + chunk(kTiles, "t") + chunk(kSprites, "\1") + chunk(kMap, "m") +
                              chunk(kFlags, "f") + chunk(kTiles, "t", 1) + chunk(kCode, "c"));
}

TEST(Tic, AnEmptiedSectionIsLeftOut) {
  Level level = read(chunk(kTiles, "t") + chunk(kMap, "m") + chunk(kCode, "c"));
  level.map.set({0, 0}, 0);
  EXPECT_EQ(write(level), chunk(kTiles, "t") + chunk(kCode, "c"));
}

TEST(Tic, ACartWithNothingInItIsNotWritten) {
  Level level = read(chunk(kMap, "m"));
  level.map.set({0, 0}, 0);
  EXPECT_EQ(write_tic(level, {}).error().message,
            "has neither drawings nor code, but TIC-80 cannot load an empty cartridge");
}

TEST(Tic, AnEditedPaletteKeepsTheSecondOne) {
  const std::string second(48, 's');
  Level level = read(chunk(kPalette, kSomePalette + second) + chunk(kCode, "c"));
  level.palette[0] = {1, 2, 3};
  std::string edited = kSomePalette;
  edited.replace(0, 3, "\1\2\3");
  EXPECT_EQ(write(level), chunk(kPalette, edited + second) + chunk(kCode, "c"));
}

TEST(Tic, AnEditedDefaultPaletteWritesTheWaves) {
  Level level = read(chunk(27, "u") + chunk(17, "") + chunk(kTiles, "t") + chunk(17, "", 1));
  level.palette[0] = {9, 9, 9};
  std::string palette(default_palette_bytes());
  palette.replace(0, 3, "\x09\x09\x09");
  EXPECT_EQ(write(level), chunk(27, "u") + chunk(kPalette, palette) +
                              chunk(kWaves, std::string(default_wave_bytes())) + chunk(kTiles, "t") +
                              chunk(17, "", 1));
}

TEST(Tic, AWaveformWinsOverADefaultBehindIt) {
  Level level = read(chunk(kWaves, "W") + chunk(17, ""));
  level.palette[0] = {9, 9, 9};
  std::string waves(default_wave_bytes());
  waves[0] = 'W';
  EXPECT_THAT(write(level), HasSubstr(chunk(kWaves, waves)));
}

TEST(Tic, ALevelWithoutACartIsWrittenLikeTic80Does) {
  Level level;
  level.map.set({0, 0}, 1);
  level.sheet(SheetId::tiles).flags[1] = 1;
  const std::string bytes = write(level);
  EXPECT_EQ(bytes.substr(0, 14),
            chunk(17, "") + chunk(kMap, "\1") + chunk(kFlags, std::string("\0\1", 2)).substr(0, 5));
  const auto chunks = parse_tic(bytes).value();
  EXPECT_EQ(chunks.back().type, kCode);
  EXPECT_THAT(std::string(chunks.back().data), HasSubstr("function TIC()"));
}

TEST(Tic, CodeIsReadFromTheHighestBankDown) {
  const std::string full(65536, 'a');
  EXPECT_EQ(tic_content(chunk(kCode, "end", 0) + chunk(kCode, full, 1))->code, full + "end");
}

TEST(Tic, CompressedCodeIsReadAndKept) {
  const std::string bytes = chunk(kCode, "other") + chunk(16, zipped("print()"));
  EXPECT_EQ(tic_content(bytes)->code, "print()");
  EXPECT_EQ(write(read(bytes)), bytes);
}

TEST(Tic, OnlyTheLastCompressedCodeIsUnpacked) {
  const std::string bytes = chunk(16, "not zlib") + chunk(16, zipped("print()"));
  const auto cart = tic_content(bytes);
  ASSERT_TRUE(cart) << cart.error().message;
  EXPECT_EQ(cart->code, "print()");
  EXPECT_EQ(write(read(bytes)), bytes);
  EXPECT_EQ(error_of(chunk(16, zipped("print()")) + chunk(16, "not zlib")).message,
            "the compressed code is damaged");
}

TEST(Tic, ReadingCanBeCancelled) {
  FormatContext context{"tic"};
  context.progress = Progress([](double) { return false; });
  const auto level = read_tic(chunk(kTiles, "t"), context);
  ASSERT_FALSE(level);
  EXPECT_EQ(level.error().message, was_cancelled().value().message);
}

TEST(Tic, ACompressionBombIsRefused) {
  EXPECT_EQ(tic_content(chunk(16, zipped(std::string(524'287, 'a'))))->code.size(), 524'287u);
  const FormatError error = error_of(chunk(kTiles, "t") + chunk(16, zipped(std::string(524'288, 'a'))));
  EXPECT_EQ(error.place, "byte 5");
  EXPECT_EQ(error.message, "the compressed code unpacks to more than 524287 bytes");
}

TEST(Tic, DamagedCompressedCodeIsRefused) {
  EXPECT_EQ(error_of(chunk(16, "not zlib")).message, "the compressed code is damaged");
  EXPECT_EQ(error_of(chunk(16, zipped("print()").substr(0, 8))).message, "the compressed code is damaged");
}

TEST(Tic, ErrorsSayAtWhichByte) {
  EXPECT_EQ(error_of("").message, "the file is empty");
  EXPECT_EQ(error_of(chunk(kTiles, "t") + "\x04").place, "byte 5");
  const FormatError truncated = error_of(chunk(kTiles, "t") + chunk(kMap, "abcdef").substr(0, 6));
  EXPECT_EQ(truncated.place, "byte 5");
  EXPECT_EQ(truncated.message, "the MAP chunk says 6 bytes, but the file ends after 2");
  const FormatError oversized = error_of(chunk(kFlags, std::string(513, 'f')));
  EXPECT_EQ(oversized.place, "byte 0");
  EXPECT_EQ(oversized.message, "the FLAGS chunk has 513 bytes, more than the 512 it can have");
}

TEST(Tic, AFileOfZerosIsNoCart) {
  const std::string zeros(1000, '\0');
  EXPECT_EQ(error_of(zeros).message, "has no chunk that TIC-80 loads: the file is damaged");
  for (const char* extension : {"tic", "tmx", "tmj", "ldtk", "json", "talus.json", "png", "lua"}) {
    FormatContext context;
    context.extension = extension;
    EXPECT_FALSE(read_level(zeros, context)) << extension;
  }
}

TEST(Tic, EveryTruncationIsAnErrorOrAShorterCart) {
  const std::string bytes =
      chunk(17, "") + chunk(kTiles, "tt") + chunk(16, zipped("code")) + chunk(kCode, "c");
  int errors = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) errors += !read_tic(bytes.substr(0, size), {});
  EXPECT_EQ(errors, static_cast<int>(bytes.size()) - 3);  // but for the ends of the first three chunks
}

TEST(Tic, AMapTooLargeIsAnError) {
  Level level;
  level.map = TileMap(241, 136);
  EXPECT_EQ(write_tic(level, {}).error().message,
            "the map is 241x136 cells, but a cart's map has at most 240x136");
}

TEST(Tic, ASmallerMapIsPadded) {
  Level level;
  level.map = TileMap(2, 2);
  level.map.set({1, 1}, 9);
  const Level again = read(write(level));
  EXPECT_EQ(again.map.width(), 240);
  EXPECT_EQ(again.map.at({1, 1}), 9);
  EXPECT_EQ(again.map.at({3, 0}), 0);
}

}  // namespace talus::tic_test
