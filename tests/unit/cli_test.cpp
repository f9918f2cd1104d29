// The command line: exit statuses, messages and output.

#include "cli/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace talus::cli_test {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kOne = TALUS_SOURCE_DIR "/tests/golden/article/one.lua";
const std::string kSix = TALUS_SOURCE_DIR "/tests/golden/article/six.lua";

struct Answer {
  int status;
  std::string out, err;
};

Answer run(const std::vector<std::string>& arguments) {
  std::ostringstream out, err;
  const int status = run_cli(arguments, out, err);
  return {status, out.str(), err.str()};
}

std::string write_file(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string read_whole(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Cli, WrongUsageIsTwo) {
  EXPECT_EQ(run({"sim"}).status, kExitUsage);
  EXPECT_EQ(run({"sim", kOne, "--frames", "-1"}).status, kExitUsage);
  EXPECT_EQ(run({"sim", kOne, "--frames", "1", "--solver", "nonsense"}).status, kExitUsage);
  EXPECT_EQ(run({"--nonsense"}).status, kExitUsage);
  EXPECT_EQ(run({"export", kOne, "--to", "nonsense", "-o", "x"}).status, kExitUsage);
}

TEST(Cli, HelpIsGood) {
  const Answer help = run({"--help"});
  EXPECT_EQ(help.status, kExitGood);
  for (const char* command : {"edit", "sim", "replay", "import", "export", "check", "shot", "bench"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
  }
}

TEST(Cli, AMissingFileIsOneLineWithItsName) {
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"sim", "/no/such.tic", "--frames", "1"},
                                             {"replay", "/no/such.json"},
                                             {"check", "/no/such.tic"},
                                             {"import", "/no/such.tic", "-o", "-"},
                                             {"bench", "/no/such.tic", "--bodies", "1", "--frames", "1"}}) {
    const Answer answer = run(arguments);
    EXPECT_EQ(answer.status, kExitBad) << arguments[0];
    EXPECT_THAT(answer.err, StartsWith("/no/such.")) << arguments[0];
    EXPECT_THAT(answer.err, HasSubstr(": error: ")) << arguments[0];
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    EXPECT_EQ(answer.out, "") << arguments[0];
  }
}

TEST(CliSim, HashIsTheLastLine) {
  const Answer traced = run({"sim", kOne, "--frames", "3", "--trace", "-", "--hash"});
  const Answer silent = run({"sim", kOne, "--frames", "3", "--hash"});
  EXPECT_EQ(silent.out.size(), 17u);
  EXPECT_EQ(traced.out.substr(traced.out.size() - 17), silent.out);
}

TEST(CliSim, ContactsAreInTheTraceUnlessSwitchedOff) {
  const auto last_line = [](const Answer& answer) {
    std::istringstream lines(answer.out);
    std::string line, last;
    while (std::getline(lines, line)) last = line;
    return nlohmann::json::parse(last);
  };
  const auto with = last_line(run({"sim", kOne, "--frames", "40", "--trace", "-"}));
  const auto without = last_line(run({"sim", kOne, "--frames", "40", "--trace", "-", "--no-contacts"}));
  EXPECT_FALSE(without.contains("contacts"));
  ASSERT_TRUE(with.contains("contacts"));
  EXPECT_EQ(with["bodies"], without["bodies"]);
}

TEST(CliSim, ANumberOfTheTuningCanBeSet) {
  const Answer answer =
      run({"sim", kOne, "--frames", "1", "--set", "fall_blend=1", "--trace", "-", "--no-contacts"});
  EXPECT_EQ(nlohmann::json::parse(answer.out)["bodies"][0]["vy"], 5);
  EXPECT_EQ(run({"sim", kOne, "--frames", "1", "--set", "fall_blend=2"}).status, kExitUsage);
  EXPECT_THAT(run({"sim", kOne, "--frames", "1", "--set", "gravity=2"}).err, HasSubstr("gravity"));
  EXPECT_EQ(run({"sim", kOne, "--frames", "1", "--set", "fall_blend=1x"}).status, kExitUsage);
  EXPECT_EQ(run({"sim", kOne, "--frames", "1", "--set", "exact.substeps=2"}).status, kExitGood);
  EXPECT_THAT(run({"sim", kOne, "--frames", "1", "--set", "exact.substeps=1.5"}).err,
              HasSubstr("exact.substeps must be a whole number from 1 to 64"));
}

TEST(CliSim, BadInputIsNamedByItsLine) {
  for (const char* line :
       {"nonsense", "{\"mouse\":[1,2]}", "{\"frame\":0}", "{\"frame\":1,\"mouse\":[1]}",
        "{\"frame\":1,\"down\":1}", "{\"frame\":1,\"mice\":[]}", "{\"frame\":1,\"mouse\":[1e99,0]}"}) {
    const std::string path =
        write_file("bad.jsonl", std::string("{\"frame\":1,\"down\":true}\n") + line + "\n");
    const Answer answer = run({"sim", kOne, "--frames", "1", "--input", path});
    EXPECT_EQ(answer.status, kExitBad) << line;
    EXPECT_THAT(answer.err, StartsWith(path + ":line 2: error: ")) << line;
  }
  const std::string path = write_file("back.jsonl", "{\"frame\":5}\n\n{\"frame\":4}\n");
  EXPECT_THAT(run({"sim", kOne, "--frames", "1", "--input", path}).err, HasSubstr("line 3"));
}

TEST(CliReplay, PrintsOneLineForEachOperation) {
  const std::string path = write_file(
      "scenario.json",
      R"({"cell_size":64,"ops":[{"op":"add","item":1,"rect":[0,0,2,2]},{"op":"getRect","item":1}]})");
  const Answer answer = run({"replay", path});
  EXPECT_EQ(answer.status, kExitGood);
  std::istringstream lines(answer.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(nlohmann::json::parse(line)["ok"], true);
  std::getline(lines, line);
  EXPECT_EQ(nlohmann::json::parse(line)["rect"], nlohmann::json::parse("[0,0,2,2]"));
}

TEST(CliConvert, ACartComesBackByWayOfTheNativeFormat) {
  const std::string native = testing::TempDir() + "one.talus.json";
  const std::string back = testing::TempDir() + "one-back.lua";
  EXPECT_EQ(run({"import", kOne, "-o", native}).status, kExitGood);
  EXPECT_EQ(run({"export", native, "--to", "tic-text", "-o", back}).status, kExitGood);
  EXPECT_EQ(read_whole(back), read_whole(kOne));
  const Answer printed = run({"export", native, "--to", "tic-text", "-o", "-"});
  EXPECT_EQ(printed.out, read_whole(kOne));
}

TEST(CliConvert, WhatCannotBeWrittenIsAnErrorAndLeavesNothing) {
  const std::string path = testing::TempDir() + "no-such-folder/one.tic";
  const Answer answer = run({"export", kOne, "--to", "tic", "-o", path});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, StartsWith(path));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(CliConvert, RefusesTheNameOfAnotherFormat) {
  for (const char* name : {"named.tic", "named.lua"}) {
    const std::string path = testing::TempDir() + name;
    const Answer answer = run({"import", kOne, "-o", path});
    EXPECT_EQ(answer.status, kExitBad);
    EXPECT_EQ(
        answer.err,
        path +
            ": error: is no name of a Talus level, which would be written: it must end with .talus.json\n");
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  const std::string json = testing::TempDir() + "named.talus.json";
  EXPECT_THAT(run({"export", kOne, "--to", "tic", "-o", json}).err,
              HasSubstr("is no name of a TIC-80 cartridge, which would be written: it must end with .tic"));
  EXPECT_FALSE(std::filesystem::exists(json));
}

TEST(CliBench, PrintsOneJsonLineAndTheSameHashForTheSameSeed) {
  const std::vector<std::string> arguments = {"bench",    kSix, "--bodies", "50",
                                              "--frames", "20", "--solver", "article"};
  const Answer answer = run(arguments);
  ASSERT_EQ(answer.status, kExitGood) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["solver"], "article");
  EXPECT_EQ(json["bodies"], 56);
  EXPECT_EQ(json["frames"], 20);
  EXPECT_EQ(json["threads"], 1);
  EXPECT_GT(json["ns_per_body_step"], 0);
  EXPECT_GT(json["ratio_to_kernel"], 0);
  EXPECT_EQ(nlohmann::json::parse(run(arguments).out)["hash"], json["hash"]);
  auto other_seed = arguments;
  other_seed.insert(other_seed.end(), {"--seed", "2"});
  EXPECT_NE(nlohmann::json::parse(run(other_seed).out)["hash"], json["hash"]);
}

TEST(CliBench, RestingIsTheShareOfBallStepsWithoutMotion) {
  const auto resting = [](const std::string& frames) {
    return nlohmann::json::parse(run({"bench", kSix, "--bodies", "50", "--frames", frames}).out)["resting"]
        .get<double>();
  };
  EXPECT_EQ(resting("1"), 0) << "all fall at first";
  const double later = resting("2000");
  EXPECT_GT(later, 0) << "some lie still by then";
  EXPECT_LT(later, 1);
}

TEST(CliBench, BallsBlockOneAnotherOnlyWithPairs) {
  std::vector<std::string> arguments = {"bench", kSix, "--bodies", "5000", "--frames", "20"};
  const auto without = nlohmann::json::parse(run(arguments).out);
  arguments.push_back("--pairs");
  const auto with = nlohmann::json::parse(run(arguments).out);
  EXPECT_EQ(without["pairs"], false);
  EXPECT_EQ(with["pairs"], true);
  EXPECT_NE(without["hash"], with["hash"]);
}

TEST(CliBench, TooManyBodiesAreRefused) {
  const Answer answer = run({"bench", kSix, "--bodies", "1000000", "--frames", "1"});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, HasSubstr("too few free cells"));
}

TEST(CliCheck, ErrorsGiveOneAndNameTheirCell) {
  EXPECT_EQ(run({"check", kSix}).status, kExitGood) << run({"check", kSix}).out;
  const std::string native = testing::TempDir() + "spawn.talus.json";
  EXPECT_EQ(run({"import", kSix, "-o", native}).status, kExitGood);
  auto json = nlohmann::json::parse(read_whole(native));
  json["spawns"] = nlohmann::json::parse(R"([{"name":"stuck","x":0,"y":0}])");
  const std::string path = write_file("stuck.talus.json", json.dump());
  const Answer answer = run({"check", path});
  EXPECT_EQ(answer.status, kExitBad) << answer.out << answer.err;
  EXPECT_THAT(answer.out, HasSubstr(path + ":cell 0,0: error: "));
}

TEST(CliShot, TheReachNeedsAPlayer) {
  const Answer answer = run({"shot", kSix, "--overlay", "reach", "-o", testing::TempDir() + "reach.png"});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, HasSubstr(": error: No player to follow"));
}

}  // namespace talus::cli_test
