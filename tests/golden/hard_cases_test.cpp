// The hard cases of assets/hard_cases in the three solvers. The exact solver passes all of them. The failures
// of the other two are listed here, as they are references for how slopes go wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>

#include <talus/sim/solver.h>
#include "formats/native/hard_case_file.h"
#include "level/transform.h"
#include "paths.h"
#include "sim/hard_case_run.h"

namespace talus::hard_cases_test {

struct CaseFile {
  std::string name;  // without folder and extension
  Level level;
  HardCase hard;
};

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("assets/hard_cases"))) {
    const std::string name = entry.path().filename().string();
    const std::size_t end = name.find(".talus.json");
    if (end != std::string::npos) names.push_back(name.substr(0, end));
  }
  std::sort(names.begin(), names.end());
  return names;
}

CaseFile load_case(const std::string& name) {
  const auto loaded = load_level(source_path("assets/hard_cases/") + name + ".talus.json");
  EXPECT_TRUE(loaded) << name << " " << (loaded ? "" : loaded.error().place + ": " + loaded.error().message);
  const auto hard = hard_case_of(loaded->level);
  EXPECT_TRUE(hard) << name << " " << (hard ? "" : hard.error().place + ": " + hard.error().message);
  return {name, loaded->level, hard->value()};
}

// The failing checks as measure and body, such as "position 1, sink 2".
std::string failures_of(const CaseFile& file, SolverKind solver, std::string* details = nullptr) {
  Level level = file.level;
  level.tuning.solver = solver;
  std::string failures;
  const std::vector<CaseResult> results = run_hard_case(file.hard, level).value();
  for (const CaseResult& result : results) {
    if (result.passed) continue;
    const auto& info = case_measure_infos()[static_cast<std::size_t>(result.check.measure)];
    failures +=
        (failures.empty() ? "" : ", ") + std::string(info.key) + " " + std::to_string(result.check.body);
    if (details != nullptr)
      *details += "\n  " + std::string(info.key) + ": " + std::to_string(result.measured);
  }
  return failures;
}

struct KnownFailures {
  std::string article, bump;
};
const std::map<std::string, KnownFailures>& known_failures() {
  static const std::map<std::string, KnownFailures> kKnown = {
      {"01-seam-in-a-wall",
       {"position 1, position 4, position 6, mirror 1, translate 1",
        "position 1, position 4, position 6, mirror 1, translate 1"}},
      {"02-floor-of-tiles",
       {"reaches 2, reaches 4, walls 2, walls 4", "reaches 2, reaches 4, walls 2, walls 4"}},
      {"03-step-with-a-slope", {"reaches 1, sink 1, walls 1, position 1", ""}},
      {"04-peak", {"position 2", ""}},
      {"05-valley", {"position 1, sink 1", ""}},
      {"06-low-end-of-a-slope", {"walls 1, reaches 1, sink 1", ""}},
      {"07-t-junction", {"sink 1", "sink 1"}},
      {"08-slight-bends", {"sink 1, normal 1, normal 1", "sink 1, normal 1, normal 1"}},
      {"09-ramp-into-a-wall", {"position 1, sink 1", "mirror 1"}},
      {"10-wedge", {"position 1", "position 1"}},
      {"11-sloped-ceiling", {"position 1, velocity 1", ""}},
      {"12-steepness-limit", {"reaches 1, position 1, sink 1", "position 1"}},
      {"13-downhill", {"gap 1", "gap 1"}},
      {"14-jump-uphill", {"position 1, sink 1", "position 1"}},
      {"15-ledge-as-deep-as-the-snap", {"gap 1", "gap 1"}},
      {"16-landing-uphill", {"sink 1, reaches 1", ""}},
      {"17-thin-floor",
       {"position 1, position 2, position 3, position 1, position 2, position 3",
        "position 1, position 2, position 3, position 1, position 2, position 3"}},
      {"18-touch-at-the-end", {"untouched 1, untouched 2", "untouched 1, untouched 2"}},
      {"19-touch-at-the-start", {"position 5", "position 5"}},
      {"20-corner-to-corner",
       {"position 1, position 2, position 3, position 4", "position 1, position 2, position 3, position 4"}},
      {"21-beside-a-ledge", {"position 2, position 3, mirror 1", "position 2, position 3, mirror 1"}},
      {"22-a-little-inside-a-wall",
       {"position 1, position 2, position 3", "position 1, position 2, position 3"}},
      {"23-push-and-leave", {"translate 1", "translate 1"}},
      {"26-rest", {"position 2, sink 3", "changes 2, position 2"}},
      {"27-bounce-for-ever", {"apex 1", "apex 1"}},
      {"28-bounce-on-45-degrees", {"velocity 1, velocity 2", ""}},
      {"29-many-bounces-in-a-frame", {"position 1, velocity 1", "position 1, velocity 1"}},
      {"30-mirror", {"mirror 1", "mirror 1"}},
      {"33-through-air", {"position 1", ""}},
      {"37-elastic",
       {"velocity 1, velocity 2, position 1, position 2, velocity 3, velocity 7, position 3, position 4, "
        "position 5, position 6, position 7, velocity 8, velocity 9, position 8, position 9",
        "velocity 1, velocity 2, position 1, position 2, velocity 3, velocity 7, position 3, position 4, "
        "position 5, position 6, position 7, velocity 8, velocity 9, position 8, position 9"}},
      {"38-curves", {"sink 1", "sink 1"}},
      {"38-quarter-pipe",
       {"position 1, velocity 1, normal 1, sink 2, sink 3, velocity 2, position 4, position 5, position 6",
        "position 1, velocity 1, normal 1, sink 2, sink 3, velocity 2, position 4, position 5, position 6"}},
      {"39-crest-inside-the-box", {"sink 1", "sink 1"}},
      {"40-cradle",
       {"velocity 1, velocity 5, position 1, position 5", "velocity 1, velocity 5, position 1, position 5"}},
      {"41-two-come",
       {"velocity 1, velocity 2, velocity 4, velocity 5, position 6, position 9, permute 1",
        "velocity 1, velocity 2, velocity 4, velocity 5, position 6, position 9, permute 1"}},
      {"42-masses",
       {"velocity 1, velocity 2, velocity 3, velocity 4, velocity 5, velocity 6",
        "velocity 1, velocity 2, velocity 3, velocity 4, velocity 5, velocity 6"}},
      {"44-pyramid",
       {"position 11, position 28, position 46, position 53, position 55",
        "position 11, position 28, position 46, position 53, position 55"}},
      {"44-stack",
       {"position 2, position 3, position 4, position 5, position 6, position 7, position 8, position 9, "
        "position 10",
        "position 2, position 3, position 4, position 5, position 6, position 7, position 8, position 9, "
        "position 10"}},
      {"53-conveyors",
       {"position 1, position 2, position 3, position 4", "position 1, position 2, position 3, position 4"}},
      {"54-crate-on-an-incline",
       {"position 2, position 2, velocity 2", "position 2, position 2, velocity 2"}},
      {"57-off-a-corner", {"velocity 2", "velocity 2"}},
      {"58-box-in-a-valley", {"position 1, position 2", "position 1, position 2"}},
      {"58-disc-in-a-valley", {"position 1, position 2", "position 1, position 2"}},
      {"59-through-a-gap", {"position 1, position 2", "position 1, position 2"}},
      {"60-in-a-bowl", {"energy 1, energy 2", "energy 1, energy 2"}},
      {"61-boxes-turned-round", {"returns 1, permute 1", "returns 1, permute 1"}},
      {"61-closed-room", {"permute 1", "permute 1"}},
      {"62-corner-on-corner",
       {"position 1, position 2, position 3, position 4", "position 1, position 2, position 3, position 4"}},
      {"64-heavy-on-light",
       {"position 2, position 1, position 3, position 4", "position 2, position 1, position 3, position 4"}},
      {"65-in-one-place",
       {"position 1, position 2, position 3, position 4, position 5, position 6, position 7, position 8, "
        "position 9, position 10, position 11, position 12, position 13, position 14, position 15, position "
        "16, position 17, position 18",
        "position 1, position 2, position 3, position 4, position 5, position 6, position 7, position 8, "
        "position 9, position 10, position 11, position 12, position 13, position 14, position 15, position "
        "16, position 17, position 18"}},
      {"66-crate-taken-away",
       {"position 2, position 3, position 4, position 5, position 6, position 2, position 3, position 4, "
        "position 5, position 6",
        "position 2, position 3, position 4, position 5, position 6, position 2, position 3, position 4, "
        "position 5, position 6"}},
  };
  return kKnown;
}

class HardCases : public testing::TestWithParam<std::string> {};

TEST_P(HardCases, FailAsKnown) {
  const CaseFile file = load_case(GetParam());
  const auto known = known_failures().find(GetParam());
  const KnownFailures expected = known == known_failures().end() ? KnownFailures{} : known->second;
  std::string details;
  EXPECT_EQ(failures_of(file, SolverKind::article, &details), expected.article) << details;
  details.clear();
  EXPECT_EQ(failures_of(file, SolverKind::bump, &details), expected.bump) << details;
}

TEST_P(HardCases, PassInTheExactSolver) {
  std::string details;
  EXPECT_EQ(failures_of(load_case(GetParam()), SolverKind::exact, &details), "") << details;
}

// With tiles of 16, 24 and 32 px, and everything else as many times larger, the answers are as many times
// larger, too. Three times a number of the case is rounded, so that a bound of 0 cannot hold there.
TEST_P(HardCases, PassInTheExactSolverWithLargerTiles) {
  const CaseFile file = load_case(GetParam());
  for (const int factor : {2, 3, 4}) {
    if (factor != 3 && file.hard.frames > 10'000) continue;  // it takes long, and rounds the most
    CaseFile larger{file.name, scaled(file.level, factor), scaled(file.hard, factor)};
    std::erase_if(larger.hard.checks, [](const CaseCheck& check) {  // no map goes so far
      return check.measure == CaseCheck::Measure::translate && check.x.value_or(0) > kMaxCoordinate / 2;
    });
    if (factor == 3) {
      for (CaseCheck& check : larger.hard.checks) check.bound += 1e-9;
    }
    std::string details;
    EXPECT_EQ(failures_of(larger, SolverKind::exact, &details), "") << 8 * factor << " px" << details;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, HardCases, testing::ValuesIn(case_names()), [](const auto& name) {
  std::string text = name.param;
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
});

TEST(HardCaseFiles, HoldEveryCaseOfShapes) {
  std::vector<int> numbers, wanted;
  for (const std::string& name : case_names()) {
    const CaseFile file = load_case(name);
    EXPECT_EQ(std::stoi(name.substr(0, 2)), file.hard.number) << name;
    EXPECT_FALSE(file.hard.checks.empty()) << name;
    EXPECT_EQ(file.level.tuning.solver, SolverKind::exact) << name;
    numbers.push_back(file.hard.number);
  }
  for (int number = 1; number <= 33; ++number) wanted.push_back(number);
  wanted.insert(wanted.end(), {37, 38, 38, 39});  // an impact, curves, and a quarter pipe
  wanted.insert(wanted.end(), {40, 41, 42, 43, 44, 44, 53, 54, 57, 58, 58, 59, 60, 61, 61, 62, 64, 65,
                               66});  // bodies that meet
  EXPECT_EQ(numbers, wanted);
}

// ---- The same files in other ways ----

// The failures of `checks` in a case's first frames, with another tuning.
std::string failures_with(const std::string& name, std::int64_t frames, std::vector<CaseCheck> checks,
                          const std::function<void(Tuning&)>& change) {
  CaseFile file = load_case(name);
  change(file.level.tuning);
  file.hard.frames = frames;
  file.hard.checks = std::move(checks);
  return failures_of(file, file.level.tuning.solver);
}

CaseCheck check_of(CaseCheck::Measure measure, double bound, std::int64_t first = 0) {
  CaseCheck check;
  check.measure = measure;
  check.bound = bound;
  check.first = first;
  return check;
}

// Case 30 mirrors every scene, and case 31 adds the bodies of every scene in another order. The tolerance is
// a millionth of a pixel: doubles are finer on the left, and bounces amplify the difference. Where circles
// hit one another, each impact makes it several times as large.
TEST(HardCaseFiles, ExactIsTheSameMirroredAndReordered) {
  for (const std::string& name : case_names()) {
    const auto keep = [](Tuning&) {};
    const std::int64_t frames = std::min<std::int64_t>(load_case(name).hard.frames, 600);
    const std::int64_t mirrored = name == "61-closed-room" ? 50 : frames;
    EXPECT_EQ(failures_with(name, mirrored, {check_of(CaseCheck::Measure::mirror, 1e-6)}, keep), "") << name;
    if (name == "65-in-one-place") continue;  // only their order tells its bodies apart
    EXPECT_EQ(failures_with(name, frames, {check_of(CaseCheck::Measure::permute, 0)}, keep), "") << name;
  }
}

// Case 3 at 0.5 to 5 px a frame.
TEST(HardCaseFiles, ASlopeBetweenStepsIsPassedAtEverySpeed) {
  using M = CaseCheck::Measure;
  CaseCheck reaches = check_of(M::reaches, 0);
  reaches.x = 110;
  for (const double speed : {0.5, 0.7, 1.0, 1.9, 3.0, 5.0}) {
    const auto frames = static_cast<std::int64_t>(75 / speed);
    const auto run = [&](SolverKind solver) {
      return failures_with("03-step-with-a-slope", frames,
                           {reaches, check_of(M::sink, 1e-9), check_of(M::walls, 0)}, [&](Tuning& t) {
                             t.solver = solver;
                             t.shared.drift_speed = speed;
                           });
    };
    EXPECT_EQ(run(SolverKind::exact), "") << speed;
    EXPECT_NE(run(SolverKind::article), "") << speed;
  }
}

// Case 13 at 0.5 to 20 px a frame.
TEST(HardCaseFiles, APlayerStaysOnADownhillAtEverySpeed) {
  using M = CaseCheck::Measure;
  for (const double speed : {0.5, 1.0, 2.3, 5.0, 10.0, 20.0}) {
    const auto frames = static_cast<std::int64_t>(200 / speed);
    const auto set_speed = [&](Tuning& t) { t.player.run_speed = t.player.run_gain = speed; };
    EXPECT_EQ(
        failures_with("13-downhill", frames, {check_of(M::sink, 1e-9), check_of(M::gap, 1e-9, 2)}, set_speed),
        "")
        << speed;
  }
}

// Case 14: the player leaves the floor if and only if the jump goes up faster than the floor, which rises by
// 1.5 px a frame. Gravity takes 0.2 of the jump.
TEST(HardCaseFiles, AJumpUphillLeavesTheFloorOnlyIfItIsFaster) {
  const auto gaps = [](double jump_speed) {
    return failures_with("14-jump-uphill", 7, {check_of(CaseCheck::Measure::gap, 1e-9, 2)},
                         [&](Tuning& t) { t.player.jump_speed = jump_speed; });
  };
  for (const double jump_speed : {0.5, 1.0, 1.6}) EXPECT_EQ(gaps(jump_speed), "") << jump_speed;
  for (const double jump_speed : {1.8, 2.5, 4.0}) EXPECT_EQ(gaps(jump_speed), "gap 1") << jump_speed;
}

// Case 26 for TALUS_REST_FRAMES frames, or for the frames of the case if those are more.
TEST(HardCaseFiles, RestForALongTime) {
  const char* text = std::getenv("TALUS_REST_FRAMES");
  const std::int64_t frames = std::max<std::int64_t>(20000, text == nullptr ? 0 : std::atoll(text));
  const auto scene = std::make_shared<const Scene>(compile_scene(load_case("26-rest").level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  while (state.frame < 1000) solver->step(state, {});
  const State rest = state;
  while (state.frame < frames) solver->step(state, {});
  state.frame = rest.frame;
  EXPECT_EQ(state, rest);
  EXPECT_EQ(state_hash(state), state_hash(rest));
}

}  // namespace talus::hard_cases_test
