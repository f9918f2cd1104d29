// Edits of the layers of a map.
#include "edit/layer_tools.h"

#include <gtest/gtest.h>

#include <limits>

#include <talus/level/placed_picture.h>
#include "edit/layer_looks.h"
#include "edit/map_stroke.h"
#include "edit/undo_stack.h"
#include "session/session.h"

namespace talus::layer_tools_test {

std::shared_ptr<const MapCells> cells_of(std::vector<TileNumber> tiles) {
  return std::make_shared<const MapCells>(std::move(tiles));
}

// A map of 3x1 cells with the layers "back" (tiles 1 1 1), "middle" (0 2 0), which is chosen, and "front" (3
// 0 0).
Level three_layers() {
  Level level;
  level.map = TileMap(3, 1);
  level.map.cells().tiles() = {0, 2, 0};
  level.layers.list = {{.name = "back", .cells = cells_of({1, 1, 1})},
                       {.name = "middle"},
                       {.name = "front", .cells = cells_of({3, 0, 0})}};
  level.layers.chosen = 1;
  return level;
}

// "back 111, [middle 020], front 300": from the back, the chosen one in brackets.
std::string text_of(const Level& level) {
  std::string text;
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    std::string row = level.layers.list[static_cast<std::size_t>(layer)].name + " ";
    for (const TileNumber tile : level.cells_of(layer).tiles()) row += std::to_string(tile);
    if (layer == level.layers.chosen) row = "[" + row + "]";
    text += (text.empty() ? "" : ", ") + row;
  }
  return text;
}

// The layers after an edit. Expects that undo and redo go back and forth.
std::string after(Level level, Edit edit) {
  const std::string before = text_of(level);
  UndoStack history;
  rebase_edit(level, edit);
  history.push(level, std::move(edit));
  const std::string now = text_of(level);
  if (history.can_undo()) {
    history.undo(level);
    EXPECT_EQ(text_of(level), before);
    history.redo(level);
    EXPECT_EQ(text_of(level), now);
  }
  return now;
}

TEST(LayerTools, ANewLayerIsEmptyAndChosen) {
  EXPECT_EQ(after(three_layers(), add_layer(three_layers())),
            "back 111, middle 020, [Layer 4 000], front 300");
  const Level plain;
  const Edit edit = add_layer(plain);
  EXPECT_EQ(edit.label, "Add layer");
  Level two = plain;
  apply_edit(two, edit);
  EXPECT_EQ(two.layers.count(), 2);
  EXPECT_EQ(two.layers.chosen, 1);
  EXPECT_FALSE(problem_after(plain, edit));
}

TEST(LayerTools, ACopyIsInFrontOfTheLayer) {
  const Level level = three_layers();
  EXPECT_EQ(after(level, duplicate_layer(level, 1)), "back 111, middle 020, [middle copy 020], front 300");
  EXPECT_EQ(after(level, duplicate_layer(level, 0)), "back 111, [back copy 111], middle 020, front 300");
  EXPECT_EQ(after(level, duplicate_layer(level, 2)), "back 111, middle 020, front 300, [front copy 300]");
  EXPECT_TRUE(duplicate_layer(level, 3).empty());
}

TEST(LayerTools, ADeletedLayerLeavesAnotherChosen) {
  const Level level = three_layers();
  EXPECT_EQ(after(level, remove_layer(level, 1)), "[back 111], front 300");
  EXPECT_EQ(after(level, remove_layer(level, 0)), "[middle 020], front 300");
  EXPECT_EQ(after(level, remove_layer(level, 2)), "back 111, [middle 020]");
  Level back = level;
  back.choose_layer(0);
  EXPECT_EQ(after(back, remove_layer(back, 0)), "[middle 020], front 300");
  EXPECT_TRUE(remove_layer(Level(), 0).empty()) << "the only one stays";
  EXPECT_TRUE(remove_layer(level, -1).empty());
}

TEST(LayerTools, MergingPutsTilesOverThoseBehind) {
  const Level level = three_layers();
  EXPECT_EQ(after(level, merge_layer_down(level, 1)), "[back 121], front 300");
  EXPECT_EQ(after(level, merge_layer_down(level, 2)), "back 111, [middle 320]");
  Level front = level;
  front.choose_layer(2);
  EXPECT_EQ(after(front, merge_layer_down(front, 1)), "[back 121], front 300");
  EXPECT_TRUE(merge_layer_down(level, 0).empty());
}

TEST(LayerTools, AMovedLayerLeavesTheSameOneChosen) {
  const Level level = three_layers();
  EXPECT_EQ(after(level, move_layer(level, 1, 2)), "back 111, front 300, [middle 020]");
  EXPECT_EQ(after(level, move_layer(level, 0, 2)), "[middle 020], front 300, back 111");
  EXPECT_EQ(after(level, move_layer(level, 2, 0)), "front 300, back 111, [middle 020]");
  EXPECT_EQ(after(level, move_layer(level, 2, 1)), "back 111, front 300, [middle 020]");
  EXPECT_EQ(after(level, move_layer(level, 0, 1)), "[middle 020], back 111, front 300");
  EXPECT_TRUE(move_layer(level, 1, 1).empty());
  EXPECT_TRUE(move_layer(level, 1, 3).empty());
}

TEST(LayerTools, LooksChangeUnderAPlainLabel) {
  const Level level = three_layers();
  const auto label = [&](const auto& change) {
    TileLayer looks = level.layers.list[2];
    change(looks);
    return set_layer_looks(level, 2, looks).label;
  };
  EXPECT_EQ(label([](TileLayer& l) { l.name = "top"; }), "Rename layer");
  EXPECT_EQ(label([](TileLayer& l) { l.visible = false; }), "Hide layer");
  EXPECT_EQ(label([](TileLayer& l) { l.locked = true; }), "Lock layer");
  EXPECT_EQ(label([](TileLayer& l) { l.is_ground = false; }), "Make layer scenery");
  EXPECT_EQ(label([](TileLayer& l) { l.opacity = 0.5; }), "Change a layer's opacity");
  EXPECT_EQ(label([](TileLayer& l) { l.offset.x = 4; }), "Change a layer's offset");
  EXPECT_EQ(label([](TileLayer& l) { l.parallax.y = 0; }), "Change a layer's parallax");
  EXPECT_EQ(label([](TileLayer& l) { l.tint.r = 0; }), "Change a layer's tint");
  EXPECT_TRUE(set_layer_looks(level, 2, level.layers.list[2]).empty());
  TileLayer renamed = level.layers.list[1];
  renamed.name = "ground";
  EXPECT_EQ(after(level, set_layer_looks(level, 1, renamed)), "back 111, [ground 020], front 300");
}

TEST(LayerTools, LooksStayWithinTheirRanges) {
  Level level = three_layers();
  TileLayer looks = level.layers.list[2];
  looks.opacity = 3;
  looks.offset = {1e9, std::numeric_limits<double>::quiet_NaN()};
  looks.parallax = {-1e9, 1e9};
  apply_edit(level, set_layer_looks(level, 2, looks));
  const TileLayer& front = level.layers.list[2];
  EXPECT_EQ(front.opacity, 1);
  EXPECT_EQ(front.offset, (Vec2{kMaxLayerOffset, 0}));
  EXPECT_EQ(front.parallax, (Vec2{-kMaxParallax, kMaxParallax}));
}

TEST(LayerTools, ALayerWithoutANameHasItsPlace) {
  Level level = three_layers();
  EXPECT_EQ(layer_name(level, 2), "front");
  level.layers.list[2].name = "";
  EXPECT_EQ(layer_name(level, 2), "Layer 3");
}

TEST(LayerTools, ALockedOrHiddenLayerIsNotPainted) {
  Session session(three_layers());
  const auto paint = [&] {
    session.apply(action::DismissMessage{});
    session.apply(action::EditLevel{paint_stamp(session.level(), {0, 0}, {1, 1, {5}})});
    return session.message() ? session.message()->text : "";
  };
  const auto look = [&](bool visible, bool locked) {
    TileLayer looks = session.level().layers.list[1];
    looks.visible = visible;
    looks.locked = locked;
    session.apply(action::EditLevel{set_layer_looks(session.level(), 1, looks)});
  };
  look(true, true);
  EXPECT_EQ(paint(), "The layer \"middle\" is locked: unlock it under Layers to paint on it.");
  EXPECT_EQ(session.level().map.at({0, 0}), 0);
  look(false, false);
  EXPECT_EQ(paint(), "The layer \"middle\" is hidden: show it under Layers to paint on it.");
  EXPECT_EQ(session.level().map.at({0, 0}), 0);
  look(true, false);
  EXPECT_EQ(paint(), "");
  EXPECT_EQ(session.level().map.at({0, 0}), 5);
}

TEST(LayerTools, LooksCostNoOtherScene) {
  Session session(three_layers());
  const Scene* scene = &session.scene();
  TileLayer looks = session.level().layers.list[2];
  looks.opacity = 0.5;
  session.apply(action::EditLevel{set_layer_looks(session.level(), 2, looks)});
  session.advance(0);
  EXPECT_EQ(&session.scene(), scene);
}

// The names of all layers from the back.
std::string names_in_order(const Level& level) {
  std::string names;
  for (const auto& [has_tiles, index] : layers_in_order(level)) {
    const auto at = static_cast<std::size_t>(index);
    names += (names.empty() ? "" : " ") + (has_tiles ? level.layers.list[at].name : level.objects[at].name);
  }
  return names;
}

TEST(LayerTools, LayersOfObjectsKeepTheirPlaces) {
  Level level = three_layers();
  level.objects = {{.name = "sky", .place = 0}, {.name = "things", .place = 2}, {.name = "top"}};
  EXPECT_EQ(names_in_order(level), "sky back middle things front top");
  const auto after = [&](const Edit& edit) {
    Level changed = level;
    apply_edit(changed, edit);
    Level back = changed;
    revert_edit(back, edit);
    EXPECT_EQ(back, level);
    return names_in_order(changed);
  };
  EXPECT_EQ(after(add_layer(level)), "sky back middle Layer 4 things front top");
  EXPECT_EQ(after(remove_layer(level, 0)), "sky middle things front top");
  EXPECT_EQ(after(merge_layer_down(level, 1)), "sky back things front top");
  EXPECT_EQ(after(move_layer(level, 1, 2)), "sky back things front middle top");
  EXPECT_EQ(after(move_in_order(level, 0, 3)), "back middle things sky front top");
  EXPECT_EQ(after(move_in_order(level, 5, 0)), "top sky back middle things front");
}

TEST(LayerLooks, OfEveryKindAreSetWithinTheirRanges) {
  Level level = three_layers();
  level.objects = {{.name = "walls"}};
  const LayerInOrder walls{false, 0}, front{true, 2};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const LayerInOrder& layer : {walls, front}) {
    const Edit edit =
        set_looks(level, layer, {.opacity = 2, .offset = {nan, 4}, .parallax = {1000, 0}, .tint = {1, 2, 3}});
    apply_edit(level, edit);
    EXPECT_EQ(looks_of(level, layer),
              (LayerLooks{.offset = {0, 4}, .parallax = {kMaxParallax, 0}, .tint = {1, 2, 3}}));
    EXPECT_TRUE(set_looks(level, layer, looks_of(level, layer)).empty());
    revert_edit(level, edit);
    EXPECT_EQ(looks_of(level, layer), LayerLooks());
  }
  EXPECT_TRUE(set_looks(level, {false, 1}, {.opacity = 0.5}).empty()) << "there is no such layer";
  EXPECT_TRUE(set_looks(level, {true, 3}, {.opacity = 0.5}).empty());
}

TEST(LayerLooks, OfGroupsAreSetWithinTheirRanges) {
  Level level = three_layers();
  level.layers.groups = {{.name = "far", .locked = true}};
  level.layers.list[2].group = 0;
  const Edit edit = set_looks_of_group(level, 0, {.opacity = 2, .offset = {3, 4}, .tint = {1, 2, 3}});
  apply_edit(level, edit);
  EXPECT_EQ(looks_of_group(level, 0), (LayerLooks{.locked = true, .offset = {3, 4}, .tint = {1, 2, 3}}));
  EXPECT_EQ(looks_of(level, {true, 2}), LayerLooks()) << "its own";
  EXPECT_TRUE(set_looks_of_group(level, 1, {.opacity = 0.5}).empty()) << "there is no such group";
  EXPECT_EQ(looks_of_group(level, 1), LayerLooks());
}

}  // namespace talus::layer_tools_test
