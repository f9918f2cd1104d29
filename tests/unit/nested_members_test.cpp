// Every file that holds a level can hold a level of any allowed nesting: its own file, a companion, a
// recording, an autosave.
#include <gtest/gtest.h>

#include <filesystem>

#include "folder_test.h"
#include "formats/native/companion.h"
#include "formats/native/recording_file.h"
#include "formats/text/json_text.h"
#include "native_text.h"
#include "platform/autosave.h"
#include "sim/timeline.h"

namespace talus::nested_members_test {

std::string lists(int depth) { return std::string(depth, '[') + std::string(depth, ']'); }

// Levels with an unknown member in each object that may have one, nested as deep as a file may be.
std::vector<std::string> deepest_levels() {
  std::vector<std::string> levels;
  const auto add = [&](int objects, const std::string& before, const std::string& after) {
    const std::string deep = before + "\"zz\": " + lists(kMaxJsonDepth - objects) + after;
    const bool is_map = before.starts_with("\"map\"");
    levels.push_back(native_with((is_map ? "" : R"("map": {"width": 4, "height": 3}, )") + deep));
  };
  add(1, "", "");
  for (const std::string member : {"roles", "tiles", "sprites", "auto_tiles", "cart"})
    add(2, "\"" + member + "\": {", "}");
  add(2, R"("map": {"width": 4, "height": 3, )", "}");
  add(3, R"("tuning": {"article": {)", "}}");
  add(3, R"("tiles": {"3": {)", "}}");
  add(3, R"("flag_shapes": {"3": {"kind": "solid", )", "}}");
  add(3, R"("spawns": [{"x": 8, "y": 8, )", "}]");
  add(3, R"("brushes": [{"name": "b", "rows": ["01"], )", "}]");
  add(3, R"("curves": [{"kind": "segment", "from": [0, 10], "to": [16, 10], )", "}]");
  add(3, R"("exports": [{"name": "e", "to": "love", "path": "game", )", "}]");
  return levels;
}

// A recording in which the level is edited: the edit adds whatever `after` has and `before` has not.
Recording recording_of(const Level& before, const Level& after) {
  Timeline timeline(before);
  timeline.step({});
  timeline.edit(after);
  timeline.step({});
  return timeline.whole_recording(timeline.current(), after);
}

class NestedMembers : public FolderTest {};

TEST_F(NestedMembers, AreSavedRecordedAndRecovered) {
  for (const std::string& text : deepest_levels()) {
    SCOPED_TRACE(text);
    const auto level = read_native(text, {});
    ASSERT_TRUE(level) << to_string(level.error(), "level");
    EXPECT_EQ(level_of_native(native_of_level(*level)), *level);

    Level moved = *level, bare;
    moved.map.set({1, 1}, 1);
    for (const Recording& made : {recording_of(*level, moved), recording_of(bare, *level)}) {
      const auto read = read_recording(write_recording(made).value());
      ASSERT_TRUE(read) << to_string(read.error(), "recording");
      EXPECT_EQ(write_recording(*read).value(), write_recording(made).value());
    }

    const SavedWork work{path("1-0.talus-autosave"),
                         "",
                         "name",
                         5,
                         std::make_shared<const Level>(moved),
                         {std::make_shared<const Recording>(recording_of(*level, moved))}};
    ASSERT_TRUE(write_saved_work(work));
    const auto recovered = read_saved_work(work.file);
    ASSERT_TRUE(recovered) << recovered.error();
    EXPECT_EQ(*recovered->level, moved);
    EXPECT_EQ(recovered->recordings.size(), 1u);

    Level cart = *level;
    ASSERT_TRUE(save_level(cart, *find_format("tic"), path("game.tic")));
    const auto loaded = load_level(path("game.tic"));
    ASSERT_TRUE(loaded) << to_string(loaded.error(), "game.tic");
    EXPECT_EQ(loaded->note, "");
    std::filesystem::remove(path("game.tic.talus.json"));
  }
}

TEST(NestedLevels, OneMoreNestingIsRefusedEverywhere) {
  const std::string deep = native_with("\"zz\": " + lists(kMaxJsonDepth));
  EXPECT_EQ(read_native(deep, {}).error().message, "the JSON is nested deeper than 64 levels here");
  const auto read =
      read_recording(R"({"talus_recording": 1, "frames": 0, "hashes": [], "level": )" + deep + "}");
  ASSERT_FALSE(read);
  EXPECT_EQ(to_string(read.error(), "r"), "r:key level: error: is nested deeper than 64 levels");
}

// Talus adds keys when it writes the level. They must not make it unreadable.
TEST(NestedLevels, TheMostUnknownKeysThatOpenAreSaved) {
  const auto keys = [](std::size_t count) {
    std::string text = "\"0\": 0";
    for (std::size_t i = 1; i < count; ++i) text += ", \"z" + std::to_string(i) + "\": 0";
    return text;
  };
  const auto level = read_native(native_with(keys(kMaxUnknownKeys)), {});
  ASSERT_TRUE(level) << to_string(level.error(), "level");
  const auto again = read_native(native_of_level(*level), {});
  ASSERT_TRUE(again) << to_string(again.error(), "level");
  expect_native_error(native_with(keys(kMaxUnknownKeys + 1)), "",
                      "has more than 65536 keys that this Talus does not know");
}

// Each operation adds less than 64 levels of nesting, inside the lists that the one before has added.
std::string recording_with_deepening_edit(int operations, int lists_each) {
  std::string patch, path = "/zz";
  for (int i = 0; i < operations; ++i) {
    patch += std::string(i == 0 ? "" : ", ") + R"({"op": "add", "path": ")" + path + R"(", "value": )" +
             lists(lists_each) + "}";
    for (int level = 0; level < lists_each; ++level) path += "/0";
  }
  return R"({"talus_recording": 1, "frames": 1, "hashes": [], "level": {"talus": 1},
             "edits": [{"frame": 1, "patch": [)" +
         patch + "]}]}";
}

TEST(DeepeningPatches, AreRefusedIfTheLevelBecomesTooDeep) {
  const auto read = read_recording(recording_with_deepening_edit(40, 57));
  ASSERT_FALSE(read);
  EXPECT_EQ(to_string(read.error(), "r"),
            "r:key edits[0].patch[1]: error: makes a level that is nested deeper than 64 levels");
  EXPECT_TRUE(read_recording(recording_with_deepening_edit(3, 21))) << "64 levels";
  EXPECT_FALSE(read_recording(recording_with_deepening_edit(4, 16))) << "65 levels";
}

TEST(DeepeningPatches, CanBeCancelled) {
  std::string patch = R"({"op": "add", "path": "/zz", "value": 0})";
  for (int i = 0; i < 5000; ++i) patch += R"(, {"op": "replace", "path": "/zz", "value": 0})";
  const std::string text =
      R"({"talus_recording": 1, "frames": 1, "hashes": [], "level": {"talus": 1}, "edits": [{"frame": 1, "patch": [)" +
      patch + "]}]}";
  ASSERT_TRUE(read_recording(text));
  const auto read = read_recording(text, Progress([](double share) { return share < 0.5; }));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, was_cancelled().value().message);
}

}  // namespace talus::nested_members_test
