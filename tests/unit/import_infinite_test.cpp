// Infinite maps of Tiled as levels: the rectangle around their chunks.
#include <gmock/gmock.h>

#include <talus/formats/format.h>

namespace talus::import_infinite_test {

using testing::ElementsAre;

std::string map_text(const std::string& layers, const std::string& map = "") {
  return "<map orientation=\"orthogonal\" width=\"30\" height=\"20\" tilewidth=\"16\" tileheight=\"8\" "
         "infinite=\"1\"" +
         map +
         ">\n<tileset firstgid=\"1\" name=\"t\" tilewidth=\"16\" tileheight=\"8\" tilecount=\"16\" "
         "columns=\"16\"/>\n" +
         layers + "</map>";
}
std::string layer_text(const std::string& chunks, const std::string& name = "l") {
  return "<layer name=\"" + name + "\" width=\"30\" height=\"20\"><data encoding=\"csv\">\n" + chunks +
         "</data></layer>\n";
}
std::string chunk_text(int x, int y, int width, int height, const std::string& cells) {
  return "<chunk x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" width=\"" +
         std::to_string(width) + "\" height=\"" + std::to_string(height) + "\">" + cells + "</chunk>\n";
}

FormatResult<LoadedLevel> read(const std::string& text, const std::string& layer = "",
                               const std::string& extension = "tmx") {
  FormatContext context{extension};
  context.choices.layer = layer;
  return read_level(text, context);
}
Level level_of(const std::string& text, const std::string& layer = "", const std::string& extension = "tmx") {
  const auto loaded = read(text, layer, extension);
  EXPECT_TRUE(loaded) << to_string(loaded.error(), "map");
  return loaded ? loaded->level : Level();
}
std::string error_of(const std::string& text) {
  const auto loaded = read(text);
  return loaded ? "" : to_string(loaded.error(), "map");
}

TEST(ImportInfinite, ChunksBecomeTheRectangleAroundTheirTiles) {
  const std::string layer =
      layer_text(chunk_text(-2, -4, 2, 2, "0,2,0,0") + chunk_text(2, -4, 2, 2, "0,0,3,4"));
  const Level level = level_of(map_text(layer));
  EXPECT_EQ(level.map.width(), 5);
  EXPECT_EQ(level.map.tile_size(), (TileSize{16, 8}));
  EXPECT_THAT(level.map.cells().tiles(), ElementsAre(1, 0, 0, 0, 0,  //
                                                     0, 0, 0, 2, 3));
}

TEST(ImportInfinite, ObjectsAndCurvesMoveWithTheCells) {
  const std::string layers = layer_text(chunk_text(-4, 8, 2, 2, "0,2,0,0")) +
                             "<objectgroup name=\"o\" offsetx=\"1\"><object type=\"ball\" x=\"-48\" "
                             "y=\"70\" width=\"8\" height=\"8\"/></objectgroup>"
                             "<objectgroup name=\"curves\"><object x=\"-40\" y=\"66\"><polyline "
                             "points=\"0,0 8,4\"/></object></objectgroup>";
  const Level level = level_of(map_text(layers));
  EXPECT_THAT(level.map.cells().tiles(), ElementsAre(1));
  ASSERT_EQ(level.spawns.size(), 1u);
  EXPECT_EQ(level.spawns[0].position, (Vec2{1, 6}));
  ASSERT_EQ(level.curves.size(), 1u);
  EXPECT_EQ(std::get<Segment>(level.curves[0].curve.form), (Segment{{8, 2}, {16, 6}}));
}

// The edges are trimmed, but not the cells of chunks in which something stands.
TEST(ImportInfinite, ObjectsInChunksKeepTheirCells) {
  const std::string layers = layer_text(chunk_text(0, 0, 4, 2, "0,0,0,2,0,0,0,0")) +
                             "<objectgroup name=\"o\"><object type=\"ball\" x=\"20\" y=\"9\"/>"
                             "<object type=\"ball\" x=\"900\" y=\"9\"/></objectgroup>";
  const Level level = level_of(map_text(layers));
  EXPECT_EQ(level.map.width(), 3);
  EXPECT_THAT(level.map.cells().tiles(), ElementsAre(0, 0, 1, 0, 0, 0));
  EXPECT_EQ(level.spawns[0].position, (Vec2{4, 9}));
  EXPECT_EQ(level.spawns[1].position, (Vec2{884, 9})) << "off the map";
}

TEST(ImportInfinite, AllLayersHaveTheSameRectangle) {
  const std::string text = map_text(layer_text(chunk_text(0, 0, 2, 1, "0,2"), "near") + "<group>" +
                                    layer_text(chunk_text(-2, 0, 2, 1, "3,0"), "far") + "</group>");
  EXPECT_THAT(level_of(text, "near").map.cells().tiles(), ElementsAre(0, 0, 0, 1));
  EXPECT_THAT(level_of(text, "far").map.cells().tiles(), ElementsAre(2, 0, 0, 0));
}

TEST(ImportInfinite, ReadsEveryKindOfData) {
  const std::string cells = "AwAAAAIAAAAAAAAAAQAAAA==";  // 3, 2, 0, 1 in Base64
  const auto in_xml = [](const std::string& attributes, const std::string& data) {
    return map_text("<layer name=\"l\"><data" + attributes + ">" + chunk_text(-2, 6, 2, 2, data) +
                    "</data></layer>");
  };
  const auto in_json = [](const std::string& encoding, const std::string& data) {
    return R"({"type":"map","orientation":"orthogonal","width":4,"height":4,"tilewidth":8,"tileheight":8,)"
           R"("infinite":true,"tilesets":[{"firstgid":1,"name":"t","tilewidth":8,"tileheight":8,)"
           R"("tilecount":16,"columns":16}],"layers":[{"type":"tilelayer","name":"l","width":2,"height":2,)"
           R"("startx":-2,"starty":6,)" +
           encoding + R"("chunks":[{"x":-2,"y":6,"width":2,"height":2,"data":)" + data + "}]}]}";
  };
  const auto expect_cells = [](const std::string& text, const std::string& extension) {
    const auto loaded = read(text, "", extension);
    ASSERT_TRUE(loaded) << text << to_string(loaded.error(), "map");
    EXPECT_THAT(loaded->level.map.cells().tiles(), ElementsAre(2, 1, 0, 0)) << text;
    EXPECT_THAT(loaded->dropped, testing::Each(testing::HasSubstr("picture"))) << text;
  };
  expect_cells(in_xml(" encoding=\"csv\"", "3,2,\n0,1\n"), "tmx");
  expect_cells(in_xml(" encoding=\"base64\"", cells), "tmx");
  expect_cells(in_xml(" encoding=\"base64\" compression=\"zlib\"", "eJxjZmBgYGKAAEYgBgAAXAAH"), "tmx");
  expect_cells(in_xml("", "<tile gid=\"3\"/><tile gid=\"2\"/><tile/><tile gid=\"1\"/>"), "tmx");
  expect_cells(in_json("", "[3,2,0,1]"), "tmj");
  expect_cells(in_json("\"encoding\":\"base64\",\"compression\":\"\",", "\"" + cells + "\""), "tmj");
}

TEST(ImportInfinite, ALayerMayHaveNoChunks) {
  const std::string text = map_text(layer_text(chunk_text(3, 3, 2, 1, "1,2")) + layer_text("", "e"));
  EXPECT_THAT(level_of(text, "e").map.cells().tiles(), ElementsAre(0, 0));
  const Level empty = level_of(map_text(layer_text("")));
  EXPECT_EQ(empty.map.width(), 30) << "the map's own size";
  EXPECT_EQ(empty.map.height(), 20);
  EXPECT_EQ(level_of(map_text(layer_text(chunk_text(70, 0, 2, 1, "0,0")))).map.width(), 30);
  std::string sizeless = map_text(layer_text(""));
  sizeless.replace(sizeless.find("width=\"30\""), 10, "width=\"0\"");
  EXPECT_EQ(level_of(sizeless).map.width(), 1);
}

TEST(ImportInfinite, OfOverlappingChunksTheLastCounts) {
  const std::string layer = layer_text(chunk_text(0, 0, 2, 1, "2,3") + chunk_text(1, 0, 2, 1, "4,5"));
  EXPECT_THAT(level_of(map_text(layer)).map.cells().tiles(), ElementsAre(1, 3, 4));
}

TEST(ImportInfinite, SpreadTilesAreCountedBeforeTheyAreMade) {
  const auto apart = [](const std::string& first, const std::string& last) {
    return error_of(map_text(
        layer_text(chunk_text(-(1 << 30), 0, 1, 1, first) + chunk_text((1 << 30) - 1, 99, 1, 1, last))));
  };
  EXPECT_EQ(apart("1", "1"),
            "map:line 1: error: is an infinite map whose tiles are spread over 2147483648x100 cells, but a "
            "level has at most 16777216 cells and 16777216 px a side");
  EXPECT_EQ(apart("1", "0"), "") << "empty chunks are left out";
  std::string layers;
  for (int i = 0; i < 5; ++i)
    layers += layer_text(chunk_text(0, 0, 1, 1, "1") + chunk_text(4095, 4095, 1, 1, "1"));
  EXPECT_EQ(error_of(map_text(layers)),
            "map:line 1: error: has 5 layers of 4096x4096 tiles, but all layers of a map may have at most "
            "67108864 cells together");
}

TEST(ImportInfinite, BadChunksAreErrorsOnTheirLine) {
  const auto error = [](const std::string& chunk) { return error_of(map_text(layer_text(chunk))); };
  EXPECT_EQ(error(chunk_text(0, 0, 2, 2, "1,2,3")), "map:line 4: error: has 3 cells, but needs 4");
  EXPECT_EQ(error(chunk_text(0, 0, 0, 2, "")),
            "map:line 4: error: must have a whole number from 1 to 2097152 as width");
  EXPECT_EQ(error(chunk_text(2147483647, 0, 1, 1, "1")),
            "map:line 4: error: must have a whole number from -1073741824 to 1073741824 as x");
  EXPECT_EQ(error(chunk_text(0, 0, 2097152, 33, "1")),
            "map:line 4: error: is one chunk too many: all layers of a map may have at most 67108864 cells "
            "together");
}

}  // namespace talus::import_infinite_test
