// talus prove
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli_answer.h"
#include "folder_test.h"
#include "ldtk_text.h"
#include "paths.h"

namespace talus::cli_prove_test {

using testing::HasSubstr;

const std::string kStep = source_path("assets/hard_cases/03-step-with-a-slope.talus.json");
const std::string kMeadow = source_path("assets/platformer/meadow.tmx");

TEST(CliProve, SaysWhatItTried) {
  const CliAnswer answer = cli_answer({"prove", kStep});
  EXPECT_EQ(answer.status, kExitGood) << answer.out;
  EXPECT_THAT(answer.out, HasSubstr(" places, "));
  EXPECT_THAT(answer.out, HasSubstr("steps of the solver exact, no finding"));
}

TEST(CliProve, ListsFindingsAndFails) {
  const CliAnswer answer = cli_answer({"prove", kMeadow});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(
      answer.out,
      HasSubstr(":cell 48,18: a player of 10x15 px on its centre that runs to the right is stopped by a "
                "low edge of 0.5"));
  EXPECT_THAT(answer.out, HasSubstr("12 findings: 12 of the level, 0 of the solver"));
}

TEST(CliProve, PrintsJson) {
  const CliAnswer answer = cli_answer({"prove", kMeadow, "--json", "--threads", "2"});
  EXPECT_EQ(answer.status, kExitBad);
  const auto proof = nlohmann::json::parse(answer.out);
  EXPECT_EQ(proof["solver"], "exact");
  ASSERT_EQ(proof["findings"].size(), 12u);
  const auto& first = proof["findings"][1];
  EXPECT_EQ(first["kind"], "lip");
  EXPECT_EQ(first["of"], "level");
  EXPECT_EQ(first["body"]["foot"], "centre");
  EXPECT_GT(first["start"]["velocity"][0], 0);
}

TEST(CliProve, TriesTheBodiesThatAreNamed) {
  const CliAnswer answer = cli_answer({"prove", kMeadow, "--json", "--body", "player:6x6:box", "ball:4x4"});
  const auto proof = nlohmann::json::parse(answer.out);
  ASSERT_EQ(proof["bodies"].size(), 2u);
  EXPECT_EQ(proof["bodies"][0]["size"], nlohmann::json({6, 6}));
  EXPECT_EQ(proof["bodies"][1]["kind"], "ball");
}

class CliProveLdtk : public FolderTest {};

TEST_F(CliProveLdtk, TakesOneOfSeveralLevels) {
  const std::string project = put("caves.ldtk", ldtk_project(ldtk_level(ldtk_grid(1, 1, "1"), "Cave") + "," +
                                                                 ldtk_level(ldtk_grid(2, 1, "1,0"), "Top"),
                                                             R"({"value":1,"identifier":"wall"})"));
  const CliAnswer all = cli_answer({"prove", project});
  EXPECT_EQ(all.status, kExitBad);
  EXPECT_THAT(all.err, HasSubstr("choose one by `--level NAME`"));
  const CliAnswer one = cli_answer({"prove", project, "--level", "Top"});
  EXPECT_EQ(one.status, kExitGood) << one.err;
  EXPECT_THAT(one.out, HasSubstr("no finding"));
  EXPECT_EQ(cli_answer({"check", project, "--level", "1"}).status, kExitGood);
}

TEST(CliProve, RefusesBodiesThatAreNone) {
  for (const char* body :
       {"player", "player:8", "player:8x", "player:0x8", "player:8x8:toe", "dog:8x8", "player:8x8x"}) {
    const CliAnswer answer = cli_answer({"prove", kStep, "--body", body});
    EXPECT_EQ(answer.status, 2) << body;
    EXPECT_THAT(answer.err, HasSubstr("must be KIND:WxH")) << body;
  }
}

TEST(CliProve, RefusesALipThatIsNone) {
  for (const char* lip : {"nan", "inf", "0", "-1", "257", "1px", ""}) {
    const CliAnswer answer = cli_answer({"prove", kStep, "--lip", lip});
    EXPECT_EQ(answer.status, 2) << lip;
    EXPECT_THAT(answer.err, HasSubstr("must be 0.01 to 256 px")) << lip;
  }
  EXPECT_NE(cli_answer({"prove", kStep, "--lip", "0.01"}).status, 2);
}

}  // namespace talus::cli_prove_test
