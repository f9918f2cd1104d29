// Bodies, curves and objects that are saved into the maps of Tiled that they came from.
#include <gmock/gmock.h>

#include "folder_test.h"

namespace talus::save_tiled_objects_test {

using testing::HasSubstr;

class SaveTiledObjects : public FolderTest {
 protected:
  // Opens the file, edits its level and saves it. Returns the error; empty if there is none.
  template <class Edit>
  std::string edit(const std::string& name, Edit change) {
    auto loaded = load_level(path(name));
    if (!loaded) return to_string(loaded.error(), name);
    change(loaded->level);
    const auto saved = save_level(loaded->level, *loaded->format, path(name), loaded->companion);
    if (!saved) return to_string(saved.error(), name);
    const Level again = level_of(name);
    EXPECT_EQ(again.spawns, loaded->level.spawns);
    EXPECT_EQ(again.curves, loaded->level.curves);
    EXPECT_EQ(again.objects, loaded->level.objects);
    return "";
  }
  Level level_of(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? loaded->level : Level();
  }
};

void nothing(Level&) {}

// A map with these layers behind its layer of tiles.
std::string map_with(const std::string& layers,
                     const std::string& next = "nextlayerid=\"8\" nextobjectid='9'",
                     const std::string& version = "1.10") {
  return "<?xml version=\"1.0\"?>\r\n<map version=\"" + version +
         "\" orientation=\"orthogonal\" width=\"4\" height=\"2\" tilewidth=\"8\" tileheight=\"8\" " + next +
         ">\r\n\t<tileset name=\"t\" firstgid=\"1\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"4\" "
         "columns=\"2\"/>\r\n\t<layer id='1' name=\"ground\" width=\"4\" height=\"2\"><data "
         "encoding=\"csv\">1,2,0,1,1,1,0,0</data></layer>\r\n" +
         layers + "</map>\r\n";
}

// Two bodies, with what nobody knows around them.
std::string bodies_with(const std::string& first, const std::string& second) {
  return "\t<objectgroup id='3' name='things'><!-- a > b -->\r\n\t\t" + first +
         "\r\n\t\t<!-- <object/> -->\r\n\t\t" + second + "\r\n\t</objectgroup>\r\n";
}
const char* const kPlayer =
    "<object id='4' name='hero' type='player' x='2' y='3' width='6' height='8' visible=\"0\">"
    "<properties><property name='hp' type='int' value='3'/></properties></object>";
const char* const kBall = "<object id='5' type='ball' x='20' y='1'  width='4' height='4'/>";

TEST_F(SaveTiledObjects, UnchangedBodiesKeepTheirBytes) {
  const std::string text = map_with(bodies_with(kPlayer, kBall));
  put("a.tmx", text);
  EXPECT_EQ(edit("a.tmx", nothing), "");
  EXPECT_EQ(bytes_of("a.tmx"), text);
}

TEST_F(SaveTiledObjects, AMovedBodyKeepsTheRestOfItsObject) {
  put("a.tmx", map_with(bodies_with(kPlayer, kBall)));
  const auto change = [](Level& level) {
    ASSERT_EQ(level.spawns.size(), 2U);
    level.spawns[0].position.x = 5.5;
    level.spawns[1].name = "b";
    level.spawns[1].velocity = {1.5, 0};
    level.spawns[1].foot = Foot::centre;
  };
  EXPECT_EQ(edit("a.tmx", change), "");
  std::string player = kPlayer;
  player.replace(player.find("x='2'"), 5, "x='5.5'");
  const std::string ball =
      "<object id='5' type='ball' x='20' y='1'  width='4' height='4' name=\"b\">\r\n\t\t\t<properties>"
      "\r\n\t\t\t\t<property name=\"vx\" type=\"float\" value=\"1.5\"/>"
      "\r\n\t\t\t\t<property name=\"foot\" value=\"centre\"/>\r\n\t\t\t</properties>\r\n\t\t</object>";
  EXPECT_EQ(bytes_of("a.tmx"), map_with(bodies_with(player, ball)));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledObjects, ANewBodyComesIntoTheLayerOfBodies) {
  put("a.tmx", map_with(bodies_with(kPlayer, kBall)));
  const auto change = [](Level& level) {
    Spawn spawn;
    spawn.position = {1, 2};
    spawn.size = {3, 4};
    level.spawns.push_back(spawn);
  };
  EXPECT_EQ(edit("a.tmx", change), "");
  const std::string layer =
      "\t<objectgroup draworder=\"index\" id=\"8\" name=\"bodies\">\r\n\t\t"
      "<object id=\"9\" type=\"ball\" x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>\r\n\t"
      "</objectgroup>\r\n";
  const std::string first =
      map_with(bodies_with(kPlayer, kBall) + layer, "nextlayerid=\"9\" nextobjectid='10'");
  EXPECT_EQ(bytes_of("a.tmx"), first);
  EXPECT_EQ(edit("a.tmx", nothing), "");
  EXPECT_EQ(bytes_of("a.tmx"), first);
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledObjects, BodiesOfAllKindsComeBack) {
  put("a.tmx", map_with(""));
  const auto change = [](Level& level) {
    for (const BodyTraits& kind : body_kinds()) level.spawns.emplace_back().kind = *find_body_kind(kind.word);
  };
  EXPECT_EQ(edit("a.tmx", change), "") << "which compares them";
  EXPECT_EQ(level_of("a.tmx").spawns.size(), body_kinds().size());
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(" type=\"crate\""));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledObjects, VersionsCallTheKindTypeOrClass) {
  for (const auto& [version, key] : std::vector<std::pair<std::string, std::string>>{
           {"1.8", "type"}, {"1.9", "class"}, {"1.10", "type"}, {"1.12", "type"}}) {
    put("a.tmx", map_with("", "nextobjectid=\"1\"", version));
    EXPECT_EQ(edit("a.tmx", [](Level& level) { level.spawns.push_back({}); }), "");
    EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(" " + key + "=\"ball\"")) << version;
  }
}

TEST_F(SaveTiledObjects, ARemovedBodyTakesItsObject) {
  put("a.tmx", map_with(bodies_with(kPlayer, kBall)));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.spawns.erase(level.spawns.begin()); }), "");
  EXPECT_EQ(bytes_of("a.tmx"),
            map_with("\t<objectgroup id='3' name='things'><!-- a > b -->\r\n\t\t<!-- <object/> -->\r\n\t\t" +
                     std::string(kBall) + "\r\n\t</objectgroup>\r\n"));
}

// One is taken away and the other is moved; then the first comes back, as by Undo.
TEST_F(SaveTiledObjects, ABodyComesBackAtItsPlace) {
  put("a.tmx", map_with(bodies_with(kBall, kPlayer)));
  const std::vector<Spawn> before = level_of("a.tmx").spawns;
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.spawns.erase(level.spawns.begin());
                   level.spawns[0].position.x = 1;
                 }),
            "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<object id='4' name='hero' type='player' x='1'"));
  EXPECT_EQ(edit("a.tmx", [&](Level& level) { level.spawns = before; }), "");
  EXPECT_EQ(level_of("a.tmx").spawns, before);
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledObjects, TuningStaysInTheCompanion) {
  put("a.tmx", map_with(bodies_with(kPlayer, kBall)));
  const auto change = [](Level& level) {
    level.tuning.shared.fall_blend = 0.125;
    level.spawns[1].position = {9, 9};
  };
  EXPECT_EQ(edit("a.tmx", change), "");
  EXPECT_TRUE(exists("a.tmx.talus.json"));
  EXPECT_THAT(bytes_of("a.tmx.talus.json"), testing::Not(HasSubstr("spawns\": [")));
  EXPECT_EQ(level_of("a.tmx").spawns.size(), 2U);
}

TEST_F(SaveTiledObjects, BodiesInMovedGroupsAreWrittenFromThere) {
  put("a.tmx", map_with("<group offsetx=\"2.5\"><objectgroup name=\"o\" offsety='-1'>" + std::string(kBall) +
                        "</objectgroup></group>"));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   ASSERT_EQ(level.spawns[0].position, (Vec2{22.5, 0}));
                   level.spawns[0].position = {10, 5};
                 }),
            "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("x='7.5' y='6'"));
}

TEST_F(SaveTiledObjects, APointThatGetsASizeIsABox) {
  put("a.tmx", map_with("<objectgroup name='o'><object id='2' type='ball' x='3' y='3'><point/></object>"
                        "</objectgroup>"));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.spawns[0].position.x = 4; }), "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<object id='2' type='ball' x='4' y='3'><point/></object>"));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.spawns[0].size = {5, 6}; }), "");
  EXPECT_THAT(bytes_of("a.tmx"),
              HasSubstr("<object id='2' type='ball' x='4' y='3' width=\"5\" height=\"6\">"));
}

TEST_F(SaveTiledObjects, APictureOfATileKeepsItsPlaceAtTheBottom) {
  put("a.tmx", map_with("<objectgroup name='o'><object id='2' type='ball' gid='1' x='3' y='13' width='8' "
                        "height='8'/></objectgroup>"));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   ASSERT_EQ(level.spawns[0].position, (Vec2{3, 5}));
                   level.spawns[0].position.y = 2;
                 }),
            "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("gid='1' x='3' y='10' width='8'"));
}

TEST_F(SaveTiledObjects, ObjectsOfTemplatesGetOnlyWhatWasEdited) {
  put("b.tx",
      "<template><object type=\"ball\" width=\"6\" height=\"8\"><properties><property name=\"vx\" "
      "type=\"float\" value=\"2\"/></properties></object></template>");
  put("a.tmx", map_with("<objectgroup name='o'><object id='2' template='b.tx' x='3' y='3'/></objectgroup>"));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.spawns.at(0).position.x = 4; }), "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<object id='2' template='b.tx' x='4' y='3'/>"));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.spawns.at(0).velocity.x = 0; }), "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<property name=\"vx\" type=\"int\" value=\"0\"/>"));
}

TEST_F(SaveTiledObjects, HostileNumbersGetNewOnes) {
  put("a.tmx", map_with("<objectgroup name='bodies'><object id='7' type='ball'/><object id='7' type='ball'/>"
                        "<object id='99999999999999999999' type='ball'/></objectgroup>",
                        "nextobjectid=\"-3\""));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.spawns.emplace_back().name = "n";
                   level.spawns.emplace_back().name = "m";
                 }),
            "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<object id=\"1\" name=\"n\""));
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<object id=\"2\" name=\"m\""));
}

TEST_F(SaveTiledObjects, CurvesOfEveryFormComeBack) {
  put("a.tmx", map_with(""));
  const std::vector<LevelCurve> curves = {
      {"line", {Segment{{1.25, 2}, {9, 8.5}}, Curve::Faces::both}, ""},
      {"", {Segment{{4, 2}, {4, 8}}, Curve::Faces::down}, ""},
      {"hill", {Arc{{12, 12}, 6, 7, 17, true}, Curve::Faces::up}, ""},
      {"bow", {Parabola{{2, 3}, {20, 9}, 14}, Curve::Faces::up}, ""},
      {"s", {Cubic{{2, 3}, {20, 9}, 0.3, -0.1}, Curve::Faces::down}, ""},
      {"wave", {Sine{2, 30, 8.1, 1.7, 9.3, 0.2}, Curve::Faces::both}, ""},
      {"steps", {Polyline{1, 10, {2, 5, 3, 3.5}}, Curve::Faces::up}, ""},
      {"two", {Polyline{1, 10, {2, 5}}, Curve::Faces::up}, ""},
  };
  EXPECT_EQ(edit("a.tmx", [&](Level& level) { level.curves = curves; }), "");
  EXPECT_EQ(level_of("a.tmx").curves, curves);
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<objectgroup draworder=\"index\" id=\"8\" name=\"curves\">"));
  const std::string text = bytes_of("a.tmx");
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.curves[2].curve.form = Arc{{12, 13}, 6, 7, 17, true};
                 }),
            "");
  EXPECT_EQ(bytes_of("a.tmx").substr(0, text.find("hill")), text.substr(0, text.find("hill")));
  EXPECT_EQ(bytes_of("a.tmx").substr(bytes_of("a.tmx").find("bow")), text.substr(text.find("bow")));
}

TEST_F(SaveTiledObjects, OneLineOfSeveralIsTakenOut) {
  put("a.tmx", map_with("<objectgroup name='curves'><object id='2' name='p' x='1' y='1'><polyline "
                        "points='0,0 4,4 20,3'/></object></objectgroup>"));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   ASSERT_EQ(level.curves.size(), 2U);
                   level.curves.erase(level.curves.begin());
                 }),
            "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("points=\"0,0 16,-1\""));
}

std::string walls_with(const std::string& objects) {
  return "\t<objectgroup id='3' name='walls' color=\"#ff0000\">\r\n" + objects + "\t</objectgroup>\r\n";
}
const char* const kWall =
    "\t\t<object id='4' name='w' class='c' x='1' y='2' width='6' height='4' rotation='3' locked='1'/>\r\n";
const char* const kArea =
    "\t\t<object id='6' x='1' y='2'><polygon points=\"0,0 4,0 4,4\"/><!-- p --></object>\r\n";

TEST_F(SaveTiledObjects, OnlyEditedFieldsOfObjectsChange) {
  put("a.tmx", map_with(walls_with(std::string(kWall) + kArea)));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   MapObject& wall = level.objects.at(0).objects.at(0);
                   wall.position = {2.5, 2};
                   wall.rotation = 0;
                   wall.type = "d & e";
                   wall.properties = R"({"one_way":true})";
                   wall.one_way = true;
                   level.objects[0].objects[1].points[2] = {5, 6};
                 }),
            "");
  EXPECT_EQ(bytes_of("a.tmx"),
            map_with(walls_with(
                "\t\t<object id='4' name='w' class='d &amp; e' x='2.5' y='2' width='6' height='4' locked='1'>"
                "\r\n\t\t\t<properties>\r\n\t\t\t\t<property name=\"one_way\" type=\"bool\" value=\"true\"/>"
                "\r\n\t\t\t</properties>\r\n\t\t</object>\r\n"
                "\t\t<object id='6' x='1' y='2'><polygon points=\"0,0 4,0 5,6\"/><!-- p --></object>\r\n")));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledObjects, NewAndRemovedObjectsChangeNoOthers) {
  put("a.tmx", map_with(walls_with(std::string(kWall) + kArea)));
  const MapObject point{.name = "p", .type = "t", .position = {3, 4}};
  EXPECT_EQ(edit("a.tmx",
                 [&](Level& level) {
                   std::vector<MapObject>& all = level.objects.at(0).objects;
                   all.erase(all.begin());
                   all.insert(all.begin(), point);
                   all.push_back({.form = MapObject::Form::ellipse, .position = {1, 1}, .size = {2, 2}});
                 }),
            "");
  EXPECT_EQ(
      bytes_of("a.tmx"),
      map_with(walls_with("\t\t<object id=\"9\" name=\"p\" type=\"t\" x=\"3\" y=\"4\">\r\n\t\t\t<point/>"
                          "\r\n\t\t</object>\r\n" +
                          std::string(kArea) +
                          "\t\t<object id=\"10\" x=\"1\" y=\"1\" width=\"2\" height=\"2\">\r\n\t\t\t"
                          "<ellipse/>\r\n\t\t</object>\r\n"),
               "nextlayerid=\"8\" nextobjectid='11'"));
}

TEST_F(SaveTiledObjects, PropertiesKeepTheirTypes) {
  const auto with = [](const std::string& color, const std::string& number) {
    return map_with(
        walls_with("<object id='1' x='1' y='1'><properties><property name='c' type='color' value='" + color +
                   "'/><property name='o' type='object' value='" + number + "'/></properties></object>"));
  };
  put("a.tmx", with("#ff000000", "4"));
  EXPECT_EQ(
      edit("a.tmx",
           [](Level& level) { level.objects.at(0).objects.at(0).properties = R"({"c":"#ff123456","o":6})"; }),
      "");
  EXPECT_EQ(bytes_of("a.tmx"), with("#ff123456", "6"));
}

TEST_F(SaveTiledObjects, LayersOfObjectsAreMovedRenamedAndMade) {
  const std::string walls = walls_with(kWall),
                    areas = "\t<objectgroup name='areas'>\r\n" + std::string(kArea) + "\t</objectgroup>\r\n";
  put("a.tmx", map_with(walls + bodies_with(kPlayer, kBall) + areas));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   ASSERT_EQ(level.objects.size(), 2U);
                   std::swap(level.objects[0], level.objects[1]);
                   level.objects[0].name = "zones";
                   level.objects[1].visible = false;
                   level.objects.push_back({.name = "new", .is_ground = true, .place = 1});
                   level.objects.back().objects.push_back({.position = {1, 1}, .size = {2, 2}});
                 }),
            "");
  std::string renamed = areas, hidden = walls;
  renamed.replace(renamed.find("areas"), 5, "zones");
  hidden.replace(hidden.find("color"), 0, "visible=\"0\" ");
  const std::string text = bytes_of("a.tmx");
  EXPECT_THAT(text, HasSubstr(renamed));
  EXPECT_THAT(text, HasSubstr(bodies_with(kPlayer, kBall)));
  EXPECT_LT(text.find("zones"), text.find("things"));
  EXPECT_LT(text.find("things"), text.find("walls"));
  EXPECT_LT(text.find("walls"), text.find("name=\"new\""));
  EXPECT_THAT(text, HasSubstr("<property name=\"ground\" type=\"bool\" value=\"true\"/>"));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

// In the form of JSON, with objects in one line and in lines of their own.
std::string json_with(const std::string& layers,
                      const std::string& next = "\"nextlayerid\":8, \"nextobjectid\":9") {
  return "{ \"layers\":[\n  {\"type\":\"tilelayer\", \"id\":1, \"name\":\"g\", \"width\":2, \"height\":1, "
         "\"data\":[1,0]}" +
         layers + "],\n \"orientation\":\"orthogonal\", \"width\":2, \"height\":1, \"tilewidth\":8, " + next +
         ", \"version\":\"1.10\",\n \"tileheight\":8, \"tilesets\":[{\"firstgid\":1, \"name\":\"t\", "
         "\"tilewidth\":8, \"tileheight\":8, \"tilecount\":4, \"columns\":2}]}\n";
}

// The order of layers of tiles among those of objects.
TEST_F(SaveTiledObjects, LayersMoveAmongThoseOfTiles) {
  const std::string walls = walls_with(kWall);
  put("a.tmx", map_with(walls + bodies_with(kPlayer, kBall)));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.objects.at(0).place = 0; }), "");
  std::string text = bytes_of("a.tmx");
  EXPECT_LT(text.find("walls"), text.find("<layer"));
  EXPECT_LT(text.find("<layer"), text.find("things"));
  EXPECT_THAT(text, HasSubstr(walls));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   TileLayer added;
                   added.name = "front";
                   added.cells = std::make_shared<const MapCells>(8);
                   level.layers.list.push_back(added);
                   level.objects.at(0).place = 1;
                   level.objects.push_back({.name = "last", .place = 2});
                   level.objects.back().objects.push_back({.position = {1, 1}, .size = {2, 2}});
                 }),
            "");
  text = bytes_of("a.tmx");
  EXPECT_LT(text.find("\"ground\""), text.find("walls"));
  EXPECT_LT(text.find("walls"), text.find("\"front\""));
  EXPECT_LT(text.find("\"front\""), text.find("\"last\""));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.objects.clear();
                   level.layers.list.pop_back();
                 }),
            "");
  EXPECT_EQ(bytes_of("a.tmx").find("walls"), std::string::npos);
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(kPlayer));
}

// A name may be all that says that a layer is ground.
TEST_F(SaveTiledObjects, ARenamedLayerStaysGround) {
  put("a.tmx", map_with(walls_with(kWall)));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.objects.at(0).name = "hall"; }), "");
  EXPECT_TRUE(level_of("a.tmx").objects.at(0).is_ground);
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledObjects, TheOrderOfDrawingIsSaved) {
  put("a.tmx", map_with(walls_with(kWall)));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.objects.at(0).by_y = false; }), "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("draworder=\"index\""));
  put("a.tmj",
      json_with(",\n  {\"type\":\"objectgroup\", \"draworder\":\"index\", \"objects\":[{\"x\":1}]}"));
  EXPECT_EQ(edit("a.tmj", [](Level& level) { level.objects.at(0).by_y = true; }), "");
  EXPECT_THAT(bytes_of("a.tmj"), HasSubstr("\"draworder\":\"topdown\""));
  EXPECT_FALSE(exists("a.tmj.talus.json"));
}

// An element of a picture holds none, so they are in the companion.
TEST_F(SaveTiledObjects, ObjectsOfAPictureAreNotWritten) {
  put("a.tmx", map_with("\t<imagelayer id='3' name='sky'><image source='sky.png'/></imagelayer>\r\n"));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.objects.at(0).objects.push_back({.size = {1, 1}}); }), "");
  EXPECT_EQ(bytes_of("a.tmx").find("<object"), std::string::npos);
}

// The x and y of an old map's picture count until it has an offset.
TEST_F(SaveTiledObjects, APictureWithXAndYIsMoved) {
  put("a.tmx",
      map_with("\t<imagelayer id='3' name='sky' x='16' y='8'><image source='sky.png'/></imagelayer>\r\n"));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.objects.at(0).offset.x += 2; }), "");
  EXPECT_EQ(level_of("a.tmx").objects.at(0).offset, (Vec2{18, 8}));
}

TEST_F(SaveTiledObjects, AMapOfObjectsGetsLayersOfTiles) {
  std::string text = map_with(walls_with(kWall));
  const std::size_t from = text.find("\t<layer"), to = text.find("</layer>") + 10;
  text.erase(from, to - from);
  put("a.tmx", text);
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   TileLayer added;
                   added.name = "new";
                   added.cells = std::make_shared<const MapCells>(8);
                   level.layers.list.push_back(added);
                 }),
            "");
  EXPECT_EQ(level_of("a.tmx").layers.count(), 2);
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("name=\"new\" width=\"4\" height=\"2\">"));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledObjects, ARemovedLayerKeepsItsBodies) {
  put("a.tmx", map_with(walls_with(std::string(kWall) + kBall)));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.objects.clear(); }), "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("walls"));
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(kBall));
  EXPECT_THAT(bytes_of("a.tmx"), testing::Not(HasSubstr("'w'")));
  put("b.tmx", map_with(walls_with(kWall)));
  EXPECT_EQ(edit("b.tmx", [](Level& level) { level.objects.clear(); }), "");
  EXPECT_EQ(bytes_of("b.tmx"), map_with(""));
}

TEST_F(SaveTiledObjects, JsonKeepsItsTextBesideTheObjects) {
  const std::string head = ",\n  {\"type\":\"objectgroup\", \"name\":\"o\", \"objects\":[\n    ";
  const std::string ball = R"({"id":2, "type":"ball", "x":1, "y":2.0e0,"own":[1]})";
  const std::string box = R"({"id":4, "name":"a", "x":1, "y":2, "width":3, "height":4})";
  put("a.tmj", json_with(head + ball + ",\n    " + box + "]}"));
  EXPECT_EQ(edit("a.tmj", nothing), "");
  EXPECT_EQ(bytes_of("a.tmj"), json_with(head + ball + ",\n    " + box + "]}"));
  EXPECT_EQ(edit("a.tmj",
                 [](Level& level) {
                   level.spawns.at(0).position.x = 1.5;
                   MapObject added = level.objects.at(0).objects.at(0);
                   added.name = "b";
                   level.objects[0].objects = {added};
                 }),
            "");
  EXPECT_EQ(bytes_of("a.tmj"),
            json_with(head + R"({"id":2, "type":"ball", "x":1.5, "y":2.0e0,"own":[1]})" + ",\n    " +
                      R"({"id":4, "name":"b", "x":1, "y":2, "width":3, "height":4})" + "]}"));
  EXPECT_EQ(edit("a.tmj",
                 [](Level& level) {
                   level.spawns.clear();
                   level.curves.push_back({"c", {Segment{{1, 2}, {9, 8}}, Curve::Faces::up}, ""});
                   level.objects[0].objects.insert(level.objects[0].objects.begin(), {.name = "new"});
                 }),
            "");
  EXPECT_THAT(bytes_of("a.tmj"), HasSubstr("\"nextlayerid\":9, \"nextobjectid\":11"));
  EXPECT_FALSE(exists("a.tmj.talus.json"));
}

TEST_F(SaveTiledObjects, LooksOfLayersAreWritten) {
  const auto change = [](Level& level) {
    ObjectLayer& layer = level.objects.at(0);
    layer.opacity = 0.5;
    layer.offset = {2.5, 0};
    layer.tint = {1, 2, 3};
    layer.parallax = {0.25, 1};
  };
  put("a.tmx", map_with(walls_with(kWall)));
  EXPECT_EQ(edit("a.tmx", change), "");
  for (const char* look :
       {"opacity=\"0.5\"", "offsetx=\"2.5\"", "tintcolor=\"#010203\"", "parallaxx=\"0.25\""})
    EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(look));
  EXPECT_THAT(bytes_of("a.tmx"), testing::Not(HasSubstr("offsety")));
  put("a.tmj", json_with(R"(,
  {"type":"objectgroup", "name":"o", "objects":[{"id":4, "x":1, "y":2, "width":3, "height":4}]})"));
  EXPECT_EQ(edit("a.tmj", change), "");
  for (const char* name : {"a.tmx", "a.tmj"}) {
    const ObjectLayer layer = load_level(path(name))->level.objects.at(0);
    EXPECT_EQ(layer.opacity, 0.5) << name;
    EXPECT_EQ(layer.offset, (Vec2{2.5, 0})) << name;
    EXPECT_EQ(layer.tint, (Rgb{1, 2, 3})) << name;
    EXPECT_EQ(layer.parallax, (Vec2{0.25, 1})) << name;
    EXPECT_FALSE(exists(std::string(name) + ".talus.json")) << name;
  }
}

}  // namespace talus::save_tiled_objects_test
