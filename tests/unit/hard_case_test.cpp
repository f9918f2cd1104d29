// Hard cases: reading them from a level, their floors, and the checks of a run.

#include "formats/native/hard_case_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formats/native/native.h"
#include "level_picture.h"
#include "sim/case_edit.h"
#include "sim/hard_case_run.h"
#include "unit/meeting_run.h"

namespace talus::hard_case_test {

Level level_with(const std::string& hard_case) {
  Level level = level_of({"o..", "...", "###"});
  level.extra = "{\"hard_case\":" + hard_case + "}";
  return level;
}

std::string case_text(const std::string& members) {
  return R"({"number":3,"title":"t","set_up":"s","right_answer":"r","frames":10)" + members + "}";
}

TEST(HardCase, ALevelWithoutTheKeyIsNoHardCase) {
  Level level = level_of({"#"});
  EXPECT_FALSE(hard_case_of(level).value());
  level.extra = R"({"author":"me"})";
  EXPECT_FALSE(hard_case_of(level).value());
}

TEST(HardCase, IsReadWhole) {
  const auto hard = hard_case_of(level_with(case_text(
      R"(,"input":[{"frame":2,"mouse":[3,4],"down":true,"keys":["left","jump"]}],
         "edits":[{"frame":0,"turn_round":true},{"frame":10,"remove":4},{"frame":10,"remove":2,"turn_round":true}],
         "floor":[[[0,8],[8,8],[16,0]],{"arc":[40,20,10,30,50]},{"bowl":[60,20,10,50,60]}],
         "checks":[{"measure":"position","body":2,"frame":5,"right":9,"bound":0.5},
                   {"measure":"gap","frames":[3,7]}])")));
  ASSERT_TRUE(hard) << hard.error().place << hard.error().message;
  const HardCase& h = **hard;
  EXPECT_EQ(h.number, 3);
  EXPECT_EQ(h.frames, 10);
  ASSERT_EQ(h.input.size(), 1u);
  EXPECT_EQ(h.input[0].mouse, (Vec2{3, 4}));
  EXPECT_TRUE(h.input[0].mouse_down && h.input[0].left && h.input[0].jump && !h.input[0].right);
  ASSERT_EQ(h.edits.size(), 3u);
  EXPECT_EQ(h.edits[0].frame, 0);
  EXPECT_TRUE(h.edits[0].turns_round && h.edits[0].remove == 0);
  EXPECT_EQ(h.edits[1].frame, 10);
  EXPECT_TRUE(!h.edits[1].turns_round && h.edits[1].remove == 4);
  EXPECT_TRUE(h.edits[2].turns_round && h.edits[2].remove == 2);
  EXPECT_EQ(h.floor.parts.size(), 4u);
  EXPECT_EQ(h.floor.top(54, 58), 28);
  ASSERT_EQ(h.checks.size(), 2u);
  EXPECT_EQ(h.checks[0].body, 2);
  EXPECT_EQ(h.checks[0].first, 5);
  EXPECT_EQ(h.checks[0].right, 9);
  EXPECT_FALSE(h.checks[0].x);
  EXPECT_EQ(h.checks[0].bound, 0.5);
  EXPECT_EQ(h.checks[1].measure, CaseCheck::Measure::gap);
  EXPECT_EQ(h.checks[1].last, 7);
}

TEST(HardCase, ErrorsNameTheirKey) {
  const auto place_of = [](const std::string& hard_case) {
    const auto hard = hard_case_of(level_with(hard_case));
    return hard ? std::string("none") : hard.error().place;
  };
  EXPECT_EQ(place_of("[]"), "key hard_case");
  EXPECT_EQ(place_of("{}"), "key hard_case.number");
  EXPECT_EQ(place_of(case_text(R"(,"checks":[{"measure":"speed"}])")), "key hard_case.checks[0].measure");
  EXPECT_EQ(place_of(case_text(R"(,"checks":[{"measure":"gap","frame":11}])")),
            "key hard_case.checks[0].frame");
  EXPECT_EQ(place_of(case_text(R"(,"checks":[{"measure":"gap","x":"1"}])")), "key hard_case.checks[0].x");
  EXPECT_EQ(place_of(case_text(R"(,"floor":[[[0,0]]])")), "key hard_case.floor[0]");
  EXPECT_EQ(place_of(case_text(R"(,"floor":[[[5,0],[0,0]]])")), "key hard_case.floor[0]");
  EXPECT_EQ(place_of(case_text(R"(,"floor":[{"arc":[1]}])")), "key hard_case.floor[0].arc");
  EXPECT_EQ(place_of(case_text(R"(,"input":[{"frame":1,"keys":["fly"]}])")), "key hard_case.input[0].keys");
  EXPECT_EQ(place_of(case_text(R"(,"input":[{"frame":1,"keys":"left"}])")), "key hard_case.input[0].keys");
  EXPECT_EQ(place_of(case_text(R"(,"input":[{"frame":2},{"frame":1}])")), "key hard_case.input[1].frame");
}

// Memory and time would have no bound.
TEST(HardCase, NumbersAndAmountsAreLimited) {
  const auto error_of = [](const std::string& members) {
    const auto hard = hard_case_of(level_with(case_text(members)));
    return hard ? std::string("none") : hard.error().place + " " + hard.error().message;
  };
  const std::string range = " must be a number from -100000000 to 100000000";
  for (const char* key : {"x", "y", "right", "bottom", "bound"}) {
    const std::string check = R"(,"checks":[{"measure":"reaches",")" + std::string(key) + "\":";
    EXPECT_EQ(error_of(check + "1e300}]"), "key hard_case.checks[0]." + std::string(key) + range);
    EXPECT_EQ(error_of(check + "-1e8}]"), "none");
  }
  EXPECT_EQ(error_of(R"(,"input":[{"frame":1,"mouse":[1e9,0]}])"), "key hard_case.input[0].mouse" + range);
  EXPECT_EQ(error_of(R"(,"floor":[{"arc":[1,2,3,4,1e9]}])"), "key hard_case.floor[0].arc" + range);
  std::string checks, points;
  for (int i = 0; i < 257; ++i) checks += R"({"measure":"gap"},)";
  for (int i = 0; i < 258; ++i) points += "[" + std::to_string(i) + ",0],";
  checks.pop_back(), points.pop_back();
  EXPECT_EQ(error_of(",\"checks\":[" + checks + "]"), "key hard_case.checks may have at most 256 checks");
  EXPECT_EQ(error_of(",\"floor\":[[" + points + "]]"),
            "key hard_case.floor may have at most 256 lines and curves");
}

TEST(HardCase, EditsAreChecked) {
  const auto error_of = [](const std::string& edits) {
    const auto hard = hard_case_of(level_with(case_text(R"(,"edits":)" + edits)));
    return hard ? std::string("none") : hard.error().place + " " + hard.error().message;
  };
  const std::string key = "key hard_case.edits";
  EXPECT_EQ(error_of("[]"), "none");
  EXPECT_EQ(error_of("{}"), key + " must be a list");
  EXPECT_EQ(error_of("[1]"), key + "[0] must be an object");
  EXPECT_EQ(error_of(R"([{"remove":1}])"), key + "[0].frame is missing");
  EXPECT_EQ(error_of(R"([{"frame":11,"remove":1}])"), key + "[0].frame must be a whole number from 0 to 10");
  EXPECT_EQ(error_of(R"([{"frame":-1,"remove":1}])"), key + "[0].frame must be a whole number from 0 to 10");
  EXPECT_EQ(error_of(R"([{"frame":1,"remove":0}])"),
            key + "[0].remove must be a whole number from 1 to 1000");
  EXPECT_EQ(error_of(R"([{"frame":1,"turn_round":1}])"), key + "[0].turn_round must be true");
  EXPECT_EQ(error_of(R"([{"frame":1}])"), key + R"([0] must have "remove" or "turn_round")");
  EXPECT_EQ(error_of(R"([{"frame":2,"remove":1},{"frame":1,"remove":2}])"), key + "[1].frame goes backwards");
  std::string many;
  for (int i = 0; i < 257; ++i) many += R"({"frame":1,"turn_round":true},)";
  many.pop_back();
  EXPECT_EQ(error_of("[" + many + "]"), key + " may have at most 256 edits");
}

// Every file is read as the program writes it.
TEST(HardCase, ItsEditsAreWrittenInOrder) {
  Level level = level_of({"#"});
  level.extra = R"({"hard_case":{"edits":[{"turn_round":true,"remove":2,"frame":3}],"number":61}})";
  const auto written = write_native(level, {});
  ASSERT_TRUE(written);
  EXPECT_NE(written->bytes.find(R"({"frame": 3, "remove": 2, "turn_round": true})"), std::string::npos)
      << written->bytes;
}

TEST(HardCase, ATranslatedLevelIsOneAsWell) {
  const auto error_of = [](const std::string& by) {
    const auto hard =
        hard_case_of(level_with(case_text(R"(,"checks":[{"measure":"translate",)" + by + "}]")));
    return hard ? std::string("none") : hard.error().place + " " + hard.error().message;
  };
  EXPECT_EQ(error_of(R"("x":800,"y":16)"), "none");
  EXPECT_EQ(
      error_of(R"("x":480000,"y":480000)"),
      "key hard_case.checks[0] moves the level by 60000x60000 tiles, which makes it larger than a level "
      "may be");
  EXPECT_EQ(error_of(R"("x":4)"), "key hard_case.checks[0].x must be whole tiles to move by, 0 or more");
  EXPECT_EQ(error_of(R"("y":-8)"), "key hard_case.checks[0].y must be whole tiles to move by, 0 or more");
}

TEST(CaseFloor, IsHighestAtAnEndOrAtACrestBetween) {
  CaseFloor floor;
  floor.parts.emplace_back(Segment{{0, 20}, {10, 10}});
  EXPECT_EQ(floor.top(2, 6), 14);
  EXPECT_EQ(floor.top(8, 30), 10);
  EXPECT_FALSE(floor.top(11, 12));
  floor.parts = {Arc{{50, 100}, 10, 40, 60, true}};
  EXPECT_EQ(floor.top(44, 56), 90);
  EXPECT_EQ(floor.top(56, 60), 92);
  floor.parts = {Arc{{50, 100}, 10, 40, 60, false}};
  EXPECT_EQ(floor.top(44, 50), 108) << "a bowl is highest at a side";
  floor.parts = {Sine{0, 40, 8, 2, 16, 0}};
  EXPECT_EQ(floor.top(10, 14), 6);
  EXPECT_EQ(floor.top(0, 40), 6);
  EXPECT_EQ(floor.top(4, 4), 10);
  EXPECT_NEAR(*floor.top(13, 15), 8 + 2 * std::sin(13 * std::acos(-1.0) / 8), 1e-12);
}

// Measures a ball of the article that falls 8 px onto a floor, whatever the solver.
double measured(CaseCheck check) {
  Level level = level_of({"o..", "...", "###"});
  HardCase hard;
  hard.frames = 20;
  hard.floor.parts.emplace_back(Segment{{0, 16}, {24, 16}});
  hard.checks = {check};
  return run_hard_case(hard, level).value().at(0).measured;
}

CaseCheck check_of(CaseCheck::Measure measure) {
  CaseCheck check;
  check.measure = measure;
  return check;
}

TEST(HardCaseRun, MeasuresWhereABodyIs) {
  using M = CaseCheck::Measure;
  CaseCheck position = check_of(M::position);
  position.first = position.last = 1;
  position.y = 0;
  position.right = 8;
  EXPECT_EQ(measured(position), 0.375);
  CaseCheck velocity = check_of(M::velocity);
  velocity.first = velocity.last = 1;
  velocity.y = 1;
  EXPECT_EQ(measured(velocity), 0.625);
  EXPECT_EQ(measured(check_of(M::sink)), 0);
  EXPECT_EQ(measured(check_of(M::gap)), 7.625);
  CaseCheck reaches = check_of(M::reaches);
  reaches.x = 5;
  EXPECT_EQ(measured(reaches), 5);
  EXPECT_EQ(measured(check_of(M::walls)), 0);
  EXPECT_EQ(measured(check_of(M::energy)), 1) << "without gravity all that it has is new";
  CaseCheck untouched = check_of(M::untouched);
  untouched.first = 1;
  untouched.last = 6;  // it falls 0.375, 0.72, 1.04, 1.34, 1.62 and 1.87 px: 6.97 of 8
  EXPECT_EQ(measured(untouched), 6);
  CaseCheck normal = check_of(M::normal);
  normal.x = 1;
  normal.y = -1;
  EXPECT_NEAR(measured(normal), 45, 1e-12);
  normal.first = normal.last = 1;
  EXPECT_EQ(measured(normal), std::numeric_limits<double>::infinity());
  CaseCheck changes = check_of(M::changes);
  changes.first = 1;
  changes.last = 3;
  EXPECT_EQ(measured(changes), 2);
  EXPECT_EQ(measured(check_of(M::repeat)), 0);
  EXPECT_EQ(measured(check_of(M::mirror)), 0);
}

TEST(HardCaseRun, KeepsABoundedNumberOfBodies) {
  Level level = level_of({"o..", "...", "###"});
  level.spawns.resize(2999);
  HardCase hard;
  hard.frames = 1'000'000;
  hard.checks = {check_of(CaseCheck::Measure::position)};
  EXPECT_EQ(
      run_hard_case(hard, level).error(),
      "makes 1000000 frames of 3000 bodies, but all frames together may have at most 2097152 bodies and "
      "4194304 contacts");
}

// ---- Edits ----

TEST(HardCaseRun, EditsAreMadeInTheirFrameAlone) {
  State state;
  state.frame = 3;
  state.bodies.resize(2);
  state.bodies[0].id = 1;
  state.bodies[0].velocity = {1, -2};
  state.bodies[0].spin = 3;
  state.bodies[1].id = state.grabbed = 2;
  const std::vector<CaseEdit> edits = {
      {.frame = 2, .remove = 1}, {.frame = 3, .remove = 2, .turns_round = true}, {.frame = 4, .remove = 1}};
  make_edits(edits, state);
  ASSERT_EQ(state.bodies.size(), 1u);
  EXPECT_EQ(state.bodies[0].velocity, (Vec2{-1, 2}));
  EXPECT_EQ(state.bodies[0].spin, -3);
  EXPECT_EQ(state.grabbed, 0) << "what the mouse held is gone";
}

// Two balls fly to the right without gravity, by 1 and 2 px a frame.
Level two_flying() {
  Level level = open_level(0, 1);
  add_body(level, BodyKind::ball, {100, 40}, {1, 0});
  add_body(level, BodyKind::ball, {200, 80}, {2, 0});
  return level;
}

double measured(const Level& level, std::int64_t frames, std::vector<CaseEdit> edits, CaseCheck check) {
  HardCase hard;
  hard.frames = frames;
  hard.edits = std::move(edits);
  hard.checks = {check};
  return run_hard_case(hard, level).value().at(0).measured;
}

TEST(HardCaseRun, ABodyThatIsRemovedIsMeasuredAsItWasLast) {
  const Level level = two_flying();
  const std::vector<CaseEdit> edits = {{.frame = 3, .remove = 1}};
  using M = CaseCheck::Measure;
  CaseCheck first = check_of(M::position), second = first, further = check_of(M::further);
  first.x = 103;
  second.body = further.body = 2;
  second.x = 212;
  EXPECT_EQ(measured(level, 6, edits, first), 0);
  EXPECT_EQ(measured(level, 6, edits, second), 0);
  EXPECT_EQ(measured(level, 6, edits, further), 0);
  EXPECT_EQ(measured(level, 6, edits, check_of(M::untouched)), 6);
}

// In a level whose spawns are in reverse order the same body has another id.
TEST(HardCaseRun, EditsFindTheirBodyInEveryRun) {
  const std::vector<CaseEdit> edits = {{.frame = 0, .remove = 2}, {.frame = 3, .turns_round = true}};
  using M = CaseCheck::Measure;
  for (const M measure : {M::permute, M::repeat, M::mirror, M::translate})
    EXPECT_EQ(measured(two_flying(), 6, edits, check_of(measure)), 0) << static_cast<int>(measure);
}

TEST(HardCaseRun, WhatIsTurnedRoundGoesBack) {
  const Level level = two_flying();
  CaseCheck position = check_of(CaseCheck::Measure::position);
  position.x = 94;
  EXPECT_EQ(measured(level, 6, {{.frame = 0, .turns_round = true}}, position), 0);
  const CaseCheck returns = check_of(CaseCheck::Measure::returns);
  EXPECT_EQ(measured(level, 6, {{.frame = 3, .turns_round = true}}, returns), 0);
  EXPECT_EQ(measured(level, 6, {}, returns), 12) << "of the faster one";
}

TEST(HardCaseRun, RefusesToRemoveABodyThatIsNotThere) {
  const auto error_of = [](std::vector<CaseEdit> edits) {
    HardCase hard;
    hard.frames = 6;
    hard.edits = std::move(edits);
    hard.checks = {check_of(CaseCheck::Measure::position)};
    return run_hard_case(hard, two_flying()).error();
  };
  EXPECT_EQ(error_of({{.frame = 1, .remove = 3}}), "removes body 3, but the level has 2");
  EXPECT_EQ(error_of({{.frame = 1, .remove = 2}, {.frame = 2, .remove = 2}}), "removes body 2 twice");
}

// A box of mass 1 hits one of mass 3 that is at rest. Without bounce a quarter of the energy is left.
TEST(HardCaseRun, TotalEnergyIsThatOfAllMasses) {
  const CaseCheck total = check_of(CaseCheck::Measure::total_energy);
  for (const double bounce : {0.0, 1.0}) {
    Level level = open_level(0, bounce);
    add_body(level, BodyKind::ball, {100, 40}, {4, 0});
    add_body(level, BodyKind::ball, {120, 40}, {}, {24, 8});
    EXPECT_NEAR(measured(level, 10, {}, total), bounce == 0 ? 0.75 : 0, 1e-12);
  }
  Level falling = open_level(0.25, 1);
  add_body(falling, BodyKind::ball, {100, 40}, {1, 0});
  add_body(falling, BodyKind::marble, {200, 40}, {}, {24, 24});
  EXPECT_NEAR(measured(falling, 10, {}, total), 0, 1e-12) << "what the fall gives was there as height";
}

TEST(HardCaseRun, ACheckOfAMissingBodyFails) {
  CaseCheck other = check_of(CaseCheck::Measure::sink);
  other.body = 2;
  EXPECT_EQ(measured(other), std::numeric_limits<double>::infinity());
  EXPECT_EQ(measured(check_of(CaseCheck::Measure::reaches)), std::numeric_limits<double>::infinity());
}

}  // namespace talus::hard_case_test
