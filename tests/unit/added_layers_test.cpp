// Layers of each kind that are added to maps of Tiled are saved into them.
#include <gmock/gmock.h>

#include "edit/group_tools.h"
#include "edit/layer_tools.h"
#include "folder_test.h"
#include "formats/pictures/png_picture.h"
#include "session/session.h"

namespace talus::added_layers_test {

namespace act = action;
using testing::HasSubstr;

class AddedLayers : public FolderTest {
 protected:
  AddedLayers() { put("t.png", encode_png(8, 4, 4, std::vector<std::uint8_t>(8 * 4 * 4, 99).data())); }
  void put_xml(const std::string& layers, const std::string& more = "") const {
    put("m.tmx", "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"4\" tileheight=\"4\"" +
                     more +
                     "><tileset firstgid=\"1\" name=\"t\" tilewidth=\"4\" tileheight=\"4\" tilecount=\"2\" "
                     "columns=\"2\"><image source=\"t.png\"/></tileset>" +
                     layers + "</map>");
  }
  void put_json(const std::string& layers) const {
    put("m.tmj", R"({"type":"map","orientation":"orthogonal","width":2,"height":1,"tilewidth":4,)"
                 R"("tileheight":4,"tilesets":[{"firstgid":1,"name":"t","tilewidth":4,"tileheight":4,)"
                 R"("tilecount":2,"columns":2,"image":"t.png"}],"layers":[)" +
                     layers + "]}");
  }
  // Opens the map, makes the edit, saves it and opens it again, without a question or a companion.
  template <class Change>
  void expect_saved(const std::string& name, const Change& change) const {
    Session session;
    session.apply(act::OpenFile{path(name)});
    ASSERT_EQ(session.path(), path(name)) << (session.message() ? session.message()->text : "");
    const Edit edit = change(session.level());
    ASSERT_FALSE(edit.changes.empty());
    session.apply(act::EditLevel{edit});
    session.apply(act::DismissMessage{});
    session.apply(act::SaveFile{});
    ASSERT_FALSE(session.question());
    ASSERT_TRUE(session.message());
    EXPECT_EQ(session.message()->text, "Saved " + name + ".");
    EXPECT_FALSE(exists(name + ".talus.json"));
    auto again = load_level(path(name));
    ASSERT_TRUE(again) << to_string(again.error(), name);
    again->level.choose_layer(session.level().layers.chosen);
    EXPECT_EQ(again->level.layers, session.level().layers) << bytes_of(name);
    EXPECT_EQ(again->level.objects, session.level().objects) << bytes_of(name);
  }
  template <class Change>
  void expect_saved_everywhere(const Change& change) const {
    const std::string cells = "<data encoding=\"csv\">1,2</data></layer>";
    const std::string tiles = "<layer id=\"1\" name=\"a\" width=\"2\" height=\"1\">" + cells;
    const std::string group = "<group id=\"3\" name=\"g\">" + tiles + "</group>";
    const std::string objects =
        "<objectgroup id=\"4\" name=\"o\"><object id=\"1\" x=\"1\" y=\"1\" "
        "width=\"2\" height=\"2\"/></objectgroup>";
    const std::string chunk =
        "<layer id=\"1\" name=\"a\" width=\"2\" height=\"1\"><data encoding=\"csv\">"
        "<chunk x=\"0\" y=\"0\" width=\"2\" height=\"1\">1,2</chunk></data></layer>";
    const std::string unnamed = "<layer width=\"2\" height=\"1\">" + cells;
    for (const std::string& layers : {tiles, group, tiles + objects, group + objects, unnamed}) {
      SCOPED_TRACE(layers);
      put_xml(layers);
      expect_saved("m.tmx", change);
    }
    put_xml(chunk + objects, " infinite=\"1\"");
    expect_saved("m.tmx", change);
    const std::string json =
        R"({"type":"tilelayer","id":1,"name":"a","width":2,"height":1,"x":0,"y":0,"data":[1,2]})";
    for (const std::string& layers : {json, R"({"type":"group","id":3,"name":"g","layers":[)" + json + "]}",
                                      json + R"(,{"type":"objectgroup","id":4,"name":"o","objects":[]})"}) {
      SCOPED_TRACE(layers);
      put_json(layers);
      expect_saved("m.tmj", change);
    }
  }
};

TEST_F(AddedLayers, OfTilesAreSaved) {
  expect_saved_everywhere([](const Level& level) { return add_layer(level); });
  expect_saved_everywhere([](const Level& level) { return duplicate_layer(level, 0); });
}

TEST_F(AddedLayers, OfObjectsAreSaved) {
  expect_saved_everywhere([](const Level& level) {
    auto made = std::make_shared<Level>(level);
    MapObject box;
    box.size = {2, 2};
    made->objects.push_back({.name = "added", .place = level.layers.count(), .objects = {box}});
    return replace_by(level, made, "Add objects");
  });
  expect_saved_everywhere([](const Level& level) {
    auto made = std::make_shared<Level>(level);
    made->objects.insert(made->objects.begin(), {.name = "empty", .place = 0});
    return replace_by(level, made, "Add a layer of objects");
  });
}

TEST_F(AddedLayers, GroupsAreSaved) {
  expect_saved_everywhere([](const Level& level) { return add_group(level, node_of_layer(level, 0)); });
}

TEST_F(AddedLayers, WhatIsRefusedIsNamed) {
  put_xml("<layer name=\"a\"><data encoding=\"csv\">1,2</data></layer>");
  auto loaded = load_level(path("m.tmx"));
  ASSERT_TRUE(loaded);
  const std::string text = bytes_of("m.tmx");
  const auto error = [&](const auto& change) {
    Level level = loaded->level;
    change(level);
    const auto saved = save_level(level, *loaded->format, path("m.tmx"), loaded->companion);
    EXPECT_EQ(bytes_of("m.tmx"), text);
    return saved ? "" : to_string(saved.error(), "m.tmx");
  };
  const auto layer = [](Level& level) -> TileLayer& { return level.layers.list[0]; };
  EXPECT_EQ(
      error([&](Level& level) { layer(level).name = "b\x01"; }),
      "m.tmx:layer \"b\\x01\": error: has a name that maps of Tiled cannot hold: give it another name, or "
      "save the level as .talus.json");
  EXPECT_EQ(
      error([&](Level& level) {
        level.layers.groups = {{.name = "g\x01"}};
        layer(level).group = 0;
      }),
      "m.tmx:group \"g\\x01\": error: has a name that maps of Tiled cannot hold: give it another name, or "
      "save the level as .talus.json");
}

}  // namespace talus::added_layers_test
