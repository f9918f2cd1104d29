// Groups of layers in maps of Tiled: read, saved back into their text, and exported.
#include <gmock/gmock.h>

#include "edit/group_tools.h"
#include "edit/layer_tools.h"
#include "export/exporter.h"
#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "paths.h"

namespace talus::tiled_groups_test {

using testing::HasSubstr;
using testing::Not;

const char* const kHills =
    "<group id=\"2\" name='far' opacity=\"0.5\" offsetx=\"4\" tintcolor=\"#80ffff\">\r\n";
const char* const kInner = "<group id='4' name=\"trees\" locked='1' parallaxx=\"0.5\"><!-- a > b -->\r\n";

std::string layer(const std::string& id, const std::string& name, const std::string& cells) {
  return "<layer id=\"" + id + "\" name=\"" + name + "\" width=\"2\" height=\"1\"><data encoding=\"csv\">" +
         cells + "</data></layer>\r\n";
}
const std::string kBox = "<object id=\"1\" x=\"1\" y=\"2\" width=\"4\" height=\"4\"/>";

// sky far(hills trees(leaves birds)) ground, with an empty group and one of bodies.
std::string map_with(const std::string& far = kHills, const std::string& inner = kInner) {
  return "<?xml version=\"1.0\"?>\r\n<map version=\"1.10\" orientation=\"orthogonal\" width=\"2\" "
         "height=\"1\" "
         "tilewidth=\"8\" tileheight=\"8\" nextlayerid=\"20\" nextobjectid=\"9\">\r\n <tileset name=\"t\" "
         "firstgid=\"1\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"4\" columns=\"2\"/>\r\n " +
         layer("1", "sky", "1,0") + " " + far + "  " + layer("3", "hills", "0,2") + "  " + inner + "   " +
         layer("5", "leaves", "3,0") + "   <objectgroup id=\"6\" name=\"birds\">" + kBox +
         "</objectgroup>\r\n  </group>\r\n  <group id=\"7\" name=\"empty\"/>\r\n </group>\r\n " +
         layer("8", "ground", "1,2") +
         " <group id=\"9\" name=\"people\" offsety=\"8\"><objectgroup id=\"10\" name=\"crowd\"><object "
         "id=\"2\" "
         "type=\"ball\" x=\"3\" y=\"-8\" width=\"4\" height=\"4\"/></objectgroup></group>\r\n</map>\r\n";
}

class TiledGroups : public FolderTest {
 protected:
  // Opens the file, edits its level and saves it. Returns the error; empty if there is none.
  template <class Change>
  std::string edit(const std::string& name, Change change) {
    auto loaded = load_level(path(name));
    if (!loaded) return to_string(loaded.error(), name);
    change(loaded->level);
    const auto saved = save_level(loaded->level, *loaded->format, path(name), loaded->companion);
    if (!saved) return to_string(saved.error(), name);
    const Level again = level_of(name);
    EXPECT_EQ(again.layers.groups, loaded->level.layers.groups);
    EXPECT_EQ(again.objects, loaded->level.objects);
    EXPECT_EQ(again.spawns, loaded->level.spawns);
    EXPECT_FALSE(exists(name + ".talus.json")) << bytes_of(name + ".talus.json");
    return "";
  }
  Level level_of(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? loaded->level : Level();
  }
  // The text of the map after an edit.
  template <class Make>
  std::string after(Make make) {
    put("a.tmx", map_with());
    EXPECT_EQ(edit("a.tmx", [&](Level& level) { apply_edit(level, make(level)); }), "");
    return bytes_of("a.tmx");
  }
};

TEST_F(TiledGroups, AreReadWithTheirFields) {
  put("a.tmx", map_with());
  const Level level = level_of("a.tmx");
  ASSERT_EQ(level.layers.groups.size(), 2U) << "those without layers are kept in the text alone";
  const LayerGroup& far = level.layers.groups[0];
  EXPECT_EQ(far.name, "far");
  EXPECT_EQ(far.opacity, 0.5);
  EXPECT_EQ(far.offset, (Vec2{4, 0}));
  EXPECT_EQ(far.tint, (Rgb{0x80, 255, 255}));
  EXPECT_EQ(far.group, -1);
  const LayerGroup& trees = level.layers.groups[1];
  EXPECT_TRUE(trees.locked);
  EXPECT_EQ(trees.parallax, (Vec2{0.5, 1}));
  EXPECT_EQ(trees.group, 0);
  ASSERT_EQ(level.layers.count(), 4);
  EXPECT_EQ(level.layers.list[0].group, -1);
  EXPECT_EQ(level.layers.list[1].group, 0);
  EXPECT_EQ(level.layers.list[2].group, 1);
  EXPECT_EQ(level.layers.list[2].opacity, 1) << "its own";
  EXPECT_EQ(level.objects.at(0).group, 1);
  EXPECT_EQ(level.spawns.at(0).position, (Vec2{3, 0})) << "moved with its group";
}

TEST_F(TiledGroups, UnchangedKeepTheirBytes) {
  put("a.tmx", map_with());
  EXPECT_EQ(edit("a.tmx", [](Level&) {}), "");
  EXPECT_EQ(bytes_of("a.tmx"), map_with());
}

TEST_F(TiledGroups, ChangedFieldsAreWrittenIntoTheirTag) {
  const std::string text = after([](const Level& level) {
    LayerGroup far = level.layers.groups[0];
    far.name = "farther";
    far.opacity = 0.25;
    far.offset = {5, 1};
    far.visible = false;
    return set_group_looks(level, 0, far);
  });
  EXPECT_EQ(text, map_with("<group id=\"2\" name='farther' opacity=\"0.25\" offsetx=\"5\" "
                           "tintcolor=\"#80ffff\" visible=\"0\" offsety=\"1\">\r\n"));
}

TEST_F(TiledGroups, TheOpacityOfATintIsPartOfTheirs) {
  put("a.tmx", map_with("<group id=\"2\" name='far' opacity=\"0.5\" tintcolor=\"#3300ff00\">\r\n"));
  const LayerGroup far = level_of("a.tmx").layers.groups.at(0);
  EXPECT_EQ(far.tint, (Rgb{0, 51, 0}));
  EXPECT_NEAR(far.opacity, 0.1, 1e-12);
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.layers.groups[0].opacity = 0.25; }), "");
  EXPECT_THAT(bytes_of("a.tmx"),
              HasSubstr("<group id=\"2\" name='far' opacity=\"0.25\" tintcolor=\"#003300\">"));
}

TEST_F(TiledGroups, MovedLayersChangeTheirPlaceAlone) {
  const std::string into =
      after([](const Level& level) { return move_node(level, node_of_layer(level, 3), 2, 0); });
  const std::string ground = layer("8", "ground", "1,2"), line = ground.substr(0, ground.size() - 2);
  std::string wanted = map_with();
  wanted.erase(wanted.find("\r\n " + line), line.size() + 3);
  const std::string hills = layer("3", "hills", "0,2");
  wanted.insert(wanted.find(hills) + hills.size() - 2, "\r\n  " + line);
  EXPECT_EQ(into, wanted);
  const std::string out =
      after([](const Level& level) { return move_node(level, node_of_layer(level, 2), 0, -1); });
  EXPECT_LT(out.find("leaves"), out.find("sky"));
  EXPECT_THAT(out, HasSubstr(kInner));
}

TEST_F(TiledGroups, NewOnesCopiesAndGoneOnesAreWritten) {
  EXPECT_THAT(after([](const Level& level) { return add_group(level, node_of_layer(level, 0)); }),
              HasSubstr("\r\n <group id=\"20\" name=\"Group 3\">\r\n  <layer id=\"1\" name=\"sky\""));
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("nextlayerid=\"21\""));
  EXPECT_THAT(after([](const Level& level) { return add_group(level, *node_of_group(level, 0)); }),
              HasSubstr("<group id=\"20\" name=\"Group 3\">\r\n  <group id=\"2\" name='far'"));
  EXPECT_THAT(after([](const Level& level) { return ungroup(level, 1); }), Not(HasSubstr("'trees'")));
  EXPECT_THAT(after([](const Level& level) { return ungroup(level, 0); }), Not(HasSubstr("far")));
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("opacity=\"0.5\"")) << "of its layers";
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("people"));
  const std::string removed = after([](const Level& level) { return remove_group(level, 0); });
  EXPECT_THAT(removed, Not(HasSubstr("hills")));
  EXPECT_THAT(removed, HasSubstr("people"));
  after([](const Level& level) { return duplicate_group(level, 0); });
  EXPECT_EQ(level_of("a.tmx").layers.groups.size(), 4U);
}

const char* const kJson =
    R"({ "layers":[
  {"type":"group", "id":1, "name":"g", "opacity":0.5, "own":[1], "layers":[
    {"type":"tilelayer", "id":2, "name":"a", "width":2, "height":1, "data":[1,0]}]},
  {"type":"tilelayer", "id":3, "name":"b", "width":2, "height":1, "data":[0,2]}],
 "orientation":"orthogonal", "width":2, "height":1, "tilewidth":8, "tileheight":8, "nextlayerid":4,
 "tilesets":[{"firstgid":1, "name":"t", "tilewidth":8, "tileheight":8, "tilecount":4, "columns":2}]}
)";

TEST_F(TiledGroups, JsonKeepsItsText) {
  put("a.tmj", kJson);
  EXPECT_EQ(edit("a.tmj", [](Level&) {}), "");
  EXPECT_EQ(bytes_of("a.tmj"), kJson);
  const auto look = [](Level& level) { level.layers.groups.at(0).opacity = 0.75; };
  EXPECT_EQ(edit("a.tmj", look), "");
  std::string wanted = kJson;
  wanted.replace(wanted.find("0.5"), 3, "0.75");
  EXPECT_EQ(bytes_of("a.tmj"), wanted);
}

TEST_F(TiledGroups, JsonGetsAndLosesThem) {
  put("a.tmj", kJson);
  const auto move = [](Level& level) { apply_edit(level, move_node(level, node_of_layer(level, 1), 0, 0)); };
  EXPECT_EQ(edit("a.tmj", move), "");
  EXPECT_EQ(level_of("a.tmj").layers.list.at(0).name, "b");
  EXPECT_THAT(bytes_of("a.tmj"), HasSubstr("\"own\":[1]"));
  const auto wrap = [](Level& level) { apply_edit(level, add_group(level, *node_of_group(level, 0))); };
  EXPECT_EQ(edit("a.tmj", wrap), "");
  EXPECT_EQ(level_of("a.tmj").layers.groups.at(1).name, "g");
  EXPECT_THAT(bytes_of("a.tmj"), HasSubstr("\"nextlayerid\":5"));
  EXPECT_EQ(edit("a.tmj", [](Level& level) { apply_edit(level, ungroup(level, 1)); }), "");
  EXPECT_EQ(edit("a.tmj", [](Level& level) { apply_edit(level, ungroup(level, 0)); }), "");
  EXPECT_THAT(bytes_of("a.tmj"), Not(HasSubstr("group")));
  EXPECT_THAT(bytes_of("a.tmj"), HasSubstr("\"opacity\":0.5"));
}

TEST_F(TiledGroups, AreExportedAndReadAgain) {
  put("a.tmx", map_with());
  const Level level = level_of("a.tmx");
  const ReadAsset read = [](const std::string& name) { return read_file(source_path("assets/") + name); };
  for (const char* const id : {"tmx", "tmj"}) {
    const auto made = find_exporter(id)->make({level, std::string("b.") + id, read});
    ASSERT_TRUE(made);
    put(std::string("b.") + id, made->files[0].bytes);
    const Level again = level_of(std::string("b.") + id);
    EXPECT_EQ(again.layers.groups, level.layers.groups) << id;
    ASSERT_EQ(again.layers.count(), 4);
    EXPECT_EQ(again.layers.list[2].group, 1);
    ASSERT_EQ(again.objects.size(), 1U) << id;
    EXPECT_EQ(again.objects[0].group, 1);
    EXPECT_EQ(again.objects[0].place, level.objects[0].place);
  }
  const auto sti = find_exporter("sti")->make({level, "b.lua", read});
  ASSERT_TRUE(sti);
  EXPECT_THAT(sti->files[0].bytes, Not(HasSubstr("\"group\"")));
  EXPECT_THAT(sti->files[0].bytes, HasSubstr("parallaxx = 0.5"));
  EXPECT_THAT(sti->dropped,
              testing::Contains("the groups of layers: each layer looks as it does in its groups"));
}

}  // namespace talus::tiled_groups_test
