// Keys that no reader takes: what is said of them, and that all kinds are those of the schema.
#include <gmock/gmock.h>

#include <talus/level/tuning.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "formats/native/unknown_keys.h"
#include "native_text.h"
#include "paths.h"

namespace talus::unknown_keys_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

// "PLACE PROBLEM" of each unknown key of a level with these members.
std::vector<std::string> said_of(const std::string& members) {
  std::vector<std::string> said;
  for (const UnknownKey& key : unknown_keys(level_of_native(R"({"talus": 1, )" + members + "}")))
    said.push_back(key.place + " " + key.problem);
  return said;
}

TEST(UnknownKeys, TheNearestKeyOfTheKindIsNamed) {
  EXPECT_THAT(said_of(R"("spwans": [])"), ElementsAre("spwans is not known; did you mean \"spawns\"?"));
  EXPECT_THAT(said_of(R"("spawns": [{}, {"naem": "a"}])"),
              ElementsAre("spawns[1].naem is not known; did you mean \"name\"?"));
  EXPECT_THAT(said_of(R"("tuning": {"exact": {"gravty": 1}})"),
              ElementsAre("tuning.exact.gravty is not known; did you mean \"gravity\"?"));
  EXPECT_THAT(said_of(R"("tiles": {"3": {"flag": [1]}})"),
              ElementsAre("tiles.3.flag is not known; did you mean \"flags\"?"));
}

TEST(UnknownKeys, AMisplacedKeyIsToldWhereItBelongs) {
  EXPECT_THAT(
      said_of(R"("tuning": {"gravity": 1, "run_speed": 2, "steepest": 1})"),
      UnorderedElementsAre("tuning.gravity is not known here; did you mean \"tuning.exact.gravity\" or "
                           "\"tuning.player.gravity\"?",
                           "tuning.run_speed is not known here; did you mean \"tuning.player.run_speed\"?",
                           "tuning.steepest is not known here; did you mean \"tuning.exact.steepest\"?"));
  EXPECT_THAT(said_of(R"("tuning": {"exact": {"fall_speed": 1}})"),
              ElementsAre("tuning.exact.fall_speed is not known here; did you mean \"tuning.fall_speed\"?"));
  EXPECT_THAT(said_of(R"("width": 1)"), ElementsAre("width is not known here; did you mean \"map.width\"?"));
  EXPECT_THAT(said_of(R"("map": {"width": 1, "height": 1, "rows": [".."], "tile_size": [8, 8]})"),
              ElementsAre("map.tile_size is not known here, but at the top of the file"));
}

TEST(UnknownKeys, WithoutANearOneNoneIsNamed) {
  EXPECT_THAT(said_of(R"("colour": 1)"), ElementsAre("colour is not known, and is kept as it is"));
  EXPECT_THAT(said_of(R"("tiles": {"shape": 1})"),
              ElementsAre("tiles.shape is not known, and is kept as it is"));
  EXPECT_THAT(said_of('"' + std::string(1000, 's') + "\": 1"), SizeIs(1));
}

TEST(UnknownKeys, AKeyOfAnotherKindOfCurveIsNotUsed) {
  EXPECT_THAT(said_of(R"("curves": [{"kind": "segment", "from": [0, 0], "to": [8, 0], "radius": 4}])"),
              ElementsAre("curves[0].radius is not used here, and is kept as it is"));
}

TEST(UnknownKeys, WhatOthersReadIsKnown) {
  EXPECT_THAT(said_of(R"("$schema": "talus.schema.json", "layers": [{"ldtk": "a"}],
    "hard_case": {"input": [{"frame": 1}], "checks": [{"bound": 0}], "floor": [[[0, 1], [2, 3]], {"bowl": []}]})"),
              IsEmpty());
  EXPECT_THAT(said_of(R"("hard_case": {"checks": [{"bounds": 0}], "floor": [{"bowls": []}]})"),
              ElementsAre("hard_case.checks[0].bounds is not known; did you mean \"bound\"?",
                          "hard_case.floor[0].bowls is not known; did you mean \"bowl\"?"));
}

// Where the readers refuse them, an error before theirs would hide them.
TEST(UnknownKeys, OfARefusedFileAreThoseOfAllKinds) {
  std::vector<std::string> said;
  for (const UnknownKey& key : unknown_keys_of_file(R"({"talus": 6, "mpa": {}, "zzzzz": 1,
      "spawns": [{"picture": {"stpes": 1}}], "tile_shapes": {"3": {"parts": [{"pionts": []}], "radius": 1}},
      "large_tiles": {"3": {"siez": 1}}, "tile_notes": {"3": {"clas": "", "properties": {"own": 1}}},
      "objects": [{"image": {"pathh": ""}, "objects": [{"heigth": 1}]}], "cart": {"chunks": [{"bnak": 0}]}})"))
    said.push_back(key.place + " " + key.problem);
  EXPECT_THAT(said, ElementsAre("cart.chunks[0].bnak is not known; did you mean \"bank\"?",
                                "large_tiles.3.siez is not known; did you mean \"size\"?",
                                "mpa is not known; did you mean \"map\"?",
                                "objects[0].image.pathh is not known; did you mean \"path\"?",
                                "objects[0].objects[0].heigth is not known; did you mean \"height\"?",
                                "spawns[0].picture.stpes is not known; did you mean \"steps\"?",
                                "tile_notes.3.clas is not known; did you mean \"class\"?",
                                "tile_shapes.3.parts[0].pionts is not known; did you mean \"points\"?",
                                "tile_shapes.3.radius is not known", "zzzzz is not known"));
}

TEST(UnknownKeys, AreListedUpToALimit) {
  std::string members = "\"k0\": 0";
  for (std::size_t i = 1; i < 2 * kMaxUnknownListed; ++i) members += ", \"k" + std::to_string(i) + "\": 0";
  EXPECT_THAT(said_of(members), SizeIs(kMaxUnknownListed));
}

TEST(UnknownKeys, KindsHaveTheKeysOfTheSchema) {
  std::ifstream file(source_path("assets/talus.schema.json"));
  const auto schema = nlohmann::json::parse(file);
  for (const KeyKind& kind : key_kinds()) {
    if (kind.keys.empty()) continue;  // its keys are numbers
    const auto& described = kind.name == "level" ? schema : schema["definitions"][std::string(kind.name)];
    std::vector<std::string> keys;
    for (const auto& [key, value] : described["properties"].items()) keys.push_back(key);
    EXPECT_THAT(kind.keys, UnorderedElementsAreArray(keys)) << kind.name;
  }
}

TEST(UnknownKeys, WordsOfTheTuningAreThoseOfTheSchema) {
  std::ifstream file(source_path("assets/talus.schema.json"));
  const auto tuning = nlohmann::json::parse(file)["definitions"]["tuning"]["properties"];
  for (const TuningField& field : tuning_fields()) {
    if (field.words.empty()) continue;
    EXPECT_EQ(tuning[std::string(field.key)]["enum"],
              nlohmann::json(std::vector<std::string>(field.words.begin(), field.words.end())))
        << field.key;
  }
}

}  // namespace talus::unknown_keys_test
