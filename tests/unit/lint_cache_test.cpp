// The lint of an edited level finds the same problems as a lint of the whole level.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "level/lint/lint_cache.h"
#include "slope_level.h"

namespace talus::lint_cache_test {

// Checks one block.
bool advance(LintCache& cache, const Level& level) {
  return cache.advance(level, {}, [] { return false; });
}

Level random_slopes(int width, int height, std::mt19937& random) {
  Level level = slope_level({"."});
  level.map = TileMap(width, height);
  for (TileNumber& tile : level.map.cells().tiles())
    tile = random() % 3 == 0 ? static_cast<TileNumber>(random() % kSlopeSigns.size()) : 0;
  level.spawns = {{"", {40, 40}, {}, "", BodyKind::player, {7, 14}}};
  return level;
}

// Puts a random tile into the cell.
void change_cell(Level& level, Cell cell, std::mt19937& random, LintCache& cache) {
  level.map.set(cell, static_cast<TileNumber>(random() % kSlopeSigns.size()));
  cache.note_cell(cell);
}

TEST(LintCache, AChangedCellIsCheckedWithItsNeighbours) {
  std::mt19937 random(1);
  Level level = random_slopes(48, 16, random);
  LintCache cache;
  cache.finish(level, {});
  for (int i = 0; i < 200; ++i) {
    for (int n = 0; n <= i % 3; ++n) {
      const Cell cell{static_cast<int>(random() % 48), static_cast<int>(random() % 16)};
      change_cell(level, cell, random, cache);
    }
    ASSERT_TRUE(advance(cache, level));
    ASSERT_EQ(cache.problems(), lint(level)) << i;
  }
}

TEST(LintCache, AChangedCellAffectsTheNextBlocksToo) {
  std::mt19937 random(2);
  Level level = random_slopes(64, 64, random);  // four blocks, of 32x32
  LintCache cache;
  int times = 1;
  for (; !advance(cache, level); ++times) {
  }
  EXPECT_EQ(times, 4);
  ASSERT_EQ(cache.problems(), lint(level));
  for (int i = 0; i < 60; ++i) {
    const Cell cell{26 + static_cast<int>(random() % 12), 26 + static_cast<int>(random() % 12)};
    change_cell(level, cell, random, cache);
    while (!advance(cache, level)) {  // a block with more problems than are listed is checked again
    }
    ASSERT_EQ(cache.problems(), lint(level)) << i;
  }
}

TEST(LintCache, TheUppermostOfTooManyProblemsAreListed) {
  std::mt19937 random(5);
  Level level = random_slopes(128, 128, random);
  for (int y = 0; y < 6; ++y) {  // the uppermost are in the last block of their row
    for (int x = 0; x < 100; ++x) level.map.set({x, y}, 0);
  }
  const std::vector<Problem> found = lint(level);
  ASSERT_EQ(found.size(), kMaxProblems + 1);
  EXPECT_EQ(found[0].rule->code, "more");
  EXPECT_GE(found[1].cell->x, 100);
  EXPECT_TRUE(std::is_sorted(found.begin() + 1, found.end(), [](const Problem& a, const Problem& b) {
    return std::pair(a.cell->y, a.cell->x) < std::pair(b.cell->y, b.cell->x);
  }));
}

TEST(LintCache, BlocksOfALargeMapAreLarger) {
  std::mt19937 random(4);
  Level level = random_slopes(40'000, 3, random);  // 625 blocks 64 cells wide
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 40'000; ++x) {
      if (std::abs(x - 64) > 30 && std::abs(x - 32'768) > 30) level.map.set({x, y}, 0);
    }
  }
  LintCache cache;
  int times = 1;
  for (; !advance(cache, level); ++times) {
  }
  EXPECT_EQ(times, 625);
  EXPECT_EQ(cache.problems(), lint(level));
  EXPECT_FALSE(cache.problems().empty());
  for (int i = 0; i < 60; ++i) {
    const int border = random() % 2 == 0 ? 64 : 32'768;
    const Cell cell{border - 12 + static_cast<int>(random() % 24), static_cast<int>(random() % 3)};
    change_cell(level, cell, random, cache);
    ASSERT_TRUE(advance(cache, level));
    ASSERT_EQ(cache.problems(), lint(level)) << i;
  }
}

TEST(LintCache, AChangedTileIsCheckedInAllBlocksStepByStep) {
  std::mt19937 random(3);
  Level level = random_slopes(64, 8, random);
  level.map = TileMap(32, 320);  // ten blocks
  level.map.set({10, 1}, kSlopeA);
  level.map.set({10, 319}, kSlopeA);
  level.spawns.resize(1);
  LintCache cache;
  EXPECT_FALSE(cache.is_done());
  cache.finish(level, {});
  EXPECT_THAT(cache.problems(), testing::IsEmpty());  // slopes in the air
  level.sheet(SheetId::tiles).flags[kSlopeA] = 4;  // without its own shape it would be a slope of two tiles
  cache.note_rest();
  EXPECT_FALSE(cache.is_done());
  for (int i = 0; i < 9; ++i) {
    EXPECT_FALSE(advance(cache, level)) << i;
    ASSERT_EQ(cache.problems().size(), 1u);
    EXPECT_EQ(cache.problems()[0].cell, (Cell{10, 1}));
  }
  EXPECT_TRUE(advance(cache, level));
  EXPECT_EQ(cache.problems(), lint(level));
  EXPECT_EQ(cache.problems().size(), 2u);
}

TEST(LintCache, APaintedPixelChecksNoBlockAgain) {
  Level level = slope_level({"o....", ".a##.", "#####"});
  LintCache cache;
  cache.finish(level, {});
  level.sheet(SheetId::tiles).images[kSolidSign][5] = 7;
  cache.note_rest();
  EXPECT_TRUE(advance(cache, level));
  EXPECT_EQ(cache.problems().size(), 1u);
}

TEST(LintCache, AnotherMapIsCheckedFromTheStart) {
  LintCache cache;
  cache.finish(slope_level({"o....", ".a##.", "#####"}), {});
  EXPECT_EQ(cache.problems().size(), 1u);
  const Level other = slope_level({"o..e", "####"});
  cache.note_map();
  cache.finish(other, {});
  EXPECT_EQ(cache.problems(), lint(other));
}

}  // namespace talus::lint_cache_test
