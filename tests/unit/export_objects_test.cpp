// Layers of objects and of pictures in maps for Tiled and STI, and the same level from them again.
#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include <talus/level/placed_picture.h>
#include "export/exporter.h"
#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "paths.h"
#include "pictured_level.h"

namespace talus::export_objects_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

ReadAsset assets() {
  return [](const std::string& name) { return read_file(source_path("assets/") + name); };
}

// Two layers of tiles with the sky behind them, things between them, in the order of their y, and marks in
// front.
Level level_with_objects() {
  Level level;
  level.map = TileMap(3, 2);
  level.map.set({1, 1}, 1);
  level.sheet(SheetId::tiles).images[1].fill(5);
  level.layers.list.front().name = "back";
  level.layers.order = RenderOrder::left_up;
  TileLayer front{.name = "front", .is_ground = false};
  front.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{1, 0, 0, 0, 0, 0});
  level.layers.list.push_back(std::move(front));
  ObjectLayer sky{.name = "sky", .opacity = 0.5, .offset = {4, -2}, .parallax = {0.25, 1}, .place = 0};
  sky.image = LayerImage{"sky.png", plain_part(2, 2, kSky), true, false};
  ObjectLayer things{.name = "things", .tint = {255, 128, 0}, .place = 1, .by_y = true};
  things.objects.push_back({.form = MapObject::Form::tile,
                            .name = "rock",
                            .position = {3, 9.123456789},
                            .size = {8, 4},
                            .rotation = 90});
  things.objects.back().picture = plain_part(4, 4, kRock);
  ObjectLayer marks{.name = "marks", .is_ground = true, .visible = false};
  marks.objects.push_back(
      {.form = MapObject::Form::ellipse, .type = "egg", .position = {1, 2}, .size = {4, 6}});
  marks.objects.push_back(
      {.form = MapObject::Form::polygon, .points = {{0, 0}, {5, 0}, {0, 5}}, .one_way = true});
  marks.objects.push_back(
      {.name = "off", .position = {7, 7}, .size = {2, 2}, .visible = false, .properties = R"({"depth":3})"});
  level.objects = {sky, things, marks};
  return level;
}

class ExportObjects : public FolderTest {
 protected:
  Exported exported(const Level& level, const std::string& to, const std::string& file = "cave") const {
    const ReadAsset read = assets();
    const Exporter& exporter = *find_exporter(to);
    const std::string name = file + "." + std::string(exporter.extensions[0]);
    const auto made = exporter.make({level, name, read});
    EXPECT_TRUE(made) << to_string(made.error(), to);
    EXPECT_TRUE(write_exported(exporter, *made, path(name)));
    return made.value_or(Exported());
  }
  LoadedLevel load(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
  }
};

std::vector<std::string> names_of(const Exported& exported) {
  std::vector<std::string> names;
  for (const ExportedFile& file : exported.files) names.push_back(file.name);
  return names;
}

TEST_F(ExportObjects, MapsHaveTheLayersInTheirOrder) {
  const Exported made = exported(level_with_objects(), "tmx");
  const std::string map = made.files[0].bytes.substr(made.files[0].bytes.find("<tileset"));
  EXPECT_THAT(made.files[0].bytes, HasSubstr("renderorder=\"left-up\""));
  EXPECT_THAT(names_of(made), ElementsAre("", "cave-picture-1.png", "cave-picture-2.png", "cave-tiles.png"));
  EXPECT_THAT(made.dropped, IsEmpty());
  const auto place = [&](const char* name) { return map.find(std::string(" name=\"") + name + "\""); };
  EXPECT_LT(place("sky"), place("back"));
  EXPECT_LT(place("back"), place("things"));
  EXPECT_LT(place("things"), place("front"));
  EXPECT_LT(place("front"), place("marks"));
  EXPECT_LT(place("marks"), place("spawns"));
}

TEST_F(ExportObjects, MapsSayWhatEachLayerAndObjectHas) {
  const std::string map = exported(level_with_objects(), "tmx").files[0].bytes;
  for (const char* text :
       {R"(name="pictures" tilewidth="4" tileheight="4" tilecount="1" columns="0")",
        R"(<image source="cave-picture-2.png" width="4" height="4" />)",
        R"(opacity="0.5" offsetx="4" offsety="-2" parallaxx="0.25" repeatx="1")",
        R"(<image source="cave-picture-1.png" />)", R"(tintcolor="#ff8000" draworder="topdown")",
        R"(name="rock" gid="257" x="3" y="9.123456789" width="8" height="4" rotation="90")", "<ellipse />",
        R"(<polygon points="0,0 5,0 0,5" />)", R"(width="2" height="2" visible="0")",
        R"(<property name="depth" type="int" value="3" />)"})
    EXPECT_THAT(map, HasSubstr(text));
  EXPECT_THAT(exported(level_with_objects(), "tmj").files[0].bytes, HasSubstr(R"("draworder": "topdown")"));
}

TEST_F(ExportObjects, PointsAreWrittenAsPoints) {
  Level level;
  level.objects = {{.name = "marks", .objects = {{.name = "start", .position = {3, 4}}}}};
  EXPECT_THAT(exported(level, "tmx").files[0].bytes, HasSubstr("<point />"));
  EXPECT_THAT(exported(level, "tmj").files[0].bytes, HasSubstr(R"("point": true)"));
  EXPECT_THAT(exported(level, "sti").files[0].bytes, HasSubstr(R"(shape = "point")"));
}

// Objects that are placed by their middle: the first one is in front by that, and behind by its lower side.
TEST_F(ExportObjects, ObjectsKeepTheirOrderByY) {
  Level level;
  ObjectLayer things{.name = "things", .by_y = true};
  for (const double height : {2.0, 12.0})
    things.objects.push_back({.form = MapObject::Form::tile,
                              .name = height == 2 ? "low" : "tall",
                              .position = {8, height == 2 ? 9.0 : 8.0},
                              .size = {4, height},
                              .picture = plain_part(4, static_cast<int>(height), kRock),
                              .anchor = {0.5, 0.5}});
  level.objects = {things};
  for (const std::string to : {"tmx", "tmj"}) {
    exported(level, to);
    const ObjectLayer again = load("cave." + to).level.objects.at(0);
    std::vector<std::string> drawn;
    for (const std::size_t i : drawn_pictures(again)) drawn.push_back(again.objects[i].name);
    EXPECT_THAT(drawn, ElementsAre("tall", "low")) << to;
  }
}

TEST_F(ExportObjects, TheLevelComesBackFromItsMap) {
  for (const std::string to : {"tmx", "tmj"}) {
    Level level = level_with_objects();
    exported(level, to);
    const LoadedLevel again = load("cave." + to);
    EXPECT_THAT(again.dropped, IsEmpty()) << to;
    EXPECT_EQ(again.level.layers, level.layers) << to;
    ASSERT_EQ(again.level.objects.size(), 3u) << to;
    EXPECT_EQ(again.level.objects[0].image->path, "cave-picture-1.png");
    EXPECT_EQ(again.level.objects[1].objects[0].tile, 257u);
    level.objects[0].image->path = "cave-picture-1.png";
    level.objects[1].objects[0].tile = 257;
    level.objects[2].objects[1].properties = R"({"one_way":true})";
    EXPECT_EQ(again.level.objects, level.objects) << to;
    exported(again.level, to, "again");
    EXPECT_EQ(load("again." + to).level.objects[1], level.objects[1]) << to << ": nothing moves any more";
  }
}

// A picture that is turned, moved and fitted in, and an anchor in the middle, look the same.
TEST_F(ExportObjects, PicturesOfObjectsAreDrawnWhereTheyWere) {
  Level level = level_with_objects();
  MapObject& rock = level.objects[1].objects[0];
  rock.anchor = {0.5, 0.5};
  rock.picture = plain_part(6, 2, kRock);
  rock.picture.swaps_axes = rock.picture.mirrors_y = rock.picture.keeps_ratio = true;
  rock.picture.shift_x = 1;
  exported(level, "tmj");
  const Level again = load("cave.tmj").level;
  const PlacedPicture before = placed(rock), now = placed(again.objects.at(1).objects.at(0));
  const Rect a = bounds_of(before), b = bounds_of(now);
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(a.w, b.w, 1e-9);
  EXPECT_NEAR(a.h, b.h, 1e-9);
  EXPECT_EQ(now.part.width, 2) << "its columns are rows";
  EXPECT_EQ(now.part.height, 6);
}

TEST_F(ExportObjects, WhatTiledRemovesStaysAway) {
  exported(level_with_objects(), "tmx");
  std::string map = bytes_of("cave.tmx");
  for (const char* tag : {"imagelayer", "objectgroup"}) {
    const std::string end = std::string("</") + tag + ">";
    const auto from = map.find(std::string("<") + tag + " id"), to = map.find(end, from) + end.size();
    map.erase(from, to - from);
  }
  put("cave.tmx", map);
  const Level again = load("cave.tmx").level;
  ASSERT_EQ(again.objects.size(), 1u);
  EXPECT_EQ(again.objects[0].name, "marks");
}

TEST_F(ExportObjects, StiHasLayersPicturesAndColoursAsItReadsThem) {
  Level level = level_with_objects();
  level.objects[2].objects[2].properties = R"({"collidable":true})";
  const Exported made = exported(level, "sti");
  const std::string& map = made.files[0].bytes;
  for (const char* text :
       {"renderorder = \"left-up\"", "image = \"cave-picture-2.png\",\n     width = 4,\n     height = 4",
        "type = \"imagelayer\"", "image = \"cave-picture-1.png\",\n   repeatx = true",
        "tintcolor = {255, 128, 0}", "draworder = \"topdown\"", "shape = \"ellipse\"", "gid = 273"})
    EXPECT_THAT(map, HasSubstr(text));
  EXPECT_THAT(names_of(made), Contains("cave-picture-2.png"));
  const auto marks = map.find("name = \"marks\"");
  EXPECT_THAT(map.substr(marks, map.find("name = \"spawns\"") - marks), Not(HasSubstr("collidable")))
      << "the ground of objects is in the slopes";
  EXPECT_THAT(made.dropped, ElementsAre("collision, which bump.lua cannot have, with 1 curve"));
}

TEST_F(ExportObjects, WhatHasNoPictureIsSaid) {
  Level level = level_with_objects();
  level.objects[0].image->part = {};
  level.objects[1].objects[0].picture = {};
  level.objects[2].objects[0].form = MapObject::Form::other;
  const Exported made = exported(level, "tmx");
  EXPECT_THAT(made.dropped,
              ElementsAre("the picture of the layer \"sky\", which is missing",
                          "the missing pictures of 1 object: boxes stand for them",
                          "the text or form of 1 object that Talus does not draw: boxes stand for them"));
  const Level again = load("cave.tmx").level;
  EXPECT_EQ(again.objects.at(1).objects.at(0).form, MapObject::Form::box);
  const ReadAsset read = assets();
  EXPECT_THAT(find_exporter("tmx")->make({level_with_objects(), "-", read})->dropped,
              Contains("the pictures of layers and objects, which go beside a file"));
}

// Older versions wrote the objects into the property alone.
TEST_F(ExportObjects, MapsOfOlderVersionsKeepTheirObjects) {
  Level level = level_with_objects();
  level.objects.erase(level.objects.begin(), level.objects.begin() + 2);
  exported(level, "tmx");
  std::string map = bytes_of("cave.tmx");
  const auto mark = map.find("<property name=\"talus_objects\""), end = map.find("/>", mark) + 2;
  map.erase(mark, end - mark);
  const auto marks = map.find("<objectgroup"), after = map.find("</objectgroup>", marks) + 14;
  map.erase(marks, after - marks);
  put("cave.tmx", map);
  LoadedLevel old = load("cave.tmx");
  ASSERT_EQ(old.level.objects.size(), 1u);
  EXPECT_EQ(old.level.objects[0].objects.size(), 3u);
  old.level.objects[0].objects[0].position = {2, 2};
  const auto saved = save_level(old.level, *find_format("tmx"), path("cave.tmx"), old.companion);
  ASSERT_TRUE(saved) << to_string(saved.error(), "cave.tmx");
  EXPECT_EQ(load("cave.tmx").level.objects.at(0).objects.at(0).position, (Vec2{2, 2}));
}

}  // namespace talus::export_objects_test
