// Exports that draw the layers of a level and collide with their ground.
#include <gmock/gmock.h>

#include "export/exporter.h"
#include "formats/files/atomic_file.h"
#include "level/layer_tree.h"
#include "paths.h"

namespace talus::export_layers_test {

using testing::HasSubstr;
using testing::Not;

constexpr TileNumber kBlock = 1, kRamp = 2, kHillPicture = 3;

// 2x1 cells. Behind: hills that are only drawn. In front: a block and a ramp, and over the ramp another
// block.
Level three_layers() {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(2, 1);
  level.tile_shapes[kBlock] = {.kind = TileShape::Kind::solid};
  level.tile_shapes[kRamp] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.map.cells().tiles() = {kHillPicture, kHillPicture};
  const auto layer = [&](const char* name, std::vector<TileNumber> cells) {
    TileLayer made{.name = name};
    made.cells = std::make_shared<const MapCells>(std::move(cells));
    level.layers.list.push_back(std::move(made));
  };
  level.layers.list.front().name = "hills";
  level.layers.list.front().is_ground = false;
  level.layers.list.front().parallax = {0.5, 1};
  level.layers.list.front().opacity = 0.25;
  layer("ground", {kBlock, kRamp});
  layer("more", {0, kBlock});
  return level;
}

Exported exported(const Level& level, std::string_view id) {
  const ReadAsset read = [](const std::string& name) { return read_file(source_path("assets/") + name); };
  return find_exporter(id)->make({level, "game", read}).value();
}

std::string text_of(const Exported& exported, const std::string& name) {
  for (const ExportedFile& file : exported.files)
    if (file.name == name) return file.bytes;
  ADD_FAILURE() << "no file " << name;
  return "";
}

TEST(ExportLayers, GamesDrawThemAndCollideWithTheirGround) {
  for (const char* id : {"love", "lua-runtime", "bump"}) {
    const Exported game = exported(three_layers(), id);
    const std::string level = text_of(game, "level.lua");
    EXPECT_THAT(level, HasSubstr("tiles = {\n    1,256,\n  }")) << id << ": a stack has a number of its own";
    EXPECT_THAT(level, HasSubstr("[256] = {kind = \"group\"")) << id;
    EXPECT_THAT(level, HasSubstr("name = \"hills\",\n      opacity = 0.25,\n      parallax_x = 0.5,")) << id;
    EXPECT_THAT(level, HasSubstr("name = \"more\",\n      ground = true,\n      tiles = {\n        0,1,"))
        << id;
    EXPECT_TRUE(game.dropped.empty()) << id << ": " << testing::PrintToString(game.dropped);
  }
}

TEST(ExportLayers, ALevelWithOneIsWrittenAsBefore) {
  Level level = three_layers();
  level.layers = {};
  EXPECT_THAT(text_of(exported(level, "love"), "level.lua"), Not(HasSubstr("layers")));
}

TEST(ExportLayers, StiHasThemAsLayers) {
  const std::string map = exported(three_layers(), "sti").files.front().bytes;
  EXPECT_THAT(map, HasSubstr("name = \"hills\""));
  EXPECT_THAT(map, HasSubstr("opacity = 0.25"));
  EXPECT_THAT(map, HasSubstr("parallaxx = 0.5"));
  EXPECT_THAT(map, HasSubstr("name = \"more\""));
  EXPECT_THAT(map, Not(HasSubstr("[\"slope\"]"))) << "the block over the ramp collides for both";
}

// The plugin for bump.lua would let a tile of any layer collide.
TEST(ExportLayers, StiDoesNotCollideWithWhatIsOnlyDrawn) {
  Level level = three_layers();
  level.map.cells().tiles() = {kBlock, kHillPicture};
  const std::string map = exported(level, "sti").files.front().bytes;
  const auto layers = map.find("layers = {");
  ASSERT_NE(layers, map.npos);
  EXPECT_THAT(map.substr(0, layers), Not(HasSubstr("collidable"))) << "no tile collides by itself";
  EXPECT_THAT(map.substr(layers), HasSubstr("collidable")) << "boxes of the ground do";
}

TEST(ExportLayers, ABodyInACellWithGroundIsSaidToBeLost) {
  Level level = three_layers();
  constexpr TileNumber kBall = 4;
  level.sheet(SheetId::tiles).flags[kBall] = static_cast<std::uint8_t>(1 << level.roles.ball);
  level.layers.list[2].cells = std::make_shared<const MapCells>(std::vector<TileNumber>{0, kBall});
  EXPECT_THAT(exported(level, "love").dropped,
              testing::ElementsAre("1 body in cells that have ground in another layer"));
}

TEST(ExportLayers, GroupsAreJoinedWithTheirLayers) {
  Level level = three_layers();
  level.layers.groups = {{.name = "far", .opacity = 0.5, .offset = {3, 4}, .tint = {0, 255, 128}}};
  level.layers.list[0].group = level.layers.list[1].group = 0;
  const Level flat = without_groups(level);
  EXPECT_EQ(flat.layers.list[0].opacity, 0.125);
  for (const Exporter& exporter : exporters()) {
    if (exporter.takes_groups) continue;
    const Exported with = exported(level, exporter.id), without = exported(flat, exporter.id);
    ASSERT_EQ(with.files.size(), without.files.size()) << exporter.id;
    for (std::size_t i = 0; i < with.files.size(); ++i)
      EXPECT_EQ(with.files[i].bytes, without.files[i].bytes) << exporter.id << " " << with.files[i].name;
  }
}

}  // namespace talus::export_layers_test
