// The report: its metrics, and the files that the command writes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "cli/report/measure.h"
#include "cli/report/reference.h"
#include "cli/report/table.h"
#include "cli_answer.h"

namespace talus::report_cli_test {

TEST(ReportMetrics, PercentileIsTheLeastValueThatCoversTheShare) {
  EXPECT_EQ(percentile({5}, 0.999), 5);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.51), 3);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0), 1);
  std::vector<double> values;
  for (int i = 1; i <= 2000; ++i) values.push_back(i);
  EXPECT_EQ(percentile(values, 0.999), 1998);
}

TEST(ReportMetrics, SpreadOfErrors) {
  Errors errors;
  EXPECT_FALSE(errors.spread().has_value());
  errors.add(1);
  errors.add(3);
  EXPECT_EQ(errors.spread()->max, 3);
  errors.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(errors.spread()->max, std::numeric_limits<double>::infinity());
}

TEST(ReportMetrics, TeleportsAreMotionsBeyondTheAskedOne) {
  EXPECT_FALSE(is_teleport(3, 4, 0, 5));
  EXPECT_FALSE(is_teleport(3, 4, 0, 6));
  EXPECT_TRUE(is_teleport(3, 4, 0, 6.5));
}

TEST(ReportReference, KnowsFloorsAndTimes) {
  EXPECT_EQ(highest(LineFloor{0, 10, 10, 0}, 2, 4), 6);
  EXPECT_EQ(highest(ArcFloor{0, 64, 64}, -3, 5), 0);
  EXPECT_EQ(highest(SineFloor{0, 8, 64, 0}, 40, 50), -8);
  EXPECT_NEAR(static_cast<double>(time_of_impact(LineFloor{0, 10, 10, 10}, {0, 0, 8, 8}, 1, 4)), 0.5, 1e-18);
  EXPECT_GT(time_of_impact(LineFloor{0, 10, 10, 10}, {0, 0, 8, 8}, 1, 1), 1);
}

// A drop under g = 1/2 whose curve begins with g/2: y = t/4 + t^2/4, so 5 px take 4 frames.
TEST(ReportReference, BouncesForEver) {
  Tuning tuning;
  tuning.exact.gravity = 0.5;
  tuning.shared.floor_bounce = 1;
  const std::vector<double> y = bouncing(tuning, -5, 8);
  EXPECT_EQ(y[0], -5);
  EXPECT_EQ(y[1], -4.5);
  EXPECT_NEAR(y[4], 0, 1e-15);
  EXPECT_NEAR(y[5], -2, 1e-15);
  EXPECT_NEAR(y[8], -5, 1e-15);
}

// Coordinates below 256 px have an ulp of 2^-45; from 2^20 px on it is 2^-32.
TEST(ReportRows, ExactIsExactOnLines) {
  for (const ReportScene scene : {ReportScene::flat_tiles, ReportScene::slope_tiles, ReportScene::segment}) {
    for (const auto& [scale, ulp] : {std::pair(1.0, 0x1p-45), std::pair(0x1p20, 0x1p-32)}) {
      const Row row = measure({.scene = scene, .solver = SolverKind::exact, .scale = scale},
                              {.moves = 500, .repeats = 1});
      EXPECT_LE(row.geometry->max, ulp) << info_of(scene).name << " at " << scale;
      EXPECT_EQ(row.counts->misses + row.counts->ghosts + row.counts->tunnels + row.counts->teleports, 0u);
    }
  }
}

// Twice and four times a number is exact; three times rounds, and then ties of `article` and `bump` end
// elsewhere.
TEST(ReportRows, LargerTilesErrAsManyTimesAsMuch) {
  for (const ReportScene scene :
       {ReportScene::flat_tiles, ReportScene::slope_tiles, ReportScene::wall_of_tiles}) {
    for (const SolverKind solver : {SolverKind::article, SolverKind::bump, SolverKind::exact}) {
      const Row usual = measure({.scene = scene, .solver = solver}, {.moves = 200, .repeats = 1});
      for (const int tile : kReportLargerTiles) {
        if (tile == 24 && solver != SolverKind::exact) continue;
        const Row row =
            measure({.scene = scene, .solver = solver, .tile = tile}, {.moves = 200, .repeats = 1});
        const double factor = tile / 8.0;
        EXPECT_NEAR(row.geometry->max, factor * usual.geometry->max, 1e-10)
            << info_of(scene).name << " by " << solver_name(row.setup) << " at " << tile << " px";
        EXPECT_EQ(row.counts->ghosts, usual.counts->ghosts);
      }
    }
  }
}

TEST(ReportRows, TheReportHasLargerTiles) {
  const auto rows = report_setups();
  for (const int tile : kReportLargerTiles)
    EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [&](const auto& row) { return row.tile == tile; }), 9);
}

TEST(ReportRows, TheKernelIsNotExact) {
  const Row row = measure({.scene = ReportScene::flat_tiles}, {.moves = 500, .repeats = 1});
  EXPECT_GT(row.geometry->max, 1);
  EXPECT_EQ(row.counts->tunnels, 0u);
}

TEST(ReportRows, PolylinesGetCloser) {
  const auto error = [](int segments) {
    return measure({.scene = ReportScene::arc, .solver = SolverKind::exact, .segments = segments},
                   {.moves = 200, .repeats = 1})
        .geometry->max;
  };
  EXPECT_GT(error(4), 0.5);
  EXPECT_LT(error(64), 0.01);
  EXPECT_LT(error(0), 1e-12);
}

TEST(ReportRows, ArticleSinksIntoSlopes) {
  const Row row = measure({.scene = ReportScene::slope_tiles, .solver = SolverKind::article}, {.moves = 200});
  EXPECT_GT(row.geometry->max, 1);
  EXPECT_GT(row.counts->misses, 0u);
}

// Each row is a line with as many fields as the heading.
TEST(ReportTable, EveryRowHasEveryColumn) {
  Row wall;
  wall.setup = {.scene = ReportScene::wall_of_bodies, .solver = SolverKind::bump, .scale = 1e7};
  wall.geometry = Spread{2, 1};
  wall.counts = Counts{1, 2, 3, 4};
  const std::string csv = csv_of({&wall, 1}, {"abc", "GNU 12", "-O2 -g,-x", "a \"quick\" one"});
  EXPECT_EQ(csv,
            "scene,solver,precision,substeps,segments,scale_px,tile_px,moves,ns_per_move,geometry_max_px,"
            "geometry_p999_px,impact_max_px,impact_p999_px,trajectory_max_px,trajectory_p999_px,model_max_px,"
            "model_p999_px,misses,ghosts,tunnels,teleports,commit,compiler,flags,cpu\n"
            "\"wall of bodies\",bump,double,1,0,1e+07,8,0,,2,1,,,,,,,1,2,3,4,"
            "\"abc\",\"GNU 12\",\"-O2 -g,-x\",\"a \"\"quick\"\" one\"\n");
}

TEST(ReportCommand, SaysWhenItCannotWrite) {
  EXPECT_EQ(cli_answer({"report"}).status, kExitUsage);
  const CliAnswer answer = cli_answer({"report", "--quick", "-o", "/dev/null/there"});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err, testing::HasSubstr("/dev/null/there: error: cannot be created as a folder"));
}

}  // namespace talus::report_cli_test
