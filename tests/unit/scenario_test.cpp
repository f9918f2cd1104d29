// Scenarios: what is answered, what is refused, and which files are no scenarios.
#include "formats/native/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace talus::scenario_test {

using testing::ElementsAre;

std::vector<std::string> replay(const std::string& ops) {
  std::vector<std::string> answers;
  const auto replayed =
      replay_scenario("{\"cell_size\":8,\"ops\":[" + ops + "]}", [&](std::string_view line) {
        answers.emplace_back(line);
        return true;
      });
  if (!replayed) answers.push_back(replayed.error().place + ": " + replayed.error().message);
  return answers;
}

const std::string kBall = R"({"op":"add","item":1,"rect":[0,0,8,8]},)";
const std::string kWall = R"({"op":"add","item":7,"rect":[12,0,8,8]},)";
const std::string kOk = R"({"ok":true})";

TEST(Replay, AnswersEveryOperationWithALine) {
  EXPECT_THAT(replay(kBall + kWall + R"({"op":"move","item":1,"goal":[20,0.5],"filter":{"7":"slide"}},
                                {"op":"getRect","item":1},{"op":"toCell","point":[-1,9]},
                                {"op":"queryRect","rect":[0,0,40,40]},{"op":"queryPoint","point":[13,1]},
                                {"op":"querySegment","from":[0,2],"to":[40,2]},
                                {"op":"querySegmentWithCoords","from":[10,2],"to":[26,2]},
                                {"op":"update","item":1,"rect":[1,2]},{"op":"getRect","item":1},
                                {"op":"remove","item":1},{"op":"queryRect","rect":[0,0,40,40]})"),
              ElementsAre(kOk, kOk,
                          R"({"x":4,"y":0.5,"cols":[{"other":7,"type":"slide","overlaps":false,"ti":0.2,)"
                          R"("move":[20,0.5],"normal":[-1,0],"touch":[4,0.1],"slide":[4,0.5]}]})",
                          R"({"rect":[4,0.5,8,8]})", R"({"cell":[0,2]})", R"({"items":[1,7]})",
                          R"({"items":[7]})", R"({"items":[1,7]})",
                          R"({"items":[{"item":1,"ti1":0,"ti2":0.125,"x1":10,"y1":2,"x2":12,"y2":2},)"
                          R"({"item":7,"ti1":0.125,"ti2":0.625,"x1":12,"y1":2,"x2":20,"y2":2}]})",
                          kOk, R"({"rect":[1,2,8,8]})", kOk, R"({"items":[7]})"));
}

TEST(Replay, AnswersWithTheErrorsOfTheWorld) {
  EXPECT_THAT(replay(kBall + kBall + R"({"op":"add","item":2,"rect":[0,0,0,5]},
                       {"op":"add","item":2,"rect":[null,0,4,5]},{"op":"add","item":2,"rect":[0,"a",4,5]},
                       {"op":"add","item":2,"rect":[0,0,4]},{"op":"add","item":2,"rect":[0,0,true,4]},
                       {"op":"getRect","item":2})"),
              ElementsAre(kOk, R"j({"error":"Item 1 added to the world twice."})j",
                          R"j({"error":"w must be a positive integer, but was 0(number)"})j",
                          R"j({"error":"x must be a number, but was nil(a nil)"})j",
                          R"j({"error":"y must be a number, but was a(a string)"})j",
                          R"j({"error":"h must be a positive integer, but was nil(nil)"})j",
                          R"j({"error":"w must be a positive integer, but was true(boolean)"})j",
                          R"j({"error":"Item 2 must be added to the world before getting its rect. )j"
                          R"j(Use world:add(item, x,y,w,h) to add it first."})j"));
}

TEST(Replay, ReportsAnUnknownResponseWhenItIsReached) {
  EXPECT_THAT(replay(kBall + kWall + R"({"op":"move","item":1,"goal":[1,0],"filter":{"default":"foo"}},
                       {"op":"move","item":1,"goal":[20,0],"filter":{"default":"foo"}},{"op":"getRect","item":1},
                       {"op":"move","item":1,"goal":[20,0],"filter":{"default":"foo","7":null}})"),
              ElementsAre(kOk, kOk, R"({"x":1,"y":0,"cols":[]})",
                          R"j({"error":"Unknown collision type: foo (string)"})j", R"({"rect":[1,0,8,8]})",
                          R"({"x":20,"y":0,"cols":[]})"));
}

// More than the world can name.
TEST(Replay, UnknownResponsesAreAnyNumber) {
  std::string filter = "\"7\":\"last\"";
  for (int i = 8; i < 65'550; ++i) {
    const std::string number = std::to_string(i);
    filter.append(",\"").append(number).append("\":\"").append(number).append("\"");
  }
  EXPECT_THAT(replay(kBall + kWall + R"({"op":"check","item":1,"goal":[20,0],"filter":{)" + filter + "}}"),
              ElementsAre(kOk, kOk, R"j({"error":"Unknown collision type: last (string)"})j"));
}

TEST(Replay, AllOperationsTogetherAreBounded) {
  std::vector<std::string> answers;
  const auto replayed = replay_scenario(
      R"({"cell_size":1,"ops":[{"op":"add","item":1,"rect":[0,0,30,30]},{"op":"move","item":1,"goal":[90,0]},
          {"op":"move","item":1,"goal":[0,0]},{"op":"move","item":1,"goal":[90,0]}]})",
      [&](std::string_view line) { return answers.emplace_back(line), true; }, /*most_looks=*/2500);
  ASSERT_FALSE(replayed);
  EXPECT_EQ(replayed.error().place, "op 2");
  EXPECT_EQ(replayed.error().message, "The operations up to here test more than 2500 cells and boxes.");
  EXPECT_EQ(answers.size(), 2u);
}

TEST(Replay, ErrorsHaveNoCharactersThatMoveText) {
  EXPECT_THAT(replay("{\"op\":\"add\",\"item\":1,\"rect\":[\"\xc2\x9b\xe2\x80\xae\\u001b\",1,1,1]}"),
              ElementsAre(R"j({"error":"x must be a number, but was \u009b\u202e\u001b(a string)"})j"));
}

// A missing goal stands for the old place. Then only a response that sets the goal lets the move succeed.
TEST(Replay, AcceptsAMissingGoal) {
  EXPECT_THAT(
      replay(kBall + R"({"op":"check","item":1,"goal":[null,3]},{"op":"move","item":1,"goal":[null,3]},
                       {"op":"getRect","item":1},{"op":"add","item":2,"rect":[0,10,8,8]},
                       {"op":"move","item":1,"goal":[null,3]})"),
      ElementsAre(kOk, R"({"x":null,"y":3,"cols":[]})",
                  R"j({"error":"x must be a number, but was nil(a nil)"})j", R"({"rect":[0,0,8,8]})", kOk,
                  R"({"x":0,"y":2,"cols":[{"other":2,"type":"slide","overlaps":false,)"
                  R"("ti":0.6666666666666666,"move":[0,3],"normal":[0,-1],"touch":[0,2],"slide":[0,2]}]})"));
}

// All answers together could be larger than the memory.
TEST(Replay, GivesEachAnswerAtOnceUntilItIsStopped) {
  EXPECT_THAT(replay(kBall + "5"), ElementsAre(kOk, "op 2: An operation must be an object."));
  int given = 0;
  const auto replayed =
      replay_scenario(R"({"ops":[)" + kBall + kWall + "5]}", [&](std::string_view) { return ++given < 2; });
  EXPECT_TRUE(replayed) << "what follows is not looked at";
  EXPECT_EQ(given, 2);
}

TEST(Replay, ErrorsNameThePlaceInTheScenario) {
  const auto error = [](std::string_view text) {
    const auto replayed = replay_scenario(text, [](std::string_view) { return true; });
    return replayed ? "none" : replayed.error().place + ": " + replayed.error().message;
  };
  EXPECT_EQ(error("{\"ops\":["), "line 1, column 9: this is not valid JSON");
  EXPECT_EQ(error("[]"), ": A scenario must be an object.");
  EXPECT_EQ(error("{}"), ": \"ops\" is missing.");
  EXPECT_EQ(error(R"({"ops":4})"), ": \"ops\" must be an array.");
  EXPECT_EQ(error(R"({"ops":[],"cell_size":0})"), ": cellSize must be a positive integer, but was 0(number)");
  EXPECT_EQ(error(R"({"ops":[],"cell_size":"8"})"), ": \"cell_size\" must be a number.");
  EXPECT_EQ(error(R"({"ops":[{"op":"toCell","point":[1,2]},5]})"), "op 2: An operation must be an object.");
  EXPECT_EQ(error(R"({"ops":[{"op":"fly"}]})"), "op 1: Unknown operation \"fly\".");
  EXPECT_EQ(error(R"({"ops":[{"op":"add","item":1}]})"), "op 1: \"rect\" is missing.");
  EXPECT_EQ(error(R"({"ops":[{"op":"getRect"}]})"), "op 1: \"item\" is missing.");
  EXPECT_EQ(error(R"({"ops":[{"op":"getRect","item":"a"}]})"), "op 1: \"item\" must be an integer.");
  EXPECT_EQ(error(R"({"ops":[{"op":"toCell","point":[1]}]})"),
            "op 1: \"point\" must be an array of 2 numbers.");
  EXPECT_EQ(error(R"({"ops":[{"op":"queryRect","rect":[1,2,3,4,5]}]})"),
            "op 1: \"rect\" must be an array of 4 numbers.");
  EXPECT_EQ(error(R"({"ops":[]})"), "none");
}

}  // namespace talus::scenario_test
