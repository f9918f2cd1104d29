// What tiles say beside their pictures, flags and shapes: from Tiled, in levels, exports and random painting.
#include <gmock/gmock.h>

#include <cmath>

#include "edit/brush_tools.h"
#include "edit/tile_note_tools.h"
#include "export/lua_level.h"
#include "export/lua_text.h"
#include "folder_test.h"
#include "level/merge.h"
#include "panels/ui/property_text.h"
#include "tiled_files.h"

namespace talus::tile_notes_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;

const TileNote kLava{"lava", 0.25, R"({"cost":3,"end":1,"name":"a \"b\"","wet":false})"};

Level noted() {
  Level level = level_for_tiled();
  level.tile_notes = {{2, {"", 0, ""}}, {5, kLava}};
  return level;
}

std::string export_of(const Level& level, const std::string& id) {
  const ReadAsset no_asset;
  const auto made = find_exporter(id)->write({level, "a." + id, no_asset});
  if (!made) return to_string(made.error(), id);
  std::string all;
  for (const auto& file : made->files) all += file.bytes;
  return all;
}

TEST(TileNotes, AreKeptByLevelsOfVersion6) {
  const Level level = noted();
  const auto text = find_format("native")->write(level, {})->bytes;
  EXPECT_THAT(text, HasSubstr("\"talus\": 6"));
  EXPECT_TRUE(read_level(text, {"json"})->level == level);
  Level without = level;
  without.tile_notes.clear();
  EXPECT_THAT(find_format("native")->write(without, {})->bytes, Not(HasSubstr("tile_notes")));
  EXPECT_FALSE(without == level);
}

TEST(TileNotes, WrongOnesAreErrors) {
  for (const auto& [json, error] : std::vector<std::pair<const char*, const char*>>{
           {R"([])", "must be an object"},
           {R"({"x": {}})", "has the key \"x\", which is no number of a tile"},
           {R"({"256": {"class": "a"}})", "of tile 256 is none of the level's"},
           {R"({"1": {"probability": -1}})", "must be a number from 0 to 1000000"},
           {R"({"1": {"properties": 3}})", "must be an object"},
           {R"({"1": {"colour": 3}})", "has the key \"colour\""}}) {
    const auto read = read_level(R"({"talus": 6, "tile_notes": )" + std::string(json) + "}", {"json"});
    ASSERT_FALSE(read) << json;
    EXPECT_THAT(read.error().message, HasSubstr(error)) << json;
  }
  EXPECT_TRUE(problem_of(TileNotes{{1, {std::string(kMaxNoteBytes + 1, 'x'), 1, ""}}}, 2));
  EXPECT_TRUE(problem_of(TileNotes{{1, {"", std::nan(""), ""}}}, 2));
}

TEST(TileNotes, FollowTheirTiles) {
  Level level = noted();
  level.set_tile_layout({16, 4});
  EXPECT_THAT(level.tile_notes, ElementsAre(Pair(2, TileNote{"", 0, ""})));
  put_note(level.tile_notes, 2, {});
  EXPECT_THAT(level.tile_notes, IsEmpty());
  // Of two changes of different parts both stay.
  const Level base = noted();
  Level mine = base, theirs = base;
  mine.tile_notes[7].type = "door";
  theirs.flag_names[7] = "x";
  EXPECT_EQ(merge_levels(base, mine, theirs, MergeSide::mine).level.tile_notes, mine.tile_notes);
}

TEST(TileNotes, ComeBackFromMapsOfTiled) {
  const Level level = noted();
  for (const char* format : {"tmx", "tmj"}) {
    const auto loaded =
        read_level(tiled_export_of(level, format, std::string("a.") + format).files[0].bytes, {format});
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->level.tile_notes, level.tile_notes) << format;
    EXPECT_EQ(loaded->level.flag_names, level.flag_names) << format;
  }
  EXPECT_THAT(export_of(level, "tmx"), HasSubstr("<tile id=\"5\" type=\"lava\" probability=\"0.25\">"));
  EXPECT_THAT(export_of(level, "sti"), HasSubstr("probability = 0.25"));
}

TEST(TileNotes, AreInPlainData) {
  const Level level = noted();
  EXPECT_THAT(export_of(level, "json"),
              HasSubstr(R"("5":{"class":"lava","probability":0.25,"properties":{"cost":3,"end":1,)"));
  EXPECT_THAT(export_of(level, "lua"),
              HasSubstr(R"([5]={class="lava",probability=0.25,properties={cost=3,["end"]=1,)"));
  EXPECT_THAT(lua_level(level, LuaForm::readable),
              HasSubstr(R"([5] = {class = "lava", probability = 0.25, properties = {)"));
  EXPECT_THAT(export_of(level_for_tiled(), "json"), Not(HasSubstr("tile_notes")));
  EXPECT_TRUE(is_lua_name("cost_2"));
  for (const char* word : {"", "2x", "a b", "end", "goto"}) EXPECT_FALSE(is_lua_name(word)) << word;
}

TEST(TileNotes, WeighRandomPainting) {
  const Stamp stamp{2, 1, {3, 4}};
  const auto count = [&](const TileNotes& notes) {
    int of_4 = 0;
    for (int x = 0; x < 1000; ++x) of_4 += random_tile(stamp, {x, 7}, 1, notes) == 4 ? 1 : 0;
    return of_4;
  };
  EXPECT_EQ(count({{4, {"", 0, ""}}}), 0);
  EXPECT_NEAR(count({{4, {"", 3, ""}}}), 750, 50);
  EXPECT_NEAR(count({{3, {"", 1.5, ""}}, {4, {"", 0.5, ""}}}), 250, 50);
  EXPECT_NEAR(count({{3, {"", 0, ""}}, {4, {"", 0, ""}}}), 500, 50);
  for (int x = 0; x < 50; ++x)
    EXPECT_EQ(random_tile(stamp, {x, 0}, 1, {{4, kLava}, {9, kLava}}) == 3 ||
                  random_tile(stamp, {x, 0}, 1, {{9, kLava}}) == random_tile(stamp, {x, 0}, 1),
              true);
}

TEST(TileNotes, ProbabilityIsAnEdit) {
  Level level = noted();
  const SpriteArea area{SheetId::tiles, {4, 0, 2, 1}};
  EXPECT_FALSE(common_probability(level, area));
  const Edit edit = set_probability(level, area, 2);
  apply_edit(level, edit);
  EXPECT_EQ(common_probability(level, area), 2);
  EXPECT_EQ(level.tile_notes[5].type, "lava");
  revert_edit(level, edit);
  EXPECT_EQ(level.tile_notes, noted().tile_notes);
}

class TileNotesFiles : public FolderTest {
 protected:
  const std::string kMap =
      R"(<map version="1.10" orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">
 <tileset firstgid="1" source="t.tsx"/>
 <layer id="1" name="l" width="1" height="1"><data encoding="csv">2</data></layer>
</map>
)";
  const std::string kTileset = R"(<tileset name="t" tilewidth="8" tileheight="8" tilecount="4" columns="4">
 <tile id="1" type="lava" probability="0.25">
  <properties>
   <property name="cost" type="int" value="3"/>
  </properties>
 </tile>
 <tile id="2" probability="0.5"/>
</tileset>
)";
};

TEST_F(TileNotesFiles, OnlyAChangedProbabilityIsWritten) {
  put("a.tmx", kMap);
  put("t.tsx", kTileset);
  auto loaded = load_level(path("a.tmx"));
  ASSERT_TRUE(loaded);
  EXPECT_THAT(loaded->level.tile_notes,
              ElementsAre(Pair(1, TileNote{"lava", 0.25, R"({"cost":3})"}), Pair(2, TileNote{"", 0.5, ""})));
  loaded->level.tile_notes[1].probability = 0.75;
  put_note(loaded->level.tile_notes, 2, {});
  loaded->level.tile_notes[3].probability = 4;
  ASSERT_TRUE(save_level(loaded->level, *loaded->format, loaded->path, loaded->companion));
  std::string wanted = kTileset;
  wanted.replace(wanted.find("0.25"), 4, "0.75");
  wanted.replace(wanted.find(" probability=\"0.5\""), 18, "");
  wanted.insert(wanted.find("</tileset>"), " <tile id=\"3\" probability=\"4\"/>\n");
  EXPECT_EQ(bytes_of("t.tsx"), wanted);
  EXPECT_EQ(bytes_of("a.tmx"), kMap);
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(TileNotesFiles, AChangedProbabilityIsWrittenIntoJson) {
  put("t.tsj", R"({"type":"tileset","name":"t","tilewidth":8,"tileheight":8,"tilecount":4,"columns":4,
"tiles":[{"id":1,"probability":0.25,"type":"lava"}]})");
  auto loaded = load_level(path("t.tsj"));
  ASSERT_TRUE(loaded);
  const auto lava = std::find_if(loaded->level.tile_notes.begin(), loaded->level.tile_notes.end(),
                                 [](const auto& note) { return note.second.type == "lava"; });
  ASSERT_NE(lava, loaded->level.tile_notes.end());
  lava->second.probability = 0.5;
  ASSERT_TRUE(save_level(loaded->level, *loaded->format, loaded->path, loaded->companion));
  EXPECT_THAT(bytes_of("t.tsj"), HasSubstr(R"({"id":1,"probability":0.5,"type":"lava"})"));
}

TEST_F(TileNotesFiles, ClassesAndPropertiesAreWritten) {
  put("a.tmx", kMap);
  put("t.tsx", kTileset);
  auto loaded = load_level(path("a.tmx"));
  ASSERT_TRUE(loaded);
  Level& level = loaded->level;
  level.tile_notes[1] = {"water", 0.25, R"({"cost":4})"};
  level.tile_notes[3] = {"door", 1, R"({"key":"red"})"};
  ASSERT_TRUE(save_level(level, *loaded->format, loaded->path, loaded->companion));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  const std::string tileset = bytes_of("t.tsx");
  EXPECT_THAT(tileset, HasSubstr(R"(<tile id="1" type="water" probability="0.25">)"));
  EXPECT_THAT(tileset, HasSubstr(R"(<property name="cost" type="int" value="4"/>)"));
  EXPECT_THAT(tileset, HasSubstr(R"(<tile id="3" type="door">)"));
  EXPECT_THAT(tileset, HasSubstr(R"(<tile id="2" probability="0.5"/>)")) << "what was not edited stays";
  EXPECT_EQ(load_level(path("a.tmx"))->level.tile_notes, level.tile_notes);
  // All of it goes again.
  auto again = load_level(path("a.tmx"));
  put_note(again->level.tile_notes, 1, {"", 0.25, ""});
  put_note(again->level.tile_notes, 3, {});
  ASSERT_TRUE(save_level(again->level, *again->format, again->path, again->companion));
  EXPECT_THAT(bytes_of("t.tsx"), Not(HasSubstr("propert")));
  EXPECT_THAT(bytes_of("t.tsx"), Not(HasSubstr("type=")));
  EXPECT_EQ(load_level(path("a.tmx"))->level.tile_notes, again->level.tile_notes);
}

TEST_F(TileNotesFiles, ClassesPropertiesAndAnimationsAreWrittenIntoJson) {
  put("t.tsj", R"({"type":"tileset","name":"t","tilewidth":8,"tileheight":8,"tilecount":4,"columns":4,
"tiles":[{"id":1,"probability":0.25,"type":"lava"}]})");
  auto loaded = load_level(path("t.tsj"));
  ASSERT_TRUE(loaded);
  Level& level = loaded->level;
  const TileNumber lava = level.tile_notes.begin()->first, other = static_cast<TileNumber>(lava + 1);
  level.tile_notes[lava] = {"", 0.25, R"({"cost":2.5})"};
  level.tile_notes[other] = {"door", 1, ""};
  level.animations[lava] = {{lava, 100}, {other, 250}};
  ASSERT_TRUE(save_level(level, *loaded->format, loaded->path, loaded->companion));
  const std::string text = bytes_of("t.tsj");
  EXPECT_THAT(text, HasSubstr(R"("animation":[{"duration":100, "tileid":1}, {"duration":250, "tileid":2}])"));
  EXPECT_THAT(text, HasSubstr(R"({"id":2, "type":"door"})"));
  EXPECT_THAT(text, Not(HasSubstr("lava")));
  const auto again = load_level(path("t.tsj"));
  EXPECT_EQ(again->level.tile_notes, level.tile_notes);
  EXPECT_EQ(again->level.animations, level.animations);
  EXPECT_FALSE(exists("t.tsj.talus.json"));
}

// In tilesets they would be flags.
TEST_F(TileNotesFiles, PropertiesThatAreTrueOrFalseAreInTheCompanion) {
  put("a.tmx", kMap);
  put("t.tsx", kTileset);
  auto loaded = load_level(path("a.tmx"));
  ASSERT_TRUE(loaded);
  loaded->level.tile_notes[1] = {"water", 0.25, R"({"cost":4,"deep":true})"};
  ASSERT_TRUE(save_level(loaded->level, *loaded->format, loaded->path, loaded->companion));
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr(R"(<property name="cost" type="int" value="4"/>)"));
  EXPECT_THAT(bytes_of("t.tsx"), Not(HasSubstr("deep")));
  EXPECT_EQ(load_level(path("a.tmx"))->level.tile_notes, loaded->level.tile_notes);
}

// The tile of another tileset is none that an animation of this one may show.
TEST_F(TileNotesFiles, AnimationsAreWrittenAndOthersAreInTheCompanion) {
  put("a.tmx", kMap);
  put("t.tsx", kTileset);
  auto loaded = load_level(path("a.tmx"));
  ASSERT_TRUE(loaded);
  Level& level = loaded->level;
  level.animations[1] = {{1, 120}, {2, 80}};
  level.animations[3] = {{0, 50}};
  ASSERT_TRUE(save_level(level, *loaded->format, loaded->path, loaded->companion));
  EXPECT_EQ(load_level(path("a.tmx"))->level.animations, level.animations);
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("   <frame tileid=\"1\" duration=\"120\"/>\n"
                                           "   <frame tileid=\"2\" duration=\"80\"/>\n  </animation>"));
  auto again = load_level(path("a.tmx"));
  again->level.animations.erase(1);
  again->level.animations.erase(3);
  ASSERT_TRUE(save_level(again->level, *again->format, again->path, again->companion));
  EXPECT_EQ(bytes_of("t.tsx"), kTileset) << "as before";
  EXPECT_TRUE(load_level(path("a.tmx"))->level.animations.empty());
}

TEST(TileNotes, ClassAndPropertiesAreEdits) {
  Level level = noted();
  const SpriteArea area{SheetId::tiles, {4, 0, 2, 1}};
  const Edit edit = set_tile_class(level, area, "door");
  apply_edit(level, edit);
  EXPECT_EQ(level.tile_notes[4].type, "door");
  EXPECT_EQ(level.tile_notes[5].probability, kLava.probability);
  const auto change = [&](const PropertyChange& property) {
    apply_edit(level, change_tile_properties(level, area, [&](const std::string& text) {
                 return with_property(text, property);
               }));
  };
  change({"cost", Json(7)});
  EXPECT_EQ(level.tile_notes[4].properties, R"({"cost":7})");
  EXPECT_THAT(level.tile_notes[5].properties, HasSubstr(R"("cost":7,"end":1)"));
  change({"cost", std::nullopt});
  EXPECT_EQ(level.tile_notes[4].properties, "");
  apply_edit(level, set_tile_class(level, {SheetId::tiles, {4, 0, 1, 1}}, ""));
  EXPECT_FALSE(level.tile_notes.contains(4));
  EXPECT_TRUE(set_tile_class(level, {SheetId::sprites, {0, 0, 1, 1}}, "x").empty());
}

TEST(PropertyText, ValuesKeepTheirKinds) {
  EXPECT_EQ(value_of_text("3", PropertyKind::whole_number), Json(3));
  EXPECT_EQ(value_of_text("3", PropertyKind::number), Json(3.0));
  EXPECT_FALSE(value_of_text("3.5", PropertyKind::whole_number));
  EXPECT_FALSE(value_of_text("inf", PropertyKind::number));
  EXPECT_FALSE(value_of_text("yes", PropertyKind::yes_or_no));
  EXPECT_EQ(in_kind(Json("12"), PropertyKind::whole_number), Json(12));
  EXPECT_EQ(in_kind(Json(2.75), PropertyKind::whole_number), Json(2));
  EXPECT_EQ(in_kind(Json(true), PropertyKind::text), Json("true"));
  EXPECT_EQ(in_kind(Json("x"), PropertyKind::number), Json(0.0));
  EXPECT_EQ(kind_of(Json(3.0)), PropertyKind::number);
  EXPECT_EQ(with_property("", {"a", Json(3.0)}), R"({"a":3.0})");
  EXPECT_EQ(with_property(R"({"a":1})", {"a", std::nullopt}), "");
  EXPECT_EQ(with_property("not json", {"a", Json(1)}), R"({"a":1})");
}

}  // namespace talus::tile_notes_test
