// talus sim --until: the first frame in which a condition holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli_answer.h"
#include "folder_test.h"
#include "formats/native/recording_file.h"
#include "level_picture.h"
#include "paths.h"
#include "sim/timeline.h"

namespace talus::cli_until_test {

using testing::HasSubstr;

const std::string kStep = source_path("assets/hard_cases/03-step-with-a-slope.talus.json");

CliAnswer sim(const std::string& condition, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"sim", kStep, "--frames", "60", "--until", condition};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return cli_answer(arguments);
}

class CliUntil : public FolderTest {};

TEST_F(CliUntil, PrintsTheFrameAndWhy) {
  const CliAnswer answer = sim("penetration > 1", {"--solver", "article"});
  ASSERT_EQ(answer.status, kExitGood) << answer.err;
  const std::size_t end = answer.out.find('\n');
  const auto frame = nlohmann::json::parse(answer.out.substr(0, end));
  EXPECT_GT(frame["frame"], 16);
  EXPECT_LT(frame["frame"], 60);
  EXPECT_FALSE(frame["contacts"].empty());
  EXPECT_THAT(answer.out.substr(end), testing::StartsWith("\nBody 1 wanted to go "));
}

TEST_F(CliUntil, FailsIfTheConditionNeverHolds) {
  const CliAnswer answer = sim("penetration > 1");
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(answer.err, kStep + ": error: \"penetration > 1\" does not hold in any of the frames 0 to 60\n");
}

TEST_F(CliUntil, LooksAtFrameZeroTooAndEndsTheTrace) {
  const CliAnswer start = sim("x > 0");
  ASSERT_EQ(start.status, kExitGood);
  EXPECT_EQ(nlohmann::json::parse(start.out)["frame"], 0);
  const CliAnswer third = sim("frame == 3", {"--trace", "-", "--no-contacts"});
  EXPECT_EQ(std::count(third.out.begin(), third.out.end(), '\n'), 4) << "three of the trace, and the frame";
  EXPECT_EQ(third.out.substr(0, third.out.find('\n')).find("contacts"), std::string::npos);
}

TEST_F(CliUntil, StopsARecording) {
  const Level level = level_of({"o..", "...", "###"});
  Timeline timeline(level);
  for (int frame = 0; frame < 30; ++frame) timeline.step({});
  const std::string file = path("run.talusrec");
  ASSERT_TRUE(save_recording(timeline.recording(timeline.current(), level), file));
  const CliAnswer answer = cli_answer({"sim", file, "--until", "body(1).touches(0, 2)"});
  ASSERT_EQ(answer.status, kExitGood) << answer.err;
  const auto frame = nlohmann::json::parse(answer.out);
  EXPECT_GT(frame["frame"], 1);
  EXPECT_EQ(frame["contacts"][0]["cell"], nlohmann::json::array({0, 2}));
  EXPECT_EQ(cli_answer({"sim", file, "--until", "x < 0"}).status, kExitBad);
}

TEST_F(CliUntil, AWrongConditionIsWrongUsage) {
  const CliAnswer answer = sim("1 < vz");
  EXPECT_EQ(answer.status, kExitUsage);
  EXPECT_THAT(answer.err, HasSubstr("at 5: unknown name 'vz'; did you mean 'vy'?"));
  EXPECT_EQ(sim("vy").status, kExitUsage);
}

}  // namespace talus::cli_until_test
