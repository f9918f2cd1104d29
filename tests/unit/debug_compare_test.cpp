// Two branches side by side, and plotted expressions as series.
#include "debug/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "debug/breakpoint_search.h"
#include "debug/plot_series.h"
#include "level_picture.h"
#include "recorded_frames.h"

namespace talus::debug_compare_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Compare, BodiesAreMatchedByTheirOrigin) {
  Body ball = body_at(1, 10, 10, {1, 0});
  ball.origin = {{1, 1}, -1};
  Body moved = ball;
  moved.id = 5;
  moved.box.x = 13;
  moved.box.y = 14;
  moved.velocity = {1, 2};
  Body new_one = body_at(1, 0, 0);
  new_one.origin = {{2, 2}, -1};
  const Body gone = body_at(2, 0, 0);
  const auto all = differences(state_of({ball, gone}), state_of({new_one, moved}));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].a, 1);
  EXPECT_EQ(all[0].b, 5);
  EXPECT_EQ(all[0].position, (Vec2{3, 4}));
  EXPECT_EQ(all[0].velocity, (Vec2{0, 2}));
  EXPECT_EQ(all[0].distance, 5);
  EXPECT_EQ(all[1].a, 2);
  EXPECT_EQ(all[1].b, 0);
  EXPECT_EQ(all[1].distance, kInfinity);
  EXPECT_EQ(all[2].a, 0);
  EXPECT_EQ(all[2].b, 1);
  EXPECT_EQ(parting_of(ball, state_of({new_one, moved})), 5);
  EXPECT_EQ(parting_of(gone, state_of({new_one, moved})), kInfinity);
}

std::optional<Stop> first_parting(const FrameSource& a, const FrameSource& b, double threshold) {
  const ComparedFrames compared(a, &b);
  const auto armed = ArmedBreakpoint::arm({.id = 1, .condition = parting_condition(threshold)});
  BreakpointSearch search({*armed}, -1, SearchDirection::forwards);
  while (!search.advance(compared, 10)) {
  }
  return search.found();
}

TEST(Compare, FindsTheFirstFrameWhereSolversDiffer) {
  Level level = level_of({".o......", "........", ".../-...", "########"});
  level.tuning.shared.drift_speed = level.tuning.shared.drift_blend = 1;
  const RecordedFrames article(level, 40);
  EXPECT_EQ(first_parting(article, RecordedFrames(level, 40), 0), std::nullopt);

  level.tuning.solver = SolverKind::exact;
  const RecordedFrames exact(level, 40);
  std::int64_t expected = 0;
  while (expected < 40 && parting_of(article.at(expected).state.bodies[0], exact.at(expected).state) <= 0.01)
    ++expected;
  ASSERT_GT(expected, 5) << "both fall alike";
  ASSERT_LT(expected, 40);
  EXPECT_EQ(first_parting(article, exact, 0.01)->frame, expected);
  EXPECT_EQ(first_parting(article, exact, 1e6), std::nullopt);
}

TEST(Compare, HasFramesBeyondTheEndOfTheOtherBranch) {
  const MadeFrames a({state_of({}), state_of({}), state_of({})}),
      b({state_of({body_at(1, 0, 0)}), state_of({})});
  const ComparedFrames compared(a, &b);
  EXPECT_EQ(compared.last(), 2);
  Frame frame;
  compared.read(0, frame);
  EXPECT_TRUE(frame.state.bodies.empty());
  EXPECT_EQ(frame.other->bodies.size(), 1u);
  compared.read(2, frame);
  EXPECT_EQ(frame.other, std::nullopt);
}

TEST(Compare, ADifferenceAtTheStartIsFound) {
  const MadeFrames a({state_of({body_at(1, 0, 0)})}), b({state_of({body_at(1, 0, 0.5)})});
  EXPECT_EQ(first_parting(a, b, 0.25), (Stop{0, 1, 1, 0}));
}

TEST(Series, HalvesItselfAndKeepsPeaks) {
  Series series(10, 4);
  for (const double number : {1, 2, 3, 4}) series.add(number);
  EXPECT_EQ(series.points().size(), 4u);
  EXPECT_EQ(series.frames_of_point(), 1);
  series.add(9);
  EXPECT_EQ(series.frames_of_point(), 2);
  ASSERT_EQ(series.points().size(), 3u);
  EXPECT_EQ(series.points()[0].least, 1);
  EXPECT_EQ(series.points()[0].greatest, 2);
  EXPECT_EQ(series.points()[0].last, 2);
  EXPECT_EQ(series.points()[2].least, 9);
  for (int i = 6; i <= 1000; ++i) series.add(i == 600 ? -50 : 0);
  EXPECT_EQ(series.frames(), 1000);
  EXPECT_EQ(series.first(), 10);
  EXPECT_EQ(series.frames_of_point(), 256);
  ASSERT_EQ(series.points().size(), 4u);
  EXPECT_EQ(series.points()[0].greatest, 9);
  EXPECT_EQ(series.points()[2].least, -50);
  EXPECT_EQ(series.points()[2].last, 0);
}

TEST(Series, LeavesOutFramesWithoutANumber) {
  const double nothing = std::nan("");
  Series series(0, 2);
  for (const double number : {nothing, 3.0, nothing, nothing}) series.add(number);
  ASSERT_EQ(series.points().size(), 2u);
  EXPECT_EQ(series.points()[0].least, 3);
  EXPECT_EQ(series.points()[0].greatest, 3);
  EXPECT_TRUE(std::isnan(series.points()[1].least));
  EXPECT_TRUE(std::isnan(series.points()[1].last));
}

TEST(PlotReader, GoesOnWhenTheRecordingGrows) {
  std::vector<State> states;
  for (int i = 0; i < 6; ++i) states.push_back(state_of({body_at(1, i * i, 0)}));
  MadeFrames source(states);
  const std::vector<PlottedExpression> plots = {{*Expression::parse("x"), 1},
                                                {*Expression::parse("x - before(x)"), 1}};
  PlotReader reader(plots, 2, 16);
  EXPECT_FALSE(reader.advance(source, 3));
  EXPECT_EQ(reader.progress(source), 0.5) << "before(x) also needs the frame before the first: a third frame";
  EXPECT_TRUE(reader.advance(source, 3));
  source.frames.push_back(source.frames.back());
  source.frames.back().state.frame = 6;
  EXPECT_TRUE(reader.advance(source, 3));
  std::vector<double> xs, steps;
  for (const SeriesPoint& point : reader.series()[0].points()) xs.push_back(point.last);
  for (const SeriesPoint& point : reader.series()[1].points()) steps.push_back(point.last);
  EXPECT_EQ(xs, (std::vector<double>{4, 9, 16, 25, 25}));
  EXPECT_EQ(steps, (std::vector<double>{3, 5, 7, 9, 0}));
}

TEST(FrameHistory, ReadsOnlyTheFramesThatItLacks) {
  const RecordedFrames recorded(level_of({"o..", "...", "###"}), 20);
  FrameHistory history(2);
  const auto reads_to = [&](std::int64_t frame) {
    const std::int64_t before = recorded.reads;
    history.go_to(recorded, frame);
    for (std::size_t back = 0; back <= 2; ++back)
      EXPECT_EQ(history.view().before(back).state.frame, frame - static_cast<std::int64_t>(back));
    return recorded.reads - before;
  };
  EXPECT_EQ(reads_to(5), 3);
  EXPECT_EQ(reads_to(6), 1) << "the next one";
  EXPECT_EQ(reads_to(8), 2) << "a jump over one frame, which is read too";
  EXPECT_EQ(reads_to(11), 3) << "reads only the frames that it lacks";
  EXPECT_EQ(reads_to(15), 3) << "does not read the frame in between";
  EXPECT_EQ(reads_to(14), 3) << "back";
}

// As a condition it is false, but there is nothing to plot.
TEST(PlottedExpression, AConditionOnAMissingBodyHasNoValue) {
  MadeFrames source({state_of({body_at(1, 0, 0)}), state_of({body_at(1, 0, 0)})});
  FrameHistory history(1);
  history.go_to(source, 1);
  const Expression grounded = *Expression::parse("grounded");
  EXPECT_TRUE(std::isnan((PlottedExpression{grounded, 0}.value(history.view()))));
  EXPECT_EQ((PlottedExpression{grounded, 1}.value(history.view())), 0);
  EXPECT_EQ((PlottedExpression{*Expression::parse("frame > 0"), 0}.value(history.view())), 1)
      << "asks about no body";
  PlotReader reader({{grounded, 0}, {grounded, 1}}, 0, 16);
  reader.advance(source, 2);
  EXPECT_TRUE(std::isnan(reader.series()[0].points()[1].last));
  EXPECT_EQ(reader.series()[1].points()[1].last, 0);
}

}  // namespace talus::debug_compare_test
