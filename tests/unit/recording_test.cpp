// Recordings as files: writing and reading them again, and what is refused.
#include "formats/native/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <talus/formats/format.h>
#include "folder_test.h"
#include "level_picture.h"
#include "sim/timeline.h"

namespace talus::recording_test {

using nlohmann::json;
using testing::HasSubstr;

Level start() {
  Level level = level_of({"o....", ".....", ".....", ".....", "#####"});
  level.sheet(SheetId::sprites).images[7].fill(3);
  level.spawns.push_back({"hero", {20, 4}, {1, 0}, ""});
  return level;
}

// 40 frames with input, three edits and a mark.
Recording sample() {
  Level level = start();
  Timeline timeline(level);
  for (std::int64_t frame = 1; frame <= 40; ++frame) {
    if (frame == 10) {
      level.map.set({3, 2}, 1);
      timeline.edit(level);
    }
    if (frame == 20) {
      level.tuning.shared.floor_grip = 0.25;
      level.spawns.push_back({"late", {8, 8}, {}, ""});
      timeline.edit(level);
      level.map.set({0, 0}, 0);
      timeline.edit(level);
    }
    Input input;
    input.right = frame > 5;
    input.mouse_down = frame > 25 && frame < 30;
    if (input.mouse_down) input.mouse = {static_cast<double>(frame) + 0.1, -0.5};
    if (input.mouse_down) input.grab = 2;
    timeline.step(input);
  }
  timeline.set_mark(12, "\"quoted\"");
  return timeline.recording(timeline.current(), start());
}

std::string text_of(const Recording& recording) { return write_recording(recording).value(); }

TEST(RecordingFile, KeepsEverything) {
  const Recording before = sample();
  const auto after = read_recording(text_of(before));
  ASSERT_TRUE(after) << to_string(after.error(), "file");
  EXPECT_EQ(after->level, before.level);
  EXPECT_EQ(after->frames, 40);
  EXPECT_EQ(after->marks, before.marks);
  EXPECT_EQ(after->hashes, before.hashes);
  ASSERT_EQ(after->edits.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(after->edits[i].frame, before.edits[i].frame);
    EXPECT_EQ(level_of(*after->edits[i].version), level_of(*before.edits[i].version));
  }
  ASSERT_EQ(after->input.size(), before.input.size());
  EXPECT_EQ(after->input.back().frame, 30);
  EXPECT_EQ(after->input[1].mouse, (Vec2{26.1, -0.5}));
  EXPECT_EQ(after->input[1].grab, 2);
  EXPECT_TRUE(after->input[1].right) << "held until the next entry says something else";
  EXPECT_EQ(text_of(*after), text_of(before));
}

TEST(RecordingFile, RunsAgainAfterReading) {
  Timeline timeline(read_recording(text_of(sample())).value());
  while (timeline.behind()) timeline.catch_up(7);
  EXPECT_EQ(timeline.unexpected_frame(timeline.current()), std::nullopt);
  EXPECT_EQ(timeline.last_frame(), 40);
}

TEST(RecordingFile, IsReadableRowByRow) {
  const std::string text = text_of(sample());
  EXPECT_THAT(text, HasSubstr("\n  \"frames\": 40,\n"));
  EXPECT_THAT(text, HasSubstr("\n    {\"frame\": 6, \"keys\": [\"right\"]},\n")) << text;
  EXPECT_THAT(text, HasSubstr("\n      \"rows\": [\n")) << "the level as in its own file, but indented";
  std::size_t longest = 0, length = 0;
  for (const char c : text) longest = std::max(longest, length = c == '\n' ? 0 : length + 1);
  EXPECT_LE(longest, 160u);
}

TEST(RecordingFile, AnEmptyRecordingIsValid) {
  Timeline timeline(start());
  const auto again = read_recording(text_of(timeline.recording(timeline.current(), start())));
  ASSERT_TRUE(again) << to_string(again.error(), "file");
  EXPECT_EQ(again->frames, 0);
  EXPECT_EQ(again->hashes.size(), 1u);
}

TEST(RecordingFile, IsRecognisedByItsContentOrItsName) {
  EXPECT_TRUE(is_recording(text_of(sample()), {"json"}));
  EXPECT_TRUE(is_recording("", {"talusrec"}));
  EXPECT_FALSE(is_recording("{\"talus\": 1}", {"json"}));
}

// The error of the file after a change to it: "PLACE: MESSAGE".
template <class Change>
std::string error_after(Change change) {
  json document = json::parse(text_of(sample()));
  change(document);
  const auto read = read_recording(document.dump());
  return read ? "none" : read.error().place + ": " + read.error().message;
}

TEST(RecordingFile, NamesTheWrongKey) {
  EXPECT_EQ(error_after([](json&) {}), "none");
  const auto expect = [](const char* expected, auto change) { EXPECT_EQ(error_after(change), expected); };
  expect(": is JSON, but not a recording", [](json& d) { d = 5; });
  expect("key talus_recording: is missing, so this is not a recording",
         [](json& d) { d.erase("talus_recording"); });
  expect("key talus_recording: is newer than what this Talus reads, version 2",
         [](json& d) { d["talus_recording"] = 3; });
  expect("key speed: is not a key of recordings", [](json& d) { d["speed"] = 2; });
  expect("key frames: must be a whole number from 0 to 100663296", [](json& d) { d["frames"] = -1; });
  expect("key frames: must be a whole number from 0 to 100663296", [](json& d) { d["frames"] = 1e18; });
  expect("key hashes: must hold 2000000 hashes, one more than frames, not 41",
         [](json& d) { d["frames"] = 1999999; });
  expect("none", [](json& d) { d["hashes"] = json::array(); });
  expect("key frames: must be a whole number from 0 to 2097152", [](json& d) {
    d["hashes"] = json::array();
    d["frames"] = (1 << 21) + 1;
  });
  expect("key hashes: is missing", [](json& d) { d.erase("hashes"); });
  expect("key hashes[2]: must be a string", [](json& d) { d["hashes"][2] = 7; });
  for (const char* text : {"0123", "0123456789abcdeg", "0123456789abcdef ",
                           "0123456789abcdef  0123456789abcdef", "0123456789abcdef0123456789abcdef"}) {
    expect("key hashes[0]: must be hashes of 16 hexadecimal digits with a space between them",
           [&](json& d) { d["hashes"][0] = text; });
  }
  expect("key level: is missing", [](json& d) { d.erase("level"); });
  expect("key level: is JSON, but not a Talus level", [](json& d) { d["level"] = nullptr; });
  expect("key level, key tuning.solver: must be \"article\", \"bump\" or \"exact\"",
         [](json& d) { d["level"]["tuning"]["solver"] = "best"; });
  expect("key marks[0].frame: must be a whole number from 0 to 40",
         [](json& d) { d["marks"][0]["frame"] = 41; });
  expect("key marks[1].frame: is not after the one before", [](json& d) {
    d["marks"].push_back({{"frame", 12}});
  });
}

TEST(RecordingFile, NamesTheWrongInput) {
  const auto expect = [](const char* expected, auto change) { EXPECT_EQ(error_after(change), expected); };
  expect("key input: must be a list", [](json& d) { d["input"] = 1; });
  expect("key input[0]: an input line must be a JSON object", [](json& d) { d["input"][0] = 1; });
  expect("key input[1].frame: is not after the one before", [](json& d) { d["input"][1]["frame"] = 6; });
  expect("key input[0].frame: is after the last frame", [](json& d) { d["input"] = {{{"frame", 41}}}; });
  expect("key input[0]: \"grab\" must be the number of a body, from 0",
         [](json& d) { d["input"][0]["grab"] = -1; });
  expect("key input[0]: \"mouse\" must lie within 100 million pixels", [](json& d) {
    d["input"][0]["mouse"] = {1e9, 0};
  });
  expect("key input[0]: unknown key \"mice\"", [](json& d) { d["input"][0]["mice"] = 1; });
}

TEST(RecordingFile, NamesTheWrongEdit) {
  const auto expect = [](const char* expected, auto change) { EXPECT_EQ(error_after(change), expected); };
  expect("key edits[0]: must be an object", [](json& d) { d["edits"][0] = 1; });
  expect("key edits[0].frame: must be a whole number from 1 to 40",
         [](json& d) { d["edits"][0]["frame"] = 0; });
  expect("key edits[1].frame: goes backwards", [](json& d) { d["edits"][1]["frame"] = 1; });
  expect("key edits[0].patch: is missing", [](json& d) { d["edits"][0].erase("patch"); });
  expect("key edits[0].patch: must be a list", [](json& d) { d["edits"][0]["patch"] = "all"; });
  expect("key edits[0].patch: does not fit the level before it", [](json& d) {
    d["edits"][0]["patch"] = {{{"op", "remove"}, {"path", "/no/such"}}};
  });
  for (const char* operation : {"copy", "move", "test", ""}) {
    expect("key edits[0].patch[0]: must have an \"op\": \"add\", \"remove\" or \"replace\"", [&](json& d) {
      d["edits"][0]["patch"] = {{{"op", operation}, {"from", "/map"}, {"path", "/tiles"}}};
    });
  }
  expect("key edits[0], key tuning.solver: must be \"article\", \"bump\" or \"exact\"", [](json& d) {
    d["edits"][0]["patch"] = {{{"op", "replace"}, {"path", "/tuning/solver"}, {"value", 0}}};
  });
  expect("key edits: has more than 10000 edits of the level", [](json& d) {
    d["edits"] = json::array();
    for (int i = 0; i < 10'001; ++i) d["edits"].push_back({{"frame", 1}, {"patch", json::array()}});
  });
}

TEST(RecordingFile, IsRefusedIfTruncatedAtAnyByte) {
  const std::string text = text_of(sample());
  for (std::size_t length = 0; length + 2 < text.size(); length += 13)
    EXPECT_FALSE(read_recording(text.substr(0, length))) << length;
}

class SavedRecording : public FolderTest {};

TEST_F(SavedRecording, CanBeLoadedAgain) {
  ASSERT_TRUE(save_recording(sample(), path("run.talusrec")));
  const auto loaded = load_recording(path("run.talusrec"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->hashes, sample().hashes);
  EXPECT_FALSE(save_recording(sample(), path("no/such/folder.talusrec")));
}

Recording with_lone_body() {
  Recording recording = sample();
  recording.alone.emplace();
  recording.alone->spawn = {.name = "",
                            .position = {12.3, 1.0 / 3},
                            .velocity = {-0.55, 0},
                            .extra = "",
                            .kind = BodyKind::player,
                            .size = {6, 11},
                            .foot = Foot::box};
  recording.alone->stands = true;
  recording.alone->run_speed = 0.55;
  return recording;
}

TEST(RecordingFile, KeepsALoneBody) {
  const Recording before = with_lone_body();
  const auto after = read_recording(text_of(before));
  ASSERT_TRUE(after) << to_string(after.error(), "file");
  EXPECT_EQ(after->alone, before.alone);
  EXPECT_EQ(text_of(*after), text_of(before));
  EXPECT_THAT(text_of(before), HasSubstr("\"talus_recording\": 2"));
  EXPECT_THAT(text_of(sample()), HasSubstr("\"talus_recording\": 1")) << "older programs read it";
}

TEST(RecordingFile, RefusesAWrongLoneBody) {
  const auto problem_with = [](const char* key, const json& value) {
    json document = json::parse(text_of(with_lone_body()));
    document["alone"][key] = value;
    const auto read = read_recording(document.dump());
    return read ? std::string() : to_string(read.error(), "file");
  };
  EXPECT_EQ(problem_with("run_speed", 65),
            "file:key alone.run_speed: error: must be a number from 0 to 64 px/frame");
  EXPECT_EQ(problem_with("stands", 1), "file:key alone.stands: error: must be true or false");
  EXPECT_EQ(problem_with("mass", 1), "file:key alone.mass: error: is not a key of recordings");
  EXPECT_EQ(problem_with("x", "left"),
            "file:key alone.x: error: must be a number from -100000000 to 100000000");
  EXPECT_EQ(problem_with("x", 3), "");
}

}  // namespace talus::recording_test
