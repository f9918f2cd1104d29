// Breakpoints, and the search for the frames where they stop.
#include "debug/breakpoint_search.h"

#include <gtest/gtest.h>

#include "recorded_frames.h"

namespace talus::debug_breakpoint_test {

// Frames in which body 1 is at these xs, and body 2 at 1000 - x.
MadeFrames frames_of(const std::vector<double>& xs) {
  std::vector<State> states;
  for (const double x : xs) states.push_back(state_of({body_at(1, x, 0), body_at(2, 1000 - x, 0)}));
  return MadeFrames(std::move(states));
}

ArmedBreakpoint armed(Breakpoint breakpoint) {
  auto made = ArmedBreakpoint::arm(breakpoint);
  EXPECT_TRUE(made) << made.error().message;
  return *made;
}

std::optional<Stop> search(const FrameSource& source, const std::vector<Breakpoint>& breakpoints,
                           std::int64_t from, SearchDirection direction) {
  std::vector<ArmedBreakpoint> list;
  for (const Breakpoint& breakpoint : breakpoints) list.push_back(armed(breakpoint));
  BreakpointSearch search(std::move(list), from, direction);
  while (!search.advance(source, 3)) EXPECT_LE(search.progress(source), 1);
  EXPECT_EQ(search.progress(source), 1);
  return search.found();
}

// The frames of all stops, found one after the other.
std::vector<std::int64_t> stops(const FrameSource& source, const Breakpoint& breakpoint,
                                SearchDirection direction) {
  const bool is_forwards = direction == SearchDirection::forwards;
  std::vector<std::int64_t> frames;
  std::int64_t at = is_forwards ? -1 : source.last() + 1;
  while (const auto stop = search(source, {breakpoint}, at, direction)) frames.push_back(at = stop->frame);
  if (!is_forwards) std::reverse(frames.begin(), frames.end());
  return frames;
}

using Frames = std::vector<std::int64_t>;

TEST(Breakpoints, StopWhereTheConditionBeginsToHold) {
  const MadeFrames source = frames_of({5, 0, 5, 5, 0, 0, 5, 5, 5, 0});
  const Breakpoint breakpoint{.id = 7, .condition = "x > 3", .body = 1};
  EXPECT_EQ(stops(source, breakpoint, SearchDirection::forwards), (Frames{0, 2, 6}));
  EXPECT_EQ(stops(source, breakpoint, SearchDirection::backwards), (Frames{0, 2, 6}));
  EXPECT_EQ(search(source, {breakpoint}, 2, SearchDirection::forwards), (Stop{6, 7, 1, 0}));
}

TEST(Breakpoints, StopInEachFrameWhereAsked) {
  const MadeFrames source = frames_of({0, 1, 2, 2, 3, 4});
  Breakpoint breakpoint{.id = 1, .condition = "changed(x)", .body = 1};
  EXPECT_EQ(stops(source, breakpoint, SearchDirection::forwards), (Frames{1, 4}));
  breakpoint.each_frame = true;
  EXPECT_EQ(stops(source, breakpoint, SearchDirection::forwards), (Frames{1, 2, 4, 5}));
  EXPECT_EQ(stops(source, breakpoint, SearchDirection::backwards), (Frames{1, 2, 4, 5}));
}

TEST(Breakpoints, HitsAreNumberedFromFrameZeroInBothDirections) {
  const MadeFrames source = frames_of({0, 5, 0, 5, 0, 5, 0, 5, 0});
  const Breakpoint breakpoint{.id = 1, .condition = "x > 3", .body = 1, .count = 3};
  EXPECT_EQ(stops(source, breakpoint, SearchDirection::forwards), (Frames{5, 7}));
  EXPECT_EQ(stops(source, breakpoint, SearchDirection::backwards), (Frames{5, 7}));
  EXPECT_EQ(search(source, {breakpoint}, 4, SearchDirection::forwards), (Stop{5, 1, 1, 3}));
  EXPECT_EQ(search(source, {breakpoint}, 7, SearchDirection::backwards), (Stop{5, 1, 1, 3}));
}

TEST(Breakpoints, ForAnyBodyStopForEachBody) {
  const MadeFrames source = frames_of({0, 100, 400, 600, 900, 1000});
  const Breakpoint any{.id = 1, .condition = "x > 350 && x < 500"};
  EXPECT_EQ(search(source, {any}, -1, SearchDirection::forwards), (Stop{2, 1, 1, 0}));
  EXPECT_EQ(search(source, {any}, 2, SearchDirection::forwards), (Stop{3, 1, 2, 0}));
  const Breakpoint of_two{.id = 1, .condition = "x > 350 && x < 500", .body = 2};
  EXPECT_EQ(search(source, {of_two}, -1, SearchDirection::forwards), (Stop{3, 1, 2, 0}));
  const Breakpoint of_none{.id = 1, .condition = "frame == 4", .body = 2};
  EXPECT_EQ(search(source, {of_none}, -1, SearchDirection::forwards), (Stop{4, 1, 0, 0}));
}

TEST(Breakpoints, DoNotStopForRemovedBodies) {
  const MadeFrames source({state_of({}), state_of({body_at(1, 0, 0)}), state_of({})});
  EXPECT_EQ(stops(source, {.id = 1, .condition = "!grounded", .body = 1}, SearchDirection::forwards),
            (Frames{1}));
  EXPECT_EQ(stops(source, {.id = 1, .condition = "!grounded"}, SearchDirection::forwards), (Frames{1}));
}

TEST(Breakpoints, TheFirstOfTheListStops) {
  const MadeFrames source = frames_of({0, 1, 2, 3, 4, 5});
  const std::vector<Breakpoint> list = {{.id = 4, .condition = "x > 4", .body = 1},
                                        {.id = 5, .condition = "x > 2", .body = 1},
                                        {.id = 6, .condition = "frame == 3"},
                                        {.id = 7, .condition = "frame == 1", .enabled = false}};
  EXPECT_EQ(search(source, list, 0, SearchDirection::forwards), (Stop{3, 5, 1, 0}));
  EXPECT_EQ(search(source, list, 5, SearchDirection::backwards), (Stop{3, 5, 1, 0}));
  EXPECT_EQ(search(source, {list[3]}, 0, SearchDirection::forwards), std::nullopt);
  EXPECT_EQ(search(source, {}, 3, SearchDirection::backwards), std::nullopt);
}

TEST(Breakpoints, SearchingBackwardsReadsBlocksOnly) {
  std::vector<double> xs(3000, 0);
  xs[17] = xs[2400] = 5;
  const MadeFrames source = frames_of(xs);
  const auto one = armed({.id = 1, .condition = "x > 3", .body = 1});
  BreakpointSearch near({one}, 2500, SearchDirection::backwards);
  EXPECT_TRUE(near.advance(source, 257)) << "a block, and the frame before";
  EXPECT_EQ(near.found(), (Stop{2400, 1, 1, 0}));
  BreakpointSearch far({one}, 2400, SearchDirection::backwards);
  EXPECT_FALSE(far.advance(source, 1200));
  EXPECT_NEAR(far.progress(source), 0.5, 0.005);
  EXPECT_TRUE(far.advance(source, 1210));
  EXPECT_EQ(far.found(), (Stop{17, 1, 1, 0}));
}

TEST(Breakpoints, AWrongConditionIsNotArmed) {
  const auto wrong = ArmedBreakpoint::arm({.id = 1, .condition = "1 < vz"});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().position, 4u);
}

TEST(HitCounter, CountsWhileTheGameRuns) {
  const MadeFrames source = frames_of({0, 5, 0, 5, 0, 5});
  HitCounter counter({armed({.id = 3, .condition = "x > 3", .body = 1, .count = 2})});
  FrameHistory history(counter.frames_before());
  std::vector<std::int64_t> stopped;
  for (const Frame& frame : source.frames) {
    history.next() = frame;
    ASSERT_TRUE(counter.advance(history.view(), 1));
    if (const auto& stop = counter.stop()) stopped.push_back(stop->frame);
  }
  EXPECT_EQ(stopped, (Frames{3, 5}));
  EXPECT_EQ(counter.hits(3), 3);
  EXPECT_EQ(counter.hits(4), 0);
}

// A body may take 1 ms, and a level may have 65,536 of them.
TEST(HitCounter, JudgesAFrameAFewBodiesAtATime) {
  std::vector<Body> bodies;
  for (int i = 1; i <= 100; ++i) bodies.push_back(body_at(i, i, 0));
  const MadeFrames source({state_of(bodies)});
  const std::vector<ArmedBreakpoint> all = {armed({.id = 1, .condition = "x > 90"}),
                                            armed({.id = 2, .condition = "x > 100"})};
  HitCounter counter(all);
  FrameHistory history(counter.frames_before());
  history.go_to(source, 0);
  int calls = 1;
  while (!counter.advance(history.view(), 10)) {
    EXPECT_EQ(counter.hits(1), 0) << "half a frame is no hit";
    ++calls;
  }
  EXPECT_EQ(calls, 20) << "91 bodies of the first, 100 of the second";
  EXPECT_EQ(counter.stop(), (Stop{0, 1, 91, 1}));
  EXPECT_TRUE(counter.was_hit(1));
  EXPECT_FALSE(counter.was_hit(2));
  EXPECT_FALSE(counter.advance(history.view(), 10));
  counter.forget_frame();
  EXPECT_EQ(counter.hits(1), 1);

  BreakpointSearch search(all, -1, SearchDirection::forwards);
  EXPECT_FALSE(search.advance(source, 91 / kBodiesAtOnce));
  EXPECT_TRUE(search.advance(source, 100));
  EXPECT_EQ(search.found(), (Stop{0, 1, 91, 0}));
}

TEST(BreakpointKinds, MakeConditionsThatCanBeArmed) {
  const auto text = [](BreakpointKind kind, std::vector<double> fields) {
    return condition_of(kind, fields);
  };
  EXPECT_EQ(text(BreakpointKind::touches_tile, {12, 9}), "touches(12, 9)");
  EXPECT_EQ(text(BreakpointKind::touches_body, {3}), "touches_body(3)");
  EXPECT_EQ(text(BreakpointKind::normal_range, {}), "normal.angle >= -45 && normal.angle <= 45");
  EXPECT_EQ(text(BreakpointKind::slope_delta, {0.1}), "abs(slope_delta) > 0.1");
  EXPECT_EQ(text(BreakpointKind::grounded, {}), "changed(grounded)");
  EXPECT_EQ(text(BreakpointKind::enters_rect, {1, 2.5}), "in_rect(1, 2.5, 8, 8)");
  EXPECT_EQ(text(BreakpointKind::parting, {1e-9}), "parting > 1e-09");
  for (std::size_t i = 0; i < breakpoint_kind_infos().size(); ++i) {
    const BreakpointKindInfo& info = breakpoint_kind_infos()[i];
    EXPECT_EQ(static_cast<std::size_t>(info.kind), i);
    EXPECT_TRUE(Expression::parse_condition(condition_of(info.kind, {}))) << info.label;
  }
}

}  // namespace talus::debug_breakpoint_test
