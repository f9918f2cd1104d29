// Replays the scenarios in replay/, and compares every answer with the reference's recorded answer, bit by
// bit.
#include "formats/native/replay.h"
#include "paths.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace talus::golden_replay_test {

using Json = nlohmann::json;

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// The parser reads "-0" as the integer 0, so it must see "-0.0".
Json parse_line(std::string line) {
  for (std::size_t at = line.find("-0"); at != std::string::npos; at = line.find("-0", at + 2)) {
    if (std::string_view(",]}").find(line[at + 2]) != std::string_view::npos) line.insert(at + 2, ".0");
  }
  return Json::parse(line);
}

bool equal_bits(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) {
    return std::bit_cast<std::uint64_t>(a.get<double>()) == std::bit_cast<std::uint64_t>(b.get<double>());
  }
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (!a.is_structured()) return a == b;
  if (a.is_array()) return std::equal(a.begin(), a.end(), b.begin(), equal_bits);
  for (const auto& [key, value] : a.items()) {
    if (!b.contains(key) || !equal_bits(value, b[key])) return false;
  }
  return true;
}

class ReplayGolden : public testing::TestWithParam<std::string> {};

TEST_P(ReplayGolden, AnswersEqualTheReferenceBitByBit) {
  const std::filesystem::path base = std::filesystem::path(source_path("tests/golden/replay")) / GetParam();
  std::vector<std::string> answers;
  const auto replayed = replay_scenario(read_text(base.string() + ".json"), [&](std::string_view answer) {
    answers.emplace_back(answer);
    return true;
  });
  ASSERT_TRUE(replayed) << replayed.error().place << ": " << replayed.error().message;
  std::istringstream expected(read_text(base.string() + ".expected.jsonl"));
  std::string line;
  std::size_t at = 0;
  for (; std::getline(expected, line); ++at) {
    ASSERT_LT(at, answers.size());
    EXPECT_TRUE(equal_bits(parse_line(answers[at]), parse_line(line)))
        << "op " << at + 1 << "\nexpected " << line << "\nactual   " << answers[at];
  }
  EXPECT_EQ(at, answers.size());
  EXPECT_GT(at, 100u);
}

INSTANTIATE_TEST_SUITE_P(, ReplayGolden,
                         testing::Values("bounce-1", "bounce-2", "churn-1", "churn-2", "dense-1", "dense-2",
                                         "errors-1", "errors-2", "overlap-1", "overlap-2", "queries-1",
                                         "queries-2", "sparse-1", "sparse-2", "tiles-1", "tiles-2"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace talus::golden_replay_test
