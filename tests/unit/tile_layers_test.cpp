// Levels with several layers of tiles.
#include <gmock/gmock.h>

#include <talus/level/ground.h>
#include <talus/level/limits.h>
#include <talus/sim/scene.h>
#include "collision/ground_queries.h"
#include "edit/map_resize.h"
#include "edit/undo_stack.h"
#include "formats/native/native.h"
#include "level/ground_cells.h"
#include "level/level_version.h"
#include "level/transform.h"

namespace talus {
namespace {

constexpr TileNumber kFull = 1, kRise = 2, kMarker = 3, kDecor = 4, kOtherFull = 5;

std::shared_ptr<const MapCells> blank_cells(const Level& level) {
  return std::make_shared<const MapCells>(level.map.cells().size());
}

// A map of 4x3 cells with three layers: "back", which is drawn only, "ground", which is chosen, and "front",
// which is ground as well.
Level layered() {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(4, 3);
  level.tile_shapes[kFull] = level.tile_shapes[kOtherFull] = {.kind = TileShape::Kind::solid};
  level.tile_shapes[kRise] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.sheet(SheetId::tiles).flags[kMarker] = static_cast<std::uint8_t>(1 << level.roles.ball);
  level.layers.list = {{.name = "back", .is_ground = false, .cells = blank_cells(level)},
                       {.name = "ground"},
                       {.name = "front", .cells = blank_cells(level)}};
  level.layers.chosen = 1;
  return level;
}

void put(Level& level, int layer, Cell cell, TileNumber tile) {
  const int chosen = level.layers.chosen;
  level.choose_layer(layer);
  level.map.set(cell, tile);
  level.choose_layer(chosen);
}

TileNumber tile_in(const Level& level, int layer, Cell cell) {
  return level.cells_of(layer).tiles()[static_cast<std::size_t>(cell.y) * level.map.width() + cell.x];
}

Edit paint(Cell cell, TileNumber tile) { return {"Paint", {CellChange{cell, 0, tile}}}; }

void push(UndoStack& history, Level& level, Edit edit, int stroke = 0) {
  rebase_edit(level, edit);
  history.push(level, std::move(edit), stroke);
}

Level read_again(const Level& level) {
  const auto written = write_native(level, {});
  EXPECT_TRUE(written) << written.error().message;
  const auto read = read_native(written->bytes, {});
  EXPECT_TRUE(read) << read.error().place << ": " << read.error().message;
  return read.value_or(Level());
}

std::string error_of(const std::string& members) {
  const auto read =
      read_native("{\"talus\": 4, \"map\": {\"width\": 2, \"height\": 1}, " + members + "}", {});
  return read ? "" : read.error().place + ": " + read.error().message;
}

TEST(TileLayers, AnyOfThemIsTheMap) {
  Level level = layered();
  level.map.set({0, 0}, kFull);
  level.choose_layer(2);
  EXPECT_EQ(level.map.at({0, 0}), 0);
  level.map.set({0, 0}, kRise);
  level.choose_layer(1);
  EXPECT_EQ(level.map.at({0, 0}), kFull);
  EXPECT_EQ(tile_in(level, 2, {0, 0}), kRise);
  EXPECT_EQ(tile_in(level, 0, {0, 0}), 0);
}

TEST(TileLayers, AreTheSameWhicheverIsChosen) {
  Level level = layered(), other = layered();
  other.choose_layer(0);
  EXPECT_EQ(level, other);
  put(other, 2, {3, 2}, kFull);
  EXPECT_NE(level, other);
}

TEST(TileLayers, UndoChoosesTheLayerOfTheEdit) {
  Level level = layered();
  UndoStack history;
  push(history, level, paint({1, 1}, kFull));
  level.choose_layer(2);
  push(history, level, paint({1, 1}, kRise));
  level.choose_layer(0);
  history.undo(level);
  EXPECT_EQ(level.layers.chosen, 2);
  EXPECT_EQ(level.map.at({1, 1}), 0);
  history.undo(level);
  EXPECT_EQ(level.layers.chosen, 1);
  EXPECT_EQ(level, layered());
  history.redo(level);
  history.redo(level);
  EXPECT_EQ(tile_in(level, 1, {1, 1}), kFull);
  EXPECT_EQ(tile_in(level, 2, {1, 1}), kRise);
}

TEST(TileLayers, AStrokeStaysInItsLayer) {
  Level level = layered();
  UndoStack history;
  push(history, level, paint({0, 0}, kFull), 1);
  push(history, level, paint({1, 0}, kFull), 1);
  level.choose_layer(2);
  push(history, level, paint({2, 0}, kFull), 1);
  EXPECT_EQ(history.edits().size(), 2U);
  history.undo(level);
  history.undo(level);
  EXPECT_EQ(level, layered());
}

TEST(TileLayers, AreAddedAndRemovedByEdits) {
  Level level = layered();
  UndoStack history;
  TileLayers fewer = level.layers;
  fewer.list.erase(fewer.list.begin());
  fewer.chosen = 0;
  push(history, level, {"Delete layer", {LayersChange{level.layers, fewer}}});
  EXPECT_EQ(level.layers.count(), 2);
  push(history, level, paint({0, 0}, kFull));
  level.choose_layer(1);
  history.undo(level);
  history.undo(level);
  EXPECT_EQ(level, layered());
  EXPECT_EQ(level.layers.chosen, 1);
  history.redo(level);
  history.redo(level);
  EXPECT_EQ(tile_in(level, 0, {0, 0}), kFull);
}

TEST(TileLayers, TooManyAreRefused) {
  Level level = layered();
  TileLayers many = level.layers;
  many.list.resize(kMaxLayers + 1, many.list.back());
  EXPECT_EQ(problem_after(level, {"Add layers", {LayersChange{level.layers, many}}}),
            "has 101 layers, but a level holds at most 100");
}

TEST(TileLayers, ComeBackFromTheFile) {
  Level level = layered();
  put(level, 0, {0, 0}, kDecor);
  level.map.set({1, 0}, kFull);
  put(level, 2, {3, 2}, kRise);
  level.layers.list[2] = {.name = "front",
                          .is_ground = true,
                          .visible = false,
                          .locked = true,
                          .opacity = 0.5,
                          .offset = {4, -2.5},
                          .parallax = {0.5, 1},
                          .tint = {255, 128, 0},
                          .extra = "{\"class\":\"sky\"}",
                          .cells = level.layers.list[2].cells};
  const Level again = read_again(level);
  EXPECT_EQ(again, level);
  EXPECT_EQ(again.layers.chosen, 1) << "the first one that is ground";
}

TEST(TileLayers, LargeOnesArePacked) {
  Level level = layered();
  level.map = TileMap(1025, 1024);
  for (TileLayer& layer : level.layers.list)
    if (layer.cells != nullptr) layer.cells = blank_cells(level);
  level.map.set({1024, 1023}, kFull);
  put(level, 2, {0, 0}, 255);
  const auto written = write_native(level, {});
  ASSERT_TRUE(written);
  EXPECT_LT(written->bytes.size(), 100'000u);
  EXPECT_EQ(read_again(level), level);
  EXPECT_EQ(error_of("\"layers\": [{\"packed\": [\"AAAA\"]}]"),
            "key layers[0].packed: must be a zlib stream of 2 cells, two bytes each");
  EXPECT_EQ(error_of("\"layers\": [{\"packed\": 1}]"),
            "key layers[0].packed: must be a list of strings in Base64");
}

TEST(TileLayers, PlainLevelsKeepTheirBytes) {
  Level level;
  const auto before = write_native(level, {});
  EXPECT_EQ(before->bytes.find("layers"), std::string::npos);
  EXPECT_THAT(before->bytes, testing::HasSubstr("\"talus\": 1"));
  level.layers.list.front().name = "ground";
  EXPECT_EQ(read_again(level), level);
}

TEST(TileLayers, BadOnesAreErrors) {
  EXPECT_EQ(error_of("\"layers\": []"), "key layers: must be a list of 1 to 100 layers");
  EXPECT_EQ(error_of("\"layers\": [{\"opacity\": 2}]"),
            "key layers[0].opacity: must be a number from 0 to 1");
  EXPECT_EQ(error_of("\"layers\": [{}, {\"rows\": [\"..\", \"..\"]}]"),
            "key layers[1].rows: has 2 rows, more than the map's height of 1");
  EXPECT_EQ(error_of("\"layers\": [{\"rows\": [\"0x\"]}]"),
            "layers[0] row 0: has a cell, number 0, that is not two hexadecimal digits");
  EXPECT_EQ(error_of("\"layers\": [{\"tint\": \"red\"}]"),
            "key layers[0].tint: must be a colour such as \"1a1c2c\"");
  EXPECT_EQ(error_of("\"layers\": [{\"offset\": [1e9, 0]}]"),
            "key layers[0].offset: must be [x, y], each from -1000000 to 1000000");
}

TEST(GroundCells, OneLayerIsTakenAsItIs) {
  Level level = layered();
  level.layers.list[2].is_ground = false;
  const GroundCells ground = ground_cells(level);
  EXPECT_EQ(ground.cells.data(), level.map.cells().tiles().data());
  EXPECT_TRUE(ground.stacks.empty());
}

TEST(GroundCells, OnlyTilesThatCountAreStacked) {
  Level level = layered();
  level.map.set({0, 0}, kFull);
  put(level, 2, {0, 0}, kDecor);
  level.map.set({1, 0}, kFull);
  put(level, 2, {1, 0}, kOtherFull);
  level.map.set({2, 0}, kRise);
  put(level, 2, {2, 0}, kMarker);
  const GroundCells ground = ground_cells(level);
  EXPECT_EQ(ground.cells[0], kFull);
  EXPECT_EQ(ground.cells[1], kOtherFull) << "of one shape, the one in front";
  EXPECT_EQ(ground.cells[2], 256);
  EXPECT_EQ(ground.stacks, (std::vector<TileStack>{{kRise, kMarker}}));
  EXPECT_EQ(ground_number(level, ground.stacks, {2, 0}), 256);
  EXPECT_EQ(ground_number(level, {}, {2, 0}), std::nullopt);
}

TEST(GroundCells, NoLayerOfGroundIsNoGround) {
  Level level = layered();
  level.tile_shapes[0] = {.kind = TileShape::Kind::solid};
  for (TileLayer& layer : level.layers.list) layer.is_ground = false;
  EXPECT_FALSE(overlaps_ground(terrain_of(level), Rect{4, 4, 4, 4}));
  EXPECT_TRUE(compile_scene(level).items.empty());
}

// The ground of layers is that of one layer with groups.
TEST(GroundCells, LayersAreTheUnionOfTheirShapes) {
  Level level = layered(), flat = layered();
  level.map.set({1, 1}, kRise);
  level.tile_shapes[kRise].side = TileShape::Side::ceiling;
  level.tile_shapes[kDecor] = {.kind = TileShape::Kind::slope, .heights = {4, 2}};
  put(level, 2, {1, 1}, kDecor);
  put(level, 2, {2, 1}, kFull);
  flat.layers = {};
  flat.tile_shapes[6] = {.kind = TileShape::Kind::group,
                         .parts = {level.tile_shapes[kRise], level.tile_shapes[kDecor]}};
  flat.map.set({1, 1}, 6);
  flat.map.set({2, 1}, kFull);
  const Terrain ground = terrain_of(level), expected = terrain_of(flat);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 32; ++x) {
      const Rect point{x + 0.25, y + 0.25, 0.5, 0.5};
      EXPECT_EQ(overlaps_ground(ground, point), overlaps_ground(expected, point)) << x << ", " << y;
    }
  }
}

TEST(GroundCells, BodiesOfAllLayersOfGroundStart) {
  Level level = layered();
  level.map.set({0, 0}, kMarker);
  put(level, 2, {1, 0}, kMarker);
  put(level, 2, {0, 0}, kFull);
  put(level, 0, {3, 0}, kMarker);
  for (const SolverKind solver : {SolverKind::exact, SolverKind::article, SolverKind::bump}) {
    level.tuning.solver = solver;
    const Scene scene = compile_scene(level);
    const auto balls = std::count_if(scene.items.begin(), scene.items.end(),
                                     [](const SceneItem& item) { return item.role == TileRole::ball; });
    EXPECT_EQ(balls, 2);
    EXPECT_EQ(scene.items.size(), solver == SolverKind::exact ? 2U : 3U);
  }
}

TEST(GroundCells, RecompiledIsAsCompiled) {
  Level level = layered();
  level.map.set({1, 1}, kRise);
  put(level, 2, {1, 1}, kMarker);
  level.map.set({3, 0}, kRise);  // so that the stack stays in use
  put(level, 2, {3, 0}, kMarker);
  const Scene scene = compile_scene(level);
  for (const TileNumber tile : {kFull, kRise, kMarker, kDecor}) {
    for (const int layer : {0, 1, 2}) {
      Level edited = level;
      put(edited, layer, {1, 1}, tile);
      put(edited, layer, {2, 2}, tile);
      const std::vector<Cell> cells{{1, 1}, {2, 2}};
      EXPECT_EQ(recompile_scene(scene, edited, cells), compile_scene(edited)) << tile << " in " << layer;
    }
  }
}

TEST(LevelVersions, KeepLayers) {
  Level level = layered();
  put(level, 2, {1, 1}, kFull);
  const LevelVersion version = version_of(level);
  EXPECT_EQ(level_of(version).layers, level.layers);
  Level edited = level;
  put(edited, 0, {3, 2}, kDecor);
  edited.map.set({0, 0}, kFull);
  const LevelVersion next = version_of(edited, &version);
  EXPECT_EQ(changed_cells(version, next, 10), (std::vector<Cell>{{0, 0}, {3, 2}}));
  EXPECT_EQ(next.layers[2].rows[1], version.layers[2].rows[1]) << "equal rows are shared";
  Level back = level;
  put_version(next, back);
  EXPECT_EQ(back, edited);
}

// A map of 4096x4096 cells takes 32 MiB a layer, which a version need not take again.
TEST(LevelVersions, ShareTheCellsOfLayersThatAreNotChosen) {
  Level level = layered();
  const int chosen = level.layers.chosen, other = chosen == 0 ? 1 : 0;
  const LevelVersion version = version_of(level);
  const auto& cells = level.layers.list[static_cast<std::size_t>(other)].cells;
  EXPECT_EQ(version.layers[static_cast<std::size_t>(other)].rows[1].cells, cells);

  level.choose_layer(other);
  level.map.set({0, 1}, kFull);
  const LevelVersion next = version_of(level, &version);
  const auto& rows = next.layers[static_cast<std::size_t>(other)].rows;
  EXPECT_EQ(rows[0], version.layers[static_cast<std::size_t>(other)].rows[0]);
  EXPECT_EQ(rows[1].at(0), MapCell(kFull));
  EXPECT_EQ(next.layers[static_cast<std::size_t>(chosen)].rows,
            version.layers[static_cast<std::size_t>(chosen)].rows);
  EXPECT_EQ(level_of(next).layers, level.layers);
  EXPECT_EQ(level_of(next).map, level.map);
}

TEST(TileLayers, AreResizedAndMovedTogether) {
  Level level = layered();
  put(level, 0, {0, 0}, kDecor);
  put(level, 2, {3, 2}, kFull);
  Edit edit = resize_map(level, {.width = 6, .height = 4, .shift = {1, 1}}, {});
  rebase_edit(level, edit);
  Level resized = level;
  apply_edit(resized, edit);
  EXPECT_EQ(tile_in(resized, 0, {1, 1}), kDecor);
  EXPECT_EQ(tile_in(resized, 2, {4, 3}), kFull);
  const Level further = moved(level, 1, 1);
  EXPECT_EQ(tile_in(further, 2, {4, 3}), kFull);
  revert_edit(resized, edit);
  EXPECT_EQ(resized, level);
}

}  // namespace
}  // namespace talus
