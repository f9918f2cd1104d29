// talus sim --verify prints a line for each check of a hard case, and its exit status is 1 if a check fails.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli_answer.h"
#include "paths.h"

namespace talus::cli_verify_test {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kStep = source_path("assets/hard_cases/03-step-with-a-slope.talus.json");

CliAnswer verify(const std::string& file, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"sim", file, "--verify"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return cli_answer(arguments);
}

TEST(CliVerify, PassesIfEveryCheckPasses) {
  const CliAnswer answer = verify(kStep, {"--solver", "bump"});
  EXPECT_EQ(answer.status, kExitGood) << answer.err;
  EXPECT_THAT(answer.out, StartsWith("passed reaches body 1: 0, bound 0\n"));
  EXPECT_THAT(answer.out, testing::Not(HasSubstr("failed")));
}

TEST(CliVerify, FailsWithWhatWasMeasured) {
  const CliAnswer answer = verify(kStep, {"--solver", "article"});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.out, HasSubstr("failed sink body 1: 2, bound 1e-09\n"));
}

TEST(CliVerify, NeedsAHardCaseAndTakesItsFramesFromIt) {
  const CliAnswer none = verify(source_path("assets/demo.talus.json"), {});
  EXPECT_EQ(none.status, kExitBad);
  EXPECT_THAT(none.err, HasSubstr("hard_case"));
  EXPECT_EQ(verify(kStep, {"--frames", "3"}).status, kExitUsage);
}

// A player that runs right by the keys of the case alone ends at the wall, with its right side at 96.
TEST(CliHardCase, IsPlayedWithItsInput) {
  const std::string ramp = source_path("assets/hard_cases/09-ramp-into-a-wall.talus.json");
  const CliAnswer answer = cli_answer({"sim", ramp, "--frames", "120", "--trace", "-", "--no-contacts"});
  ASSERT_EQ(answer.status, kExitGood) << answer.err;
  const std::string& text = answer.out;
  const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  const auto frame = nlohmann::json::parse(last);
  EXPECT_EQ(frame["frame"], 120);
  EXPECT_NEAR(frame["bodies"][0]["x"].get<double>(), 88, 1e-9);
}

}  // namespace talus::cli_verify_test
