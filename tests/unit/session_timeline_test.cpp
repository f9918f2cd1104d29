// Session: moving about in a recording, running it again, and recordings as files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ball_room.h"
#include "edit/level_settings.h"
#include "edit/map_resize.h"
#include "edit/map_stroke.h"
#include "folder_test.h"
#include "session/session.h"

namespace talus::session_timeline_test {

namespace act = action;

constexpr double kFrame = 1.0 / kStepsPerSecond;

// A ball high above a floor, and a player on the floor.
Level playground() {
  Level level = ball_room();
  Spawn player;
  player.position = {120, 88};
  player.kind = BodyKind::player;
  level.spawns.push_back(player);
  return level;
}

class SessionTimeline : public FolderTest {
 protected:
  void steps(int count) {
    for (int i = 0; i < count; ++i) session_.apply(act::StepFrame{});
  }
  void run_again() {
    while (timeline().behind()) session_.advance(kFrame);
  }
  void paint(Cell cell, TileNumber tile = kRoomSolid, int stroke = 0) {
    session_.apply(act::EditLevel{paint_stamp(session_.level(), cell, {1, 1, {tile}}), stroke});
  }
  std::int64_t frame() const { return session_.state().frame; }
  const Timeline& timeline() const { return session_.timeline(); }
  std::string message() const { return session_.message() ? session_.message()->text : ""; }

  Session session_{playground()};
};

TEST_F(SessionTimeline, StepsBackAndForth) {
  steps(10);
  const State last = session_.state();
  session_.apply({act::StepBack{}, act::StepBack{}});
  EXPECT_EQ(frame(), 8);
  EXPECT_EQ(session_.record().paths[0].to, session_.state().bodies[0].box);
  steps(2);
  EXPECT_EQ(session_.state(), last);
  EXPECT_EQ(timeline().branches().size(), 1u) << "what is recorded was shown, not played anew";
  EXPECT_EQ(timeline().last_frame(), 10);
  steps(1);
  EXPECT_EQ(timeline().last_frame(), 11);
}

TEST_F(SessionTimeline, SeekingPausesAndIsClamped) {
  session_.apply(act::Play{});
  session_.advance(20.1 * kFrame);
  session_.apply(act::SeekFrame{5});
  EXPECT_FALSE(session_.playback().running);
  EXPECT_EQ(frame(), 5);
  session_.apply(act::SeekEnd{});
  EXPECT_EQ(frame(), 20);
  session_.apply(act::SeekStart{});
  EXPECT_EQ(frame(), 0);
  session_.apply(act::StepBack{});
  EXPECT_EQ(frame(), 0);
  session_.apply(act::SeekFrame{1'000'000});
  EXPECT_EQ(frame(), 20);
}

TEST_F(SessionTimeline, PlayingInThePastReplaysAndThenAppends) {
  steps(30);
  session_.apply({act::SeekFrame{10}, act::Play{}});
  session_.advance(15 * kFrame);
  EXPECT_EQ(frame(), 25);
  EXPECT_EQ(timeline().last_frame(), 30);
  session_.advance(15 * kFrame);
  EXPECT_EQ(frame(), 40);
  EXPECT_EQ(timeline().last_frame(), 40);
  EXPECT_EQ(timeline().branches().size(), 1u);
}

TEST_F(SessionTimeline, AKeyInThePastTakesOver) {
  steps(30);
  session_.apply({act::SeekFrame{10}, act::HoldKeys{.right = true}, act::Play{}});
  session_.advance(3 * kFrame);
  EXPECT_EQ(frame(), 13);
  ASSERT_EQ(timeline().branches().size(), 2u);
  EXPECT_EQ(timeline().last_frame(), 13);
  EXPECT_EQ(timeline().current().fork, 10);
  EXPECT_GT(session_.state().bodies[1].velocity.x, 0);
  session_.apply({act::HoldKeys{}, act::SwitchBranch{timeline().branches()[0].id}});
  EXPECT_EQ(timeline().last_frame(), 30);
  EXPECT_EQ(session_.state().bodies[1].velocity.x, 0);
}

TEST_F(SessionTimeline, TheMouseTakesOverAndItsDragIsRecorded) {
  steps(20);
  session_.apply({act::SeekFrame{4}, act::SelectBody{1}, act::HoldMouse{{300, 20}, true}});
  EXPECT_EQ(session_.state().grabbed, 1) << "shown at once";
  EXPECT_EQ(timeline().state().grabbed, 0) << "and true with the next step";
  steps(10);
  session_.apply(act::HoldMouse{{300, 20}, false});
  steps(10);
  const State end = session_.state();
  EXPECT_GT(end.bodies[0].box.x, 60);
  EXPECT_EQ(timeline().branches().size(), 2u);
  EXPECT_EQ(timeline().current().input(5).grab, 1);
  EXPECT_EQ(timeline().current().input(15).grab, 0);
  session_.apply({act::SeekStart{}, act::SeekEnd{}});
  EXPECT_EQ(session_.state(), end);
}

TEST_F(SessionTimeline, TakeOverCutsTheBranchAtTheShownFrame) {
  steps(20);
  session_.apply({act::SeekFrame{6}, act::TakeOver{}});
  EXPECT_EQ(timeline().last_frame(), 6);
  steps(1);
  EXPECT_EQ(timeline().last_frame(), 7);
  session_.apply(act::DropBranch{timeline().current().id});
  ASSERT_TRUE(session_.question()) << "what is dropped is gone for good";
  EXPECT_EQ(session_.question()->kind, Question::Kind::drop_branch);
  session_.apply(act::AnswerQuestion{act::Answer::cancel});
  EXPECT_EQ(timeline().branches().size(), 2u);
  session_.apply({act::DropBranch{timeline().current().id}, act::AnswerQuestion{act::Answer::discard}});
  EXPECT_EQ(timeline().branches().size(), 1u);
  EXPECT_EQ(timeline().last_frame(), 20);
}

TEST_F(SessionTimeline, ResettingKeepsTheOldBranch) {
  steps(20);
  session_.apply(act::ResetPlay{});
  EXPECT_EQ(frame(), 0);
  EXPECT_EQ(timeline().last_frame(), 0);
  ASSERT_EQ(timeline().branches().size(), 2u);
  session_.apply(act::ResetPlay{});
  EXPECT_EQ(timeline().branches().size(), 2u);
}

TEST_F(SessionTimeline, MarksCanBeJumpedTo) {
  steps(30);
  session_.apply({act::SetMark{10, "a"}, act::SetMark{20, "b"}, act::SetMark{20, "c"}, act::SeekFrame{15}});
  EXPECT_EQ(timeline().current().marks, (std::vector<Mark>{{10, "a"}, {20, "c"}}));
  session_.apply(act::JumpToMark{true});
  EXPECT_EQ(frame(), 20);
  session_.apply(act::JumpToMark{true});
  EXPECT_EQ(frame(), 20);
  session_.apply(act::JumpToMark{false});
  EXPECT_EQ(frame(), 10);
  session_.apply({act::RemoveMark{20}, act::JumpToMark{true}});
  EXPECT_EQ(frame(), 10);
}

TEST_F(SessionTimeline, AnEditContinuesFromHereByDefault) {
  steps(30);
  paint({2, 3});
  EXPECT_EQ(frame(), 30);
  EXPECT_EQ(timeline().branches().size(), 1u);
  EXPECT_EQ(timeline().current().chapters.size(), 2u);
  session_.apply(act::SeekFrame{10});
  paint({2, 4});
  EXPECT_EQ(timeline().branches().size(), 2u) << "in the past it makes a branch";
  EXPECT_EQ(timeline().last_frame(), 10);
  paint({2, 5});
  EXPECT_EQ(timeline().branches().size(), 2u);
}

TEST_F(SessionTimeline, AStrokeRunsAgainAndMakesOneBranch) {
  steps(120);
  const State before = session_.state();
  session_.apply(act::SetEditRule{{EditRule::Kind::from_start, 0}});
  const int old = timeline().current().id, stroke = session_.next_stroke();
  for (int x = 1; x < 5; ++x) {
    paint({x, 4}, kRoomSolid, stroke);
    session_.advance(0);
  }
  run_again();
  EXPECT_EQ(frame(), 120);
  EXPECT_EQ(timeline().branches().size(), 2u);
  EXPECT_EQ(timeline().current().chapters.size(), 1u);
  EXPECT_LE(session_.state().bodies[0].box.bottom(), 32);
  ASSERT_NE(timeline().compared(), nullptr);
  EXPECT_EQ(timeline().compared()->id, old);
  const auto parted = timeline().parting_frame();
  ASSERT_TRUE(parted);
  EXPECT_EQ(timeline().state_at(timeline().current(), *parted - 1),
            timeline().state_at(*timeline().find(old), *parted - 1));
  session_.apply(act::Undo{});
  run_again();
  EXPECT_EQ(timeline().parting_frame(), std::nullopt) << "the level is as it was, and so are the frames";
  EXPECT_EQ(session_.state(), before);
}

TEST_F(SessionTimeline, AnEditRunsAgainFromTheChosenFrame) {
  steps(60);
  session_.apply(act::SetEditRule{{EditRule::Kind::from_frame, 25}});
  paint({20, 5});
  run_again();
  EXPECT_EQ(timeline().current().chapters.size(), 2u);
  EXPECT_EQ(timeline().current().chapters[1].first, 25);
  EXPECT_EQ(timeline().last_frame(), 60);
}

TEST_F(SessionTimeline, TimeStandsStillDuringARerun) {
  steps(40);
  session_.apply({act::Play{}, act::Rerun{0}});
  EXPECT_TRUE(timeline().behind());
  session_.advance(10);
  run_again();
  EXPECT_EQ(frame(), 40);
  EXPECT_TRUE(session_.playback().running);
  session_.advance(2 * kFrame);
  EXPECT_EQ(frame(), 42);
}

TEST_F(SessionTimeline, ARerunCanBeCancelled) {
  steps(40);
  session_.apply({act::Rerun{20}, act::CancelRerun{}});
  EXPECT_FALSE(timeline().behind());
  EXPECT_EQ(timeline().last_frame(), 19);
  EXPECT_EQ(timeline().branches().size(), 2u);
}

TEST_F(SessionTimeline, InputOfAFrameCanBeEdited) {
  steps(60);
  session_.apply(act::SetInput{11, 30, InputKey::right, true});
  run_again();
  EXPECT_EQ(frame(), 60);
  EXPECT_EQ(timeline().parting_frame(), 11);
  EXPECT_TRUE(timeline().current().input(30).right);
  EXPECT_FALSE(timeline().current().input(31).right);
  EXPECT_GT(session_.state().bodies[1].box.x, 120);
}

// Painting during play: a stroke is one branch, however many frames pass, and the next stroke is another
// branch.
TEST_F(SessionTimeline, EachStrokeDuringPlayMakesOneBranch) {
  steps(20);
  session_.apply({act::SetEditRule{{.kind = EditRule::Kind::from_start}}, act::Play{}});
  for (int stroke = 1; stroke <= 2; ++stroke) {
    for (int x = 0; x < 5; ++x) {
      paint({10 + x, 8 + stroke}, kRoomSolid, stroke);
      run_again();
      session_.advance(2.5 * kFrame);
    }
    EXPECT_EQ(timeline().branches().size(), 1u + static_cast<std::size_t>(stroke));
  }
  EXPECT_GT(timeline().branches()[1].last_frame(), 20) << "what was played before the second stroke is kept";
  session_.apply(act::Undo{});
  EXPECT_EQ(timeline().branches().size(), 4u);
}

TEST_F(SessionTimeline, TrailsFollowTheBodyStepByStep) {
  steps(50);
  session_.take_time();
  const auto trail = session_.trail(timeline().current(), 1, 10, 50);
  ASSERT_EQ(trail.size(), 41u);
  EXPECT_EQ(trail.front().frame, 10);
  EXPECT_EQ(trail.back().box, session_.state().bodies[0].box);
  steps(1);
  const std::int64_t before = timeline().steps_again();
  EXPECT_EQ(session_.trail(timeline().current(), 1, 11, 51).size(), 41u);
  EXPECT_LE(timeline().steps_again() - before, 1);
  EXPECT_EQ(session_.trail(timeline().current(), 1, -5, 1'000'000).size(), 52u);
  EXPECT_TRUE(session_.trail(timeline().current(), 77, 0, 50).empty());
  for (int i = 0; i < 700; ++i) session_.apply(act::StepFrame{});
  EXPECT_EQ(session_.trail(timeline().current(), 1, 0, 751).size(), 600u) << "bounded";
}

TEST_F(SessionTimeline, ARecordingIsSavedAndOpened) {
  steps(20);
  paint({2, 4});
  session_.apply(act::HoldKeys{.right = true});
  steps(20);
  session_.apply(act::SetMark{7, "look"});
  const State end = session_.state();
  const Level level = session_.level();
  const std::string file = path("saved.talusrec");
  session_.apply(act::SaveRecording{file});
  EXPECT_EQ(message(), "Saved saved.talusrec, 40 frames.");
  EXPECT_FALSE(session_.message()->is_error);

  Session other;
  other.apply(act::OpenFile{file});  // its content says that it is a recording
  EXPECT_EQ(other.state().frame, 0);
  EXPECT_TRUE(other.timeline().behind());
  while (other.timeline().behind()) other.advance(kFrame);
  EXPECT_FALSE(other.message()) << other.message()->text;
  other.apply(act::SeekEnd{});
  EXPECT_EQ(other.state(), end);
  EXPECT_TRUE(other.level() == level);
  EXPECT_EQ(other.timeline().current().marks, (std::vector<Mark>{{7, "look"}}));
  other.apply(act::StepFrame{});
  EXPECT_EQ(other.timeline().current().chapters.size(), 2u) << "played on on the level that it ended with";
  EXPECT_EQ(other.file_name(), "saved.talusrec");
  EXPECT_EQ(other.path(), "") << "saving the level asks for a name";
}

TEST_F(SessionTimeline, ARecordingThatRunsDifferentlyIsReported) {
  steps(30);
  const std::string file = path("other.talusrec");
  session_.apply(act::SaveRecording{file});
  std::string text = bytes_of("other.talusrec");
  const std::size_t hash = text.find("\"hashes\"") + 20 + 17 * 5;
  text[hash] = text[hash] == '0' ? '1' : '0';
  put("other.talusrec", text);
  session_.apply(act::OpenFile{file});
  run_again();
  EXPECT_EQ(message(), "Frame 5 differs from the recording; later frames may differ, too.");
  EXPECT_TRUE(session_.message()->is_error);
}

TEST_F(SessionTimeline, ABadFileIsReportedAfterTheQuestion) {
  steps(3);
  paint({9, 9});
  const std::string file = put("bad.talusrec", "{\"talus_recording\": 1}");
  session_.apply(act::OpenFile{file});
  ASSERT_TRUE(session_.question());
  session_.apply(act::AnswerQuestion{act::Answer::discard});
  EXPECT_EQ(message(), file + ":key hashes: error: is missing");
  EXPECT_EQ(session_.level().map.at({9, 9}), kRoomSolid);
  EXPECT_EQ(timeline().last_frame(), 3);
  session_.apply(act::OpenFile{path("missing.talusrec")});
  session_.apply(act::AnswerQuestion{act::Answer::discard});
  EXPECT_THAT(message(), testing::HasSubstr("missing.talusrec"));
}

// Empty cells mean nothing to solvers without a ground of their own.
TEST_F(SessionTimeline, EmptyCellsOfAGrownMapCanBePainted) {
  Tuning tuning = session_.level().tuning;
  tuning.solver = SolverKind::article;
  session_.apply(act::EditLevel{set_tuning(session_.level(), tuning)});
  session_.apply(act::EditLevel{resize_map(session_.level(), {.width = 60, .height = 40}, std::nullopt)});
  paint({55, 35});
  EXPECT_EQ(session_.level().map.at({55, 35}), kRoomSolid);
  const Branch& branch = timeline().current();
  EXPECT_EQ(branch.chapters.back().version->layers[0].rows.size(), 40u);
  EXPECT_EQ(branch.chapters.back().version->layers[0].rows[35].at(55).tile, kRoomSolid);
}

}  // namespace talus::session_timeline_test
