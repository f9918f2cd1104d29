// Readers report their progress, and end when they are stopped.
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/native/native.h"
#include "formats/native/recording_file.h"
#include "formats/tiled/tiled_format.h"
#include "tiled_files.h"

namespace talus::reading_progress_test {

Level large_level() {
  Level level = level_for_tiled();
  level.map = TileMap(400, 300);
  std::size_t i = 0;
  for (TileNumber& cell : level.map.cells().tiles()) cell = static_cast<TileNumber>(1 + i++ % 7);
  return level;
}

// What a reader of one kind of file makes of a large file, as bytes; and the shares that it reported until it
// was stopped, at the first one that is at least `end`.
struct Told {
  std::vector<double> shares;
  FormatResult<std::string> result;
};

FormatResult<std::string> read_as(const std::string& kind, const Progress& progress) {
  const Level level = large_level();
  if (kind == "talusrec") {
    Recording recording;
    recording.level = level;
    recording.frames = 100;
    for (int i = 0; i < 20; ++i)
      recording.edits.push_back({1 + i, std::make_shared<LevelVersion>(version_of(level))});
    const auto read = read_recording(write_recording(recording).value(), progress);
    return read ? write_recording(*read) : tl::unexpected(read.error());
  }
  const std::string bytes = kind == "json" ? write_native(level, {})->bytes
                                           : tiled_export_of(level, kind, "cave").files.front().bytes;
  FormatContext context{kind};
  context.progress = progress;
  const auto read = read_level(bytes, context);
  return read ? write_native(read->level, {})->bytes
              : FormatResult<std::string>(tl::unexpected(read.error()));
}

Told told_by(const std::string& kind, double end) {
  std::vector<double> shares;
  const Progress progress([&](double share) {
    shares.push_back(share);
    return share < end;
  });
  auto result = read_as(kind, progress);
  return {shares, std::move(result)};
}

class LongReading : public testing::TestWithParam<const char*> {};

TEST_P(LongReading, ReportsTheShareThatIsDone) {
  const Told told = told_by(GetParam(), 2);
  ASSERT_TRUE(told.result) << told.result.error().message;
  ASSERT_GT(told.shares.size(), 3u);
  EXPECT_TRUE(std::is_sorted(told.shares.begin(), told.shares.end()));
  EXPECT_GE(told.shares.front(), 0);
  EXPECT_LE(told.shares.back(), 1);
  EXPECT_EQ(*told.result, *read_as(GetParam(), {})) << "what is read is the same";
}

TEST_P(LongReading, EndsWithAnErrorWhenItIsStopped) {
  const std::vector<double> shares = told_by(GetParam(), 2).shares;
  for (const double share : {shares.front(), shares[shares.size() / 2], shares.back()}) {
    const Told told = told_by(GetParam(), share);
    ASSERT_FALSE(told.result) << share;
    EXPECT_EQ(told.result.error().message, "was cancelled");
    EXPECT_EQ(told.shares.back(), share) << "no more progress is reported";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LongReading, testing::Values("json", "tmj", "tmx", "talusrec"));

}  // namespace talus::reading_progress_test
