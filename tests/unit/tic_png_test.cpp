// TIC-80 cartridges in PNG pictures: in a chunk, and in the low bits of the pixels.
#include "formats/tic80/tic_png.h"

#include <gtest/gtest.h>

#include "formats/pictures/png_picture.h"
#include "formats/tic80/tic_cart.h"
#include "png_bytes.h"

namespace talus::tic_png_test {

// A cart whose tile 1 has the flags 5 and whose map has tile 7 at (2, 0).
std::string small_cart() {
  std::string bytes;
  append_tic_chunk(bytes, {.type = 4, .data = std::string_view("\0\0\7", 3)});
  append_tic_chunk(bytes, {.type = 6, .data = std::string_view("\0\5", 2)});
  append_tic_chunk(bytes, {.type = kTicCode, .data = "-- script: lua"});
  return bytes;
}

std::string with_chunk(const std::string& content, const std::string& type = "caRt") {
  const std::string picture = rgb_png(1, {{255, 0, 0}});
  const std::string end = png_chunk("IEND", "");
  return picture.substr(0, picture.size() - end.size()) + png_chunk(type, content) + end;
}

// A picture of `width` px. The low bits of its bytes hold a header and as much of `hidden` as fits; all other
// bits are 1.
std::string with_hidden(const std::string& hidden, std::uint32_t bits, std::uint32_t width,
                        std::size_t rows) {
  std::string pixels(4 * width * rows, '\xff');
  const auto put = [&](std::size_t byte, std::size_t bit, bool on) {
    if (byte >= pixels.size()) return;
    const int mask = 1 << bit;
    pixels[byte] = static_cast<char>(on ? pixels[byte] | mask : pixels[byte] & ~mask);
  };
  const std::uint32_t header = bits | static_cast<std::uint32_t>(hidden.size()) << 8;
  for (std::size_t i = 0; i < 32; ++i) put(i / 4, i % 4, header >> i & 1);
  for (std::size_t i = 0; i < 8 * hidden.size(); ++i)
    put(8 + i / bits, i % bits, static_cast<std::uint8_t>(hidden[i / 8]) >> i % 8 & 1);
  std::vector<std::string> lines;
  for (std::size_t row = 0; row < rows; ++row) lines.push_back(pixels.substr(4 * width * row, 4 * width));
  return png_of(width, 6, lines);
}

std::string error_of(const std::string& bytes) {
  const auto level = read_tic_png(bytes, {"png"});
  return level ? "" : to_string(level.error(), "x.png");
}

constexpr const char* kNoCart =
    "x.png: error: is a picture without a TIC-80 cartridge; to take its pixels, use File > Import a picture "
    "or talus import --into";

TEST(TicPng, ReadsTheCartInTheChunk) {
  const auto level = read_tic_png(with_chunk(zipped(small_cart())), {"png"});
  ASSERT_TRUE(level);
  EXPECT_EQ(level->map.at({2, 0}), 7);
  EXPECT_EQ(level->sheet(SheetId::tiles).flags[1], 5);
  EXPECT_EQ(*level, read_tic(small_cart(), {"tic"}).value());
  EXPECT_EQ(write_tic(*level, {"tic"})->bytes, small_cart());
}

TEST(TicPng, ReadsTheCartInTheLowBitsOfThePixels) {
  const std::string packed = zipped(small_cart());
  for (const std::uint32_t bits : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
    const auto level = read_tic_png(with_hidden(packed, bits, 16, 16), {"png"});
    ASSERT_TRUE(level) << bits;
    EXPECT_EQ(write_tic(*level, {"tic"})->bytes, small_cart()) << bits;
  }
}

// Worked out by hand: 1 bit for each byte; the sizes, and the first bytes of a zlib stream, 0x78 0x9c.
TEST(TicPng, TheLowBitsAreThoseOfTic80) {
  const std::string picture = with_hidden("\x78\x9c", 1, 4, 2);
  const auto pixels = read_rgba(picture);
  ASSERT_TRUE(pixels);
  const std::string_view header("\xf1\xf0\xf2\xf0\xf0\xf0\xf0\xf0", 8);
  EXPECT_EQ(pixels->bytes.substr(0, 8), header);
  EXPECT_EQ(pixels->bytes.substr(8, 8), "\xfe\xfe\xfe\xff\xff\xff\xff\xfe");
  EXPECT_EQ(error_of(picture),
            "x.png: error: has a damaged cartridge in it, which cannot be unpacked: the end is missing");
}

TEST(TicPng, TheChunkWinsOverThePixels) {
  const std::string hidden = with_hidden(zipped("x"), 8, 16, 16);
  const std::string end = png_chunk("IEND", "");
  const std::string both =
      hidden.substr(0, hidden.size() - end.size()) + png_chunk("caRt", zipped(small_cart())) + end;
  EXPECT_EQ(write_tic(read_tic_png(both, {"png"}).value(), {"tic"})->bytes, small_cart());
}

TEST(TicPng, IsReadByItsContentAndNeverWritten) {
  const auto loaded = read_level(with_chunk(zipped(small_cart())), {"tic"});
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->format->id, "tic-png");
  EXPECT_EQ(loaded->format->write, nullptr);
  EXPECT_EQ(format_for_file("cart.png"), nullptr);
}

TEST(TicPng, APictureWithoutACartSaysHowToUseIt) {
  EXPECT_EQ(error_of(rgb_png(2, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {1, 1, 1}})), kNoCart);
  EXPECT_EQ(error_of(rgb_png(1, {{1, 2, 3}})), kNoCart);  // too small for a header
  EXPECT_EQ(error_of(with_chunk("")), kNoCart);
  EXPECT_EQ(error_of(with_chunk(zipped(small_cart()), "caRd")), kNoCart);
  EXPECT_EQ(error_of(with_hidden("no zlib", 2, 16, 16)), kNoCart);
  EXPECT_EQ(error_of(with_hidden("", 1, 16, 16)), kNoCart);
  EXPECT_EQ(error_of(with_hidden("\x78\x9c" + std::string(126, 'x'), 8, 8, 4)),
            kNoCart);  // 120 bytes of room
  EXPECT_EQ(error_of(png_header(1025, 1, 2)),
            "x.png: error: is 1025x1 px, but may have at most 1024x1024 px");
}

TEST(TicPng, DamagedPicturesAreErrors) {
  const std::string packed = zipped(small_cart());
  EXPECT_EQ(error_of(with_chunk("no zlib")),
            "x.png: error: has a damaged cartridge in it, which cannot be unpacked: incorrect header check");
  EXPECT_EQ(error_of(with_chunk(packed.substr(0, packed.size() - 5))),
            "x.png: error: has a damaged cartridge in it, which cannot be unpacked: the end is missing");
  EXPECT_EQ(error_of(with_chunk(zipped(std::string((4 << 20) + 1, '\0')))),
            "x.png: error: has a cartridge in it that unpacks to more than 4 MB");
  EXPECT_EQ(error_of(with_chunk(zipped(""))), "x.png: error: has an empty cartridge in it");
  EXPECT_EQ(error_of(with_chunk(zipped(small_cart().substr(0, 9)))),
            "x.png:byte 7 of the cartridge in it: error: the file ends inside a chunk's header");
  const std::string whole = with_chunk(packed);
  for (std::size_t size = 1; size + 12 < whole.size(); ++size)
    EXPECT_FALSE(read_tic_png(whole.substr(0, size), {"png"})) << size;
}

// A small picture must not unpack to many times its size.
TEST(TicPng, APictureThatUnpacksTooLargeIsRefused) {
  const std::string bytes =
      png_header(8, 8, 6) + png_chunk("IDAT", zipped(std::string(1 << 20, '\0'))) + png_chunk("IEND", "");
  EXPECT_EQ(error_of(bytes), "x.png: error: has more data than a picture of its size can have");
}

}  // namespace talus::tic_png_test
