// Edits that the open map of Tiled cannot hold are asked about when they are made.
#include <gmock/gmock.h>

#include "edit/layer_tools.h"
#include "edit/map_resize.h"
#include "folder_test.h"
#include "session/session.h"

namespace talus::beyond_file_test {

namespace act = action;
using testing::HasSubstr;

constexpr const char* kPlain = "<data encoding=\"csv\">1,2,3,4,5,6</data>";

std::string layer(const std::string& name, const std::string& size, const std::string& data) {
  return "<layer name=\"" + name + "\" " + size + ">" + data + "</layer>";
}
std::string map_of(const std::string& layers) {
  return R"(<map orientation="orthogonal" width="3" height="2" tilewidth="8" tileheight="8">)"
         R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="6" columns="3"/>)" +
         layers + "</map>";
}
const std::string kOne = map_of(layer("a", R"(width="3" height="2")", kPlain));
const std::string kTwo =
    map_of(layer("a", R"(width="3" height="2")", kPlain) + layer("b", R"(width="3" height="2")", kPlain));

class BeyondFile : public FolderTest {
 protected:
  // Opens a map as m.tmx. layer: its only layer to take, from 1; 0: all.
  void open(const std::string& text, int layer = 0) {
    put("m.tmx", text);
    auto loaded = load_level(path("m.tmx"), {.layer_number = layer});
    ASSERT_TRUE(loaded) << to_string(loaded.error(), "m.tmx");
    session_ = std::make_unique<Session>(std::move(loaded->level), path("m.tmx"));
  }
  void edit(const Edit& edit) { session_->apply(act::EditLevel{edit}); }
  void answer(act::Answer answer) { session_->apply(act::AnswerQuestion{answer}); }
  Edit widened() const { return resize_map(level(), {level().map.width() + 1, 2, {0, 0}}, {}); }
  // Expects that an edit is asked about, not made when that is cancelled, made when it is wanted, and undone.
  void expect_asked(const Edit& wanted, const std::string& why) {
    const Level before = level();
    edit(wanted);
    EXPECT_EQ(question(), wanted.label + ": the level then " + why +
                              ", and cannot be saved into m.tmx.\n"
                              "A level of Talus, .talus.json, holds it. Make the edit?");
    EXPECT_EQ(level(), before);
    answer(act::Answer::cancel);
    EXPECT_EQ(level(), before);
    EXPECT_FALSE(session_->modified());
    edit(wanted);
    answer(act::Answer::allow);
    EXPECT_EQ(question(), "");
    EXPECT_NE(level(), before);
    const Level after = level();
    session_->apply(act::Undo{});
    EXPECT_EQ(level(), before);
    session_->apply(act::SaveFile{});
    EXPECT_THAT(message(), HasSubstr("Saved"));
    session_->apply(act::Redo{});
    EXPECT_EQ(question(), "");
    EXPECT_EQ(level(), after);
    session_->apply(act::SaveFile{});
    EXPECT_THAT(message(), HasSubstr(why)) << "saving refuses the same";
  }
  // Expects that it is made without a question, and saved.
  void expect_saved(const Edit& wanted) {
    edit(wanted);
    EXPECT_EQ(question(), "");
    session_->apply(act::SaveFile{});
    EXPECT_THAT(message(), HasSubstr("Saved"));
    EXPECT_EQ(load_level(path("m.tmx"))->level, level());
  }
  // A tile of the level that no tileset has; 0: there is none.
  TileNumber tile_of_no_tileset() const {
    const std::vector<std::uint32_t>& tiles = level().tiled->frame.tiles;
    const auto found = std::find(tiles.begin() + 1, tiles.end(), 0U);
    return found == tiles.end() ? TileNumber{0} : static_cast<TileNumber>(found - tiles.begin());
  }
  const Level& level() const { return session_->level(); }
  std::string message() const { return session_->message() ? session_->message()->text : ""; }
  std::string question() const { return session_->question() ? session_->question()->text : ""; }

  std::unique_ptr<Session> session_;
};

TEST_F(BeyondFile, AnotherLayerBesideOneOfSeveralIsAsked) {
  open(kTwo, 2);
  expect_asked(add_layer(level()), "has other layers of tiles than the map");
  edit(add_layer(level()));
  EXPECT_EQ(question(), "") << "it is asked once";
}

TEST_F(BeyondFile, AnotherSizeOfOneOfSeveralLayersIsAsked) {
  open(kTwo, 1);
  expect_asked(widened(), "has another size than the map, whose other layers would have to be cut with it");
  edit(widened());
  EXPECT_EQ(question(), "");
  edit(add_layer(level()));
  EXPECT_THAT(question(), HasSubstr("has other layers of tiles")) << "each limit is asked about";
}

TEST_F(BeyondFile, AnotherSizeWithTilesOffTheMapIsAsked) {
  open(map_of(layer("a", R"(width="4" height="2")", R"(<data encoding="csv">1,2,3,4,5,6,1,2</data>)")));
  expect_asked(widened(), "has another size than the map, which has tiles off it that would be lost");
}

TEST_F(BeyondFile, TilesOfNoTilesetAreAsked) {
  open(kOne);
  const TileNumber tile = tile_of_no_tileset();
  ASSERT_NE(tile, 0);
  const std::string why = "shows tile " + std::to_string(tile) + ", which no tileset of the map has";
  expect_asked(Edit{"Paint", {CellChange{{1, 1}, level().map.at({1, 1}), tile}}}, why);
  open(kOne);
  TileMap filled = level().map;
  filled.set({0, 1}, tile);
  expect_asked(Edit{"Fill", {MapChange{level().map, filled}}}, why);
}

TEST_F(BeyondFile, MoreTilesAndOtherSizesAreAsked) {
  open(kOne);
  Level larger = level();
  larger.set_tile_layout({level().sheet(SheetId::tiles).columns, level().tile_count() + 8});
  expect_asked(replace_by(level(), std::make_shared<const Level>(larger), "Add tileset"),
               "has tiles that no tileset of the map has");
  open(kOne);
  Level other = level();
  other.map = TileMap(3, 2, {16, 16});
  expect_asked(replace_by(level(), std::make_shared<const Level>(other), "Other tiles"),
               "has tiles of another size than the map");
}

TEST_F(BeyondFile, SaveAsMakesTheEditAndAsksForAName) {
  open(kTwo, 1);
  edit(add_layer(level()));
  answer(act::Answer::save);
  EXPECT_EQ(level().layers.count(), 2);
  EXPECT_TRUE(session_->wants_save_as());
  session_->apply(act::SaveFileAs{path("m.talus.json")});
  EXPECT_FALSE(session_->wants_save_as());
  EXPECT_EQ(bytes_of("m.tmx"), kTwo);
  EXPECT_EQ(load_level(path("m.talus.json"))->level, level());
  edit(widened());
  EXPECT_EQ(question(), "") << "this file holds all";
}

TEST_F(BeyondFile, WhatTheMapHoldsIsNotAsked) {
  open(kOne);
  expect_saved(add_layer(level()));
  expect_saved(widened());
  open(kTwo, 2);
  edit(Edit{"Paint", {CellChange{{1, 1}, level().map.at({1, 1}), level().map.at({0, 0})}}});
  EXPECT_EQ(question(), "");
  session_->apply(act::SaveFile{});
  EXPECT_THAT(message(), HasSubstr("Saved"));
}

TEST_F(BeyondFile, ObjectsBesideOneOfSeveralLayersAreSaved) {
  open(kTwo, 2);
  ObjectLayer layer;
  layer.name = "signs";
  MapObject object;
  object.name = "exit";
  object.position = {4, 8};
  layer.objects = {object};
  Level changed = level();
  changed.objects.push_back(layer);
  edit(replace_by(level(), std::make_shared<const Level>(changed), "Add layer"));
  EXPECT_EQ(question(), "");
  session_->apply(act::SaveFile{});
  EXPECT_THAT(message(), HasSubstr("Saved"));
  const auto again = load_level(path("m.tmx"), {.layer_number = 2});
  ASSERT_TRUE(again);
  ASSERT_EQ(again->level.objects.size(), 1u);
  EXPECT_EQ(again->level.objects[0].objects.front().name, "exit");
}

// A tileset has a map of Talus, whose size its companion keeps.
TEST_F(BeyondFile, AnotherLayerOfATilesetIsAsked) {
  put("t.tsx", R"(<tileset name="t" tilewidth="8" tileheight="8" tilecount="6" columns="3"/>)");
  auto loaded = load_level(path("t.tsx"));
  ASSERT_TRUE(loaded);
  session_ = std::make_unique<Session>(std::move(loaded->level), path("t.tsx"));
  edit(widened());
  EXPECT_EQ(question(), "");
  edit(add_layer(level()));
  EXPECT_THAT(question(), HasSubstr("has other layers of tiles than the map"));
}

}  // namespace talus::beyond_file_test
