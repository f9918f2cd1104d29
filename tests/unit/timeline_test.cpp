// Timeline: every frame of a recording is reproduced, forwards and backwards; branches, edits, reruns and the
// budget.
#include "sim/timeline.h"

#include <gtest/gtest.h>

#include "level_picture.h"
#include "sim/frame_hash.h"

namespace talus::timeline_test {

// A room with slopes, two balls and a player, for any solver.
Level room(SolverKind solver) {
  Level level = level_of({"#..........................#", "#..o.......................#",
                          "#......o...................#", "#..........................#",
                          "#................/-........#", "#..............#####.......#",
                          "#.../-\\-...................#", "############################"});
  level.tuning.solver = solver;
  Spawn player;
  player.position = {80, 40};
  player.kind = BodyKind::player;
  level.spawns.push_back(player);
  return level;
}

Level with_tile(Level level, Cell cell, TileNumber tile) {
  level.map.set(cell, tile);
  return level;
}

// The input of a user who runs to and fro, jumps, and throws the first ball about.
Input input_at(std::int64_t frame) {
  Input input;
  input.right = frame % 90 < 50;
  input.left = frame % 90 > 60;
  input.jump = frame % 37 < 5;
  input.mouse_down = frame % 120 > 80;
  if (input.mouse_down) input.mouse = {30.0 + static_cast<double>(frame % 50), 20};
  if (input.mouse_down && frame % 240 > 120) input.grab = 2;
  return input;
}

class TimelineOf : public testing::TestWithParam<SolverKind> {
 protected:
  // Plays with edits on the way: of single cells, of the tuning, of the list of bodies.
  void play(Timeline& timeline, std::int64_t frames) {
    Level level = room(GetParam());
    for (std::int64_t frame = 1; frame <= frames; ++frame) {
      if (frame == 50) timeline.edit(level = with_tile(level, {9, 5}, 1));
      if (frame == 51) timeline.edit(level = with_tile(level, {3, 1}, 0));  // the first ball goes
      if (frame == 130) level.tuning.shared.floor_bounce = 0.5;
      if (frame == 131) level.spawns.insert(level.spawns.begin(), Spawn{"", {150, 8}, {1, 0}, ""});
      if (frame == 130 || frame == 131) timeline.edit(level);
      timeline.step(input_at(frame));
      states_.push_back(timeline.state());
    }
  }

  std::vector<State> states_ = {initial_state(compile_scene(room(GetParam())))};
};

INSTANTIATE_TEST_SUITE_P(Solvers, TimelineOf, testing::ValuesIn(solver_kinds().begin(), solver_kinds().end()),
                         [](const auto& solver) { return std::string(solver_name(solver.param)); });

TEST_P(TimelineOf, RecordingChangesNothing) {
  Timeline timeline(room(GetParam()));
  const auto scene = std::make_shared<const Scene>(compile_scene(room(GetParam())));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  for (std::int64_t frame = 1; frame <= 300; ++frame) {
    timeline.step(input_at(frame));
    solver->step(state, input_at(frame));
    ASSERT_EQ(timeline.state(), state) << frame;
  }
}

TEST_P(TimelineOf, EveryFrameIsReproducedInBothDirections) {
  Timeline timeline(room(GetParam()));
  play(timeline, 300);
  const auto expect_same = [&](std::int64_t frame) {
    timeline.seek(frame);
    ASSERT_EQ(timeline.frame(), frame);
    // The states were noted right after their step. Edits of these frames came later.
    if (frame != 49 && frame != 50 && frame != 129 && frame != 130) {
      ASSERT_EQ(timeline.state(), states_[static_cast<std::size_t>(frame)]) << frame;
    }
    ASSERT_EQ(frame_hash(timeline.state()), timeline.current().hashes[static_cast<std::size_t>(frame)])
        << frame;
  };
  for (std::int64_t frame = 0; frame <= 300; ++frame) expect_same(frame);
  for (std::int64_t frame = 300; frame >= 0; --frame) expect_same(frame);
  EXPECT_EQ(timeline.branches().size(), 1u);
}

TEST_P(TimelineOf, RecordsAreReproduced) {
  Timeline timeline(room(GetParam()));
  std::vector<StepRecord> records(1);
  for (std::int64_t frame = 1; frame <= 100; ++frame) {
    timeline.step(input_at(frame));
    records.push_back(timeline.record());
  }
  for (std::int64_t frame = 100; frame >= 0; --frame) {
    timeline.seek(frame);
    const StepRecord& expected = records[static_cast<std::size_t>(frame)];
    for (const StepRecord& record : {timeline.record(), timeline.record_at(timeline.current(), frame)}) {
      ASSERT_EQ(record.paths.size(), expected.paths.size()) << frame;
      ASSERT_EQ(record.contacts.size(), expected.contacts.size()) << frame;
      for (std::size_t i = 0; i < expected.paths.size(); ++i) {
        EXPECT_EQ(record.paths[i].from, expected.paths[i].from);
        EXPECT_EQ(record.paths[i].to, expected.paths[i].to);
      }
      for (std::size_t i = 0; i < expected.contacts.size(); ++i)
        EXPECT_EQ(record.contacts[i].touch, expected.contacts[i].touch);
    }
  }
}

TEST_P(TimelineOf, ItsRecordingRunsAgain) {
  Timeline timeline(room(GetParam()));
  play(timeline, 200);
  timeline.set_mark(7, "here");
  const Recording recording = timeline.recording(timeline.current(), room(GetParam()));
  EXPECT_EQ(recording.frames, 200);
  EXPECT_EQ(recording.edits.size(), 4u);
  Timeline again(recording);
  EXPECT_TRUE(again.behind());
  while (again.behind()) again.catch_up(33);
  EXPECT_EQ(again.unexpected_frame(again.current()), std::nullopt);
  again.seek(200);
  EXPECT_EQ(again.state(), timeline.state());
  EXPECT_EQ(again.current().marks, (std::vector<Mark>{{7, "here"}}));
  EXPECT_EQ(again.scene(), timeline.scene());
}

TEST_P(TimelineOf, TheSameInputGivesTheSameFrames) {
  Timeline timeline(room(GetParam()));
  for (std::int64_t frame = 1; frame <= 150; ++frame) timeline.step(input_at(frame));
  timeline.rerun(0);
  while (timeline.behind()) timeline.catch_up(10);
  EXPECT_EQ(timeline.branches().size(), 2u);
  ASSERT_NE(timeline.compared(), nullptr);
  EXPECT_EQ(timeline.parting_frame(), std::nullopt);
  EXPECT_EQ(timeline.frame(), 150);
}

// A ball over a floor, whose top is 40 px below the ball's.
Level drop() { return level_of({"o....", ".....", ".....", ".....", ".....", "#####"}); }

Timeline& played(Timeline& timeline, std::int64_t frames) {
  for (std::int64_t i = 0; i < frames; ++i) timeline.step({});
  return timeline;
}

void finish(Timeline& timeline) {
  while (timeline.behind()) timeline.catch_up(100);
}

TEST(FrameHash, ChangesWithAnyBitOfTheState) {
  State state = initial_state(compile_scene(level_of({"oo"})));
  const std::uint64_t hash = frame_hash(state);
  State other = state;
  other.frame = 9;
  EXPECT_EQ(frame_hash(other), hash) << "the number of the frame is not part of the hash";
  for (double Rect::*number : {&Rect::x, &Rect::y}) {
    other = state;
    other.bodies[1].box.*number += 1e-9;
    EXPECT_NE(frame_hash(other), hash);
  }
  other = state;
  other.bodies[0].velocity.x = other.bodies[1].velocity.x = -0.0;
  EXPECT_NE(frame_hash(other), hash) << "two flipped signs do not cancel out";
  other = state;
  other.grabbed = 1;
  EXPECT_NE(frame_hash(other), hash);
  other = state;
  other.bodies.pop_back();
  EXPECT_NE(frame_hash(other), hash);
}

TEST(FrameHash, StaysTheSameAcrossVersions) {
  EXPECT_EQ(frame_hash(initial_state(compile_scene(drop()))), 15550583919971695676u);
}

TEST(Timeline, SeekIsClampedAndPlayingFromThePastMakesABranch) {
  Timeline timeline(drop());
  played(timeline, 30);
  timeline.seek(99);
  EXPECT_EQ(timeline.frame(), 30);
  timeline.seek(-5);
  EXPECT_EQ(timeline.frame(), 0);
  EXPECT_TRUE(timeline.record().paths.empty());
  timeline.seek(10);
  const State at_ten = timeline.state();
  timeline.step({.mouse = {4, 4}, .mouse_down = true, .grab = 1});
  ASSERT_EQ(timeline.branches().size(), 2u);
  const Branch &old = timeline.branches()[0], &now = timeline.current();
  EXPECT_EQ(old.last_frame(), 30);
  EXPECT_EQ(now.last_frame(), 11);
  EXPECT_EQ(now.parent, old.id);
  EXPECT_EQ(now.fork, 10);
  EXPECT_EQ(timeline.state_at(now, 10), at_ten);
  EXPECT_EQ(timeline.state().grabbed, 1);
  timeline.compare_with(old.id);
  EXPECT_EQ(timeline.parting_frame(), 11);
  const int first = old.id;
  timeline.switch_to(first);
  EXPECT_EQ(timeline.last_frame(), 30);
  EXPECT_EQ(timeline.frame(), 11);
  EXPECT_EQ(timeline.state().grabbed, 0);
}

TEST(Timeline, ReplayStopsAtTheEnd) {
  Timeline timeline(drop());
  played(timeline, 3);
  EXPECT_FALSE(timeline.replay());
  timeline.seek(1);
  EXPECT_TRUE(timeline.replay());
  EXPECT_TRUE(timeline.replay());
  EXPECT_FALSE(timeline.replay());
  EXPECT_EQ(timeline.frame(), 3);
  EXPECT_EQ(timeline.branches().size(), 1u);
}

TEST(Timeline, DroppingABranchKeepsTheOthers) {
  Timeline timeline(drop());
  played(timeline, 40);
  const State end = timeline.state();
  const int first = timeline.current().id;
  timeline.seek(20);
  played(timeline, 5);
  const int second = timeline.current().id;
  timeline.drop(first);
  EXPECT_EQ(timeline.find(first), nullptr);
  timeline.seek(20);
  played(timeline, 20);
  EXPECT_EQ(timeline.state(), end);
  timeline.drop(timeline.current().id);
  EXPECT_EQ(timeline.current().id, second);
  timeline.drop(second);
  EXPECT_EQ(timeline.branches().size(), 1u) << "one branch always stays";
  EXPECT_EQ(timeline.last_frame(), 0);
  EXPECT_EQ(timeline.frame(), 0);
}

TEST(Timeline, RestartKeepsTheOldBranchUnlessItIsEmpty) {
  Timeline timeline(drop());
  timeline.restart();
  EXPECT_EQ(timeline.branches().size(), 1u);
  played(timeline, 4);
  timeline.restart();
  timeline.restart();
  EXPECT_EQ(timeline.branches().size(), 2u);
  EXPECT_EQ(timeline.frame(), 0);
  EXPECT_EQ(timeline.last_frame(), 0);
  timeline.switch_to(timeline.branches()[0].id);
  EXPECT_EQ(timeline.branches().size(), 1u);
  EXPECT_EQ(timeline.last_frame(), 4);
}

TEST(Timeline, ARerunFindsTheFirstDifferentFrame) {
  Timeline timeline(drop());
  played(timeline, 120);
  std::int64_t hit = 1;  // the first frame in which the ball is lower than the new tile allows
  while (timeline.state_at(timeline.current(), hit).bodies[0].box.bottom() <= 24) ++hit;
  const int old = timeline.current().id;
  timeline.edit_and_rerun(with_tile(drop(), {0, 3}, 1), nullptr, 0);
  EXPECT_TRUE(timeline.behind());
  EXPECT_EQ(timeline.frame(), 0);
  EXPECT_EQ(timeline.progress(), 0);
  timeline.catch_up(60);
  EXPECT_EQ(timeline.progress(), 0.5);
  EXPECT_EQ(timeline.frame(), 60) << "shows the frame that it has reached";
  finish(timeline);
  EXPECT_EQ(timeline.progress(), 1);
  EXPECT_EQ(timeline.frame(), 120);
  EXPECT_EQ(timeline.last_frame(), 120);
  ASSERT_NE(timeline.compared(), nullptr);
  EXPECT_EQ(timeline.compared()->id, old);
  EXPECT_EQ(timeline.parting_frame(), hit);
  EXPECT_LE(timeline.state().bodies[0].box.bottom(), 24);
}

TEST(Timeline, FurtherEditsRerunTheSameDraft) {
  Timeline timeline(drop());
  played(timeline, 50);
  Level level = drop();
  for (int x = 0; x < 5; ++x) {
    level.map.set({x, 3}, 1);
    timeline.edit_and_rerun(level, nullptr, 10);
    timeline.catch_up(7);
  }
  EXPECT_EQ(timeline.branches().size(), 2u);
  EXPECT_EQ(timeline.current().chapters.size(), 2u);
  finish(timeline);
  EXPECT_EQ(timeline.current().last_frame(), 50);
  EXPECT_LE(timeline.state().bodies[0].box.bottom(), 24);
  timeline.switch_to(timeline.current().id);
  timeline.rerun(10);
  EXPECT_EQ(timeline.branches().size(), 3u) << "it was no draft any more";
}

TEST(Timeline, TheMouseKeepsABodyWhoseNumberChanges) {
  Level level = level_of({".o...", ".....", ".....", "#####"});
  Timeline timeline(level);
  for (int i = 0; i < 20; ++i) timeline.step({.mouse = {30, 12}, .mouse_down = true, .grab = 1});
  timeline.edit_and_rerun(level = with_tile(level, {0, 1}, 2), nullptr, 0);
  finish(timeline);
  EXPECT_EQ(timeline.state().grabbed, 2);
  EXPECT_EQ(timeline.state().find(2)->origin.cell, (Cell{1, 0}));
  EXPECT_EQ(timeline.compared()->input(1).grab, 1) << "the old branch keeps its own";
  timeline.edit_and_rerun(with_tile(level, {1, 0}, 0), nullptr, 0);
  EXPECT_EQ(timeline.current().input(1).grab, 0) << "there is no such body to hold";
}

TEST(Timeline, ACancelledRerunEndsWhereItIs) {
  Timeline timeline(drop());
  played(timeline, 50);
  timeline.set_mark(40, "late");
  timeline.rerun(0);
  timeline.catch_up(20);
  timeline.cancel();
  EXPECT_FALSE(timeline.behind());
  EXPECT_EQ(timeline.last_frame(), 20);
  EXPECT_EQ(timeline.frame(), 20);
  EXPECT_TRUE(timeline.current().marks.empty());
  EXPECT_EQ(timeline.compared()->last_frame(), 50);
}

TEST(Timeline, ABranchOfARerunForgetsWhichFrameWasWanted) {
  Timeline timeline(drop());
  played(timeline, 50);
  const int first = timeline.current().id;
  timeline.rerun(0);
  timeline.catch_up(20);
  timeline.fork();
  ASSERT_EQ(timeline.frame(), 20);
  timeline.switch_to(first);
  EXPECT_EQ(timeline.frame(), 20) << "another branch is shown at the same frame";
}

TEST(Timeline, SettingAKeyInARangeRerunsTheRest) {
  Level level = room(SolverKind::exact);
  Timeline timeline(level);
  played(timeline, 60);
  const State before = timeline.state();
  timeline.edit(level = with_tile(level, {20, 3}, 1));
  played(timeline, 10);
  timeline.set_input(30, 39, InputKey::right, true);
  EXPECT_EQ(timeline.current().run_frame(), 29) << "what is before is kept";
  finish(timeline);
  EXPECT_EQ(timeline.frame(), 70);
  EXPECT_EQ(timeline.current().chapters.size(), 2u) << "the edit is made again too";
  EXPECT_FALSE(timeline.current().input(29).right);
  EXPECT_TRUE(timeline.current().input(30).right);
  EXPECT_TRUE(timeline.current().input(39).right);
  EXPECT_FALSE(timeline.current().input(40).right);
  EXPECT_EQ(timeline.parting_frame(), 30);
  timeline.set_input(30, 500, InputKey::right, false);
  finish(timeline);
  EXPECT_EQ(timeline.branches().size(), 2u);
  EXPECT_EQ(timeline.parting_frame(), std::nullopt);
  EXPECT_EQ(timeline.state_at(timeline.current(), 59), timeline.state_at(*timeline.compared(), 59));
  timeline.set_input(1, 10, InputKey::left, false);
  EXPECT_FALSE(timeline.behind()) << "nothing is different";
  EXPECT_EQ(before.frame, 60);
}

TEST(Timeline, SettingTheMouseInARangeRerunsTheRest) {
  Timeline timeline(room(SolverKind::exact));
  for (std::int64_t frame = 1; frame <= 40; ++frame) timeline.step(input_at(frame));
  timeline.set_mouse(10, 12, {});
  EXPECT_EQ(timeline.branches().size(), 1u) << "it is there already";
  timeline.set_mouse(38, 100, {7, 9});
  ASSERT_EQ(timeline.branches().size(), 2u);
  EXPECT_EQ(timeline.current().run_frame(), 37);
  for (std::int64_t frame = 36; frame <= 40; ++frame)
    EXPECT_EQ(timeline.current().input(frame).mouse, frame < 38 ? Vec2{} : (Vec2{7, 9})) << frame;
  timeline.set_mouse(0, 1, {1, 1});
  EXPECT_EQ(timeline.branches().size(), 2u) << "the same draft";
  EXPECT_EQ(timeline.current().input(1).mouse, (Vec2{1, 1}));
  EXPECT_EQ(timeline.current().run_frame(), 0);
}

TEST(Timeline, NewInputKeepsABranchOnAnEditedLevel) {
  Timeline timeline(drop());
  played(timeline, 20);
  timeline.edit_and_rerun(with_tile(drop(), {0, 3}, 1), nullptr, 0);
  finish(timeline);
  const int edited = timeline.current().id;
  timeline.set_input(5, 6, InputKey::left, true);
  ASSERT_EQ(timeline.branches().size(), 3u);
  EXPECT_FALSE(timeline.find(edited)->input(5).left);
  EXPECT_EQ(timeline.compared()->id, edited);
  timeline.set_input(9, 9, InputKey::left, true);
  EXPECT_EQ(timeline.branches().size(), 3u) << "of one series";
  finish(timeline);
  timeline.edit_and_rerun(with_tile(drop(), {0, 2}, 1), nullptr, 0);
  EXPECT_EQ(timeline.branches().size(), 4u) << "a branch with other input is no draft of an edited level";
}

TEST(Timeline, NewInputKeepsFramesPlayedOnADraft) {
  Timeline timeline(drop());
  played(timeline, 20);
  timeline.set_input(5, 6, InputKey::left, true);
  finish(timeline);
  const int draft = timeline.current().id;
  played(timeline, 10);
  timeline.set_input(5, 5, InputKey::left, false);
  ASSERT_EQ(timeline.branches().size(), 3u);
  EXPECT_EQ(timeline.find(draft)->last_frame(), 30);
  EXPECT_TRUE(timeline.find(draft)->input(5).left);
}

TEST(Timeline, TheNextStrokeKeepsPlayedFrames) {
  Timeline timeline(drop());
  played(timeline, 20);
  Level level = drop();
  const auto edit = [&](int x) {
    level.map.set({x, 3}, 1);
    timeline.edit_and_rerun(level, nullptr, 0);
    finish(timeline);
  };
  timeline.begin_series();
  for (int x = 0; x < 3; ++x) {
    edit(x);
    played(timeline, 1);
  }
  EXPECT_EQ(timeline.branches().size(), 2u);
  const int first = timeline.current().id;
  timeline.begin_series();
  edit(3);
  EXPECT_EQ(timeline.branches().size(), 3u);
  EXPECT_EQ(timeline.find(first)->last_frame(), 23);
  timeline.begin_series();
  edit(4);
  EXPECT_EQ(timeline.branches().size(), 3u) << "nothing was played on it";
}

TEST(Timeline, ABranchOfARerunStartsAtTheRerunFrame) {
  Timeline timeline(drop());
  played(timeline, 20);
  timeline.rerun(0);
  finish(timeline);
  EXPECT_EQ(timeline.current().fork, 0);
  timeline.set_input(8, 9, InputKey::left, true);
  finish(timeline);
  EXPECT_EQ(timeline.current().fork, 7);
  timeline.set_input(12, 12, InputKey::left, true);
  EXPECT_EQ(timeline.current().fork, 7);
  timeline.set_input(3, 3, InputKey::left, true);
  EXPECT_EQ(timeline.current().fork, 2);
  finish(timeline);
  timeline.rerun(10);
  EXPECT_EQ(timeline.current().fork, 10);
}

TEST(Timeline, RestartsWhenLevelsTakeTooMuchMemory) {
  Level level = drop();
  const std::size_t one = memory_of(version_of(level), nullptr);
  Timeline timeline(level, Timeline::kKeyframeBytes, 10 * one);
  played(timeline, 5);
  int kept = 0;
  const auto add_body = [&] {
    level.spawns.push_back({"", {static_cast<double>(kept), 0}, {}, ""});
    return timeline.edit(level);
  };
  while (kept < 1000 && add_body()) ++kept;
  EXPECT_GT(kept, 3);
  EXPECT_LT(kept, 500);
  EXPECT_EQ(timeline.frame(), 0);
  EXPECT_EQ(timeline.branches().size(), 1u);
  EXPECT_EQ(*timeline.current().chapters[0].version->spawns, level.spawns);
  played(timeline, 5);
  EXPECT_TRUE(add_body()) << "there is room again";
}

TEST(Timeline, EditsOfOneFrameAreOneChapter) {
  Timeline timeline(drop());
  played(timeline, 5);
  Level level = drop();
  for (int x = 0; x < 5; ++x) timeline.edit(level = with_tile(level, {x, 3}, 1));
  EXPECT_EQ(timeline.current().chapters.size(), 2u);
  timeline.edit(level = with_tile(level, {0, 0}, 0));
  EXPECT_TRUE(timeline.state().bodies.empty());
  timeline.edit(level = with_tile(level, {0, 0}, 2));
  EXPECT_EQ(timeline.state().bodies[0].id, 2);
  EXPECT_EQ(timeline.state().bodies[0].box.y, 0) << "it starts anew";
  const State end = played(timeline, 10).state();
  timeline.seek(0);
  timeline.seek(15);
  EXPECT_EQ(timeline.state(), end);
}

TEST(Timeline, AnotherBranchContinuesOnTheCurrentLevel) {
  Timeline timeline(drop());
  played(timeline, 10);
  const int first = timeline.current().id;
  timeline.seek(0);
  timeline.edit(with_tile(drop(), {0, 3}, 1));
  timeline.switch_to(first);
  EXPECT_EQ(timeline.scene(), compile_scene(drop())) << "what was played is shown as it was";
  timeline.seek(10);
  played(timeline, 100);
  EXPECT_LE(timeline.state().bodies[0].box.bottom(), 24);
  EXPECT_EQ(timeline.current().chapters.size(), 2u);
}

TEST(Timeline, WalkVisitsEachFrameOnceUntilItIsEnough) {
  Timeline timeline(drop());
  played(timeline, 40);
  std::vector<std::int64_t> frames;
  StepRecord walked;
  timeline.walk(timeline.current(), 0, 40, &walked, [&](const State& state, const StepRecord* record) {
    frames.push_back(state.frame);
    EXPECT_EQ(record == nullptr, state.frame == 0);
    if (record != nullptr) {
      EXPECT_EQ(record->paths[0].to, state.bodies[0].box);
    }
    return state.frame < 33;
  });
  EXPECT_EQ(frames.size(), 34u);
  EXPECT_EQ(frames.front(), 0);
  EXPECT_EQ(timeline.frame(), 40) << "what is shown stays";
}

TEST(Timeline, AnEditAtTheEndDiscardsTheLookAhead) {
  Timeline timeline(drop());
  played(timeline, 9);
  EXPECT_EQ(timeline.state_at(timeline.current(), 9).bodies.size(), 1u);
  timeline.edit(with_tile(drop(), {4, 0}, 2));
  EXPECT_EQ(timeline.state_at(timeline.current(), 9), timeline.state());
  EXPECT_EQ(timeline.state().bodies.size(), 2u);
  const State next = played(timeline, 1).state();
  EXPECT_EQ(timeline.state_at(timeline.current(), 10), next);
}

TEST(Timeline, MarksBelongToAFrameAndABranch) {
  Timeline timeline(drop());
  played(timeline, 30);
  timeline.set_mark(20, "b");
  timeline.set_mark(10, "a");
  timeline.set_mark(20, "c");
  timeline.set_mark(999, "end");
  EXPECT_EQ(timeline.current().marks, (std::vector<Mark>{{10, "a"}, {20, "c"}, {30, "end"}}));
  timeline.seek(15);
  played(timeline, 1);
  EXPECT_EQ(timeline.current().marks, (std::vector<Mark>{{10, "a"}}));
  timeline.remove_mark(10);
  EXPECT_TRUE(timeline.current().marks.empty());
}

// The promise for an hour with 100 bodies, in numbers that do not depend on the machine: a seek repeats at
// most this many steps, and the keyframes take at most this many bytes. The times are in tests/bench.
TEST(Timeline, KeyframesObeyTheirBudgetAndSeeksStayShort) {
  Level level = level_of({"o.o.o.o.o.o.o.o.o.o.", "....................", "####################"});
  constexpr std::size_t kBudget = 400'000;
  Timeline timeline(level, kBudget);
  constexpr std::int64_t kFrames = 10'000;
  for (std::int64_t frame = 1; frame <= kFrames; ++frame) {
    timeline.step({});
    ASSERT_LE(timeline.keyframe_bytes(), kBudget);
  }
  const auto per_state = static_cast<std::int64_t>(sizeof(State) + 10 * sizeof(Body));
  const std::int64_t fitting = static_cast<std::int64_t>(kBudget) / per_state;
  EXPECT_LE(timeline.keyframe_stride(), 2 * kFrames / fitting);
  std::int64_t frame = 1;
  for (int i = 0; i < 200; ++i) {
    frame = frame * 7919 % kFrames;
    const std::int64_t before = timeline.steps_again();
    timeline.seek(frame);
    EXPECT_LE(timeline.steps_again() - before, timeline.keyframe_stride());
    EXPECT_EQ(frame_hash(timeline.state()), timeline.current().hashes[static_cast<std::size_t>(frame)]);
  }
}

TEST(Timeline, LevelsOfManyBodiesHaveFewerKeyframes) {
  Level level;
  level.tuning.shared.bodies = 0;
  level.spawns.resize(1'000);
  Timeline timeline(level);
  played(timeline, 63);
  EXPECT_EQ(timeline.keyframe_bytes(), 0u);
  played(timeline, 1);
  EXPECT_EQ(timeline.keyframe_bytes(), sizeof(State) + 1'000 * sizeof(Body));
}

TEST(Timeline, AHundredEditsDoNotMakeSeeksLong) {
  Level level = room(SolverKind::exact);
  Timeline timeline(level, 20'000);
  for (std::int64_t frame = 1; frame <= 400; ++frame) {
    const Cell cell{static_cast<int>(frame / 4 % 20) + 2, 2};
    if (frame % 4 == 0) level.map.set(cell, level.map.tile_at(cell) == 1 ? 0 : 1);
    if (frame % 4 == 0) timeline.edit(level);
    timeline.step(input_at(frame));
    ASSERT_LE(timeline.keyframe_bytes(), 20'000u);
  }
  EXPECT_EQ(timeline.current().chapters.size(), 101u);
  for (std::int64_t frame = 400; frame > 0; frame -= 13) {
    const std::int64_t before = timeline.steps_again();
    timeline.seek(frame);
    EXPECT_LE(timeline.steps_again() - before, timeline.keyframe_stride());
    EXPECT_EQ(frame_hash(timeline.state()), timeline.current().hashes[static_cast<std::size_t>(frame)]);
  }
}

TEST(Timeline, BranchesShareTheirKeyframes) {
  Timeline timeline(drop());
  played(timeline, 800);
  const std::size_t bytes = timeline.keyframe_bytes();
  timeline.seek(799);
  timeline.fork();
  EXPECT_EQ(timeline.keyframe_bytes(), bytes);
  timeline.drop(timeline.branches()[0].id);
  EXPECT_LT(timeline.keyframe_bytes(), bytes);
}

TEST(Timeline, ARecordingReusesScenesCompiledBefore) {
  Timeline timeline(drop());
  played(timeline, 20);
  timeline.edit(with_tile(drop(), {0, 0}, 1));
  timeline.step({});
  const Recording recording = timeline.recording(timeline.current(), drop());
  const EndScenes scenes = compile_ends(recording, {});
  ASSERT_TRUE(scenes.first && scenes.last);
  EXPECT_FALSE(*scenes.first == *scenes.last);
  Timeline again(recording, scenes);
  EXPECT_EQ(&again.scene(), scenes.first.get());
  EXPECT_EQ(again.level_scene(), scenes.last);
  finish(again);
  EXPECT_EQ(again.unexpected_frame(again.current()), std::nullopt);
  const EndScenes cancelled = compile_ends(recording, Progress([](double) { return false; }));
  EXPECT_FALSE(cancelled.first || cancelled.last);
}

TEST(Timeline, TheStepsOfASeekCanBeLimited) {
  Timeline timeline(drop());
  played(timeline, 30);
  const State last = timeline.state();
  timeline.seek(0);
  timeline.limit_way(1);
  timeline.seek(30);
  for (std::int64_t calls = 0; timeline.on_the_way() && calls < 30; ++calls) {
    EXPECT_EQ(timeline.state(), timeline.state_at(timeline.current(), timeline.frame()));
    EXPECT_EQ(timeline.record().paths.size(), timeline.state().bodies.size());
    const std::int64_t before = timeline.frame();
    timeline.go_on(2);
    EXPECT_LE(timeline.frame() - before, 2);
  }
  EXPECT_EQ(timeline.state(), last);
  EXPECT_FALSE(timeline.on_the_way());
  // Other work goes on from the frame that is shown meanwhile.
  timeline.seek(1);
  timeline.seek(29);
  const std::int64_t shown = timeline.frame();
  timeline.step({});
  EXPECT_EQ(timeline.frame(), shown + 1);
  EXPECT_EQ(timeline.last_frame(), shown + 1);
  EXPECT_FALSE(timeline.on_the_way());
}

TEST(Timeline, ATamperedHashIsNamedByItsFrame) {
  Timeline timeline(drop());
  played(timeline, 90);
  Recording recording = timeline.recording(timeline.current(), drop());
  recording.hashes[61] ^= 1;
  Timeline again(recording);
  finish(again);
  EXPECT_EQ(again.unexpected_frame(again.current()), 61);
}

// A level with a ball of its own, and a player that is to run alone over its floor.
LoneBody runner() {
  LoneBody body;
  body.spawn.kind = BodyKind::player;
  body.spawn.position = {20, 40};
  body.spawn.velocity = {1.25, 0};
  body.spawn.foot = Foot::centre;
  body.stands = true;
  body.run_speed = 1.25;
  return body;
}

Level floor_with_ball() {
  Level level =
      level_of({"......o.", "........", "........", "........", "........", "........", "########"});
  level.tuning.solver = SolverKind::exact;
  return level;
}

TEST(LoneBody, PlaysInsteadOfTheBodiesOfTheLevel) {
  Timeline timeline(floor_with_ball());
  timeline.restart(runner());
  ASSERT_EQ(timeline.state().bodies.size(), 1u);
  EXPECT_EQ(timeline.state().bodies[0].box, (Rect{20, 40, 8, 8}));
  EXPECT_TRUE(timeline.state().bodies[0].gait.grounded);
  EXPECT_EQ(timeline.scene().tuning.player.run_speed, 1.25);
  Input input;
  input.right = true;
  for (int i = 0; i < 10; ++i) timeline.step(input);
  EXPECT_EQ(timeline.state().bodies[0].box.x, 32.5);
  const State last = timeline.state();
  timeline.seek(0);
  timeline.seek(10);
  EXPECT_EQ(timeline.state(), last) << "from a keyframe";
}

TEST(LoneBody, StaysAloneWhenTheLevelIsEdited) {
  Level level = floor_with_ball();
  Timeline timeline(level);
  timeline.step({});
  const int own = timeline.current().id;
  timeline.restart(runner());
  Input input;
  input.right = true;
  for (int i = 0; i < 20; ++i) timeline.step(input);
  level.map.set({5, 5}, 1);  // a wall in its way
  timeline.edit_and_rerun(level, nullptr, 0);
  while (timeline.behind()) timeline.catch_up(100);
  timeline.seek(20);
  ASSERT_EQ(timeline.state().bodies.size(), 1u);
  EXPECT_EQ(timeline.state().bodies[0].box.right(), 40);
  timeline.edit(level = with_tile(level, {5, 5}, 0));
  EXPECT_EQ(timeline.state().bodies.size(), 1u);
  for (int i = 0; i < 4; ++i) timeline.step(input);
  EXPECT_GT(timeline.state().bodies[0].box.right(), 40);

  timeline.switch_to(own);
  timeline.seek(1);
  timeline.step({});
  EXPECT_EQ(timeline.state().bodies[0].kind, BodyKind::ball) << "other branches have the bodies of the level";
  timeline.restart();
  EXPECT_EQ(timeline.state().bodies[0].kind, BodyKind::ball);
}

TEST(LoneBody, IsKeptByRecordings) {
  Timeline timeline(floor_with_ball());
  timeline.restart(runner());
  Input input;
  input.right = true;
  for (int i = 0; i < 10; ++i) timeline.step(input);
  const Recording recording = timeline.recording(timeline.current(), floor_with_ball());
  EXPECT_EQ(recording.alone, runner());
  EXPECT_EQ(recording.level, floor_with_ball());
  Timeline again(recording);
  while (again.behind()) again.catch_up(100);
  EXPECT_FALSE(again.unexpected_frame(again.current()));
  again.seek(10);
  EXPECT_EQ(again.state(), timeline.state());
}

}  // namespace talus::timeline_test
