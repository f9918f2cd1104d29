// Text projects line by line: what is kept, what an edit changes, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/tic80/tic_cart.h"
#include "formats/tic80/tic_text.h"

namespace talus::text_test {

using testing::ElementsAre;
using testing::HasSubstr;

Level read(const std::string& bytes, const std::string& extension = "lua") {
  return read_text(bytes, {extension}).value();
}
std::string write(const Level& level, const std::string& extension = "lua") {
  return write_text(level, {extension}).value().bytes;
}
FormatError error_of(const std::string& bytes) { return read_text(bytes, {"lua"}).error(); }

std::string zeros(int digits) { return std::string(static_cast<std::size_t>(digits), '0'); }
// A row of the map that begins with these digits, the low digit of each cell first.
std::string map_row(const std::string& digits) {
  return digits + zeros(480 - static_cast<int>(digits.size()));
}
std::string tile_row(const std::string& digits) {
  return digits + zeros(64 - static_cast<int>(digits.size()));
}

const std::string kMapSection = "-- <MAP>\n-- 001:" + map_row("1032") + "\n-- </MAP>\n\n";
const std::string kTileSection = "-- <TILES>\n-- 002:" + tile_row("1f") + "\n-- </TILES>\n\n";

TEST(Text, DecodesRowsLowDigitFirst) {
  const Level level = read("code()\n\n" + kTileSection + kMapSection);
  EXPECT_EQ(level.map.at({0, 1}), 0x01);
  EXPECT_EQ(level.map.at({1, 1}), 0x23);
  EXPECT_EQ(level.sheet(SheetId::tiles).images[2][0], 1);
  EXPECT_EQ(level.sheet(SheetId::tiles).images[2][1], 15);
}

TEST(Text, ThePaletteHasTheHighDigitFirst) {
  const Level level = read("c\n-- <PALETTE>\n-- 000:1a1c2c" + zeros(90) + "\n-- </PALETTE>\n");
  EXPECT_EQ(level.palette[0], (Rgb{0x1a, 0x1c, 0x2c}));
}

TEST(Text, EachExtensionHasItsComment) {
  for (const std::string extension : {"lua", "yue", "moon", "wasmp"})
    EXPECT_EQ(comment_of_extension(extension), "--");
  for (const std::string extension : {"js", "nut", "wren"}) EXPECT_EQ(comment_of_extension(extension), "//");
  for (const std::string extension : {"fnl", "scm"}) EXPECT_EQ(comment_of_extension(extension), ";;");
  for (const std::string extension : {"rb", "py", "janet"}) EXPECT_EQ(comment_of_extension(extension), "#");
  EXPECT_EQ(comment_of_extension("txt"), "");
}

TEST(Text, AllCommentsReadAndWrite) {
  for (const std::string extension : {"lua", "js", "fnl", "py"}) {
    const std::string comment(comment_of_extension(extension));
    const std::string text =
        "code\n" + comment + " <MAP>\n" + comment + " 000:" + map_row("7") + "\n" + comment + " </MAP>\n\n";
    Level level = read(text, extension);
    EXPECT_EQ(level.map.at({0, 0}), 7);
    EXPECT_EQ(write(level, extension), text);
    level.map.set({0, 0}, 8);
    EXPECT_EQ(write(level, extension), "code\n" + comment + " <MAP>\n" + comment + " 000:" + map_row("8") +
                                           "\n" + comment + " </MAP>\n\n");
  }
}

TEST(Text, AnotherExtensionGetsItsComment) {
  const Level level = read("code\n" + kMapSection);
  EXPECT_EQ(write(level, "js"), "code\n// <MAP>\n// 001:" + map_row("1032") + "\n// </MAP>\n\n");
}

TEST(Text, TheCommentOfAnUnknownFileComesFromItsContent) {
  EXPECT_TRUE(accepts_text("x\n;; <MAP>\n;; </MAP>\n", {"txt"}));
  EXPECT_FALSE(accepts_text("x\n;; <MAPPE>\n", {"txt"}));
  EXPECT_EQ(read_text("x\n;; <MAP>\n;; </MAP>\n", {"txt"})->cart->comment, ";;");
}

TEST(Text, KeepsEveryByteOfAnUntouchedProject) {
  for (const std::string& text :
       {std::string("code without sections"),
        std::string("code\r\n-- <MAP>\r\n-- 000:" + map_row("1") + "\r\n\r\n-- </MAP>"),
        "c\n-- <COVER>\n-- 000:ff\n-- </COVER>\n" + kMapSection + "stray\n" + kMapSection,
        std::string("-- <MAP>\n-- </MAP>\n"),
        "c\n-- <MAP>\n-- 000:" + map_row("aB") + "  \n-- </MAP>\n-- <LANG>\n-- 000:10\n-- </LANG>"}) {
    EXPECT_EQ(write(read(text)), text);
  }
}

TEST(Text, AnEditChangesOnlyItsSection) {
  const std::string before = "code\n-- <SFX>\n\n-- </SFX>\n-- <COVER>\n";
  Level level = read(before + kMapSection + kTileSection + "trail");
  level.map.set({0, 2}, 0xab);
  EXPECT_EQ(write(level), before + "-- <MAP>\n-- 001:" + map_row("1032") + "\n-- 002:" + map_row("ba") +
                              "\n-- </MAP>\n\n" + kTileSection + "trail");
}

TEST(Text, AnEditKeepsCarriageReturns) {
  Level level = read("a\r\n-- <MAP>\r\n-- 000:" + map_row("1") + "\r\n-- </MAP>\r\n\r\n");
  level.map.set({0, 0}, 2);
  EXPECT_EQ(write(level), "a\r\n-- <MAP>\r\n-- 000:" + map_row("2") + "\r\n-- </MAP>\r\n\r\n");
}

TEST(Text, NewSectionsGoWhereTic80WritesThem) {
  const std::string screen = "-- <SCREEN>\n-- </SCREEN>\n\n";
  Level level = read("code\n" + kMapSection + screen);
  level.sheet(SheetId::tiles).images[2][0] = 1;
  level.sheet(SheetId::tiles).images[2][1] = 15;
  level.sheet(SheetId::tiles).flags[0] = 1;
  EXPECT_EQ(write(level), "code\n" + kTileSection + kMapSection + "-- <FLAGS>\n-- 000:10" + zeros(510) +
                              "\n-- </FLAGS>\n\n" + screen);
}

TEST(Text, AddingTheFirstSectionKeepsTheCode) {
  for (const std::string code : {"code", "code\n", "code\n\n"}) {
    Level level = read(code);
    level.map.set({0, 1}, 1);
    level.map.set({1, 1}, 0x23);
    EXPECT_EQ(write(level), code + "\n" + kMapSection);
    level = read(code + "\n" + kMapSection);
    level.map = TileMap();
    EXPECT_EQ(write(level), code);
  }
}

TEST(Text, StrayLinesDoNotBecomeCode) {
  Level level = read("code\n" + kMapSection + "stray\n");
  level.map = TileMap();
  EXPECT_EQ(write(level), "code\n-- <MAP>\n-- </MAP>\n\nstray\n");
}

TEST(Text, ABlankProjectIsALevel) {
  Level level = read("");
  EXPECT_EQ(write(level), "");
  level.map.set({0, 1}, 1);
  level.map.set({1, 1}, 0x23);
  EXPECT_EQ(write(level), kMapSection);
}

TEST(Text, OfTwoSectionsTheFirstCounts) {
  const std::string second = "-- <MAP>\n-- 000:" + map_row("99") + "\n-- </MAP>\n";
  Level level = read("c\n" + kMapSection + second);
  EXPECT_EQ(level.map.at({0, 0}), 0);
  level.map.set({0, 1}, 0);
  EXPECT_EQ(write(level), "c\n-- <MAP>\n-- 001:" + map_row("0032") + "\n-- </MAP>\n\n" + second);
}

TEST(Text, TheCartridgeGetsTheOtherBanks) {
  const std::string text = "c\n-- <TILES3>\n-- 000:" + tile_row("12") +
                           "\n-- </TILES3>\n\n-- <SFX1>\n-- 000:1" + zeros(131) + "\n-- </SFX1>\n\n";
  const WrittenLevel cart = write_tic(read(text), {}).value();
  EXPECT_TRUE(cart.dropped.empty());
  const auto chunks = parse_tic(cart.bytes).value();
  ASSERT_EQ(chunks.size(), 3u);
  EXPECT_EQ(chunks[0].bank, 1);
  EXPECT_EQ(chunks[0].type, 9);
  EXPECT_EQ(chunks[1].bank, 3);
  EXPECT_EQ(chunks[1].data, "\x21");
  EXPECT_EQ(write(read_tic(cart.bytes, {}).value()), text);
}

TEST(Text, ListsWhatACartridgeCannotHold) {
  const std::string text =
      "c\n-- <COVER>\n-- 000:ff\n-- </COVER>\n" + kMapSection + "-- <LANG>\n-- 000:10\n-- </LANG>\n";
  EXPECT_THAT(write_tic(read(text), {})->dropped,
              ElementsAre("3 lines that are neither code nor a known section",
                          "the LANG section (TIC-80 never writes it to a cartridge)"));
}

TEST(Text, ListsWhatATextProjectCannotHold) {
  std::string cart;
  append_tic_chunk(cart, {.type = 19, .data = "binary"});
  append_tic_chunk(cart, {.type = 27, .bank = 3, .data = "x"});
  append_tic_chunk(cart, {.type = 3, .data = "GIF"});
  append_tic_chunk(cart, {.type = 20, .data = "\x05"});
  append_tic_chunk(cart, {.type = 5, .data = {"a\r\nb\0c", 6}});
  const WrittenLevel text = write_text(read_tic(cart, {}).value(), {"lua"}).value();
  EXPECT_EQ(text.bytes, "a\nb\n-- <LANG>\n-- 000:50\n-- </LANG>\n\n");
  EXPECT_THAT(text.dropped, ElementsAre("code after a NUL byte", "the BINARY chunk of bank 0",
                                        "the type 27 chunk of bank 3", "the COVER chunk of bank 0",
                                        "the carriage returns of the code"));
}

TEST(Text, TheDefaultsOfACartridgeAreWrittenOut) {
  std::string cart;
  append_tic_chunk(cart, {.type = kTicDefault, .bank = 2});
  append_tic_chunk(cart, {.type = kTicCode, .data = "c"});
  const std::string text = write(read_tic(cart, {}).value());
  EXPECT_THAT(
      text,
      HasSubstr(
          "-- <WAVES2>\n-- 000:00000000ffffffff00000000ffffffff\n-- 001:0123456789abcdeffedcba9876543210\n"));
  EXPECT_THAT(text, HasSubstr("-- <PALETTE2>\n-- 000:1a1c2c5d275d"));
  EXPECT_EQ(write_tic(read(text), {})->bytes, cart);
}

TEST(Text, ErrorsSayInWhichLine) {
  const auto expect = [](const std::string& text, const std::string& place, const std::string& message) {
    const FormatError error = error_of(text);
    EXPECT_EQ(error.place, place);
    EXPECT_EQ(error.message, message);
  };
  expect("a\n\n-- <MAP>\n-- 000:" + map_row("1"), "line 3", "the section MAP has no end");
  expect("a\n-- <MAP>\n-- 000:" + map_row("1g") + "\n-- </MAP>", "line 3",
         "this row has a character that is not a hexadecimal digit");
  expect("a\n-- <MAP>\n-- 000:10\n-- </MAP>", "line 3", "a row of MAP has 480 digits, but this one has 2");
  expect("a\n-- <MAP>\n-- 136:" + map_row("1") + "\n-- </MAP>", "line 3", "MAP must have rows 0 to 135");
  expect("a\n-- <MAP>\n-- 0x1:" + map_row("1") + "\n-- </MAP>", "line 3", "this is not a row of MAP");
  expect("a\n-- <MAP>\nx\n-- </MAP>", "line 3", "this is not a row of MAP");
  expect(std::string("a\n\0", 3), "line 2", "a text project must not have NUL bytes");
  expect("s = \"-- <MAP>\"\n" + kMapSection, "line 1",
         "\"-- <MAP>\" stands before its section, but TIC-80 would read the section from here");
}

TEST(Text, CodeThatWouldEndEarlyIsNotWritten) {
  std::string cart;
  append_tic_chunk(cart, {.type = 4, .data = "m"});
  append_tic_chunk(cart, {.type = kTicCode, .data = "a\n-- <b>\nc"});
  EXPECT_THAT(write_text(read_tic(cart, {}).value(), {"lua"}).error().message,
              HasSubstr("such as \"-- <\" at the start of a line"));
  EXPECT_TRUE(write_text(read_tic(cart, {}).value(), {"js"}));
}

TEST(Text, AnEditThatTheCodeWouldHideIsNotWritten) {
  Level level = read("s = \"-- <FLAGS>\"\n" + kMapSection);
  level.sheet(SheetId::tiles).flags[1] = 1;
  EXPECT_FALSE(write_text(level, {"lua"}));
}

}  // namespace talus::text_test
