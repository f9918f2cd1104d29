// The command line: exit statuses, messages and output.

#include "cli/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/trace.h"
#include "cli_answer.h"
#include "folder_test.h"
#include "native_text.h"
#include "paths.h"

namespace talus::cli_test {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kOne = source_path("tests/golden/article/one.lua");
const std::string kSix = source_path("tests/golden/article/six.lua");

class CliSim : public FolderTest {};
class CliReplay : public FolderTest {};
class CliConvert : public FolderTest {};
class CliCheck : public FolderTest {};
class CliShot : public FolderTest {};

TEST(Cli, WrongUsageExitsWithTwo) {
  EXPECT_EQ(cli_answer({"sim"}).status, kExitUsage);
  EXPECT_EQ(cli_answer({"sim", kOne, "--frames", "-1"}).status, kExitUsage);
  EXPECT_EQ(cli_answer({"sim", kOne, "--frames", "1", "--solver", "nonsense"}).status, kExitUsage);
  EXPECT_EQ(cli_answer({"--nonsense"}).status, kExitUsage);
  EXPECT_EQ(cli_answer({"export", kOne, "--to", "nonsense", "-o", "x"}).status, kExitUsage);
}

TEST(Cli, HelpExitsWithZero) {
  const CliAnswer help = cli_answer({"--help"});
  EXPECT_EQ(help.status, kExitGood);
  for (const char* command : {"edit", "sim", "replay", "import", "export", "check", "shot", "bench"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
  }
}

TEST(Cli, AWordThatIsNoCommandIsSaidToBeNone) {
  const CliAnswer answer = cli_answer({"info", "a.tmx"});
  EXPECT_EQ(answer.status, kExitUsage);
  EXPECT_THAT(answer.err, testing::StartsWith("info: error: is neither a command nor a file: the commands "
                                              "are edit, sim, replay"));
}

TEST(Cli, TextOfAFileCannotStartALineOfTheLog) {
  const CliAnswer missing = cli_answer({"check", "/no\n::error::such\x1b[31m.tic"});
  EXPECT_EQ(missing.err,
            R"(/no\n::error::such\x1b[31m.tic: error: cannot be opened: No such file or directory)"
            "\n");
  EXPECT_EQ(cli_answer({"check", "::error::x.tic"}).err.find(R"(\x3a:error::x.tic: error: )"), 0u);
  EXPECT_EQ(cli_answer({"check", "a", "::error::b"}).err.find("\n::"), std::string::npos);
}

// A script must not ship numbered boxes in place of pictures.
TEST_F(CliSim, MissingFilesEndExportsAndChecks) {
  const std::string map =
      put("m.tmx", R"(<map orientation="orthogonal" width="2" height="1" tilewidth="8" tileheight="8">
 <tileset firstgid="1" source="town.tsx"/>
 <tileset firstgid="101" name="trees" tilewidth="8" tileheight="8" tilecount="1" columns="1"><image source="trees.png"/></tileset>
 <layer id="1" name="ground" width="2" height="1"><data encoding="csv">1,101</data></layer>
</map>)");
  const std::string error =
      map +
      ": error: names 2 files that could not be read: town.tsx, trees.png: --allow-missing goes on "
      "without them\n";
  const std::vector<std::string> to_json = {"export", map, "--to", "json", "-o", path("out.json")};
  for (std::vector<std::string> words : {std::vector<std::string>{"check", map}, to_json}) {
    const CliAnswer answer = cli_answer(words);
    EXPECT_EQ(answer.status, kExitBad);
    EXPECT_THAT(answer.err, HasSubstr(error));
    EXPECT_FALSE(std::filesystem::exists(path("out.json")));
  }
  std::vector<std::string> words = to_json;
  words.emplace_back("--allow-missing");
  EXPECT_EQ(cli_answer(words).status, kExitGood);
  EXPECT_TRUE(std::filesystem::exists(path("out.json")));
  EXPECT_EQ(cli_answer({"check", map, "--allow-missing"}).status, kExitGood);
  EXPECT_EQ(cli_answer({"sim", map, "--frames", "1"}).status, kExitGood);
}

TEST_F(CliSim, InputIsReadWithBounds) {
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += "[";
  const auto error = [&](const std::string& input) {
    return cli_answer({"sim", kOne, "--frames", "1", "--input", put("in.jsonl", input)}).err;
  };
  const std::string at = path("in.jsonl") + ":line 2";
  EXPECT_EQ(error("\n{\"frame\": 1, \"keys\": " + keys),
            at + ": error: the JSON is nested deeper than 64 levels here\n");
  EXPECT_EQ(error("\n{\"frame\": 1, \"frame\": 2}"), at + ", key frame: error: is twice in one object\n");
  EXPECT_EQ(error("\n{\"frame\": 1} {}"), at + ", column 14: error: this is not valid JSON\n");
  EXPECT_EQ(error("\n{\"frame\": 9223372036854775808}"),
            at + ": error: \"frame\" must be a whole number from 1\n");
}

TEST(Cli, AMissingFileIsOneLineWithItsName) {
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"sim", "/no/such.tic", "--frames", "1"},
                                             {"replay", "/no/such.json"},
                                             {"check", "/no/such.tic"},
                                             {"import", "/no/such.tic", "-o", "-"},
                                             {"bench", "/no/such.tic", "--bodies", "1", "--frames", "1"}}) {
    const CliAnswer answer = cli_answer(arguments);
    EXPECT_EQ(answer.status, kExitBad) << arguments[0];
    EXPECT_THAT(answer.err, StartsWith("/no/such.")) << arguments[0];
    EXPECT_THAT(answer.err, HasSubstr(": error: ")) << arguments[0];
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    EXPECT_EQ(answer.out, "") << arguments[0];
  }
}

TEST_F(CliSim, HashIsTheLastLine) {
  const CliAnswer traced = cli_answer({"sim", kOne, "--frames", "3", "--trace", "-", "--hash"});
  const CliAnswer silent = cli_answer({"sim", kOne, "--frames", "3", "--hash"});
  EXPECT_EQ(silent.out.size(), 17u);
  EXPECT_EQ(traced.out.substr(traced.out.size() - 17), silent.out);
}

TEST_F(CliSim, ContactsAreInTheTraceUnlessSwitchedOff) {
  const auto last_line = [](const CliAnswer& answer) {
    std::istringstream lines(answer.out);
    std::string line, last;
    while (std::getline(lines, line)) last = line;
    return nlohmann::json::parse(last);
  };
  const auto with = last_line(cli_answer({"sim", kOne, "--frames", "40", "--trace", "-"}));
  const auto without =
      last_line(cli_answer({"sim", kOne, "--frames", "40", "--trace", "-", "--no-contacts"}));
  EXPECT_FALSE(without.contains("contacts"));
  ASSERT_TRUE(with.contains("contacts"));
  EXPECT_EQ(with["bodies"], without["bodies"]);
}

TEST_F(CliSim, ContactsNameTheKindOfABody) {
  State state;
  for (const BodyKind kind : {BodyKind::ball, BodyKind::crate, BodyKind::player}) {
    Body& body = state.bodies.emplace_back();
    body.id = static_cast<int>(state.bodies.size());
    body.kind = kind;
  }
  StepRecord record;
  for (const int body : {1, 2, 3, 4, 0}) {
    record.contacts.emplace_back().body = 1;
    record.contacts.back().other = {body != 0 ? TileRole::ball : TileRole::up_slope, {}, body, {}};
  }
  const auto frame = nlohmann::json::parse(trace_line(state, &record));
  std::vector<std::string> others;
  for (const auto& contact : frame["contacts"]) others.push_back(contact["other"]);
  EXPECT_THAT(others, testing::ElementsAre("ball", "crate", "player", "body", "up_slope"))
      << "body 4 is gone after the step";
}

TEST_F(CliSim, EventsAreInTraces) {
  const auto traced = [](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"sim", kOne, "--frames", "40", "--solver", "exact", "--trace", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::istringstream lines(cli_answer(arguments).out);
    std::vector<std::string> events, contacts;
    for (std::string line; std::getline(lines, line);) {
      const auto frame = nlohmann::json::parse(line);
      if (frame.contains("events")) events.push_back(frame["events"].dump());
      if (frame.contains("contacts")) contacts.push_back(frame["contacts"].dump());
    }
    return std::pair(events, contacts);
  };
  const auto whole = traced({});
  EXPECT_FALSE(whole.first.empty());
  EXPECT_EQ(whole.second.size(), 40u);
  const auto without = traced({"--no-contacts"});
  EXPECT_EQ(without.first, whole.first);
  EXPECT_TRUE(without.second.empty());
}

TEST_F(CliSim, AValueOfTheTuningCanBeSet) {
  const CliAnswer answer =
      cli_answer({"sim", kOne, "--frames", "1", "--set", "fall_blend=1", "--trace", "-", "--no-contacts"});
  EXPECT_EQ(nlohmann::json::parse(answer.out)["bodies"][0]["vy"], 5);
  EXPECT_EQ(cli_answer({"sim", kOne, "--frames", "1", "--set", "fall_blend=2"}).status, kExitUsage);
  EXPECT_THAT(cli_answer({"sim", kOne, "--frames", "1", "--set", "gravity=2"}).err, HasSubstr("gravity"));
  EXPECT_EQ(cli_answer({"sim", kOne, "--frames", "1", "--set", "fall_blend=1x"}).status, kExitUsage);
  EXPECT_EQ(cli_answer({"sim", kOne, "--frames", "1", "--set", "exact.substeps=2"}).status, kExitGood);
  EXPECT_THAT(cli_answer({"sim", kOne, "--frames", "1", "--set", "exact.substeps=1.5"}).err,
              HasSubstr("exact.substeps must be a whole number from 1 to 64"));
}

TEST_F(CliSim, SaysOnceWhichGroundTheSolverIgnores) {
  Level level;
  level.curves = {{"", {Segment{{1, 2}, {9, 8}}, Curve::Faces::up}, ""}};
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid, .one_way = true};
  level.map.set({0, 0}, 1);
  const std::string file = put("level.talus.json", native_of_level(level));
  const auto warnings = [&](const std::string& solver) {
    return cli_answer({"sim", file, "--frames", "2", "--solver", solver}).err;
  };
  EXPECT_EQ(warnings("exact"), "");
  const std::string curves =
      file +
      ": warning: curves and segments stop only bodies of the exact solver, but the level's solver is ";
  EXPECT_EQ(warnings("bump"), curves + "bump\n");
  EXPECT_THAT(warnings("article"),
              StartsWith(curves + "article\n" + file + ": warning: bodies pass through tile 1"));
}

TEST_F(CliSim, BadInputIsNamedByItsLine) {
  for (const char* line :
       {"nonsense", "{\"mouse\":[1,2]}", "{\"frame\":0}", "{\"frame\":1,\"mouse\":[1]}",
        "{\"frame\":1,\"down\":1}", "{\"frame\":1,\"mice\":[]}", "{\"frame\":1,\"mouse\":[1e99,0]}"}) {
    const std::string file = put("bad.jsonl", std::string("{\"frame\":1,\"down\":true}\n") + line + "\n");
    const CliAnswer answer = cli_answer({"sim", kOne, "--frames", "1", "--input", file});
    EXPECT_EQ(answer.status, kExitBad) << line;
    EXPECT_THAT(answer.err, StartsWith(file + ":line 2")) << line;
  }
  const std::string file = put("back.jsonl", "{\"frame\":5}\n\n{\"frame\":4}\n");
  EXPECT_THAT(cli_answer({"sim", kOne, "--frames", "1", "--input", file}).err, HasSubstr("line 3"));
}

TEST_F(CliReplay, PrintsOneLineForEachOperation) {
  const std::string file =
      put("scenario.json",
          R"({"cell_size":64,"ops":[{"op":"add","item":1,"rect":[0,0,2,2]},{"op":"getRect","item":1}]})");
  const CliAnswer answer = cli_answer({"replay", file});
  EXPECT_EQ(answer.status, kExitGood);
  std::istringstream lines(answer.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(nlohmann::json::parse(line)["ok"], true);
  std::getline(lines, line);
  EXPECT_EQ(nlohmann::json::parse(line)["rect"], nlohmann::json::parse("[0,0,2,2]"));
  const CliAnswer half = cli_answer(
      {"replay", put("half.json", R"({"ops":[{"op":"add","item":1,"rect":[0,0,2,2]},{"op":"fly"}]})")});
  EXPECT_EQ(half.status, kExitBad);
  EXPECT_EQ(half.out, "{\"ok\":true}\n") << "each line is printed as it is made";
}

TEST_F(CliConvert, ACartSurvivesTheNativeFormat) {
  const std::string native = path("one.talus.json");
  const std::string back = path("one-back.lua");
  EXPECT_EQ(cli_answer({"import", kOne, "-o", native}).status, kExitGood);
  EXPECT_EQ(cli_answer({"export", native, "--to", "tic-text", "-o", back}).status, kExitGood);
  EXPECT_EQ(bytes_of(back), bytes_of(kOne));
  const CliAnswer printed = cli_answer({"export", native, "--to", "tic-text", "-o", "-"});
  EXPECT_EQ(printed.out, bytes_of(kOne));
}

TEST_F(CliConvert, AFailedConversionIsAnErrorAndLeavesNoFile) {
  const std::string file = path("no-such-folder/one.tic");
  const CliAnswer answer = cli_answer({"export", kOne, "--to", "tic", "-o", file});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, StartsWith(file));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(CliConvert, RefusesTheNameOfAnotherFormat) {
  for (const char* name : {"named.tic", "named.lua"}) {
    const std::string file = path(name);
    const CliAnswer answer = cli_answer({"import", kOne, "-o", file});
    EXPECT_EQ(answer.status, kExitBad);
    EXPECT_EQ(answer.err, file + ": error: is not a name for a Talus level: it must end with .talus.json\n");
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  const std::string json = path("named.talus.json");
  EXPECT_THAT(cli_answer({"export", kOne, "--to", "tic", "-o", json}).err,
              HasSubstr("is not a name for a TIC-80 cartridge: it must end with .tic"));
  EXPECT_FALSE(std::filesystem::exists(json));
}

TEST(CliBench, PrintsOneJsonLineAndTheSameHashForTheSameSeed) {
  const std::vector<std::string> arguments = {"bench",    kSix, "--bodies", "50",
                                              "--frames", "20", "--solver", "article"};
  const CliAnswer answer = cli_answer(arguments);
  ASSERT_EQ(answer.status, kExitGood) << answer.err;
  const auto json = nlohmann::json::parse(answer.out);
  EXPECT_EQ(json["solver"], "article");
  EXPECT_EQ(json["bodies"], 56);
  EXPECT_EQ(json["frames"], 20);
  EXPECT_EQ(json["threads"], 1);
  EXPECT_GT(json["ns_per_body_step"], 0);
  EXPECT_GT(json["ratio_to_kernel"], 0);
  EXPECT_EQ(nlohmann::json::parse(cli_answer(arguments).out)["hash"], json["hash"]);
  auto other_seed = arguments;
  other_seed.insert(other_seed.end(), {"--seed", "2"});
  EXPECT_NE(nlohmann::json::parse(cli_answer(other_seed).out)["hash"], json["hash"]);
}

TEST(CliBench, RestingIsTheShareOfBallStepsWithoutMotion) {
  const auto resting = [](const std::string& frames) {
    return nlohmann::json::parse(
               cli_answer({"bench", kSix, "--bodies", "50", "--frames", frames}).out)["resting"]
        .get<double>();
  };
  EXPECT_EQ(resting("1"), 0) << "all fall at first";
  const double later = resting("2000");
  EXPECT_GT(later, 0) << "some lie still by then";
  EXPECT_LT(later, 1);
}

TEST(CliBench, BallsBlockOneAnotherOnlyWithPairs) {
  std::vector<std::string> arguments = {"bench", kSix, "--bodies", "5000", "--frames", "20"};
  const auto without = nlohmann::json::parse(cli_answer(arguments).out);
  arguments.push_back("--pairs");
  const auto with = nlohmann::json::parse(cli_answer(arguments).out);
  EXPECT_EQ(without["pairs"], false);
  EXPECT_EQ(with["pairs"], true);
  EXPECT_NE(without["hash"], with["hash"]);
}

TEST(CliBench, TooManyBodiesAreRefused) {
  const CliAnswer answer = cli_answer({"bench", kSix, "--bodies", "1000000", "--frames", "1"});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, HasSubstr("too few free cells"));
}

TEST_F(CliCheck, ErrorsExitWithOneAndNameTheirCell) {
  EXPECT_EQ(cli_answer({"check", kSix}).status, kExitGood) << cli_answer({"check", kSix}).out;
  const std::string native = path("spawn.talus.json");
  EXPECT_EQ(cli_answer({"import", kSix, "-o", native}).status, kExitGood);
  auto json = nlohmann::json::parse(bytes_of(native));
  json["spawns"] = nlohmann::json::parse(R"([{"name":"stuck","x":0,"y":0}])");
  const std::string file = put("stuck.talus.json", json.dump());
  const CliAnswer answer = cli_answer({"check", file});
  EXPECT_EQ(answer.status, kExitBad) << answer.out << answer.err;
  EXPECT_THAT(answer.out, HasSubstr(file + ":cell 0,0: error: "));
}

TEST_F(CliCheck, UnknownKeysAreWarningsAndStay) {
  const std::string file = put("a.talus.json", R"({"talus": 1, "spwans": [7], "spawns": [{"naem": "b"}]})");
  const CliAnswer answer = cli_answer({"check", file});
  EXPECT_EQ(answer.status, kExitGood) << answer.err;
  for (const char* const said :
       {R"(:key spwans: warning: is not known; did you mean "spawns"? [unknown-key])",
        R"(:key spawns[0].naem: warning: is not known; did you mean "name"? )"})
    EXPECT_THAT(answer.out, HasSubstr(file + said));
  EXPECT_EQ(cli_answer({"import", file, "-o", path("b.talus.json")}).status, kExitGood);
  const auto kept = nlohmann::json::parse(bytes_of(path("b.talus.json")));
  EXPECT_EQ(kept["spwans"], nlohmann::json({7}));
  EXPECT_EQ(kept["spawns"][0]["naem"], "b");
}

TEST_F(CliCheck, UnknownKeysAreNamedWithTheErrorTheyCause) {
  const std::string file = put("a.talus.json", R"({"talus": 1, "spawns": [{"name": "b", "sise": [8, 8]}],
    "map": {"widht": 9, "height": 4, "rows": ["000"]}, "roles": 5, "tiles": {"1": 7}})");
  const CliAnswer answer = cli_answer({"check", file});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, HasSubstr(":key roles: error: must be an object"));
  const std::string place = file + ":key ";
  EXPECT_EQ(answer.out, place + "map.widht: warning: is not known; did you mean \"width\"? [unknown-key]\n" +
                            place +
                            "spawns[0].sise: warning: is not known; did you mean \"size\"? [unknown-key]\n");
  const std::string version = put("b.talus.json", R"({"tallus": 1})");
  EXPECT_THAT(cli_answer({"check", version}).out, HasSubstr("did you mean \"talus\"?"));
}

TEST_F(CliCheck, OtherRefusedFilesHaveNoUnknownKeys) {
  for (const char* text : {R"({"talus": 99, "spwans": []})", R"({"spwans": []})",
                           R"({"talus": 1, "companion": {}, "spwans": 1})", R"({"talus": 1, "spwans": [)"}) {
    const CliAnswer answer = cli_answer({"check", put("a.json", text)});
    EXPECT_EQ(answer.status, kExitBad);
    EXPECT_EQ(answer.out, "") << text;
  }
}

TEST_F(CliCheck, AWrongHardCaseIsAnError) {
  const std::string file = put("a.talus.json", R"({"talus": 1, "hard_case": {"number": 0}})");
  const CliAnswer answer = cli_answer({"check", file});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, HasSubstr(":key hard_case.number: error: must be a whole number from 1 to 999"));
}

TEST_F(CliShot, APanelIsShownInASmallWindow) {
  const auto picture_with = [&](const std::string& panel) {
    const std::string picture = path(panel + ".png");
    EXPECT_EQ(status_of_own_process({"shot", kSix, "--window", "800x600", "--panel", panel, "-o", picture}),
              kExitGood);
    return bytes_of(picture);
  };
  EXPECT_NE(picture_with("why"), picture_with("shape"));
}

TEST_F(CliShot, PanelsOfOnePlaceAreRefused) {
  const CliAnswer answer = cli_answer(
      {"shot", kSix, "--window", "1280x720", "--panel", "why,problems,tuning", "-o", path("a.png")});
  EXPECT_EQ(answer.status, kExitUsage);
  EXPECT_THAT(answer.err,
              HasSubstr("why and tuning are tabs of one place, so only one of them can be shown"));
}

TEST_F(CliShot, TheThemeIsThatOfTheWindow) {
  const std::string dark = path("dark.png"), light = path("light.png");
  EXPECT_EQ(cli_answer({"shot", kSix, "--light", "-o", light}).status, kExitUsage)
      << "the play view has no theme";
  EXPECT_EQ(status_of_own_process({"shot", kSix, "--window", "700x450", "-o", dark}), kExitGood);
  EXPECT_EQ(status_of_own_process({"shot", kSix, "--window", "700x450", "--light", "-o", light}), kExitGood);
  EXPECT_NE(bytes_of(dark), bytes_of(light));
}

TEST_F(CliShot, TheReachNeedsAPlayer) {
  const CliAnswer answer = cli_answer({"shot", kSix, "--overlay", "reach", "-o", path("reach.png")});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, HasSubstr(": error: No player to follow"));
}

}  // namespace talus::cli_test
