// Maps of Tiled whose layers other programs have written otherwise than Tiled does.
#include <gmock/gmock.h>

#include <functional>

#include "folder_test.h"

namespace talus::odd_layers_test {

using testing::ElementsAre;
using testing::HasSubstr;

class OddLayers : public FolderTest {
 protected:
  // Opens a map, which must work.
  LoadedLevel opened(const std::string& name, const std::string& text) const {
    put(name, text);
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
  }
  // Edits and saves it, opens it again, and returns its text.
  std::string edited(const std::string& name, const std::string& text,
                     const std::function<void(Level&)>& change) const {
    LoadedLevel loaded = opened(name, text);
    if (loaded.format == nullptr) return "";
    change(loaded.level);
    const auto saved = save_level(loaded.level, *loaded.format, path(name), loaded.companion);
    EXPECT_TRUE(saved) << to_string(saved.error(), name);
    const auto again = load_level(path(name));
    EXPECT_TRUE(again) << to_string(again.error(), name);
    if (!again) return "";
    EXPECT_EQ(again->level.layers, loaded.level.layers);
    const bool is_same_place = again->level.map.width() == loaded.level.map.width();
    if (is_same_place) {
      EXPECT_EQ(again->level.map, loaded.level.map);
    }
    return bytes_of(name);
  }
  // The same with an infinite map without a tile, which gets one.
  void expect_painted(const std::string& name, const std::string& text) const {
    edited(name, text, [](Level& level) { level.map.set({1, 1}, 2); });
    EXPECT_THAT(load_level(path(name))->level.map.cells().tiles(), ElementsAre(2)) << bytes_of(name);
  }
};

void nothing(Level&) {}
const auto kPaint = [](int x, int y, TileNumber tile) {
  return [=](Level& level) { level.map.set({x, y}, tile); };
};

// 3x2 cells.
std::string xml_map(const std::string& layers, const std::string& more = "") {
  return R"(<map orientation="orthogonal" width="3" height="2" tilewidth="8" tileheight="8")" + more +
         R"(><tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="8" columns="8"/>)" +
         layers + "</map>";
}
std::string xml_layer(const std::string& size, const std::string& data) {
  return "<layer name=\"l\" " + size + ">" + data + "</layer>";
}
std::string json_map(const std::string& layer, const std::string& more = "") {
  return R"({"orientation":"orthogonal","width":3,"height":2,"tilewidth":8,"tileheight":8,)" + more +
         R"("tilesets":[{"firstgid":1,"name":"t","tilewidth":8,"tileheight":8,"tilecount":8,"columns":8}],)" +
         R"("layers":[{"type":"tilelayer","name":"l",)" + layer + "}]}";
}

TEST_F(OddLayers, WithoutDataAreEmpty) {
  const std::string size = R"(width="3" height="2")";
  const std::string first = xml_layer(size, R"(<data encoding="csv">1,2,3,4,5,6</data>)");
  for (const std::string& layer :
       {"<layer " + size + "/>", xml_layer(size, ""), xml_layer(size, "<data/>"), std::string("<layer/>")}) {
    const std::string text = xml_map(layer);
    EXPECT_THAT(opened("m.tmx", text).level.map.cells().tiles(), ElementsAre(0, 0, 0, 0, 0, 0)) << layer;
    EXPECT_EQ(edited("m.tmx", text, nothing), text);
    edited("m.tmx", text, kPaint(1, 1, 2));
    edited("m.tmx", xml_map(layer + first), kPaint(1, 1, 2));
  }
  EXPECT_EQ(edited("m.tmx", xml_map("<layer " + size + "/>"), kPaint(1, 1, 2)),
            xml_map("<layer " + size + "><data encoding=\"csv\">\n0,0,0,\n0,3,0\n</data></layer>"));
  for (const std::string layer : {R"("width":3,"height":2)", R"("width":3,"height":2,"data":null)",
                                  R"("width":3,"height":2,"data":"")"}) {
    EXPECT_EQ(edited("m.tmj", json_map(layer), nothing), json_map(layer));
    EXPECT_THAT(edited("m.tmj", json_map(layer), kPaint(1, 1, 2)), HasSubstr("3"));
  }
}

TEST_F(OddLayers, WithoutDataInAnInfiniteMapGetIt) {
  const std::string more = R"( infinite="1")", infinite = R"("infinite":true,)";
  expect_painted("m.tmx", xml_map(xml_layer("", ""), more));
  expect_painted("m.tmx", xml_map("<layer/>", more));
  expect_painted("m.tmj", json_map(R"("width":3,"height":2)", infinite));
  expect_painted("m.tmj", json_map(R"("width":0,"height":0,"data":[])", infinite));
  const std::string empty = R"("chunks":[{"x":0,"y":0,"width":3,"height":2}])";
  expect_painted("m.tmj", json_map(empty, infinite));
}

// What is off the map is listed, and stays.
TEST_F(OddLayers, LargerThanTheMapKeepTheRest) {
  const auto with = [](const std::string& cells) {
    return xml_map(xml_layer(R"(width="4" height="3")", "<data encoding=\"csv\">" + cells + "</data>"));
  };
  const std::string text = with("1,2,3,4,5,6,7,8,1,1,1,1");
  const LoadedLevel loaded = opened("m.tmx", text);
  EXPECT_THAT(loaded.level.map.cells().tiles(), ElementsAre(0, 1, 2, 4, 5, 6));
  EXPECT_THAT(loaded.dropped, testing::Contains("the tiles off the map in the layer \"l\""));
  EXPECT_EQ(edited("m.tmx", text, nothing), text);
  EXPECT_EQ(edited("m.tmx", text, kPaint(0, 0, 4)), with("5,2,3,4,5,6,7,8,1,1,1,1"));
  const std::string json = R"("width":4,"height":3,"data":[1,2,3,4,5,6,7,8,1,1,1,)";
  EXPECT_EQ(edited("m.tmj", json_map(json + "1]"), kPaint(0, 1, 3)),
            json_map(R"("width":4,"height":3,"data":[1,2,3,4,4,6,7,8,1,1,1,1])"));
}

TEST_F(OddLayers, LargerThanTheMapRefuseANewSize) {
  const auto with = [](const std::string& cells) {
    return xml_map(xml_layer(R"(width="4" height="2")", "<data encoding=\"csv\">" + cells + "</data>"));
  };
  const auto widen = [](Level& level) {
    TileMap wide(4, 2, level.map.tile_size());
    wide.set({3, 1}, 2);
    level.map = wide;
  };
  EXPECT_EQ(edited("m.tmx", with("1,2,3,0,5,6,7,0"), widen).find("width=\"3\""), std::string::npos);
  LoadedLevel loaded = opened("m.tmx", with("1,2,3,4,5,6,7,0"));
  widen(loaded.level);
  const auto saved = save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion);
  ASSERT_FALSE(saved);
  EXPECT_EQ(
      to_string(saved.error(), "m.tmx"),
      "m.tmx: error: has another size than the map, which has tiles off it that would be lost: take back "
      "the new size, or save the level as .talus.json");
  EXPECT_EQ(bytes_of("m.tmx"), with("1,2,3,4,5,6,7,0"));
}

TEST_F(OddLayers, SmallerThanTheMapGrowWhenPainted) {
  const std::string text = xml_map(xml_layer(R"(width="2" height="1")", "<data encoding=\"csv\">1,2</data>"));
  EXPECT_THAT(opened("m.tmx", text).level.map.cells().tiles(), ElementsAre(0, 1, 0, 0, 0, 0));
  EXPECT_EQ(edited("m.tmx", text, nothing), text);
  EXPECT_THAT(edited("m.tmx", text, kPaint(0, 0, 3)),
              HasSubstr(R"(width="2" height="1"><data encoding="csv">4,2<)"));
  EXPECT_THAT(edited("m.tmx", text, kPaint(2, 1, 3)), HasSubstr(R"(width="3" height="2"><data)"));
  const std::string tiles =
      xml_map(xml_layer(R"(width="2" height="1")", "<data><tile gid=\"1\"/><tile gid=\"2\"/></data>"));
  edited("m.tmx", tiles, kPaint(2, 1, 3));
  EXPECT_EQ(edited("m.tmj", json_map(R"("width":2,"height":1,"data":[1,2])"), kPaint(2, 0, 3)),
            json_map(R"("width":3,"height":2,"data":[1,2,4,0,0,0])"));
}

TEST_F(OddLayers, WithChunksInAFiniteMapKeepThem) {
  const auto chunk = [](int x, int y, const std::string& cells) {
    return "<chunk x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) +
           "\" width=\"2\" height=\"2\">" + cells + "</chunk>";
  };
  const auto with = [&](const std::string& chunks) {
    return xml_map(xml_layer(R"(width="3" height="2")", "<data encoding=\"csv\">" + chunks + "</data>"));
  };
  const std::string off = chunk(2, 0, "5,6,7,8");
  const std::string text = with(chunk(0, 0, "1,2,3,4") + off);
  EXPECT_THAT(opened("m.tmx", text).level.map.cells().tiles(), ElementsAre(0, 1, 4, 2, 3, 6));
  EXPECT_EQ(edited("m.tmx", text, nothing), text);
  EXPECT_EQ(edited("m.tmx", text, kPaint(0, 0, 4)), with(chunk(0, 0, "5,2,3,4") + off));
  edited("m.tmx", with(chunk(0, 0, "1,2,3,4")), kPaint(2, 0, 3));
  const std::string json =
      R"("width":3,"height":2,"chunks":[{"x":1,"y":0,"width":2,"height":2,"data":[1,2,3,4]}])";
  EXPECT_EQ(edited("m.tmj", json_map(json), nothing), json_map(json));
  edited("m.tmj", json_map(json), kPaint(0, 0, 3));
}

TEST_F(OddLayers, ChunksThatOverlapKeepWhatTheyCover) {
  const auto with = [](const std::string& first, const std::string& second) {
    return xml_map(xml_layer("", "<data encoding=\"csv\"><chunk x=\"0\" y=\"0\" width=\"3\" height=\"1\">" +
                                     first + "</chunk><chunk x=\"1\" y=\"0\" width=\"2\" height=\"2\">" +
                                     second + "</chunk></data>"),
                   R"( infinite="1")");
  };
  const std::string text = with("1,2,3", "4,0,6,7");
  EXPECT_THAT(opened("m.tmx", text).level.map.cells().tiles(), ElementsAre(0, 3, 0, 0, 5, 6));
  EXPECT_EQ(edited("m.tmx", text, nothing), text);
  EXPECT_EQ(edited("m.tmx", text, kPaint(2, 0, 4)), with("1,2,3", "4,5,6,7"));
  EXPECT_EQ(edited("m.tmx", text, kPaint(0, 0, 4)), with("5,2,3", "4,0,6,7"));
  const std::string json =
      R"("width":3,"height":2,"chunks":[{"x":0,"y":0,"width":2,"height":1,"data":[1,2]},{"x":1,"y":0,"width":1,"height":1,"data":[3]}])";
  EXPECT_EQ(edited("m.tmj", json_map(json, R"("infinite":true,)"), nothing),
            json_map(json, R"("infinite":true,)"));
}

}  // namespace talus::odd_layers_test
