// The lint of a level that is being edited finds what a lint of the whole level finds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "level/lint_cache.h"
#include "slope_level.h"

namespace talus::lint_cache_test {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

Level random_slopes(int width, int height, std::mt19937& random) {
  Level level = slope_level({"."});
  level.map = TileMap(width, height);
  for (std::uint8_t& tile : level.map.cells())
    tile = random() % 3 == 0 ? static_cast<std::uint8_t>(random() % kSlopeSigns.size()) : 0;
  level.spawns = {{"", {40, 40}, {}, "", BodyKind::player, {7, 14}}};
  return level;
}

// Puts some tile into the cell.
void change_cell(Level& level, Cell cell, std::mt19937& random, LintCache& cache) {
  level.map.set(cell, static_cast<std::uint8_t>(random() % kSlopeSigns.size()));
  cache.note_cell(cell);
}

TEST(LintCache, AChangedCellIsLookedAtWithItsSurroundings) {
  std::mt19937 random(1);
  Level level = random_slopes(48, 16, random);
  LintCache cache;
  cache.advance(level, {}, kAll);
  for (int i = 0; i < 200; ++i) {
    for (int n = 0; n <= i % 3; ++n) {
      const Cell cell{static_cast<int>(random() % 48), static_cast<int>(random() % 16)};
      change_cell(level, cell, random, cache);
    }
    ASSERT_TRUE(cache.advance(level, {}, 1));
    ASSERT_EQ(cache.problems(), lint(level)) << i;
  }
}

TEST(LintCache, AChangedCellCountsInTheNextBlockToo) {
  std::mt19937 random(2);
  Level level = random_slopes(4096, 40, random);  // blocks of 4 rows
  for (int y = 0; y < 40; ++y) {
    for (int x = 40; x < 4096; ++x) level.map.set({x, y}, 0);
  }
  LintCache cache;
  cache.advance(level, {}, kAll);
  for (int i = 0; i < 12; ++i) {
    const Cell cell{static_cast<int>(random() % 40), 13 + static_cast<int>(random() % 6)};
    change_cell(level, cell, random, cache);
    ASSERT_TRUE(cache.advance(level, {}, 1));
    ASSERT_EQ(cache.problems(), lint(level)) << i;
  }
}

TEST(LintCache, ALongRowIsLookedAtInParts) {
  std::mt19937 random(4);
  Level level = random_slopes(40'000, 3, random);  // blocks of 16,384 cells of one row
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 40'000; ++x) {
      if (std::abs(x - 16'384) > 30 && std::abs(x - 32'768) > 30) level.map.set({x, y}, 0);
    }
  }
  LintCache cache;
  int times = 1;
  for (; !cache.advance(level, {}, 1); ++times) {
  }
  EXPECT_EQ(times, 9) << "three blocks in each of three rows";
  EXPECT_EQ(cache.problems(), lint(level));
  EXPECT_FALSE(cache.problems().empty());
  for (int i = 0; i < 60; ++i) {
    const int border = random() % 2 == 0 ? 16'384 : 32'768;
    const Cell cell{border - 12 + static_cast<int>(random() % 24), static_cast<int>(random() % 3)};
    change_cell(level, cell, random, cache);
    ASSERT_TRUE(cache.advance(level, {}, 1));
    ASSERT_EQ(cache.problems(), lint(level)) << i;
  }
}

TEST(LintCache, AChangedTileIsLookedAtInAllBlocksALittleAtATime) {
  std::mt19937 random(3);
  Level level = random_slopes(64, 8, random);
  level.map = TileMap(4096, 40);  // ten blocks
  level.map.set({10, 1}, kSlopeA);
  level.map.set({10, 39}, kSlopeA);
  level.spawns.resize(1);
  LintCache cache;
  EXPECT_FALSE(cache.is_done());
  ASSERT_TRUE(cache.advance(level, {}, kAll));
  EXPECT_THAT(cache.problems(), testing::IsEmpty());  // slopes in the air
  level.sheet(SheetId::tiles).flags[kSlopeA] = 4;     // a slope of two tiles, but for its own shape
  cache.note_rest();
  EXPECT_FALSE(cache.is_done());
  for (int i = 0; i < 9; ++i) {
    EXPECT_FALSE(cache.advance(level, {}, 1)) << i;
    ASSERT_EQ(cache.problems().size(), 1u);
    EXPECT_EQ(cache.problems()[0].cell, (Cell{10, 1}));
  }
  EXPECT_TRUE(cache.advance(level, {}, 1));
  EXPECT_EQ(cache.problems(), lint(level));
  EXPECT_EQ(cache.problems().size(), 2u);
}

TEST(LintCache, APaintedPixelLooksAtNoBlockAgain) {
  Level level = slope_level({"o....", ".a##.", "#####"});
  LintCache cache;
  cache.advance(level, {}, kAll);
  level.sheet(SheetId::tiles).images[kSolidSign][5] = 7;
  cache.note_rest();
  EXPECT_TRUE(cache.advance(level, {}, 0));
  EXPECT_EQ(cache.problems().size(), 1u);
}

TEST(LintCache, AnotherMapIsAnotherLevel) {
  LintCache cache;
  cache.advance(slope_level({"o....", ".a##.", "#####"}), {}, kAll);
  EXPECT_EQ(cache.problems().size(), 1u);
  const Level other = slope_level({"o..e", "####"});
  cache.note_map();
  cache.advance(other, {}, kAll);
  EXPECT_EQ(cache.problems(), lint(other));
}

}  // namespace talus::lint_cache_test
