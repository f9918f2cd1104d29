// Pictures besides the sheet's in native levels.
#include <gmock/gmock.h>

#include "formats/native/native.h"
#include "pictured_level.h"

namespace talus::native_pictures_test {

using testing::HasSubstr;

std::string text_of(const Level& level) {
  const auto written = write_native(level, {});
  EXPECT_TRUE(written) << written.error().message;
  return written ? written->bytes : "";
}

std::string error_of(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  if (at != text.npos) text.replace(at, what.size(), by);
  const auto read = read_native(text, {});
  return read ? "" : to_string(read.error(), "level");
}

TEST(NativePictures, AreReadAgain) {
  Level level = pictured_level();
  level.layers.order = RenderOrder::left_up;
  level.large_tiles[1].part.mirrors_y = true;
  level.large_tiles[1].part.shift_x = -3;
  level.objects[0].image->repeats_x = true;
  level.objects[1].opacity = 0.5;
  level.objects[1].tint = {1, 2, 3};
  level.objects[1].objects[0].anchor = {0.5, 0};
  level.objects[1].by_y = true;
  const std::string text = text_of(level);
  EXPECT_THAT(text, HasSubstr("\"talus\": 6"));
  const auto read = read_native(text, {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, level);
  EXPECT_EQ(text_of(*read), text);
}

TEST(NativePictures, APictureIsStoredOnce) {
  Level level = pictured_level();
  level.large_tiles[2] = level.large_tiles[1];
  level.objects[1].objects[0].picture = level.large_tiles[1].part;
  const auto read = read_native(text_of(level), {});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->large_tiles.at(1).part.picture, read->large_tiles.at(2).part.picture);
  EXPECT_EQ(read->large_tiles.at(1).part.picture, read->objects[1].objects[0].picture.picture);
}

TEST(NativePictures, ObjectsWithoutThemKeepTheVersion) {
  Level level = pictured_level();
  level.large_tiles.clear();
  level.objects[0].image.reset();
  level.objects[1].objects[0].picture = {};
  EXPECT_THAT(text_of(level), HasSubstr("\"talus\": 5"));
}

TEST(NativePictures, WrongNumbersAreErrors) {
  const std::string text = text_of(pictured_level());
  EXPECT_THAT(error_of(text, "\"picture\": 1", "\"picture\": 3"), HasSubstr("from 0"));
  EXPECT_THAT(error_of(text, "\"size\": [8, 16]", "\"size\": [8, 5000]"), HasSubstr("large_tiles.1.size"));
  EXPECT_THAT(error_of(text, "\"size\": [8, 16]", "\"size\": [8, 16], \"rect\": [0, 0, 9, 1]"),
              HasSubstr("a part of its picture"));
  EXPECT_THAT(error_of(text, "\"place\": 0", "\"place\": -1"), HasSubstr("objects[0].place"));
}

}  // namespace talus::native_pictures_test
