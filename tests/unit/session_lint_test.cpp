// The problems in a session: found while time passes, and always those of the current level.
#include <gtest/gtest.h>

#include <limits>

#include "session/session.h"
#include "slope_level.h"

namespace talus::session_lint_test {

void look_at_all(Session& session) {
  for (int i = 0; i < 10'000 && session.is_linting(); ++i) session.advance(0);
}

TEST(SessionLint, AdvanceListsThem) {
  Session session(slope_level({"o....", ".a##.", "#####"}));
  EXPECT_TRUE(session.is_linting());
  EXPECT_TRUE(session.listed_problems().empty());
  session.advance(0);
  EXPECT_FALSE(session.is_linting());
  ASSERT_EQ(session.listed_problems().size(), 1u);

  session.apply(action::EditLevel{{"Paint", {CellChange{{1, 1}, kSlopeA, 0}}}});
  EXPECT_TRUE(session.is_linting());
  EXPECT_EQ(session.listed_problems().size(), 1u);  // as before
  session.advance(0);
  EXPECT_TRUE(session.listed_problems().empty());
  session.apply(action::Undo{});
  EXPECT_EQ(session.problems().size(), 1u);  // does not wait
}

TEST(SessionLint, ALargeLevelIsLookedAtALittleAtATime) {
  Level level = slope_level({"."});
  level.map = TileMap(4096, 512);
  for (int y = 1; y < 512; y += 2) {
    for (int x = 0; x < 4096; x += 30) level.map.set({x, y}, kSlopeA);
  }
  level.map.set({7, 511}, kFlaggedSlope);
  level.spawns.resize(1);
  Session session(std::move(level));
  session.advance(0);
  EXPECT_TRUE(session.is_linting());
  look_at_all(session);
  ASSERT_EQ(session.listed_problems().size(), 1u);
  EXPECT_EQ(session.listed_problems()[0].cell, (Cell{7, 511}));
}

TEST(SessionLint, AllowedJumpsAreNotListed) {
  Session session(slope_level({"o....", ".a##.", "#####"}));
  EXPECT_EQ(session.problems().size(), 1u);
  session.apply(action::SetLintOptions{{4}});
  EXPECT_TRUE(session.problems().empty());
  session.apply(action::SetLintOptions{{-1}});
  EXPECT_EQ(session.lint_options().seam, 0);
  session.apply(action::SetLintOptions{{std::numeric_limits<double>::quiet_NaN()}});
  EXPECT_EQ(session.lint_options().seam, 0);
  session.apply(action::SetLintOptions{{100}});
  EXPECT_EQ(session.lint_options().seam, max_seam({}));
}

TEST(SessionLint, AnotherLevelHasItsOwnProblems) {
  Session session(slope_level({"o....", ".a##.", "#####"}));
  look_at_all(session);
  session.apply(action::NewLevel{});
  look_at_all(session);
  ASSERT_EQ(session.listed_problems().size(), 1u);
  EXPECT_EQ(session.listed_problems()[0].rule->code, "no-bodies");
}

}  // namespace talus::session_lint_test
