// What of the runs the user has made by hand is asked about before it is lost, and saved by itself.
#include <gtest/gtest.h>

#include "folder_test.h"
#include "formats/recording.h"
#include "platform/autosave.h"
#include "slope_level.h"

namespace talus::session_runs_test {

namespace act = action;

class SessionRuns : public FolderTest {
 protected:
  void SetUp() override { play(session_, 20); }

  static Level level() { return slope_level({"o.....", "......", "...ab#", "######"}); }
  static void play(Session& session, int frames) {
    for (int i = 0; i < frames; ++i) session.apply(act::StepFrame{});
  }
  static void run_again(Session& session) {
    for (int i = 0; i < 1000 && session.timeline().behind(); ++i) session.advance(0.01);
    ASSERT_FALSE(session.timeline().behind());
  }
  void answer(act::Answer answer) { session_.apply(act::AnswerQuestion{answer}); }

  Session session_{level(), "", "slopes"};
};

TEST_F(SessionRuns, WhatWasOnlyPlayedIsNotAskedAbout) {
  session_.apply(act::SeekFrame{5});
  session_.apply(act::TakeOver{});
  play(session_, 5);
  EXPECT_EQ(session_.unsaved_run(), nullptr);
  session_.apply(act::NewLevel{});
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(session_.timeline().last_frame(), 0);
}

TEST_F(SessionRuns, AMarkIsAskedAboutAndKept) {
  session_.apply(act::SetMark{7, "sticks"});
  ASSERT_NE(session_.unsaved_run(), nullptr);
  session_.apply(act::Quit{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unsaved_run);
  EXPECT_EQ(session_.question()->text,
            "Keep the recording of run 1?\nIt has marks or inputs of yours, and is in no file yet.");
  answer(act::Answer::cancel);
  EXPECT_FALSE(session_.wants_quit());
  session_.apply(act::Quit{});
  answer(act::Answer::save);
  EXPECT_TRUE(session_.wants_save_recording());
  EXPECT_FALSE(session_.wants_quit());
  session_.apply(act::SaveRecording{path("run.talusrec")});
  EXPECT_TRUE(session_.wants_quit());
  EXPECT_FALSE(session_.wants_save_recording());
  const auto saved = load_recording(path("run.talusrec"));
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->frames, 20);
  EXPECT_EQ(saved->marks, (std::vector<Mark>{{7, "sticks"}}));
}

TEST_F(SessionRuns, ARemovedMarkIsNothingToKeep) {
  session_.apply(act::SetMark{7, "sticks"});
  session_.apply(act::RemoveMark{3});
  EXPECT_NE(session_.unsaved_run(), nullptr) << "another frame";
  session_.apply(act::RemoveMark{7});
  EXPECT_EQ(session_.unsaved_run(), nullptr);
}

TEST_F(SessionRuns, InputsSetByHandAreAskedAboutRunByRun) {
  session_.apply(act::SetInput{3, 6, InputKey::left, false});
  EXPECT_EQ(session_.unsaved_run(), nullptr) << "it was not held before";
  session_.apply(act::SetMark{7, "sticks"});
  session_.apply(act::SetInput{3, 6, InputKey::left, true});
  run_again(session_);
  ASSERT_NE(session_.unsaved_run(), nullptr);
  EXPECT_EQ(session_.unsaved_run()->id, 2);
  session_.apply(act::SwitchBranch{1});
  session_.apply(act::NewLevel{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.timeline().current().id, 2) << "what is asked about is shown";
  answer(act::Answer::discard);
  ASSERT_TRUE(session_.question()) << "the run with the mark";
  EXPECT_EQ(session_.timeline().current().id, 1);
  answer(act::Answer::discard);
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(session_.timeline().last_frame(), 0) << "a new level";
}

TEST_F(SessionRuns, TheLevelIsAskedAboutFirst) {
  session_.apply(act::EditLevel{paint_stamp(session_.level(), {5, 1}, {1, 1, {1}}), 0});
  session_.apply(act::SetMark{7, "sticks"});
  session_.apply(act::Quit{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unsaved_changes);
  answer(act::Answer::discard);
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unsaved_run);
  answer(act::Answer::discard);
  EXPECT_TRUE(session_.wants_quit());
}

TEST_F(SessionRuns, SavedByItselfAndRecovered) {
  session_.apply(act::SetMark{7, "sticks"});
  ASSERT_FALSE(session_.modified());
  {
    Autosave autosave(path("state"));
    EXPECT_FALSE(autosave.follow(session_, 0));
    EXPECT_EQ(autosave.due(), Autosave::kDelay);
    ASSERT_TRUE(autosave.save_now(session_));
  }
  const auto left = Autosave(path("state")).left_behind();
  ASSERT_EQ(left.size(), 1u);
  ASSERT_NE(left[0].recording, nullptr);
  EXPECT_EQ(left[0].recording->frames, 20);
  Session next;
  next.apply(act::RecoverLevel{left[0].level, left[0].path, left[0].name, left[0].recording});
  run_again(next);
  EXPECT_EQ(next.level().map, session_.level().map);
  EXPECT_EQ(next.timeline().last_frame(), 20);
  EXPECT_EQ(next.timeline().current().marks, (std::vector<Mark>{{7, "sticks"}}));
  EXPECT_EQ(next.timeline().branches().size(), 1u);
  next.apply(act::SeekEnd{});
  EXPECT_EQ(next.state(), session_.state());
  next.apply(act::NewLevel{});
  EXPECT_TRUE(next.question()) << "it is in no file yet";
}

TEST_F(SessionRuns, WhatIsNotMarkedIsNotSavedByItself) {
  Autosave autosave(path("state"));
  for (int second = 0; second < 20; ++second) EXPECT_FALSE(autosave.follow(session_, second));
  EXPECT_FALSE(exists("state"));
}

}  // namespace talus::session_runs_test
