// The article solver, run by the program's own command, against the trajectories of the reference: every
// double of every frame must have the same bits.

#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli/cli.h"
#include "paths.h"

namespace talus::article_test {

using Json = nlohmann::json;

const std::string kFolder = source_path("tests/golden/article/");
constexpr int kFrames = 600;

std::string run(std::vector<std::string> arguments) {
  std::ostringstream out, err;
  EXPECT_EQ(run_cli(arguments, out, err), kExitGood) << err.str();
  return out.str();
}

std::vector<std::string> sim_arguments(const std::string& name) {
  std::vector<std::string> arguments = {"sim",          kFolder + name + ".lua", "--solver", "article",
                                        "--frames",     std::to_string(kFrames), "--trace",  "-",
                                        "--no-contacts"};
  const std::string input = kFolder + name + ".input.jsonl";
  if (std::ifstream(input)) arguments.insert(arguments.end(), {"--input", input});
  return arguments;
}

std::uint64_t bits(const Json& number) { return std::bit_cast<std::uint64_t>(number.get<double>()); }

class ArticleGolden : public testing::TestWithParam<const char*> {};

TEST_P(ArticleGolden, EveryFrameHasTheReferencesBits) {
  std::istringstream trace(run(sim_arguments(GetParam())));
  std::ifstream expected(kFolder + GetParam() + ".expected.jsonl");
  std::string got_line, want_line;
  int frames = 0;
  while (std::getline(expected, want_line)) {
    ASSERT_TRUE(std::getline(trace, got_line)) << "the trace ends after frame " << frames;
    const Json got = Json::parse(got_line), want = Json::parse(want_line);
    ++frames;
    ASSERT_EQ(got["frame"], frames);
    ASSERT_EQ(got["bodies"].size(), want["bodies"].size());
    for (std::size_t i = 0; i < want["bodies"].size(); ++i) {
      ASSERT_EQ(got["bodies"][i]["id"], want["bodies"][i]["id"]);
      for (const char* key : {"x", "y", "vx", "vy"}) {
        ASSERT_EQ(bits(got["bodies"][i][key]), bits(want["bodies"][i][key]))
            << "frame " << frames << " body " << i + 1 << " " << key << ": " << got["bodies"][i][key]
            << " instead of " << want["bodies"][i][key];
      }
    }
  }
  EXPECT_EQ(frames, kFrames);
}

INSTANTIATE_TEST_SUITE_P(Carts, ArticleGolden, testing::Values("one", "six", "s4", "s26", "s60", "drag"),
                         [](const auto& cart) { return std::string(cart.param); });

}  // namespace talus::article_test
