// talus sim --until: the first frame in which a condition holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/cli.h"
#include "formats/recording.h"
#include "level_text.h"
#include "sim/timeline.h"

namespace talus::cli_until_test {

using testing::HasSubstr;

const std::string kStep = TALUS_SOURCE_DIR "/assets/hard_cases/03-step-with-a-slope.talus.json";

struct Answer {
  int status;
  std::string out, err;
};

Answer sim(const std::string& condition, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"sim", kStep, "--frames", "60", "--until", condition};
  arguments.insert(arguments.end(), more.begin(), more.end());
  std::ostringstream out, err;
  const int status = run_cli(arguments, out, err);
  return {status, out.str(), err.str()};
}

TEST(CliUntil, PrintsTheFrameAndWhy) {
  const Answer answer = sim("penetration > 1", {"--solver", "article"});
  ASSERT_EQ(answer.status, kExitGood) << answer.err;
  const std::size_t end = answer.out.find('\n');
  const auto frame = nlohmann::json::parse(answer.out.substr(0, end));
  EXPECT_GT(frame["frame"], 16);
  EXPECT_LT(frame["frame"], 60);
  EXPECT_FALSE(frame["contacts"].empty());
  EXPECT_THAT(answer.out.substr(end), testing::StartsWith("\nBody 1 wanted to go "));
}

TEST(CliUntil, FailsWhereTheConditionNeverHolds) {
  const Answer answer = sim("penetration > 1");
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(answer.err, kStep + ": error: \"penetration > 1\" does not hold in any of the frames 0 to 60\n");
}

TEST(CliUntil, BeginsWithTheStartAndStopsTheTrace) {
  const Answer start = sim("x > 0");
  ASSERT_EQ(start.status, kExitGood);
  EXPECT_EQ(nlohmann::json::parse(start.out)["frame"], 0);
  const Answer third = sim("frame == 3", {"--trace", "-", "--no-contacts"});
  EXPECT_EQ(std::count(third.out.begin(), third.out.end(), '\n'), 4) << "three of the trace, and the frame";
  EXPECT_EQ(third.out.substr(0, third.out.find('\n')).find("contacts"), std::string::npos);
}

TEST(CliUntil, StopsARecording) {
  const Level level = level_of({"o..", "...", "###"});
  Timeline timeline(level);
  for (int frame = 0; frame < 30; ++frame) timeline.step({});
  const std::string path = testing::TempDir() + "talus_cli_until.talusrec";
  ASSERT_TRUE(save_recording(timeline.recording(timeline.current(), level), path));
  std::ostringstream out, err;
  ASSERT_EQ(run_cli({"sim", path, "--until", "body(1).touches(0, 2)"}, out, err), kExitGood) << err.str();
  const auto frame = nlohmann::json::parse(out.str());
  EXPECT_GT(frame["frame"], 1);
  EXPECT_EQ(frame["contacts"][0]["cell"], nlohmann::json::array({0, 2}));
  EXPECT_EQ(run_cli({"sim", path, "--until", "x < 0"}, out, err), kExitBad);
}

TEST(CliUntil, AWrongConditionIsWrongUsage) {
  const Answer answer = sim("1 < vz");
  EXPECT_EQ(answer.status, kExitUsage);
  EXPECT_THAT(answer.err, HasSubstr("at 5: no name 'vz'; do you mean 'vy'?"));
  EXPECT_EQ(sim("vy").status, kExitUsage);
}

}  // namespace talus::cli_until_test
