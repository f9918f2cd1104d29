// Companions of maps whose objects show pictures.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "formats/native/companion.h"

namespace talus::companion_pictures_test {

std::shared_ptr<const SheetPicture> picture_of(std::uint8_t shade) {
  return std::make_shared<const SheetPicture>(SheetPicture{1, 1, {shade, shade, shade, 255}});
}

MapObject object_with(std::shared_ptr<const SheetPicture> picture, double x) {
  MapObject object{.form = MapObject::Form::tile, .position = {x, 0}, .size = {1, 1}};
  object.picture.picture = std::move(picture);
  object.picture.width = object.picture.height = 1;
  return object;
}

FormatResult<JoinedLevel> joined(const Level& level, const Level& saved, const Level& now) {
  const Format& format = *find_format("tmx");
  const auto companion = write_companion(level, saved, format, "a.tmx", true);
  EXPECT_TRUE(companion);
  return join_companion(*companion, now, format, "a.tmx");
}

TEST(CompanionPictures, ObjectsBehindEverythingAreJoined) {
  Level file;
  file.objects.push_back({.name = "o", .place = 0});
  Level level = file;
  level.tuning.shared.fall_blend = 0.125;
  const auto both = joined(level, file, file);
  ASSERT_TRUE(both) << both.error().place << both.error().message;
  EXPECT_EQ(both->level.tuning, level.tuning);
  EXPECT_EQ(both->level.objects[0].place, 0);
}

// A file has them in the order in which they are drawn, and pictures that are read again are others.
TEST(CompanionPictures, LayersInAnotherOrderAreNoChange) {
  Level level, file;
  level.tuning.shared.fall_blend = 0.125;
  level.objects.push_back({.name = "front", .objects = {object_with(picture_of(9), 1)}});
  level.objects.push_back({.name = "behind", .place = 0, .objects = {object_with(picture_of(9), 1)}});
  file.objects = {level.objects[1], level.objects[0]};
  file.objects[0].objects = {object_with(picture_of(9), 1)};
  file.objects[1].place = 1;
  Level held = file;
  held.objects = level.objects;  // as it is saved
  const auto both = joined(level, held, file);
  ASSERT_TRUE(both) << both.error().place << both.error().message;
  EXPECT_EQ(both->note, "");
  EXPECT_EQ(both->level.tuning, level.tuning);
  EXPECT_EQ(both->level.objects, file.objects);
}

// The companion has one picture fewer than the file, which was changed since.
TEST(CompanionPictures, ObjectsThatWereChangedKeepTheirPictures) {
  const auto dark = picture_of(1), light = picture_of(200);
  Level file;
  file.objects.push_back({.name = "o", .objects = {object_with(dark, 1), object_with(light, 2)}});
  Level level = file;
  level.objects[0].objects.erase(level.objects[0].objects.begin());
  Level now = file;
  now.objects[0].objects[1].position.x = 5;
  const auto both = joined(level, file, now);
  ASSERT_TRUE(both) << both.error().place << both.error().message;
  ASSERT_EQ(both->level.objects[0].objects.size(), 2U);
  EXPECT_EQ(*both->level.objects[0].objects[1].picture.picture, *light);
}

TEST(CompanionPictures, ObjectsOfTheCompanionHaveItsPictures) {
  const auto dark = picture_of(1), light = picture_of(200);
  Level file;
  file.objects.push_back({.name = "o", .objects = {object_with(dark, 1), object_with(light, 2)}});
  Level level = file;
  level.objects[0].objects.erase(level.objects[0].objects.begin());
  const auto both = joined(level, file, file);
  ASSERT_TRUE(both) << both.error().place << both.error().message;
  ASSERT_EQ(both->level.objects[0].objects.size(), 1U);
  EXPECT_EQ(*both->level.objects[0].objects[0].picture.picture, *light);
}

}  // namespace talus::companion_pictures_test
