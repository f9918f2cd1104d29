// Pictures of Aseprite.
#include <gmock/gmock.h>

#include "formats/pictures/aseprite_picture.h"
#include "zipped.h"

namespace talus::aseprite_test {

using testing::ElementsAre;

std::string number(std::uint32_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(std::uint64_t{value} >> (8 * i) & 255);
  return bytes;
}
std::string chunk(std::uint32_t type, const std::string& content) {
  return number(static_cast<std::uint32_t>(content.size()) + 6, 4) + number(type, 2) + content;
}
std::string layer(bool is_visible, int opacity = 255, int type = 0, int nested = 0) {
  return chunk(0x2004, number(is_visible ? 1 : 0, 2) + number(static_cast<std::uint32_t>(type), 2) +
                           number(static_cast<std::uint32_t>(nested), 2) + number(0, 6) +
                           number(static_cast<std::uint32_t>(opacity), 1) + number(0, 3) + number(0, 2));
}
// Pixels of a layer with the corner at (x, y).
std::string cel(int layer, int x, int y, std::uint32_t width, std::uint32_t height, const std::string& pixels,
                bool is_packed = false) {
  return chunk(0x2005, number(static_cast<std::uint32_t>(layer), 2) +
                           number(static_cast<std::uint32_t>(x), 2) +
                           number(static_cast<std::uint32_t>(y), 2) + number(255, 1) +
                           number(is_packed ? 2 : 0, 2) + number(0, 7) + number(width, 2) +
                           number(height, 2) + (is_packed ? zipped(pixels) : pixels));
}
std::string ase(std::uint32_t width, std::uint32_t height, std::uint32_t bits, const std::string& chunks) {
  std::string header = number(0, 4) + number(0xa5e0, 2) + number(1, 2) + number(width, 2) +
                       number(height, 2) + number(bits, 2) + number(1, 4);
  header.resize(128);
  return header + number(static_cast<std::uint32_t>(chunks.size()) + 16, 4) + number(0xf1fa, 2) +
         std::string(10, '\0') + chunks;
}

// Of all pixels, the four parts of each.
std::vector<int> parts_of(const std::string& bytes) {
  const auto picture = read_aseprite(bytes, 64);
  EXPECT_TRUE(picture) << to_string(picture.error(), "a");
  std::vector<int> parts;
  for (const char part : picture ? picture->bytes : "") parts.push_back(static_cast<std::uint8_t>(part));
  return parts;
}
std::string error_of(const std::string& bytes) {
  const auto picture = read_aseprite(bytes, 64);
  return picture ? "" : to_string(picture.error(), "a");
}

const std::string kRed("\xff\0\0\xff", 4), kGreen("\0\xff\0\xff", 4), kClear(4, '\0');

TEST(Aseprite, LayersLieOverOneAnother) {
  const std::string chunks =
      layer(true) + layer(true) + cel(0, 0, 0, 2, 1, kRed + kRed, true) + cel(1, 0, 0, 2, 1, kGreen + kClear);
  EXPECT_THAT(parts_of(ase(2, 1, 32, chunks)), ElementsAre(0, 255, 0, 255, 255, 0, 0, 255));
}

TEST(Aseprite, HiddenLayersAndGroupsAreNotDrawn) {
  const std::string chunks = layer(false) + layer(false, 255, 1) + layer(true, 255, 0, 1) + layer(true, 128) +
                             cel(0, 0, 0, 1, 1, kRed) + cel(2, 0, 0, 1, 1, kRed) + cel(3, 0, 0, 1, 1, kGreen);
  EXPECT_THAT(parts_of(ase(1, 1, 32, chunks)), ElementsAre(0, 255, 0, 128));
}

TEST(Aseprite, CelsMayLieOutsideOfThePicture) {
  const std::string chunks = layer(true) + cel(0, -1, -1, 2, 2, kRed + kRed + kRed + kGreen);
  EXPECT_THAT(parts_of(ase(1, 1, 32, chunks)), ElementsAre(0, 255, 0, 255));
}

TEST(Aseprite, IndicesAndGreysAreColours) {
  const std::string palette =
      chunk(0x2019, number(2, 4) + number(0, 4) + number(1, 4) + number(0, 8) + number(1, 2) + kGreen +
                        number(1, 2) + "n" + number(0, 2) + kRed);
  EXPECT_THAT(parts_of(ase(3, 1, 8, palette + layer(true) + cel(0, 0, 0, 3, 1, std::string("\1\0\7", 3)))),
              ElementsAre(255, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 0))
      << "index 0 is transparent, and 7 is no colour";
  EXPECT_THAT(parts_of(ase(1, 1, 16, layer(true) + cel(0, 0, 0, 1, 1, "\x50\x80"))),
              ElementsAre(0x50, 0x50, 0x50, 0x80));
}

TEST(Aseprite, WrongFilesAreErrors) {
  const std::string good = ase(1, 1, 32, layer(true) + cel(0, 0, 0, 1, 1, kRed));
  EXPECT_EQ(error_of("x"), "a: error: is not a picture of Aseprite");
  EXPECT_EQ(error_of(good.substr(0, good.size() - 1)), "a:byte 128: error: must have a frame of the picture");
  EXPECT_EQ(error_of(ase(1, 1, 24, "")),
            "a:byte 12: error: has pixels of 24 bits, but must have 8, 16 or 32");
  EXPECT_EQ(error_of(ase(65, 1, 32, "")), "a: error: is 65x1 px, but may have at most 64x64 px");
  EXPECT_EQ(error_of(ase(1, 1, 32, number(5, 4) + "abcd")),
            "a:byte 144: error: the picture ends in the middle of a chunk");
  EXPECT_EQ(error_of(ase(1, 1, 32, cel(0, 0, 0, 1, 1, kRed))),
            "a:byte 144: error: has pixels of a layer that it does not have");
  EXPECT_EQ(error_of(ase(1, 1, 32, layer(true, 255, 2) + cel(0, 0, 0, 1, 1, kRed))),
            "a:byte 168: error: has a layer of another kind than pixels");
  EXPECT_EQ(error_of(ase(1, 1, 32, layer(true) + cel(0, 0, 0, 2, 1, kRed))),
            "a:byte 168: error: has fewer pixels than it says");
  EXPECT_EQ(error_of(ase(1, 1, 32, layer(true) + cel(0, 0, 0, 1, 1, kRed + kRed, true))),
            "a:byte 168: error: has pixels that cannot be unpacked");
  EXPECT_EQ(error_of(ase(1, 1, 32, layer(true) + cel(0, 0, 0, 65535, 65535, kRed))),
            "a:byte 168: error: has layers of more than 67108864 pixels in all");
}

}  // namespace talus::aseprite_test
