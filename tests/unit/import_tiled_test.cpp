// Maps of Tiled as levels: what is kept, what is reported, what is refused.
#include <gmock/gmock.h>
#include <zlib.h>
#include <zstd.h>

#include <nlohmann/json.hpp>

#include "folder_test.h"
#include "formats/pictures/png_picture.h"
#include "formats/pictures/png_sheet.h"
#include "formats/tiled/tiled_format.h"
#include "paths.h"
#include "tiled_files.h"

namespace talus::import_tiled_test {

using testing::ElementsAre;
using testing::HasSubstr;

// A map of 2x2 cells with one layer and one tileset of 16 tiles, with these parts inserted.
struct Parts {
  std::string cells = "1,2,0,1", tiles = {}, layers = {}, map = {}, tileset = {};
};
std::string map_text(const Parts& p) {
  return R"({"type":"map","orientation":"orthogonal","width":2,"height":2,"tilewidth":8,"tileheight":8,)" +
         p.map +
         R"("infinite":false,"tilesets":[{"firstgid":1,"name":"t","tilewidth":8,"tileheight":8,"columns":4,)" +
         p.tileset + R"("tilecount":16,"tiles":[)" + p.tiles +
         R"(]}],"layers":[{"type":"tilelayer","name":"ground","width":2,"height":2,"data":[)" + p.cells +
         "]}" + p.layers + "]}";
}
std::string tile_text(const std::string& objects, const std::string& properties = "") {
  return R"({"id":5,"properties":[)" + properties + R"(],"objectgroup":{"type":"objectgroup","objects":[)" +
         objects + "]}}";
}
std::string polygon(const std::string& points) { return R"({"x":0,"y":0,"polygon":[)" + points + "]}"; }

LoadedLevel read(const std::string& text, const std::string& extension = "tmj") {
  auto loaded = read_level(text, {extension});
  EXPECT_TRUE(loaded) << to_string(loaded.error(), "map");
  return loaded ? *loaded : LoadedLevel{Level(), nullptr};
}
std::string error_of(const std::string& text, const std::string& extension = "tmj") {
  const auto loaded = read_level(text, {extension});
  return loaded ? "" : to_string(loaded.error(), "map");
}
// The shape of tile 5 of a tileset with four columns, which is tile 17 of a sheet.
TileShape shape_of(const std::string& objects, const std::string& properties = "") {
  return read(map_text({.tiles = tile_text(objects, properties)})).level.tile_shapes[17];
}

TEST(ImportTiled, KeepsThePlacesOfTilesOnASmallSheet) {
  const LoadedLevel loaded = read(map_text({.cells = "1,6,0,16"}));
  EXPECT_EQ(loaded.format->id, "tmj");
  EXPECT_TRUE(loaded.format->writes_back);
  EXPECT_EQ(loaded.level.map.width(), 2);
  EXPECT_THAT(loaded.level.map.cells().tiles(), ElementsAre(0, 17, 0, 51));
  EXPECT_THAT(loaded.dropped, ElementsAre("the picture of the tileset \"t\""));
}

TEST(ImportTiled, BoxesAndPolygonsBecomeShapes) {
  using Kind = TileShape::Kind;
  using Side = TileShape::Side;
  EXPECT_EQ(shape_of(R"({"x":0,"y":0,"width":8,"height":8})"), (TileShape{.kind = Kind::solid}));
  EXPECT_EQ(shape_of(R"({"x":0,"y":5,"width":8,"height":3})"),
            (TileShape{.kind = Kind::slope, .heights = {3, 3}}));
  EXPECT_EQ(shape_of(R"({"x":0,"y":0,"width":16,"height":2})"),
            (TileShape{.kind = Kind::slope, .side = Side::ceiling, .tiles = 2, .heights = {2, 2}}));
  EXPECT_EQ(shape_of(polygon(R"({"x":0,"y":8},{"x":16,"y":-4},{"x":16,"y":8})")),
            (TileShape{.kind = Kind::slope, .tiles = 2, .heights = {0, 12}}));
  EXPECT_EQ(
      shape_of(polygon(R"({"x":8,"y":8},{"x":8,"y":4},{"x":0,"y":8})")),  // the corners in the opposite order
      (TileShape{.kind = Kind::slope, .heights = {0, 4}}));
  EXPECT_EQ(shape_of(polygon(R"({"x":0,"y":0},{"x":8,"y":0},{"x":8,"y":2},{"x":6,"y":4},{"x":0,"y":1})")),
            (TileShape{.kind = Kind::profile, .side = Side::ceiling, .heights = {1, 2, 3, 4, 2}}));
  EXPECT_EQ(shape_of(R"({"x":0,"y":8,"polygon":[{"x":0,"y":0},{"x":4,"y":-4},{"x":8,"y":0}]})"),
            (TileShape{.kind = Kind::profile, .heights = {0, 4, 0}}));
  EXPECT_EQ(shape_of(polygon(R"({"x":0,"y":4},{"x":4,"y":2},{"x":8,"y":0},{"x":8,"y":8},{"x":0,"y":8})")),
            (TileShape{.kind = Kind::slope, .heights = {4, 8}}))
      << "a point on a straight line is no corner";
  EXPECT_EQ(shape_of(R"({"x":0,"y":5,"width":8,"height":3})", R"({"name":"shape_one_way","value":true})"),
            (TileShape{.kind = Kind::slope, .one_way = true, .heights = {3, 3}}));
  const std::string one_way =
      R"({"x":0,"y":5,"width":8,"height":3,"properties":[{"name":"one_way","type":"bool","value":true}]})";
  EXPECT_EQ(shape_of(one_way), (TileShape{.kind = Kind::slope, .one_way = true, .heights = {3, 3}}));
  EXPECT_EQ(shape_of(one_way, R"({"name":"shape_one_way","value":false})"),
            (TileShape{.kind = Kind::slope, .heights = {3, 3}}));
}

TEST(ImportTiled, ObjectsThatAreNoOutlineAreReported) {
  const std::vector<std::string> others = {R"({"x":0,"y":0,"width":8,"height":8,"text":{"text":"a"}})",
                                           R"({"x":0,"y":0,"polyline":[{"x":0,"y":8},{"x":8,"y":0}]})"};
  for (const std::string& object : others) {
    std::string map = map_text({.tiles = tile_text(object)});
    map.replace(map.find("\"ground\""), 8, "\"main\"");  // a name that makes no tile solid
    const LoadedLevel loaded = read(map);
    EXPECT_EQ(loaded.level.tile_shapes[17], TileShape()) << object;
    EXPECT_THAT(loaded.dropped,
                testing::Contains(
                    "a collision shape of tile 17 (5 in Tiled), which is not a box, an ellipse or a polygon"))
        << object;
  }
  const LoadedLevel flat = read(map_text({.tiles = tile_text(polygon(R"({"x":0,"y":8},{"x":8,"y":8})"))}));
  EXPECT_THAT(flat.dropped, testing::Contains("the outline of tile 17 (5 in Tiled), of which nothing is in "
                                              "the tile or up and right of it"));
}

TEST(ImportTiled, FlagsAreReadByNumberAndByName) {
  const auto flags = [](const std::string& properties) {
    return read(map_text({.tiles = tile_text("", properties)})).level.tile_flags(17);
  };
  EXPECT_EQ(flags(R"({"name":"flags","value":37})"), 37);
  EXPECT_EQ(
      flags(
          R"({"name":"solid","value":true},{"name":"up_slope","value":true},{"name":"flag7","value":true})"),
      1 | 4 | 128);
  EXPECT_EQ(flags(R"({"name":"flags","value":5},{"name":"solid","value":false})"), 4)
      << "a property with a flag's name overrides \"flags\"";
  const auto named = [](const std::string& properties) {
    return read(map_text({.tiles = tile_text("", R"({"name":"ladder","value":true})" + properties)})).level;
  };
  EXPECT_EQ(named("").flag_names[4], "ladder") << "the first flag without a role";
  EXPECT_EQ(named("").tile_flags(17), 16);
  const Level numbered = named(R"(,{"name":"flags","value":32})");
  EXPECT_EQ(numbered.flag_names[5], "ladder") << "the flag that the same tiles have by number";
  EXPECT_EQ(numbered.tile_flags(17), 32);
  EXPECT_EQ(read(map_text({.tiles = tile_text("", R"({"name":"collidable","value":true})")}))
                .level.tile_shapes[17]
                .kind,
            TileShape::Kind::solid);
}

TEST(ImportTiled, DroppedThingsAreReported) {
  const std::string tiles =
      tile_text("",
                R"({"name":"flags","value":4294967296},{"name":"hp","value":2},{"name":"x","value":{}})") +
      R"(,{"id":6,"animation":[{}],"type":"door"})";
  const std::string layers =
      R"(,{"type":"objectgroup","name":"things","objects":[{"x":1,"y":1,"type":"chest"},)"
      R"({"x":1,"y":1,"type":"chest"},{"x":1,"y":1,"type":"ball","rotation":5,)"
      R"("properties":[{"name":"hp","value":1}]},{"x":1e9,"y":1,"type":"ball","name":"far"}]},)"
      R"({"type":"imagelayer","name":"sky","image":"a.png"},)"
      R"({"type":"objectgroup","name":"curves","objects":[{"x":0,"y":0,"name":"c",)"
      R"("polyline":[{"x":0,"y":0},{"x":99,"y":0}]}]})";
  const LoadedLevel loaded =
      read(map_text({.tiles = tiles,
                     .layers = layers,
                     .map = R"("backgroundcolor":"#ff0000","properties":[{"name":"m","value":1}],)"}));
  EXPECT_THAT(
      loaded.dropped,
      testing::UnorderedElementsAre(
          "the picture of the tileset \"t\"", "`flags` of a tile, which is not a whole number of 32 bits",
          "the property \"x\" of a tile", "the rotation of a body", "the property \"hp\" of a body",
          "the body \"far\", as a number of it must be a number from -100000000 to 100000000",
          "the picture of the layer \"sky\"", "the curve \"c\", which has its last end off the map",
          "the property \"m\" of the map"));
  ASSERT_EQ(loaded.level.spawns.size(), 1u);
  EXPECT_EQ(loaded.level.spawns[0].size, (Vec2{8, 8}));
}

TEST(ImportTiled, PolylinesBecomeCurves) {
  const std::string layers = R"(,{"type":"objectgroup","name":"curves","offsetx":1,"objects":[)"
                             R"({"x":0,"y":8,"polyline":[{"x":0,"y":0},{"x":4,"y":-2.5}]},)"
                             R"({"x":0,"y":8,"polyline":[{"x":0,"y":0},{"x":4,"y":1},{"x":8,"y":3}]},)"
                             R"({"x":9,"y":8,"polyline":[{"x":0,"y":0},{"x":-4,"y":1},{"x":-4,"y":3}]}]})";
  const std::vector<LevelCurve> curves = read(map_text({.layers = layers})).level.curves;
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(std::get<Segment>(curves[0].curve.form), (Segment{{1, 8}, {5, 5.5}}));
  EXPECT_EQ(std::get<Polyline>(curves[1].curve.form), (Polyline{1, 9, {8, 9, 11}}));
  EXPECT_EQ(std::get<Segment>(curves[2].curve.form), (Segment{{6, 9}, {10, 8}}));
  EXPECT_EQ(std::get<Segment>(curves[3].curve.form), (Segment{{6, 9}, {6, 11}}));
}

TEST(ImportTiled, AnExportedPolylineIsReadAgain) {
  Level level = level_for_tiled();
  const Polyline line{1, 9, {8, 9, 11, 4, 0.5}};
  level.curves = {{"hill", {line, Curve::Faces::up}, ""}};
  auto map = nlohmann::json::parse(tiled_export_of(level, "tmj", "-").files[0].bytes);
  map.erase("properties");  // one of them is the level itself
  const std::vector<LevelCurve> curves = read(map.dump()).level.curves;
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0] == level.curves[0]);
}

// Bytes in Base64, as Tiled writes them.
std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<std::uint8_t>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j > bytes.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
  }
  return text;
}
// window_bits: 15 for zlib, 31 for gzip.
std::string packed(const std::string& bytes, int window_bits) {
  std::string out(200, '\0');
  z_stream stream = {};
  deflateInit2(&stream, 9, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string packed_by_zstd(const std::string& bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
  return out;
}

std::string xml_map(const std::string& data) {
  return "<?xml version=\"1.0\"?>\n<map version=\"1.10\" orientation=\"orthogonal\" width=\"2\" height=\"2\" "
         "tilewidth=\"8\" tileheight=\"8\" infinite=\"0\">\n <tileset firstgid=\"1\" name=\"t\" "
         "tilewidth=\"8\" "
         "tileheight=\"8\" tilecount=\"16\" columns=\"16\"/>\n <layer id=\"1\" name=\"l\" width=\"2\" "
         "height=\"2\">\n  " +
         data + "\n </layer>\n</map>\n";
}

TEST(ImportTiled, ReadsEveryKindOfLayerData) {
  const std::string bytes("\3\0\0\0\2\0\0\0\0\0\0\0\1\0\0\0", 16);
  const std::vector<std::string> datas = {
      "<data encoding=\"csv\">\n3,2,\n0,1\n</data>",
      "<data encoding=\"base64\">\n   " + base64(bytes) + "\n  </data>",
      "<data encoding=\"base64\" compression=\"zlib\">" + base64(packed(bytes, 15)) + "</data>",
      "<data encoding=\"base64\" compression=\"gzip\">" + base64(packed(bytes, 31)) + "</data>",
      "<data encoding=\"base64\" compression=\"zstd\">" + base64(packed_by_zstd(bytes)) + "</data>",
      "<data><tile gid=\"3\"/><tile gid=\"2\"/><tile/><tile gid=\"1\"/></data>"};
  for (const std::string& data : datas)
    EXPECT_THAT(read(xml_map(data), "tmx").level.map.cells().tiles(), ElementsAre(2, 1, 0, 0)) << data;
}

TEST(ImportTiled, DataWithoutCellsIsAnEmptyLayer) {
  for (const char* data : {"<data encoding=\"csv\">\n</data>", "<data/>",
                           "<data encoding=\"base64\" compression=\"zstd\"></data>"})
    EXPECT_THAT(read(xml_map(data), "tmx").level.map.cells().tiles(), ElementsAre(0, 0, 0, 0)) << data;
}

TEST(ImportTiled, CellsWithUnknownTilesAreEmpty) {
  const LoadedLevel loaded = read(xml_map("<data encoding=\"csv\">3,2,17,17</data>"), "tmx");
  EXPECT_THAT(loaded.level.map.cells().tiles(), ElementsAre(2, 1, 0, 0));
  EXPECT_THAT(loaded.dropped, testing::Contains("tile 17 in cells, which no tileset has"));
}

TEST(ImportTiled, BadLayerDataIsAnErrorOnItsLine) {
  const auto error = [](const std::string& data) { return error_of(xml_map(data), "tmx"); };
  const std::string at = "map:line 4: error: ";
  EXPECT_EQ(error("<data encoding=\"csv\">1,2,3</data>"), at + "has 3 cells, but needs 4");
  EXPECT_EQ(error("<data encoding=\"csv\">1,2,x,4</data>"), at + "must have a number as cell 3");
  EXPECT_EQ(error("<data encoding=\"csv\">1,2,3,99999999999</data>"), at + "must have a number as cell 4");
  EXPECT_EQ(error("<data encoding=\"base64\">AA*A</data>"), at + "has a character that is not Base64");
  EXPECT_EQ(error("<data encoding=\"base64\">AAAA</data>"), at + "ends in the middle of a cell");
  EXPECT_EQ(error("<data encoding=\"base64\" compression=\"zlib\">AAAA</data>"),
            at + "has compressed cells that are damaged");
  EXPECT_EQ(error("<data encoding=\"base64\" compression=\"zlib\">" +
                  base64(packed(std::string(1000, 'x'), 15)) + "</data>"),
            at + "unpacks to more cells than the layer has");
  EXPECT_EQ(error("<data encoding=\"base64\" compression=\"zstd\">AAAA</data>"),
            at + "has compressed cells that are damaged");
  EXPECT_EQ(error("<data encoding=\"base64\" compression=\"lz4\">AAAA</data>"),
            at + "has the unknown compression \"lz4\"");
  EXPECT_EQ(error("<data encoding=\"base64\" compression=\"zstd\">" +
                  base64(packed_by_zstd(std::string(1000, 'x'))) + "</data>"),
            at + "unpacks to more cells than the layer has");
}

TEST(ImportTiled, RefusesMapsThatCannotBeALevel) {
  const auto with = [](std::string text, const std::string& what, const std::string& by) {
    return error_of(text.replace(text.find(what), what.size(), by));
  };
  const std::string good = map_text({});
  EXPECT_EQ(with(good, "orthogonal", "isometric"),
            "map:key orientation: error: has the orientation \"isometric\", but must be orthogonal");
  EXPECT_EQ(
      with(good, "\"tilewidth\":8,\"tileheight\":8", "\"tilewidth\":257,\"tileheight\":16"),
      "map:key tilewidth: error: has tiles of 257x16 px, but a level needs tiles of 1 to 256 px a side");
  EXPECT_EQ(with(good, "\"width\":2", "\"width\":0"),
            "map:key width: error: must have a whole number from 1 to 2097152 as width");
  EXPECT_EQ(with(good, "\"width\":2,\"height\":2", "\"width\":2000000,\"height\":2000000"),
            "map:key width: error: has 2000000x2000000 cells, but a level has at most 16777216");
  EXPECT_EQ(with(good, "\"width\":2", "\"width\":\"two\""),
            "map:key width: error: must have a number as width");
  EXPECT_EQ(with(good, "[1,2,0,1]", "[1,2,0,-1]"),
            "map:key layers[0].data: error: must have a number as cell 4");
  EXPECT_EQ(with(good, "[1,2,0,1]", "7"), "map:key layers[0].data: error: has 0 cells, but needs 4");
  EXPECT_EQ(with(good, "\"tiles\":[]", "\"tiles\":3"),
            "map:key tilesets[0].tiles: error: must have a list as tiles");
  EXPECT_EQ(with(good, "\"tiles\":[]", "\"tiles\":[3]"),
            "map:key tilesets[0].tiles[0]: error: must be an object");
  EXPECT_EQ(with(good, "\"tiles\":[]", "\"tiles\":[{\"id\":1e300}]"),
            "map:key tilesets[0].tiles[0].id: error: must have a whole number from 0 to "
            "1048576 as id");
  EXPECT_EQ(error_of("{}"), "map: error: is not a Tiled map");
  EXPECT_EQ(error_of("<a/>", "tmx"), "map: error: is not a Tiled map or tileset");
  EXPECT_EQ(error_of("<map>\n<layer", "tmx"), "map:line 2: error: this is not valid XML");
  EXPECT_EQ(error_of("{\"a\":" + std::string(100, '[')),
            "map:line 1: error: the JSON is nested deeper than 64 levels here");
  std::string groups;
  for (int i = 0; i < 40; ++i) groups += "<group>";
  for (int i = 0; i < 40; ++i) groups += "</group>";
  EXPECT_EQ(
      error_of("<map orientation=\"orthogonal\" width=\"2\" height=\"2\" tilewidth=\"8\" tileheight=\"8\">" +
                   groups + "</map>",
               "tmx"),
      "map:line 1: error: is nested too deep in groups");
}

// Attributes and elements whose names mean something else in Tiled's JSON.
TEST(ImportTiled, NamesOfXmlDoNotClashInJson) {
  const auto with = [](std::string what, const std::string& by) {
    std::string text =
        "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">"
        "<tileset firstgid=\"1\" name=\"t\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"2\" columns=\"2\">"
        "<tile id=\"1\"><objectgroup><object x=\"0\" y=\"0\" width=\"8\" height=\"8\"/></objectgroup></tile>"
        "</tileset><layer name=\"l\"><data encoding=\"csv\">2</data></layer>"
        "<objectgroup name=\"o\"><object type=\"ball\" x=\"1\" y=\"2\"/></objectgroup></map>";
    return text.replace(text.find(what), what.size(), by);
  };
  const auto dropped = [&](const std::string& what, const std::string& by) {
    std::vector<std::string> phrases;
    FormatContext context{"tmx"};
    context.dropped = &phrases;
    const auto level = read_tiled(with(what, by), context);
    if (!level) return std::vector<std::string>{to_string(level.error(), "map")};
    EXPECT_EQ(level->map.at({0, 0}), 1);
    EXPECT_EQ(level->spawns.size(), 1u);
    std::erase(phrases, "the picture of the tileset \"t\"");
    return phrases;
  };
  EXPECT_THAT(dropped("<map ", "<map "), ElementsAre());
  EXPECT_THAT(dropped("<map ", "<map layers=\"x\" "), ElementsAre("\"layers=\" of the map"));
  EXPECT_THAT(dropped("<map ", "<map tilesets=\"x\" "), ElementsAre("\"tilesets=\" of the map"));
  EXPECT_THAT(dropped("<tileset ", "<tileset tiles=\"x\" "), ElementsAre("\"tiles=\" of the tileset \"t\""));
  EXPECT_THAT(dropped("<objectgroup name", "<objectgroup objects=\"x\" name"),
              ElementsAre("\"objects=\" of the layer \"o\""));
  EXPECT_THAT(dropped("<layer ", "<layers/><layer "), ElementsAre("\"<layers>\" of the map"));
  EXPECT_THAT(dropped("<tileset ", "<tilesets/><tileset "), ElementsAre("\"<tilesets>\" of the map"));
  EXPECT_THAT(dropped("<tile ", "<tiles/><tile "), ElementsAre("\"<tiles>\" of the tileset \"t\""));
  EXPECT_THAT(dropped("<object type", "<objects/><object type"),
              ElementsAre("\"<objects>\" of the layer \"o\""));
  EXPECT_THAT(dropped("<layer ", "<width/><layer "), ElementsAre("\"<width>\" of the map"));
  EXPECT_THAT(dropped("<layer ", "<type/><layer "), ElementsAre("\"<type>\" of the map"));
  EXPECT_THAT(dropped("<data ", "<properties data=\"x\"/><data "), ElementsAre());
  EXPECT_THAT(dropped("<map ", "<map width=\"1\" "), ElementsAre("map:line 1: error: has \"width\" twice"));
  EXPECT_THAT(dropped("<data ", "<data/><data "), ElementsAre("map:line 1: error: has \"data\" twice"));
  EXPECT_THAT(dropped("name=\"l\"", "name=\"&#xD800;\""),
              ElementsAre("map:line 1: error: refers to a character that does not exist"));
  EXPECT_THAT(dropped("</tileset>",
                      "</tileset>\n<imagelayer name=\"a&#10;::error::[31m\"><image "
                      "source=\"a.png\"/></imagelayer>"),
              ElementsAre(R"(the picture of the layer "a\n::error::[31m")"));
}

TEST(ImportTiled, EntitiesOfAFileAreNotExpanded) {
  std::string entities = "<!ENTITY a0 \"aaaaaaaaaa\">";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "&a" + std::to_string(i - 1) + ";";
    entities += "<!ENTITY a" + std::to_string(i) + " \"" + before + before + before + before + "\">";
  }
  const std::string text =
      "<!DOCTYPE map [" + entities +
      "<!ENTITY file SYSTEM \"/etc/passwd\">]><map orientation=\"orthogonal\" width=\"1\" "
      "height=\"1\" tilewidth=\"8\" tileheight=\"8\"><layer name=\"&a29;&file;\"><data "
      "encoding=\"csv\">0</data></layer></map>";
  FormatContext context{"tmx"};
  context.choices.layer = "none";
  EXPECT_EQ(read_level(text, context).error().message,
            "has no tile layer with the name \"none\", but \"&a29;&file;\"");
}

TEST(ImportTiled, TakesAllLayers) {
  const Level level = read(map_text({.layers = R"(,{"type":"group","name":"g","opacity":0.5,"offsetx":3,)"
                                               R"("layers":[{"type":"tilelayer","name":"back","opacity":0.5,)"
                                               R"("visible":false,"locked":true,"parallaxx":0.25,)"
                                               R"("tintcolor":"#ff8000","data":[0,3,0,0],"properties":[)"
                                               R"({"name":"ground","type":"bool","value":false}]}]})"}))
                          .level;
  ASSERT_EQ(level.layers.count(), 2);
  EXPECT_EQ(level.layers.chosen, 0);
  EXPECT_EQ(level.layers.list[0].name, "ground");
  EXPECT_THAT(level.map.cells().tiles(), ElementsAre(0, 1, 0, 0));
  TileLayer back = level.layers.list[1];
  EXPECT_THAT(back.cells->tiles(), ElementsAre(0, 2, 0, 0));
  back.cells = nullptr;
  EXPECT_EQ(back, (TileLayer{.name = "back",
                             .is_ground = false,
                             .visible = false,
                             .locked = true,
                             .opacity = 0.5,
                             .parallax = {0.25, 1},
                             .tint = {255, 128, 0},
                             .group = 0,
                             .extra = {},
                             .cells = nullptr}));
  EXPECT_EQ(level.layers.groups, (LayerGroups{{.name = "g", .opacity = 0.5, .offset = {3, 0}}}));
}

TEST(ImportTiled, AsksForOneOfTooManyLayers) {
  std::string layers;
  for (int i = 0; i < 100; ++i)
    layers += R"(,{"type":"tilelayer","name":"l","width":2,"height":2,"data":[0,0,0,0]})";
  EXPECT_EQ(error_of(map_text({.layers = layers})),
            "map: error: has 101 tile layers, but a level holds at most 100: choose one by "
            "`--layer NAME`");
}

// The ground is not moved, and that is said.
TEST(ImportTiled, TellsThatAnOffsetMovesNoGround) {
  const LoadedLevel one =
      read(map_text({.layers = R"(,{"type":"tilelayer","name":"a","offsety":4,"data":[0,0,0,0],
      "properties":[{"name":"ground","type":"bool","value":true}]})"}));
  EXPECT_THAT(one.dropped,
              testing::Contains("the offset of the ground of the layer \"a\": only its picture is moved"));
}

TEST(ImportTiled, ChoosesOneOfSeveralLayers) {
  const std::string text = map_text(
      {.layers =
           R"(,{"type":"group","name":"g","layers":[{"type":"tilelayer","name":"back","data":[3,3,3,3]}]})"});
  FormatContext context{"tmj"};
  std::vector<std::string> dropped;
  context.choices.layer = "back";
  const auto loaded = read_level(text, context);
  ASSERT_TRUE(loaded);
  EXPECT_THAT(loaded->level.map.cells().tiles(), ElementsAre(2, 2, 2, 2));
  EXPECT_THAT(loaded->dropped, testing::Contains("the layer \"ground\""));
  context.choices.layer = "front";
  EXPECT_EQ(read_level(text, context).error().message,
            "has no tile layer with the name \"front\", but \"ground\", \"back\"");
}

TEST(ImportTiled, TakesUsedTilesOfLargeAndOfSeveralTilesets) {
  std::string text = map_text({.cells = "600,1,0,600"});
  const std::string count = "\"tilecount\":16";
  text.replace(text.find(count), count.size(), "\"tilecount\":700");
  const auto all = read_level(text, FormatContext{"tmj"});
  ASSERT_TRUE(all);
  EXPECT_THAT(all->level.map.cells().tiles(), ElementsAre(599, 0, 0, 599));
  EXPECT_EQ(all->level.sheet(SheetId::tiles).layout(), (SheetLayout{4, 700}));
  FormatContext used{"tmj"};
  used.choices.used_tiles = true;
  EXPECT_THAT(read_level(text, used)->level.map.cells().tiles(), ElementsAre(2, 1, 0, 2));

  const std::string first = "\"tilesets\":[";
  std::string two = map_text({.cells = "1,101,0,1"});
  two.insert(two.find(first) + first.size(),
             R"({"firstgid":100,"name":"u","tilewidth":8,"tileheight":8,"columns":4,"tilecount":8},)");
  EXPECT_THAT(read_level(two, used)->level.map.cells().tiles(), ElementsAre(2, 1, 0, 2));
  const Level both = read(two).level;
  EXPECT_THAT(both.map.cells().tiles(), ElementsAre(0, 17, 0, 0)) << "below the rows of the first one";
  EXPECT_EQ(both.sheet(SheetId::tiles).layout(), (SheetLayout{4, 24}));
}

TEST(ImportTiled, HasAtMostAllNumbersOfTiles) {
  const auto with_tiles = [](const std::string& tiles) {
    std::string text = map_text({.cells = "1,0,0,1"});
    const std::string count = "\"tilecount\":16";
    return text.replace(text.find(count), count.size(), "\"tilecount\":" + tiles);
  };
  EXPECT_EQ(read(with_tiles("8192")).level.tile_count(), 8192);
  EXPECT_EQ(read(with_tiles("8193")).level.tile_count(), 8193) << "one behind another";
  EXPECT_EQ(
      error_of(with_tiles("65537")),
      "map: error: has tilesets of 4x16385 tiles in all, but a level has only 65536, in up to 2048 columns "
      "and rows: `talus import --tiles-used` takes only those that the map shows");
}

TEST(ImportTiled, CellsKeepTheirFlips) {
  const std::string slope = polygon(R"({"x":0,"y":8},{"x":8,"y":4},{"x":8,"y":8})");
  // The cells as they are, mirrored horizontally, mirrored vertically, and turned by a quarter clockwise.
  const std::string text =
      map_text({.cells = "6,2147483654,1073741830,2684354566", .tiles = tile_text(slope)});
  FormatContext used{"tmj"};
  used.choices.used_tiles = true;
  for (const FormatContext& context : {FormatContext{"tmj"}, used}) {
    const auto loaded = read_level(text, context);
    ASSERT_TRUE(loaded);
    const TileNumber tile = context.choices.used_tiles ? 1 : 17;
    const Level& level = loaded->level;
    EXPECT_THAT(level.map.cells().tiles(), ElementsAre(tile, tile, tile, tile));
    EXPECT_THAT(level.map.cells().turns(),
                ElementsAre(TileTurn::none, TileTurn::left_right, TileTurn::up_down, kTurnRight));
    EXPECT_THAT(loaded->dropped, testing::Not(testing::Contains(HasSubstr("turned"))));
    EXPECT_EQ(shape_of_cell(level, level.map.at({1, 0})),
              (TileShape{.kind = TileShape::Kind::slope, .heights = {4, 0}}));
  }
}

// A cell cannot turn a tile of another size about the tile's middle.
TEST(ImportTiled, TurnedTilesOfOtherSizesAreTilesOfTheirOwn) {
  std::string text = map_text({.cells = "6,2147483654,1073741830,6"});
  const std::string width = "\"tilewidth\":8";
  text.replace(text.rfind(width), width.size(), "\"tilewidth\":4");  // of the tileset
  const LoadedLevel loaded = read(text);
  EXPECT_FALSE(loaded.level.map.cells().has_turned());
  EXPECT_NE(loaded.level.map.at({0, 0}), loaded.level.map.at({1, 0}));
  EXPECT_THAT(loaded.dropped, testing::Contains(testing::HasSubstr("do not have the size of a cell")));
}

TEST(ImportTiled, XmlNeedsOneRootAndValidCharacters) {
  const std::string map =
      "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">\n"
      "<layer name=\"l\"><data encoding=\"csv\">0</data></layer></map>";
  EXPECT_EQ(error_of("\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!-- a -->" + map + "\n<!-- b -->\n", "tmx"), "");
  const std::string more = "map:line 3: error: there is more than one element in the XML";
  EXPECT_EQ(error_of(map + "\ntext", "tmx"), more);
  EXPECT_EQ(error_of(map + "\n<map/>", "tmx"), more);
  EXPECT_EQ(error_of(map + "\n<![CDATA[a]]>", "tmx"), more);
  EXPECT_EQ(error_of("<!-- a -->", "tmx"), "map:line 1: error: this is not valid XML");
  const auto with = [&](std::string_view name) {
    std::string text = map;
    return text.replace(text.find("name=\"l\"") + 6, 1, name);
  };
  EXPECT_EQ(error_of(with("&#9;&#10;&#13;\xc3\xa4"), "tmx"), "");
  for (const char* name : {"&#27;", "&#x1b;", "\x1b", "&#xFFFE;", "\xef\xbf\xbf", "&#xD800;"})
    EXPECT_EQ(error_of(with(name), "tmx"), "map:line 2: error: refers to a character that does not exist")
        << name;
}

TEST(ImportTiled, SaysWhatIsNeitherXmlNorJson) {
  using namespace std::string_literals;
  EXPECT_EQ(error_of("", "tmx"), "map: error: is empty");
  EXPECT_EQ(error_of("", "tmj"), "map: error: is empty");
  EXPECT_EQ(error_of("[1]", "tmx"), "map: error: is not XML, which begins with \"<\"");
  EXPECT_EQ(error_of("{", "tmx"), "map:line 1, column 2: error: this is not valid JSON, and not XML either");
  EXPECT_EQ(error_of("{", "tmj"), "map:line 1, column 2: error: this is not valid JSON");
  for (const std::string& text : {"\xff\xfe{\0"s, "\xfe\xff\0{"s})
    EXPECT_EQ(error_of(text, "tmx"), "map: error: is text in UTF-16, but must be UTF-8");
}

// A million messages took 54 MB in the window.
TEST(ImportTiled, ReportsTheFirstThousandDroppedThings) {
  std::string text = map_text({});
  std::string keys;
  for (int i = 0; i < 1005; ++i) keys += "\"later" + std::to_string(i) + "\":0,";
  text.insert(1, keys);
  const LoadedLevel loaded = read(text);
  ASSERT_EQ(loaded.dropped.size(), 1001u);
  EXPECT_EQ(loaded.dropped.back(), "and 6 more");
}

TEST(ImportTiled, TakesALayerByNumberIfNoneHasThatName) {
  const std::string text =
      map_text({.layers = R"(,{"type":"tilelayer","name":"ground","width":2,"height":2,"data":[3,3,3,3]})"});
  FormatContext context{"tmj"};
  const auto first_cell = [&] {
    const auto loaded = read_level(text, context);
    return loaded ? loaded->level.map.tile_at({0, 0}) : 255;
  };
  context.choices.layer = "ground";
  EXPECT_EQ(first_cell(), 0) << "the first of two layers with one name";
  context.choices.layer = "2";
  EXPECT_EQ(first_cell(), 2);
  context.choices = {.layer_number = 2};
  EXPECT_EQ(first_cell(), 2);
  context.choices = {.layer_number = 3};
  EXPECT_EQ(first_cell(), 255);
}

// Each tile of this tileset has a flag, so that none is free for empty cells.
TEST(ImportTiled, EmptyCellsGetATileBehindAllOthers) {
  std::string tiles, cells;
  for (int id = 0; id < kCartTiles; ++id)
    tiles += (id == 0 ? "" : ",") + std::string(R"({"id":)") + std::to_string(id) + "}";
  std::string text = map_text({.cells = "1,0,1,1", .tiles = tiles});
  const std::string count = "\"tilecount\":16";
  text.replace(text.find(count), count.size(), "\"tilecount\":256");
  const LoadedLevel loaded = read(text);
  EXPECT_EQ(loaded.level.tile_count(), 257);
  EXPECT_THAT(loaded.level.map.cells().tiles(), ElementsAre(256, 0, 256, 256));
  EXPECT_THAT(loaded.dropped, testing::Not(testing::Contains(testing::HasSubstr("tile 0"))))
      << "nobody has to know how tiles are numbered";
}

class ImportTiledFiles : public FolderTest {
 protected:
  // Writes an export of the level as cave.EXTENSION, and reads it.
  LoadedLevel there_and_back(const Level& level, const std::string& format) {
    const std::string file = path("cave." + format);
    const Exported exported = tiled_export_of(level, format, "cave." + format);
    EXPECT_TRUE(write_exported(*find_exporter(format), exported, file));
    auto loaded = load_level(file);
    EXPECT_TRUE(loaded) << to_string(loaded.error(), file);
    return loaded ? *loaded : LoadedLevel{Level(), nullptr};
  }
};

TEST_F(ImportTiledFiles, AnExportIsReadBackWithoutLoss) {
  Level level = level_for_tiled();
  for (const std::string format : {"tmj", "tmx"}) {
    const LoadedLevel loaded = there_and_back(level, format);
    EXPECT_TRUE(loaded.level == level) << format;
    EXPECT_THAT(loaded.dropped, ElementsAre()) << format;
  }
  level.sheet(SheetId::tiles).images[0][5] = 1;  // tile 0 is drawn, as the others are
  EXPECT_TRUE(there_and_back(level, "tmj").level == level);
  const auto cart = load_level(source_path("assets/demo.talus.json"));
  const auto native = [](const Level& l) { return find_format("native")->write(l, {})->bytes; };
  EXPECT_EQ(native(there_and_back(cart->level, "tmx").level), native(cart->level)) << "with the cart's code";
}

TEST_F(ImportTiledFiles, ShapesFlagsAndNamesDoNotNeedTheLevelProperty) {
  const Level level = level_for_tiled();
  std::string text = tiled_export_of(level, "tmj", "cave.tmj").files[0].bytes;
  text.replace(text.find("talus_level"), 11, "another");
  const LoadedLevel loaded = read(text);
  EXPECT_THAT(loaded.dropped, testing::UnorderedElementsAre("the picture of the tileset \"tiles\"",
                                                            "the property \"another\" of the map"));
  EXPECT_EQ(loaded.level.tile_shapes, level.tile_shapes);
  EXPECT_EQ(loaded.level.sheet(SheetId::tiles).flags, level.sheet(SheetId::tiles).flags);
  EXPECT_EQ(loaded.level.flag_names, level.flag_names);
  EXPECT_EQ(loaded.level.map, level.map);
  EXPECT_EQ(loaded.level.spawns[0].velocity, level.spawns[0].velocity);
  EXPECT_EQ(loaded.level.curves, level.curves) << "properties have the exact form of the arc";
}

TEST_F(ImportTiledFiles, ChangesMadeInTiledAreKept) {
  std::string text = tiled_export_of(level_for_tiled(), "tmj", "cave.tmj").files[0].bytes;
  const auto change = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  change(R"({"x": 16, "y": -12})", R"({"x": 16, "y": -11})");
  change(R"("x": 12.3456789)", R"("x": 13)");
  change(R"({"x": 7.75, "y": 6.5})", R"({"x": 7.75, "y": 7})");
  const LoadedLevel loaded = read(text);
  EXPECT_EQ(loaded.level.tile_shapes[5].heights, (std::vector<double>{1.00390625, 19}));
  EXPECT_TRUE(loaded.level.tile_shapes[5].one_way);
  EXPECT_EQ(loaded.level.spawns[0].position, (Vec2{13, 2}));
  EXPECT_EQ(std::get<Segment>(loaded.level.curves[0].curve.form), (Segment{{1.25, 2}, {9, 9}}));
  EXPECT_EQ(loaded.level.curves[1], level_for_tiled().curves[1]) << "the arc was left alone";
  EXPECT_THAT(loaded.dropped,
              testing::Contains("the property \"shape_heights\" of a tile, as its outline says otherwise"));
}

TEST_F(ImportTiledFiles, EmptyCellsGetAnotherTileIfTile0IsDrawn) {
  Level level = level_for_tiled();
  level.sheet(SheetId::tiles).images[0].fill(2);
  std::string text = tiled_export_of(level, "tmj", "cave.tmj").files[0].bytes;
  const std::string row = "2,2,2,2,2,2";
  text.replace(text.find(row), row.size(), "2,2,0,2,2,2");
  put("cave.tmj", text);
  put("cave-tiles.png", write_png_part(level, PngPart::tiles));
  const auto loaded = load_level(path("cave.tmj"));
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "map");
  EXPECT_EQ(loaded->level.map.at({2, 3}), 0);
  EXPECT_EQ(loaded->level.map.at({0, 0}), 8) << "the first blank one";
  EXPECT_EQ(loaded->level.sheet(SheetId::tiles).images[8][0], 2);
  EXPECT_THAT(loaded->dropped, testing::IsEmpty());
}

// A picture of 32x32 px in which the red of each tile is its number.
std::string numbered_png() {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const auto number = static_cast<std::uint8_t>(y / 8 * 4 + x / 8);
      bytes.insert(bytes.end(), {static_cast<std::uint8_t>(10 * number), 0, 0,
                                 static_cast<std::uint8_t>(number == 0 ? 0 : 255)});
    }
  }
  return encode_png(32, 32, 4, bytes.data());
}

TEST_F(ImportTiledFiles, FindsTilesetsAndPicturesBesideTheMap) {
  std::filesystem::create_directories(folder_ / "sets");
  put("map.tmx",
      "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">"
      "<tileset firstgid=\"5\" source=\"sets/t.tsx\"/><layer name=\"l\"><data "
      "encoding=\"csv\">10,0</data></layer></map>");
  put("sets/t.tsx",
      "<tileset name=\"t\" tilewidth=\"8\" tileheight=\"8\"><image source=\"..\\t.png\" width=\"32\" "
      "height=\"32\"/>"
      "<tile id=\"5\"><objectgroup><object x=\"0\" y=\"0\" width=\"8\" "
      "height=\"8\"/></objectgroup></tile></tileset>");
  put("t.png", numbered_png());
  const auto loaded = load_level(path("map.tmx"));
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "map");
  EXPECT_THAT(loaded->dropped, ElementsAre());
  EXPECT_THAT(loaded->level.map.cells().tiles(), ElementsAre(17, 0));
  EXPECT_EQ(loaded->level.tile_shapes[17].kind, TileShape::Kind::solid);
  const std::uint8_t color = loaded->level.sheet(SheetId::tiles).images[17][0];
  EXPECT_EQ(loaded->level.palette[color], (Rgb{50, 0, 0}));
  const auto tileset = load_level(path("sets/t.tsx"));
  ASSERT_TRUE(tileset);
  EXPECT_EQ(tileset->level.tile_shapes[17].kind, TileShape::Kind::solid);
}

TEST_F(ImportTiledFiles, NamesTheTilesetThatIsOutside) {
  const auto error_with = [&](const std::string& source) {
    put("map.tmx",
        "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\">"
        "<tileset firstgid=\"1\" source=\"" +
            source + "\"/><layer name=\"l\"><data encoding=\"csv\">0</data></layer></map>");
    const auto loaded = load_level(path("map.tmx"));
    return loaded ? loaded->dropped.back() : to_string(loaded.error(), "map");
  };
  EXPECT_EQ(error_with("/etc/passwd"),
            "the tileset, file /etc/passwd: must be relative to the folder of the map");
  EXPECT_EQ(error_with("C:\\t.tsx"), "the tileset, file C:/t.tsx: must be relative to the folder of the map");
  EXPECT_EQ(error_with("."), "the tileset, file .: is not a file");
  put("t.tsx", "<tileset tilewidth=\"16\" tileheight=\"0\"/>");
  EXPECT_EQ(error_with("t.tsx"),
            "map:file t.tsx, line 1: error: has tiles of 16x0 px, but a tileset needs tiles of 1 to 4096 px "
            "a side");
}

TEST_F(ImportTiledFiles, PicturesOfManyColoursGetTheNearest) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 32 * 32; ++i) bytes.insert(bytes.end(), {static_cast<std::uint8_t>(i % 32 * 8), 0, 0});
  put("t.png", encode_png(32, 32, 3, bytes.data()));
  put("map.tmj", map_text({.tileset = R"("image":"t.png","imagewidth":32,"imageheight":32,)"}));
  const auto loaded = load_level(path("map.tmj"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->level.palette, default_palette());
  EXPECT_NE(loaded->level.sheet(SheetId::tiles).picture, nullptr) << "which has all colours";
}

TEST_F(ImportTiledFiles, LevelsAndMapsOfTiledAreDistinguished) {
  EXPECT_EQ(read_level(R"({"talus": 1})", {"json"})->format->id, "native");
  EXPECT_EQ(read_level(map_text({}), {"json"})->format->id, "tmj") << "as older versions of Tiled name them";
  EXPECT_EQ(
      read_level(tiled_export_of(level_for_tiled(), "tmj", "a.tmj").files[0].bytes, {"json"})->format->id,
      "tmj");
}

}  // namespace talus::import_tiled_test
