// Levels whose tiles do not have 8x8 px: what their map, their scene and their files make of the size.
#include <gmock/gmock.h>

#include <talus/level/ground.h>
#include <talus/level/tuning.h>
#include <talus/sim/scene.h>
#include <talus/sim/solver.h>
#include "export/lua_level.h"
#include "exported_level.h"
#include "formats/tic80/tic_cart.h"
#include "level/lint/lint.h"
#include "level/transform.h"
#include "tiled_files.h"

namespace talus::tile_size_test {

using testing::HasSubstr;

constexpr TileSize kWide{18, 12};

// Flagged tiles, shapes, a ball tile, a curve and a body.
Level plain_level() {
  Level level;
  level.map = TileMap(12, 6);
  level.map.cells().tiles() = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  //
                               0, 4, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0,  //
                               0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  //
                               0, 0, 2, 0, 0, 0, 0, 0, 6, 0, 0, 0,  //
                               1, 1, 1, 1, 0, 3, 0, 1, 1, 1, 0, 0,  //
                               1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  auto& flags = level.sheet(SheetId::tiles).flags;
  flags[1] = 1, flags[2] = 4, flags[3] = 8, flags[4] = 2;
  level.tile_shapes[5] = {.kind = TileShape::Kind::profile, .one_way = true, .heights = {2, 8, 3}};
  level.tile_shapes[6] = {
      .kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .heights = {8, 1}};
  level.curves.push_back({"", {Segment{{60, 40}, {90, 30}}, Curve::Faces::up}, ""});
  level.spawns.push_back({.name = "", .position = {70, 4}, .velocity = {1, 0.5}, .extra = ""});
  return level;
}

TEST(TileSizes, AMapKnowsThePxOfItsCells) {
  const TileMap map(3, 4, kWide);
  EXPECT_EQ(map.px_width(), 54);
  EXPECT_EQ(map.px_height(), 48);
  EXPECT_EQ(map.box_of({2, 1}), (Rect{36, 12, 18, 12}));
  EXPECT_EQ(map.cell_at({36, 11.5}), (Cell{2, 0}));
  EXPECT_EQ(map.cell_at({-0.5, -12.5}), (Cell{-1, -2}));
  EXPECT_NE(map, TileMap(3, 4));
}

// Powers of two scale every double of a run exactly, but for the few px that solvers look around themselves.
TEST(TileSizes, AScaledLevelRunsAsTheLevelItself) {
  for (const SolverKind solver : solver_kinds()) {
    Level level = plain_level();
    level.tuning.solver = solver;
    // Its boxes of one-way lines reach a px lower than the line, whatever the tiles.
    if (solver == SolverKind::bump) level.tile_shapes[5].one_way = false;
    const auto scene = std::make_shared<const Scene>(compile_scene(level));
    const auto larger = std::make_shared<const Scene>(compile_scene(scaled(level, 4)));
    EXPECT_EQ(larger->tile_size, (TileSize{32, 32}));
    ASSERT_EQ(scene->items.size(), larger->items.size());
    for (std::size_t i = 0; i < scene->items.size(); ++i) {
      const Rect& box = scene->items[i].box;
      EXPECT_EQ(larger->items[i].box, (Rect{4 * box.x, 4 * box.y, 4 * box.w, 4 * box.h}));
    }
    State a = initial_state(*scene), b = initial_state(*larger);
    const auto small_solver = make_solver(scene), large_solver = make_solver(larger);
    for (int frame = 0; frame < 120; ++frame) {
      small_solver->step(a, {});
      large_solver->step(b, {});
      for (std::size_t k = 0; k < a.bodies.size(); ++k) {
        const Rect &box = a.bodies[k].box, &other = b.bodies[k].box;
        ASSERT_NEAR(4 * box.x, other.x, 1e-4) << solver_name(solver) << " frame " << frame;
        ASSERT_NEAR(4 * box.y, other.y, 1e-4) << solver_name(solver) << " frame " << frame;
      }
    }
  }
}

TEST(TileSizes, TheLintFindsTheSameInAScaledLevel) {
  Level level = plain_level();
  level.tile_shapes[7] = {.kind = TileShape::Kind::slope, .heights = {3, 6}};
  level.map.set({8, 3}, 7);
  level.spawns.push_back({.name = "", .position = {-3, 44}, .velocity = {}, .extra = ""});
  const auto found = [](const Level& of) {
    std::vector<std::pair<std::string_view, std::optional<Cell>>> problems;
    for (const Problem& problem : lint(of)) problems.emplace_back(problem.rule->code, problem.cell);
    return problems;
  };
  EXPECT_GT(found(level).size(), 2U);
  EXPECT_EQ(found(scaled(level, 3)), found(level));
}

TEST(TileSizes, ANewLevelHasItsNumbersScaled) {
  EXPECT_EQ(new_tuning({}), Tuning());
  const Tuning tuning = new_tuning({16, 32});
  EXPECT_EQ(tuning.player.run_speed, 3);
  EXPECT_EQ(tuning.player.jump_speed, 14);
  EXPECT_EQ(tuning.shared.slope_width, 32);
  EXPECT_EQ(tuning.shared.slope_height, 32);
  EXPECT_EQ(tuning.shared.floor_bounce, Tuning().shared.floor_bounce) << "a share has no length";
  for (const TuningField& field : tuning_fields())
    EXPECT_TRUE(field.accepts(field.of(new_tuning({256, 256})))) << field.path();
  EXPECT_EQ(new_body_size(BodyKind::player, kWide), (Vec2{18, 12}));
}

TEST(TileSizes, ACartRefusesOtherTiles) {
  Level level;
  level.map = TileMap(20, 20, {16, 16});
  for (int tile = 1; tile <= 63; ++tile) level.map.set({tile % 20, tile / 20}, static_cast<TileNumber>(tile));
  level.map.set({19, 19}, 1);
  EXPECT_EQ(write_tic(level, {}).error().message,
            "the map shows 63 tiles of 16x16 px, but a cart has tiles of 8x8 px: drawn with those, the map "
            "takes 252 of its 256");
  level.set_tile_layout({16, 515});
  for (int tile = 1; tile <= 204; ++tile)
    level.map.set({tile % 20, tile / 20}, static_cast<TileNumber>(tile + 300));
  const auto written = write_tic(level, {});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message,
            "the map shows 205 tiles of 16x16 px, which take 820 tiles of 8x8 px, but a cart has only 256: "
            "room for 64 of 16x16 px");
  const auto playable = exported("tic-playable", level, "game.tic");
  ASSERT_FALSE(playable);
  EXPECT_EQ(playable.error().message, written.error().message);
}

TEST(TileSizes, TheLevelInLuaSaysThem) {
  Level level;
  level.map = TileMap(10, 10, kWide);
  const std::string text = lua_level(level, LuaForm::readable);
  EXPECT_THAT(text, HasSubstr("tile_width = 18"));
  EXPECT_THAT(text, HasSubstr("tile_height = 12"));
  EXPECT_THAT(text, HasSubstr("w = 18, h = 12")) << "of new bodies of a kind";
  EXPECT_THAT(lua_level(Level(), LuaForm::readable), testing::Not(HasSubstr("tile_width")));
}

TEST(TileSizes, LdtkRefusesTilesThatAreNotSquare) {
  Level level;
  level.map = TileMap(10, 10, kWide);
  EXPECT_EQ(exported_file("ldtk", level),
            "the level's tiles have 18x12 px, but those of LDtk must be square");
}

TEST(TileSizes, MapsOfTiledComeBack) {
  for (const char* form : {"tmx", "tmj"}) {
    const Level level = scaled(level_for_tiled(), 3);
    const Exported files = tiled_export_of(level, form, "map");
    EXPECT_THAT(files.files[0].bytes, HasSubstr("tilewidth")) << form;
    const auto back = read_level(files.files[0].bytes, {form});
    ASSERT_TRUE(back) << to_string(back.error(), form);
    EXPECT_EQ(back->level.map, level.map);
    EXPECT_EQ(back->level.tile_shapes, level.tile_shapes);
    EXPECT_EQ(back->level.spawns, level.spawns);
    EXPECT_EQ(back->level.curves, level.curves);
    EXPECT_EQ(back->level.tuning, level.tuning);
  }
}

TEST(TileSizes, AMapOf18x12PxIsReadWithItsShapes) {
  const std::string text =
      R"({"type":"map","orientation":"orthogonal","width":2,"height":2,"tilewidth":18,"tileheight":12,)"
      R"("infinite":false,"tilesets":[{"firstgid":1,"name":"t","tilewidth":18,"tileheight":12,"columns":4,)"
      R"("tilecount":16,"tiles":[{"id":1,"objectgroup":{"type":"objectgroup","objects":[)"
      R"({"x":0,"y":12,"polygon":[{"x":0,"y":0},{"x":36,"y":-24},{"x":36,"y":0}]}]}}]}],)"
      R"("layers":[{"type":"tilelayer","name":"a","width":2,"height":2,"data":[0,0,2,0]},)"
      R"({"type":"objectgroup","name":"o","objects":[{"type":"player","x":3,"y":4,"point":true}]}]})";
  const auto loaded = read_level(text, {"tmj"});
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "map");
  const Level& level = loaded->level;
  EXPECT_EQ(level.map.tile_size(), kWide);
  EXPECT_EQ(level.tile_shapes[1],
            (TileShape{.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 24}}));
  EXPECT_EQ(level.tuning, new_tuning(kWide));
  ASSERT_EQ(level.spawns.size(), 1U);
  EXPECT_EQ(level.spawns[0].size, (Vec2{18, 12}));
}

}  // namespace talus::tile_size_test
