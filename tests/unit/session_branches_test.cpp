// Branches that the user has worked on: which are asked about before they are lost, and which are saved
// automatically.
#include <gtest/gtest.h>

#include "edit/map_stroke.h"
#include "folder_test.h"
#include "formats/native/recording_file.h"
#include "platform/autosave.h"
#include "slope_level.h"

namespace talus::session_branches_test {

namespace act = action;

class SessionBranches : public FolderTest {
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
  SavedWork saved_by_itself(const Session& session, const std::string& folder) const {
    EXPECT_TRUE(Autosave(path(folder)).save_now(session));
    return Autosave(path(folder)).left_behind().at(0);
  }
  static void recover(Session& session, const SavedWork& work) {
    session.apply(act::RecoverLevel{work.level, work.path, work.name, work.recordings});
  }
  void answer(act::Answer answer) { session_.apply(act::AnswerQuestion{answer}); }

  Session session_{level(), "", "slopes"};
};

TEST_F(SessionBranches, AMerePlaythroughIsNotAskedAbout) {
  session_.apply(act::SeekFrame{5});
  session_.apply(act::TakeOver{});
  play(session_, 5);
  EXPECT_TRUE(session_.unsaved_branches().empty());
  session_.apply(act::NewLevel{});
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(session_.timeline().last_frame(), 0);
}

TEST_F(SessionBranches, AMarkIsAskedAboutAndKept) {
  session_.apply(act::SetMark{7, "sticks"});
  ASSERT_FALSE(session_.unsaved_branches().empty());
  session_.apply(act::Quit{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unsaved_branch);
  EXPECT_EQ(
      session_.question()->text,
      "Keep the recording of branch 1?\nIt has marks or inputs of yours, and is not saved in a file yet.");
  answer(act::Answer::cancel);
  EXPECT_FALSE(session_.wants_quit());
  session_.apply(act::Quit{});
  answer(act::Answer::save);
  EXPECT_TRUE(session_.wants_save_recording());
  EXPECT_FALSE(session_.wants_quit());
  session_.apply(act::SaveRecording{path("branch.talusrec")});
  EXPECT_TRUE(session_.wants_quit());
  EXPECT_FALSE(session_.wants_save_recording());
  const auto saved = load_recording(path("branch.talusrec"));
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->frames, 20);
  EXPECT_EQ(saved->marks, (std::vector<Mark>{{7, "sticks"}}));
}

TEST_F(SessionBranches, ARemovedMarkIsNotAskedAbout) {
  session_.apply(act::SetMark{7, "sticks"});
  session_.apply(act::RemoveMark{3});
  EXPECT_FALSE(session_.unsaved_branches().empty()) << "another frame";
  session_.apply(act::RemoveMark{7});
  EXPECT_TRUE(session_.unsaved_branches().empty());
}

TEST_F(SessionBranches, EachBranchWithInputsByHandIsAskedAbout) {
  session_.apply(act::SetInput{3, 6, InputKey::left, false});
  EXPECT_TRUE(session_.unsaved_branches().empty()) << "it was not held before";
  session_.apply(act::SetMark{7, "sticks"});
  session_.apply(act::SetInput{3, 6, InputKey::left, true});
  run_again(session_);
  ASSERT_FALSE(session_.unsaved_branches().empty());
  EXPECT_EQ(session_.unsaved_branches().back()->id, 2);
  session_.apply(act::SwitchBranch{1});
  session_.apply(act::NewLevel{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.timeline().current().id, 2) << "what is asked about is shown";
  answer(act::Answer::discard);
  ASSERT_TRUE(session_.question()) << "the branch with the mark";
  EXPECT_EQ(session_.timeline().current().id, 1);
  answer(act::Answer::discard);
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(session_.timeline().last_frame(), 0) << "a new level";
}

TEST_F(SessionBranches, TheLevelIsAskedAboutFirst) {
  session_.apply(act::EditLevel{paint_stamp(session_.level(), {5, 1}, {1, 1, {1}}), 0});
  session_.apply(act::SetMark{7, "sticks"});
  session_.apply(act::Quit{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unsaved_changes);
  answer(act::Answer::discard);
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::unsaved_branch);
  answer(act::Answer::discard);
  EXPECT_TRUE(session_.wants_quit());
}

TEST_F(SessionBranches, AreSavedAutomaticallyAndRecovered) {
  session_.apply(act::SetMark{7, "sticks"});
  ASSERT_FALSE(session_.modified());
  {
    Autosave autosave(path("followed"));
    EXPECT_FALSE(autosave.follow(session_, 0));
    EXPECT_EQ(autosave.due(), Autosave::kDelay);
  }
  const SavedWork left = saved_by_itself(session_, "state");
  ASSERT_EQ(left.recordings.size(), 1u);
  EXPECT_EQ(left.recordings[0]->frames, 20);
  Session next;
  recover(next, left);
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

TEST_F(SessionBranches, UnrunBranchesAreSavedAndRecovered) {
  session_.apply(act::SetMark{7, "sticks"});
  session_.apply(act::SetInput{3, 6, InputKey::left, true});
  run_again(session_);
  Session first, second;
  recover(first, saved_by_itself(session_, "first"));
  recover(second, saved_by_itself(first, "second"));  // before any of its branches was run
  ASSERT_EQ(second.timeline().branches().size(), 2u);
  run_again(second);
  EXPECT_EQ(second.timeline().last_frame(), 20);
  EXPECT_TRUE(second.timeline().current().input(5).left);
  EXPECT_EQ(second.timeline().current().hashes[20], session_.timeline().current().hashes[20]);
  second.apply(act::SwitchBranch{second.timeline().branches()[0].id});
  run_again(second);
  EXPECT_EQ(second.timeline().current().marks, (std::vector<Mark>{{7, "sticks"}}));
  EXPECT_FALSE(second.timeline().current().input(5).left);
  EXPECT_EQ(second.timeline().last_frame(), 20);
}

TEST_F(SessionBranches, BranchesWithoutMarksAreNotSaved) {
  Autosave autosave(path("state"));
  for (int second = 0; second < 20; ++second) EXPECT_FALSE(autosave.follow(session_, second));
  EXPECT_FALSE(exists("state"));
}

}  // namespace talus::session_branches_test
