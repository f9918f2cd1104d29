// Maps of Tiled that others have made are saved, whatever they are like.
#include <gmock/gmock.h>

#include <functional>

#include "folder_test.h"
#include "formats/pictures/png_picture.h"

namespace talus::save_every_map_test {

using testing::HasSubstr;

class SaveEveryMap : public FolderTest {
 protected:
  // Tiles of 2x2 px in four columns; the first are drawn, the others clear.
  void put_tiles(const std::string& name, int drawn, int rows) const {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < 2 * rows; ++y) {
      for (int x = 0; x < 8; ++x) {
        const int tile = y / 2 * 4 + x / 2;
        pixels.insert(pixels.end(), {static_cast<std::uint8_t>(40 + 9 * tile), 0, 99,
                                     static_cast<std::uint8_t>(tile < drawn ? 255 : 0)});
      }
    }
    put(name, encode_png(8, 2 * rows, 4, pixels.data()));
  }
  // A map of 2x2 cells.
  void put_map(const std::string& tilesets, const std::string& cells, const std::string& layer = "") const {
    put("m.tmx",
        "<map orientation=\"orthogonal\" width=\"2\" height=\"2\" tilewidth=\"2\" tileheight=\"2\">" +
            tilesets + "<layer name=\"l\" width=\"2\" height=\"2\"" + layer + "><data encoding=\"csv\">" +
            cells + "</data></layer></map>");
  }
  // Opens the map, edits its level, saves it, and opens it again.
  Level edit(const std::function<void(Level&)>& change) const {
    auto loaded = load_level(path("m.tmx"));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "m.tmx");
    if (!loaded) return Level();
    change(loaded->level);
    const auto saved = save_level(loaded->level, *loaded->format, path("m.tmx"), loaded->companion);
    EXPECT_TRUE(saved) << to_string(saved.error(), "m.tmx");
    const auto again = load_level(path("m.tmx"));
    EXPECT_TRUE(again) << to_string(again.error(), "m.tmx");
    if (again) {
      EXPECT_EQ(again->level.layers, loaded->level.layers);
      EXPECT_EQ(again->level.map, loaded->level.map);
      EXPECT_EQ(again->level.tile_shapes, loaded->level.tile_shapes);
    }
    return again ? again->level : Level();
  }
};

std::string tileset(int first, const std::string& picture, int count) {
  return "<tileset firstgid=\"" + std::to_string(first) +
         "\" name=\"t\" tilewidth=\"2\" tileheight=\"2\" tilecount=\"" + std::to_string(count) +
         "\" columns=\"4\"><image source=\"" + picture + "\"/></tileset>";
}

void nothing(Level&) {}

TEST_F(SaveEveryMap, WithTilesetsThatOverlap) {
  put_tiles("t.png", 16, 4);
  put_tiles("u.png", 8, 4);
  put_map(tileset(1, "t.png", 16) + tileset(9, "u.png", 16), "1,2,9,10");
  const std::string text = bytes_of("m.tmx");
  edit(nothing);
  EXPECT_EQ(bytes_of("m.tmx"), text);
  edit([](Level& level) { level.map.set({0, 0}, level.map.at({1, 1})); });
  EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(">10,2,9,10<"));
}

TEST_F(SaveEveryMap, WithATilesetInPlaceOfAnother) {
  put_tiles("t.png", 8, 2);
  const std::string set =
      R"(<tileset name="t" tilewidth="2" tileheight="2" tilecount="8" columns="4"><image source="t.png"/></tileset>)";
  put("t.tsx", set);
  put("u.tsx", set);
  put_map("<tileset firstgid=\"1\" source=\"t.tsx\"/><tileset firstgid=\"5\" source=\"u.tsx\"/>", "1,2,5,6");
  const std::string text = bytes_of("m.tmx");
  edit(nothing);
  EXPECT_EQ(bytes_of("m.tmx"), text);
  edit([](Level& level) { level.tile_shapes[level.map.tile_at({0, 1})] = {.kind = TileShape::Kind::solid}; });
}

TEST_F(SaveEveryMap, WithoutEmptyCellsThatGrows) {
  for (const int drawn : {8, 3}) {
    put_tiles("t.png", drawn, 2);
    put_map(tileset(1, "t.png", 8), "1,2,3,1");
    edit([](Level& level) {
      TileMap map(3, 2, level.map.tile_size());
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) map.set({x, y}, level.map.at({x, y}));
      level.map = map;
    });
    EXPECT_THAT(bytes_of("m.tmx"), HasSubstr("1,2,0,"));
  }
}

TEST_F(SaveEveryMap, WhoseOnlyLayerIsEdited) {
  put_tiles("t.png", 8, 2);
  const auto each = [&](const auto& change, const std::string& written) {
    for (const std::string cells : {"1,2,3,4", "1,0,3,4"}) {
      put_map(tileset(1, "t.png", 8), cells);
      edit([&](Level& level) { change(level.layers.list[0]); });
      EXPECT_THAT(bytes_of("m.tmx"), HasSubstr(written)) << cells;
    }
  };
  each([](TileLayer& layer) { layer.name = "other"; }, "<layer name=\"other\"");
  each([](TileLayer& layer) { layer.visible = false; }, "visible=\"0\"");
  each([](TileLayer& layer) { layer.locked = true; }, "locked=\"1\"");
  each([](TileLayer& layer) { layer.is_ground = false; }, "name=\"ground\" type=\"bool\" value=\"false\"");
  each([](TileLayer& layer) { layer.opacity = 0.5; }, "opacity=\"0.5\"");
}

}  // namespace talus::save_every_map_test
