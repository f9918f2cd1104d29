// Exporters report their progress, and end when they are stopped.
#include <gtest/gtest.h>

#include <algorithm>

#include "export/export_plan.h"
#include "exported_level.h"
#include "formats/files/atomic_file.h"
#include "paths.h"

namespace talus::export_progress_test {

const ReadAsset kAssets = [](const std::string& name) { return read_file(source_path("assets/") + name); };

// Solid tiles, slopes and one-way tiles beside one another: much for every exporter.
Level busy_level() {
  Level level = level_of_shapes({"##"});
  level.map = TileMap(64, 64);
  level.tile_shapes[1] = {TileShape::Kind::solid, TileShape::Side::floor, false, 1, {}};
  level.tile_shapes[2] = {TileShape::Kind::slope, TileShape::Side::floor, false, 1, {0, 8}};
  level.tile_shapes[3] = {TileShape::Kind::slope, TileShape::Side::floor, true, 1, {8, 8}};
  std::size_t i = 0;
  for (TileNumber& cell : level.map.cells().tiles()) cell = static_cast<TileNumber>(i++ * 7 % 11 % 4);
  return level;
}

// The shares that an exporter reports until it is stopped, at the first one that is at least `end`.
struct Told {
  std::vector<double> shares;
  FormatResult<Exported> result;
};
Told told_by(const std::string& id, const Level& level, double end) {
  std::vector<double> shares;
  const Progress progress([&](double share) {
    shares.push_back(share);
    return share < end;
  });
  auto result = find_exporter(id)->make({level, "cave", kAssets, {}, progress});
  return {shares, std::move(result)};
}

TEST(Progress, PartsCountFromZeroToOne) {
  std::vector<double> shares;
  const Progress whole([&](double share) {
    shares.push_back(share);
    return true;
  });
  const Progress second = whole.part(0.5, 1);
  EXPECT_TRUE(whole.part(0, 0.5).at(0.5));
  EXPECT_TRUE(second.at(1, 2));
  EXPECT_TRUE(second.part(0.5, 1).at(1));
  EXPECT_EQ(shares, (std::vector<double>{0.25, 0.75, 1}));
  EXPECT_TRUE(Progress().at(0.5)) << "without a listener all goes on";
}

TEST(Progress, ReportsAThousandSharesAtMostAndStaysStopped) {
  int calls = 0;
  const Progress progress([&](double share) {
    ++calls;
    return share < 0.5;
  });
  for (int i = 0; i <= 100'000; ++i) progress.at(i, 100'000);
  EXPECT_GT(calls, 400);
  EXPECT_LE(calls, 502);
  EXPECT_TRUE(progress.stopped());
  EXPECT_FALSE(progress.part(0, 0.1).at(0)) << "once stopped, it stays stopped";
  const Progress all([&](double) { return ++calls > 0; });
  calls = 0;
  for (int i = 0; i <= 100'000; ++i) all.at(i, 100'000);
  EXPECT_GT(calls, 900);
  EXPECT_LE(calls, 1001);
}

class LongExport : public testing::TestWithParam<const char*> {};

TEST_P(LongExport, ReportsTheShareThatIsDone) {
  const Told told = told_by(GetParam(), busy_level(), 2);
  ASSERT_TRUE(told.result) << told.result.error().message;
  ASSERT_FALSE(told.shares.empty());
  EXPECT_TRUE(std::is_sorted(told.shares.begin(), told.shares.end()));
  EXPECT_GE(told.shares.front(), 0);
  EXPECT_LE(told.shares.back(), 1);
  const Level level = busy_level();
  const FormatResult<Exported> plain = find_exporter(GetParam())->write({level, "cave", kAssets});
  ASSERT_EQ(plain->files.size(), told.result->files.size());
  for (std::size_t i = 0; i < plain->files.size(); ++i)
    EXPECT_EQ(plain->files[i].bytes, told.result->files[i].bytes) << plain->files[i].name;
}

TEST_P(LongExport, EndsWithAnErrorWhenItIsStopped) {
  const std::vector<double> shares = told_by(GetParam(), busy_level(), 2).shares;
  for (const double share : {shares.front(), shares[shares.size() / 2], shares.back()}) {
    const Told told = told_by(GetParam(), busy_level(), share);
    ASSERT_FALSE(told.result) << share;
    EXPECT_EQ(told.result.error().message, "was cancelled");
    EXPECT_EQ(told.shares.back(), share) << "no more progress is reported";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LongExport,
                         testing::Values("json", "lua", "csv", "svg", "png", "ldtk", "tmj", "tmx", "sti",
                                         "lua-runtime"),
                         [](const auto& value) {
                           std::string name = value.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ExportProgress, AStoppedPlanIsAProblem) {
  const auto plan =
      plan_export(busy_level(), "json", "", kAssets, {}, Progress([](double share) { return share < 0.5; }));
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().field, ExportProblem::Field::level);
  EXPECT_EQ(plan.error().error.message, "was cancelled");
}

TEST(ExportProgress, APlanReusesFilesThatAreMadeAlready) {
  const Exported made{{{"", "bytes"}}, {"a thing"}};
  const auto plan = plan_export(Level(), "json", "", kAssets, {}, {}, &made);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->content.files[0].bytes, "bytes");
  EXPECT_EQ(plan->content.dropped, std::vector<std::string>{"a thing"});
  EXPECT_EQ(plan->files[0].size, 5u);
}

}  // namespace talus::export_progress_test
