// Random ground with planted faults: no fix adds a problem, an overhang, a jump or a pit.
#include "level/lint/fixes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "collision/tile_outlines.h"
#include "property/tries.h"
#include "prove/proof.h"
#include "slope_level.h"

namespace talus::fix_property_test {

constexpr int kWidth = 14, kHeight = 9;  // cells

// Ground of steps and ramps from the left to the right, in which some cells have another tile, and some
// shapes another height.
Level faulty_level(unsigned seed) {
  std::mt19937 engine(seed);
  const auto up_to = [&](int last) { return static_cast<int>(engine() % static_cast<unsigned>(last + 1)); };
  std::vector<std::string> rows(kHeight, std::string(kWidth, '.'));
  rows[0][0] = 'o';
  int top = 3 + up_to(2);  // the row of the upper full tiles
  for (int x = 0; x < kWidth; ++x) {
    const auto at = [&](int column, int row) -> char& {
      return rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    };
    const bool is_wide = x + 1 < kWidth;
    const int what = up_to(5);
    if (what == 0 && top > 2) --top;
    if (what == 1 && top < kHeight - 2) ++top;
    for (int y = top; y < kHeight; ++y) at(x, y) = '#';
    if (what > 2 || !is_wide) continue;
    const bool rises = what == 0 || (what == 2 && up_to(1) == 0);
    for (int y = top; y < kHeight; ++y) at(x + 1, y) = '#';
    const bool is_flagged = rises && up_to(3) == 0;
    at(x, top - 1) = is_flagged ? '/' : rises ? 'a' : 'c';
    at(x + 1, top - 1) = is_flagged ? '-' : rises ? 'b' : 'd';
    ++x;
    if (rises && top > 2) --top;
  }
  for (int i = up_to(3); i >= 0; --i)
    rows[static_cast<std::size_t>(1 + up_to(kHeight - 2))][static_cast<std::size_t>(up_to(kWidth - 1))] =
        kSlopeSigns[static_cast<std::size_t>(up_to(10))];
  Level level = slope_level(rows);
  for (int tile = kSlopeA; tile <= kBlockE; ++tile) {
    if (up_to(3) != 0) continue;
    std::vector<double>& heights = level.tile_shapes[static_cast<std::size_t>(tile)].heights;
    heights[static_cast<std::size_t>(up_to(1))] = up_to(16) / 2.0;
  }
  return level;
}

// The ground as pixels, by column from the top: independent of the outline.
using Pixels = std::vector<std::vector<bool>>;
Pixels pixels_of(const Level& level) {
  const TileSize size = level.map.tile_size();
  Pixels pixels(static_cast<std::size_t>(level.map.px_width()),
                std::vector<bool>(static_cast<std::size_t>(level.map.px_height())));
  for (Cell c{0, 0}; c.y < kHeight; ++c.y) {
    for (c.x = 0; c.x < kWidth; ++c.x) {
      const TileShape shape = shape_of_tile(level, level.map.tile_at(c));
      if (shape.kind == TileShape::Kind::none) continue;
      const bool is_floor = shape.side == TileShape::Side::floor;
      for (int x = 0; x < shape.tiles * size.width && c.x * size.width + x < kWidth * size.width; ++x) {
        const double height = height_of_line(shape, x + 0.5, size);
        for (int y = 0; y < height; ++y) {
          const int row = is_floor ? (c.y + 1) * size.height - 1 - y : c.y * size.height + y;
          if (row >= 0 && row < kHeight * size.height)
            pixels[static_cast<std::size_t>(c.x * size.width + x)][static_cast<std::size_t>(row)] = true;
        }
      }
    }
  }
  return pixels;
}

int top_of(const std::vector<bool>& column) {
  return static_cast<int>(std::find(column.begin(), column.end(), true) - column.begin());
}
int overhangs_of(const std::vector<bool>& column) {
  int count = 0;
  for (std::size_t y = 1; y < column.size(); ++y) count += column[y - 1] && !column[y] ? 1 : 0;
  return count;
}
// How far the top of a column is below those on both sides, at most `reach` columns away.
int depth_of(const Pixels& pixels, int x, int reach) {
  const int last = static_cast<int>(pixels.size()) - 1;
  int left = top_of(pixels[static_cast<std::size_t>(x)]), right = left;
  const int own = left;
  for (int i = std::max(x - reach, 0); i < x; ++i)
    left = std::min(left, top_of(pixels[static_cast<std::size_t>(i)]));
  for (int i = x + 1; i <= std::min(x + reach, last); ++i)
    right = std::min(right, top_of(pixels[static_cast<std::size_t>(i)]));
  return own - std::max(left, right);
}

void expect_no_worse_ground(const Level& before, const Level& after, const std::string& what) {
  constexpr int kPixel = 2;  // px; a steep line jumps by so much from column to column
  const Pixels old = pixels_of(before), now = pixels_of(after);
  for (std::size_t x = 0; x < now.size(); ++x) {
    EXPECT_LE(overhangs_of(now[x]), overhangs_of(old[x])) << what << " at " << x << " px";
    if (now[x] != old[x]) {
      EXPECT_LE(depth_of(now, static_cast<int>(x), 16), depth_of(old, static_cast<int>(x), 16) + 1)
          << what << " at " << x << " px";
    }
    if (x == 0) continue;
    const int jump = std::abs(top_of(now[x]) - top_of(now[x - 1]));
    EXPECT_LE(jump, std::max(std::abs(top_of(old[x]) - top_of(old[x - 1])) + 1, kPixel))
        << what << " at " << x << " px";
  }
}

std::map<std::string, int> findings(const Level& level) {
  std::map<std::string, int> counts;
  for (const Problem& problem : lint(level)) {
    const Cell cell = problem.cell.value_or(Cell{-1, -1});
    ++counts[std::string(problem.rule->code) + " at " + std::to_string(cell.x) + ", " +
             std::to_string(cell.y)];
  }
  return counts;
}

void expect_no_new_finding(const Level& before, const Level& after, const std::string& what) {
  const auto old = findings(before);
  for (const auto& [finding, count] : findings(after)) {
    const auto known = old.find(finding);
    EXPECT_LE(count, known == old.end() ? 0 : known->second) << what << " adds " << finding;
  }
}

TEST(FixProperty, NoFixMakesTheGroundWorse) {
  int tried = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Level level = faulty_level(seed);
    for (const Problem& problem : lint(level)) {
      for (const Edit& edit : fixes_for(level, level, {}, problem)) {
        const std::string what = "level " + std::to_string(seed) + ", " + edit.label;
        Level fixed = level;
        apply_edit(fixed, edit);
        expect_no_new_finding(level, fixed, what);
        expect_no_worse_ground(level, fixed, what);
        EXPECT_LT(lint(fixed).size(), lint(level).size()) << what;
        revert_edit(fixed, edit);
        EXPECT_TRUE(fixed == level) << what;
        ++tried;
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(tried, 100) << "the levels have faults that can be fixed";
}

TEST(FixProperty, FixingAllOfEachKindAddsNothing) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Level level = faulty_level(seed);
    for (const LintRule* rule : lint_rules()) {
      Level fixed = level;
      const Edit edit = fix_all(level, level, {}, lint(level), *rule);
      apply_edit(fixed, edit);
      expect_no_new_finding(level, fixed, "level " + std::to_string(seed) + ", " + edit.label);
      level = fixed;
    }
    if (HasFailure()) return;
  }
}

TEST(FixProperty, FixingOneByOneEnds) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Level level = faulty_level(seed);
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      const std::vector<Problem> problems = lint(level);
      for (const Problem& problem : problems) {
        const std::vector<Edit> fixes = fixes_for(level, level, {}, problem);
        if (fixes.empty()) continue;
        apply_edit(level, fixes.front());
        ASSERT_LT(lint(level).size(), problems.size()) << "level " << seed << ", " << fixes.front().label;
        goes_on = true;
        break;
      }
    }
  }
}

// What the solver finds when it moves a player over the ground, by kind.
std::map<FindingKind, int> proof_of(Level level) {
  level.tuning.solver = SolverKind::exact;
  const Proof proof = *prove(ProveScene(level, {.bodies = {{.speed = 1}}}), 1);
  std::map<FindingKind, int> counts;
  for (const Finding& finding : proof.findings) ++counts[finding.kind];
  return counts;
}

// TALUS_FIXED_LEVELS: the number of levels, at least kFixedLevels.
TEST(FixProperty, AllFixesTogetherNeverAddAFindingOfTheProof) {
  constexpr double kFixedLevels = 40;
  const auto last = static_cast<unsigned>(tries("TALUS_FIXED_LEVELS", kFixedLevels));
  int better = 0;
  for (unsigned seed = 1; seed <= last; ++seed) {
    const Level level = faulty_level(seed);
    Level fixed = level;
    for (const LintRule* rule : lint_rules())
      apply_edit(fixed, fix_all(fixed, fixed, {}, lint(fixed), *rule));
    const auto before = proof_of(level), after = proof_of(fixed);
    for (const auto& [kind, count] : after) {
      const auto old = before.find(kind);
      EXPECT_LE(count, old == before.end() ? 0 : old->second)
          << "level " << seed << " " << info_of(kind).label;
    }
    better += after != before ? 1 : 0;
  }
  EXPECT_GT(better, 0) << "the levels have faults that a proof finds, and that can be fixed";
}

}  // namespace talus::fix_property_test
