// The limits of a level: refused in reading, editing and saving. Everything that can be saved can be read.
#include <talus/level/limits.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "edit/undo_stack.h"
#include "folder_test.h"
#include "formats/native/recording_file.h"
#include "formats/tic80/tic_cart.h"
#include "formats/tic80/tic_text.h"
#include "formats/tiled/tiled_map.h"
#include "native_text.h"
#include "png_bytes.h"
#include "session/session.h"
#include "tiled_files.h"

namespace talus::limits_test {

using nlohmann::json;
using testing::HasSubstr;

Level with_spawns(std::size_t count) {
  Level level;
  level.spawns.assign(count, Spawn{});
  return level;
}

class SavedLimits : public FolderTest {};

TEST_F(SavedLimits, ATooLargeLevelIsRefusedAndTheOldFileStays) {
  const std::string file = path("cave.talus.json");
  ASSERT_TRUE(save_level(with_spawns(1), *find_format("native"), file));
  const std::string before = bytes_of("cave.talus.json");
  const auto saved = save_level(with_spawns(kMaxSpawns + 1), *find_format("native"), file);
  ASSERT_FALSE(saved);
  EXPECT_EQ(to_string(saved.error(), "cave"),
            "cave: error: has 65537 bodies, but a level holds at most 65536");
  EXPECT_EQ(bytes_of("cave.talus.json"), before);
}

TEST(LevelLimits, TheLargestNumberOfBodiesIsReadAgain) {
  Level level = with_spawns(kMaxSpawns);
  for (std::size_t i = 0; i < level.spawns.size(); ++i) level.spawns[i].position.x = static_cast<double>(i);
  const auto again = read_native(native_of_level(level), {});
  ASSERT_TRUE(again) << to_string(again.error(), "level");
  EXPECT_TRUE(*again == level);
}

TEST(LevelLimits, LongListsAreRefusedBeforeTheyAreRead) {
  const auto entries = [](std::size_t count) {
    std::string list = "{}";
    for (std::size_t i = 1; i < count; ++i) list += ",{}";
    return "[" + list + "]";
  };
  expect_native_error(native_with("\"spawns\":" + entries(kMaxSpawns + 1)), "key spawns",
                      "must be a list of up to 65536 bodies");
  expect_native_error(native_with("\"curves\":" + entries(kMaxCurves + 1)), "key curves",
                      "must be a list of up to 16384 curves");
}

// A level with amounts close to the limits, some of them above.
Level level_with(const std::vector<std::size_t>& amounts) {
  Level level = with_spawns(amounts[0] % 50);
  level.curves.resize(amounts[1] % 50, {"ramp", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""});
  if (!level.spawns.empty()) level.spawns[0].name.assign(kMaxNameBytes - 300 + amounts[2] % 250, 'x');
  level.extra = json{{"unknown", std::string(kMaxUnknownBytes - 100 + amounts[3] % 100, 'x')}}.dump();
  level.brushes.resize(15 + amounts[4] % 2, {"b", 256, 256, std::vector<MapCell>(256 * 256, 3), false, ""});
  if (amounts[4] % 5 == 0) level.brushes.push_back({"one", 1, 1, {7}, false, ""});
  Polyline line{0, 1900, std::vector<double>(kMaxPolylineHeights, 4)};
  level.curves.resize(level.curves.size() + 3 + amounts[5] % 3, {"", {line, Curve::Faces::up}, ""});
  return level;
}

TEST(LargeLevels, SavedLevelsCanBeRead) {
  std::size_t saved = 0, refused = 0, number = 1;
  const auto next = [&number] { return (number = number * 48271 % 2147483647) >> 3; };
  for (int i = 0; i < 4; ++i) {
    const Level level = level_with({next(), next(), next(), next(), next(), next()});
    const auto written = write_native(level, {});
    EXPECT_EQ(written.has_value(), !problem_of_amounts(level));
    ++(written ? saved : refused);
    if (!written) continue;
    const auto again = read_native(written->bytes, {});
    ASSERT_TRUE(again) << to_string(again.error(), "level");
    EXPECT_TRUE(*again == level);
    if (saved > 1) continue;  // one map is enough, as maps of Tiled take seconds
    for (const std::string to : {"tmx", "tmj"}) {
      const std::string text = tiled_export_of(level, to, "cave." + to).files[0].bytes;
      const auto map = read_level(text, {to});
      ASSERT_TRUE(map) << to_string(map.error(), to);
      EXPECT_EQ(map->level.spawns, level.spawns);
    }
  }
  EXPECT_GT(saved, 0u);
  EXPECT_GT(refused, 0u);
}

// Returns why the level is not exported, or nothing if it is.
std::string refusal(const Level& level, const std::string& to) {
  const ReadAsset no_asset;
  const auto exported = find_exporter(to)->write({level, "cave." + to, no_asset});
  return exported ? "" : exported.error().message;
}

// 20 bodies whose names take so many bytes together.
Level with_names(std::size_t bytes, char character) {
  Level level = with_spawns(20);
  for (Spawn& spawn : level.spawns) spawn.name.assign(bytes / level.spawns.size(), character);
  return level;
}

// A map has each name twice.
TEST(LevelLimits, MapsThatCannotBeReadAreNotExported) {
  EXPECT_EQ(refusal(with_names(1'300'000, '='), "tmx"), "has too many elements")
      << "the writer counts as the reader does";
}

// Each character of such a name takes 6 or 7 bytes in the map.
TEST(LargeLevels, MapsOfTheLongestNamesAreReadAgain) {
  EXPECT_EQ(refusal(with_names(kMaxNameBytes, '='), "tmx"), "has too many elements");
  EXPECT_EQ(refusal(with_names(kMaxNameBytes, '='), "tmj"), "");
  const Level level = with_names(kMaxNameBytes, '\\');
  for (const std::string to : {"tmx", "tmj"}) {
    ASSERT_EQ(refusal(level, to), "");
    EXPECT_TRUE(read_level(tiled_export_of(level, to, "cave." + to).files[0].bytes, {to}));
  }
}

// Each of twenty such sine curves took 700 MB of ground.
TEST(LevelLimits, CurvesAreLimitedByTheCellsThatTheyCross) {
  Level level;
  level.curves = {{"", {Sine{0, 1900, 500, 400, 2, 0}, Curve::Faces::up}, ""}};
  EXPECT_FALSE(problem_of_amounts(level));
  level.curves.resize(20, level.curves.front());
  EXPECT_EQ(problem_of_amounts(level),
            "has 3881760 cells that curves pass, but a level holds at most 2097152");
  EXPECT_FALSE(write_native(level, {}));

  std::vector<double> heights;
  for (int i = 0; i < 1000; ++i) heights.push_back(i % 2 * 1000);
  level.curves = {{"", {Polyline{0, 1900, heights}, Curve::Faces::both}, ""}};
  level.curves.resize(9, level.curves.front());
  EXPECT_TRUE(problem_of_amounts(level));
  level.curves.resize(8);
  EXPECT_FALSE(problem_of_amounts(level));
}

TEST(LevelLimits, UnknownMembersAreKeptUpToAMegabyte) {
  std::string keys;
  for (int i = 0; i < 50'000; ++i) keys += ",\"key of a later version " + std::to_string(i) + "\":0";
  const auto read = read_native(R"({"talus":1)" + keys + "}", {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("bytes of unknown members, but a level holds"));
}

TEST(LevelLimits, NamesAndUnknownMembersOfAllListsAreCounted) {
  const auto expect_counted = [](auto list) {
    Level level;
    (level.*list).resize(1);
    EXPECT_EQ(problem_of_amounts(level), std::nullopt);
    (level.*list)[0].name.assign(kMaxNameBytes + 1, 'x');
    EXPECT_THAT(problem_of_amounts(level).value_or(""), HasSubstr(" bytes of names"));
    (level.*list)[0].name.clear();
    (level.*list)[0].extra.assign(kMaxUnknownBytes + 1, 'x');
    EXPECT_THAT(problem_of_amounts(level).value_or(""), HasSubstr(" bytes of unknown"));
  };
  expect_counted(&Level::flag_fields);
  expect_counted(&Level::spawns);
  expect_counted(&Level::curves);
  expect_counted(&Level::brushes);
  expect_counted(&Level::exports);
}

TEST(LevelLimits, AnObjectOfManyKeysIsRefusedWhileItIsRead) {
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += ",\"k" + std::to_string(i) + "\":0";
  expect_native_error(R"({"talus":1)" + keys + "}", "line 1",
                      "the JSON has an object with more than 66048 keys");
}

// Written with one value on each line, behind a hundred blanks, it would take fifty times as much.
TEST(LevelLimits, DeepUnknownMembersStaySmall) {
  std::string deep = "{\"a\":{}";
  for (int i = 1; i < 1000; ++i) deep += ",\"a" + std::to_string(i) + "\":{}";
  deep += "}";
  for (int i = 0; i < 50; ++i) deep = "{\"a\":" + deep + "}";
  Level level;
  level.extra = deep;
  const std::string text = native_of_level(level);
  EXPECT_LT(text.size(), 2 * deep.size() + 10'000);
  EXPECT_TRUE(level_of_native(text).extra == json::parse(deep).dump());
}

TEST(LevelLimits, RepeatedSectionLinesDoNotMakeACartGrow) {
  Level level;
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{17});
  json document = json::parse(native_of_level(level));
  document["cart"] = {{"kind", "text"}, {"comment", "--"}, {"lines", json::array()}};
  for (int i = 0; i < 200; ++i) document["cart"]["lines"].push_back({{"level", "MAP"}});
  expect_native_error(document.dump(), "key cart.lines",
                      "make the cart larger than 4 MiB, the limit for carts");
}

TEST(LevelLimits, CodeOfOnlyLineBreaksIsKeptAsData) {
  const Level level = read_text(std::string(1'000'000, '\n'), {"lua"}).value();
  const json document = json::parse(native_of_level(level));
  EXPECT_FALSE(document["cart"].contains("lines"));
  EXPECT_EQ(level_of_native(document.dump()).cart->bytes, level.cart->bytes);
}

TEST(LevelLimits, ALevelTooLargeForACartIsNotSavedAsOne) {
  std::string bytes;
  constexpr int kUnknown = 21;
  const std::string data(65'535, 'x');
  for (int i = 0; i < 63; ++i) append_tic_chunk(bytes, {.type = kUnknown, .data = data});
  append_tic_chunk(bytes, {.type = kUnknown,
                           .data = std::string_view(data).substr(0, kMaxCartBytes - bytes.size() - 100)});
  auto level = read_tic(bytes, {});
  ASSERT_TRUE(level) << level.error().message;
  std::fill(level->map.cells().tiles().begin(), level->map.cells().tiles().end(), TileNumber{3});
  const auto cart = write_tic(*level, {});
  ASSERT_FALSE(cart);
  EXPECT_THAT(cart.error().message, HasSubstr("bytes as a cartridge, but may have only 4194304"));
  EXPECT_TRUE(level_of_native(native_of_level(*level)) == *level);
}

// ---- Recordings

json recording_with(const Level& level, const json& edits) {
  Recording recording;
  recording.level = level;
  recording.frames = 100;
  json document = json::parse(write_recording(recording).value());
  document["edits"] = edits;
  return document;
}

std::string error_of(const json& recording) {
  const auto read = read_recording(recording.dump());
  return read ? "" : to_string(read.error(), "file");
}

// A level of one body whose name takes 4 MiB. A version of it is large, but quick to make.
Level with_long_name() {
  Level level = with_spawns(1);
  level.spawns[0].name.assign(kMaxNameBytes, 'n');
  return level;
}
constexpr int kTooManyEdits = 70;  // for such a level

TEST(RecordingLimits, TheLevelsAfterEachEditAreLimited) {
  json edits = json::array();
  for (int i = 0; i < kTooManyEdits; ++i)
    edits.push_back({{"frame", 2}, {"patch", {{{"op", "add"}, {"path", "/spawns/0/x"}, {"value", i}}}}});
  EXPECT_EQ(error_of(recording_with(with_long_name(), edits)),
            "file:key edits: error: has too many edits for a level of this size");
}

// A cart is large and slow to unpack, and no edit of the physics needs it.
TEST(RecordingLimits, EditsDoNotReadTheCart) {
  Level level;
  level.cart = std::make_shared<const CartOrigin>(
      CartOrigin{.kind = CartOrigin::Kind::text, .comment = "--", .bytes = "-- script: lua\ntrace(1)\n"});
  const json damage = {{{"op", "replace"}, {"path", "/cart/kind"}, {"value", 5}}};
  const json edits = {{{"frame", 1}, {"patch", damage}}, {{"frame", 2}, {"patch", json::array()}}};
  EXPECT_EQ(error_of(recording_with(level, edits)), "");

  Recording recording;
  recording.level = level;
  recording.frames = 1;
  Level wider = level;
  wider.map = TileMap(300, 10);  // too large for a cart
  recording.edits.push_back({1, std::make_shared<LevelVersion>(version_of(wider))});
  const auto text = write_recording(recording);
  ASSERT_TRUE(text);
  EXPECT_EQ(json::parse(*text)["edits"].dump().find("/cart"), std::string::npos);
  const auto again = read_recording(*text);
  ASSERT_TRUE(again) << to_string(again.error(), "file");
  ASSERT_TRUE(again->level.cart);
  EXPECT_NE(again->level.cart->bytes.find("trace(1)"), std::string::npos);
  EXPECT_EQ(again->edits[0].version->width, 300);
}

TEST(RecordingLimits, TheCartCountsAsAPartOfALevel) {
  Level level;
  const std::size_t without = size_of(level);
  level.cart = std::make_shared<const CartOrigin>(
      CartOrigin{.kind = CartOrigin::Kind::text, .comment = "--", .bytes = std::string(100'000, '-')});
  EXPECT_EQ(size_of(level), without + 100'000);
}

TEST(RecordingLimits, PatchesDoNotRepeatLongLists) {
  Level level;
  level.extra = R"({"list":[0)";
  for (int i = 0; i < 500'000; ++i) level.extra += ",0";
  level.extra += "]}";
  json patch = json::array();
  for (int i = 0; i < 50; ++i) patch.push_back({{"op", "remove"}, {"path", "/list/0"}});
  EXPECT_EQ(error_of(recording_with(level, {{{"frame", 1}, {"patch", patch}}})),
            "file:key edits[0].patch: error: moves too many entries of lists");
}

TEST(RecordingLimits, ManyAddedOrRemovedBodiesAreOneOperation) {
  Recording recording;
  recording.level = with_spawns(3000);
  recording.frames = 10;
  for (const std::size_t count : {1000u, 2000u, 2000u}) {
    Level edited = with_spawns(count);
    for (std::size_t i = 0; i < count; ++i)
      edited.spawns[i].position.x = static_cast<double>(recording.edits.size() + (i > 7 ? 0 : i));
    recording.edits.push_back({1, std::make_shared<LevelVersion>(version_of(edited))});
  }
  const auto text = write_recording(recording);
  ASSERT_TRUE(text);
  EXPECT_EQ(json::parse(*text)["edits"][0]["patch"].size(), 1u);
  const auto again = read_recording(*text);
  ASSERT_TRUE(again) << to_string(again.error(), "file");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(*again->edits[i].version->spawns, *recording.edits[i].version->spawns);
}

TEST(RecordingLimits, RecordingsThatCannotBeReadAreNotWritten) {
  Recording recording;
  recording.level = with_long_name();
  recording.frames = 10;
  LevelVersion version = version_of(recording.level);
  EXPECT_TRUE(write_recording(recording));
  for (int i = 0; i < kTooManyEdits; ++i) {
    std::vector<Spawn> spawns = *version.spawns;
    spawns[0].position.x = i + 1;
    version.spawns = std::make_shared<const std::vector<Spawn>>(std::move(spawns));
    recording.edits.push_back({1, std::make_shared<LevelVersion>(version)});
  }
  const auto text = write_recording(recording);
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().message, "has too many edits for a level of this size");
}

// ---- Edits

TEST(EditLimits, AnEditBeyondALimitIsRefusedWithAMessage) {
  Session session(with_spawns(kMaxSpawns));
  std::vector<Spawn> more = session.level().spawns;
  more.emplace_back();
  session.apply(action::EditLevel{{"Place a body", {SpawnsChange{session.level().spawns, more}}}});
  EXPECT_EQ(session.level().spawns.size(), kMaxSpawns);
  EXPECT_FALSE(session.modified());
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_EQ(
      session.message()->text,
      "Place a body: not done, because the level then has 65537 bodies, but a level holds at most 65536.");
}

TEST(EditLimits, OldEditsAreForgottenToSaveMemory) {
  Level level;
  UndoStack history(10'000);
  history.mark_saved();
  for (std::size_t i = 1; i <= 100; ++i) {
    std::vector<Spawn> spawns(i % 2);
    history.push(level, {"Edit " + std::to_string(i), {SpawnsChange{level.spawns, spawns}}});
  }
  EXPECT_LT(history.edits().size(), 50u);
  EXPECT_GT(history.edits().size(), 2u);
  EXPECT_EQ(history.edits().back().label, "Edit 100");
  EXPECT_FALSE(history.is_saved());
  while (history.can_undo()) history.undo(level);
  EXPECT_FALSE(history.is_saved()) << "what was saved cannot be reached any more";
  while (history.can_redo()) history.redo(level);
  EXPECT_TRUE(level.spawns.empty());
}

// ---- Maps of Tiled

std::string tiled_map(int side, const std::string& tilesets, const std::string& layers) {
  const std::string size = std::to_string(side);
  return R"({"type":"map","orientation":"orthogonal","tilewidth":8,"tileheight":8,"width":)" + size +
         ",\"height\":" + size + ",\"tilesets\":[" + tilesets + "],\"layers\":[" + layers + "]}";
}

TEST(TiledLimits, LayersAreCountedBeforeTheyAreUnpacked) {
  std::string layers =
      R"({"type":"tilelayer","name":"a","encoding":"base64","compression":"zlib","data":"x"})";
  for (int i = 1; i < 100; ++i)
    layers += ",{\"type\":\"group\",\"layers\":[{\"type\":\"tilelayer\",\"data\":\"x\"}]}";
  const auto read = read_level(tiled_map(4096, "", layers), {"tmj"});
  ASSERT_FALSE(read);
  EXPECT_EQ(to_string(read.error(), "map"),
            "map:key layers: error: has 100 layers of 4096x4096 tiles, but all layers of a map may have at "
            "most 67108864 cells together");
}

TEST(TiledLimits, ObjectsAreCountedBeforeTheyAreRead) {
  std::string xml, json_list = "{}";
  for (std::size_t i = 0; i <= kMaxTiledObjects; ++i) xml += "<object/>";
  for (std::size_t i = 0; i < kMaxTiledObjects; ++i) json_list += ",{}";
  xml =
      "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" "
      "tileheight=\"8\"><objectgroup>" +
      xml + "</objectgroup></map>";
  EXPECT_EQ(read_level(xml, {"tmx"}).error().message,
            "has 262145 objects, but a map may have at most 262144");
  const auto read =
      read_level(tiled_map(1, "", R"({"type":"objectgroup","objects":[)" + json_list + "]}"), {"tmj"});
  ASSERT_FALSE(read);
  EXPECT_EQ(
      to_string(read.error(), "map"),
      "map:key layers[0].objects[262144]: error: is one object too many: a map may have at most 262144");
}

TEST(TiledLimits, LayersTilesetsAndPointsAreCounted) {
  const auto xml_error = [](const std::string& parts) {
    const std::string map =
        R"(<map orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">)";
    return to_string(read_level(map + parts + "</map>", {"tmx"}).error(), "map");
  };
  const auto times = [](std::size_t count, const std::string& part) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += part;
    return text;
  };
  EXPECT_EQ(xml_error(times(kMaxTiledLayers, "<objectgroup/>") + "\n<layer/>"),
            "map:line 2: error: is one layer too many: a map may have at most 4096");
  EXPECT_EQ(xml_error(times(kMaxTiledTilesets, R"(<tileset source="a.tsx"/>)") + "\n<tileset/>"),
            "map:line 2: error: is one tileset too many: a map may have at most 4096");
  EXPECT_EQ(xml_error("<polygon points=\"" + times(kMaxTiledPoints, "1,2 ") + "\"/>"),
            "map: error: has 2097153 points, but a map may have at most 2097152");
  const std::string groups = times(kMaxTiledLayers, R"({"type":"objectgroup"},)") + R"({"type":"group"})";
  EXPECT_EQ(to_string(read_level(tiled_map(1, "", groups), {"tmj"}).error(), "map"),
            "map:key layers[4096]: error: is one layer too many: a map may have at most 4096");
  const std::string sets = times(kMaxTiledTilesets, R"({"source":"a.tsj"},)") + R"({"source":"a.tsj"})";
  EXPECT_EQ(to_string(read_level(tiled_map(1, sets, ""), {"tmj"}).error(), "map"),
            "map:key tilesets[4096]: error: is one tileset too many: a map may have at most 4096");
}

// Each line of a curve gets its name: 1 MB of them took 7 GB.
TEST(TiledLimits, NamesOfCurvesAreCountedBeforeTheyAreCopied) {
  std::string points;
  for (int i = 0; i < 3000; ++i)
    points += std::string(i > 0 ? "," : "") + R"({"x":)" + std::to_string(i / 1000.0 + (i == 1 ? 1e-4 : 0)) +
              R"(,"y":0})";
  const std::string layers =
      R"({"type":"tilelayer","data":[0]},{"type":"objectgroup","objects":[{"x":0,"y":0,)"
      R"("type":"curve","name":")" +
      std::string(100'000, 'n') + R"(","polyline":[)" + points + "]}]}";
  const auto read = read_level(tiled_map(1, "", layers), {"tmj"});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "has 4200000 bytes of names, but a level holds at most 4194304");
}

TEST(TiledLimits, NamesInMessagesAreCut) {
  std::string properties;
  for (int i = 0; i < 1002; ++i)
    properties += std::string(i > 0 ? "," : "") + R"({"name":"p)" + std::to_string(i) + R"(","value":1})";
  const std::string layer = R"({"type":"tilelayer","data":[0],"name":")" + std::string(100'000, 'n') +
                            R"(","properties":[)" + properties + "]}";
  const auto read = read_level(tiled_map(1, "", layer), {"tmj"});
  ASSERT_TRUE(read) << to_string(read.error(), "map");
  ASSERT_EQ(read->dropped.size(), 1001u);
  EXPECT_EQ(read->dropped[0], "the property \"p0\" of the layer \"" + std::string(77, 'n') + "...\"");
}

TEST(TiledLimits, MapsBeyondTheLimitsOfALevelAreNotRead) {
  const std::string layers =
      R"({"type":"tilelayer","data":[0]},{"type":"objectgroup","objects":[{"type":"ball","name":")" +
      std::string(kMaxNameBytes + 1, 'n') + "\"}]}";
  const auto read = read_level(tiled_map(1, "", layers), {"tmj"});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "has 4194305 bytes of names, but a level holds at most 4194304");
}

class TiledFilesLimits : public FolderTest {
 protected:
  // A map of `count` tilesets whose pictures have the names that `picture` returns.
  template <class Picture>
  std::string error_of_map(int tilesets, Picture picture) const {
    std::string list;
    for (int i = 0; i < tilesets; ++i) {
      list += std::string(i == 0 ? "" : ",") + "{\"name\":\"t\",\"firstgid\":" + std::to_string(1 + 256 * i) +
              R"(,"tilewidth":8,"tileheight":8,"tilecount":256,"columns":16,"image":")" + picture(i) + "\"}";
    }
    put("map.tmj", tiled_map(1, list, R"({"type":"tilelayer","data":[1]})"));
    const auto read = load_level(path("map.tmj"));
    return read ? "" : to_string(read.error(), "map");
  }
};

TEST_F(TiledFilesLimits, TilesetsOfOnePictureShareIt) {
  put("a.png", png_of(1024, 2, std::vector<std::string>(1024, std::string(3 * 1024, '\x40'))));
  EXPECT_EQ(error_of_map(500, [](int) { return "a.png"; }), "");
}

TEST_F(TiledFilesLimits, AFileWithManyNamesIsReadOnce) {
  put("a.png", png_of(1024, 2, std::vector<std::string>(1024, std::string(3 * 1024, '\x40'))));
  std::filesystem::create_symlink("a.png", path("link.png"));
  std::filesystem::create_hard_link(path("a.png"), path("hard.png"));
  const auto spelled = [](int i, const std::string& name) {
    std::string spelling;
    for (int k = 0; k < i; ++k) spelling += "./";
    return spelling + name;
  };
  EXPECT_EQ(error_of_map(100, [&](int i) { return spelled(i, "a.png"); }), "");
  EXPECT_EQ(error_of_map(40, [&](int i) { return spelled(i, i % 2 == 0 ? "link.png" : "hard.png"); }), "");

  put("s.tsj", R"({"type":"tileset","name":")" + std::string(2'000'000, 'n') +
                   R"(","tilewidth":8,"tileheight":8,"tilecount":256,"columns":16})");
  std::string list;
  for (int i = 0; i < 40; ++i)
    list += std::string(i == 0 ? "" : ",") + "{\"firstgid\":" + std::to_string(1 + 256 * i) +
            R"(,"source":")" + spelled(i, "s.tsj") + "\"}";
  put("map.tmj", tiled_map(1, list, R"({"type":"tilelayer","data":[1]})"));
  const auto read = load_level(path("map.tmj"));
  EXPECT_TRUE(read) << to_string(read.error(), "map");
}

TEST_F(TiledFilesLimits, PicturesAreCountedTogether) {
  const std::string png = png_of(1024, 2, std::vector<std::string>(1024, std::string(3 * 1024, '\x40')));
  for (int i = 0; i < 33; ++i) put(std::to_string(i) + ".png", png);
  EXPECT_EQ(error_of_map(33, [](int i) { return std::to_string(i) + ".png"; }), "");
  EXPECT_THAT(load_level(path("map.tmj"))->dropped,
              testing::Contains("the picture of the tileset \"t\", file 32.png: is too large: all pictures "
                                "that a map names may have up to 33554432 pixels together"));
}

}  // namespace talus::limits_test
