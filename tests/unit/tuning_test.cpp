// The table of the physics' numbers.
#include <talus/level/tuning.h>

#include <gtest/gtest.h>

#include <set>

namespace talus::tuning_test {

TEST(Tuning, EveryNumberHasOneField) {
  constexpr std::size_t kNumbers =
      (sizeof(SharedTuning) + sizeof(ExactTuning) + sizeof(PlayerTuning)) / sizeof(double);
  std::set<std::string> paths;
  std::set<double*> places;
  Tuning tuning;
  for (const TuningField& field : tuning_fields()) {
    paths.insert(field.path());
    places.insert(&field.in(tuning));
    EXPECT_TRUE(field.accepts(field.standard())) << field.path();
  }
  EXPECT_EQ(tuning_fields().size(), kNumbers);
  EXPECT_EQ(paths.size(), kNumbers);
  EXPECT_EQ(places.size(), kNumbers);
}

TEST(Tuning, FieldsReachTheirGroup) {
  Tuning tuning;
  for (const TuningField& field : tuning_fields()) {
    if (field.path() == "gravity") FAIL() << "gravity is in groups alone";
    if (field.path() == "exact.gravity") field.in(tuning) = 3;
    if (field.path() == "player.gravity") field.in(tuning) = 5;
  }
  EXPECT_EQ(tuning.exact.gravity, 3);
  EXPECT_EQ(tuning.player.gravity, 5);
}

TEST(Tuning, SomeNumbersAreWhole) {
  for (const TuningField& field : tuning_fields()) {
    if (field.path() == "exact.max_passes") {
      EXPECT_TRUE(field.accepts(5));
      EXPECT_FALSE(field.accepts(5.5));
      EXPECT_FALSE(field.accepts(3));
    }
    EXPECT_EQ(field.accepts((field.min + field.max) / 2 + 0.015625), !field.whole) << field.path();
  }
}

TEST(Tuning, SolversAreKnownByName) {
  for (const SolverKind solver : solver_kinds()) EXPECT_EQ(solver_of_name(solver_name(solver)), solver);
  EXPECT_EQ(solver_kinds().size(), 3u);
  EXPECT_EQ(solver_of_name("exact"), SolverKind::exact);
  EXPECT_EQ(solver_of_name("Exact"), std::nullopt);
  EXPECT_EQ(solver_of_name(""), std::nullopt);
}

TEST(Tuning, NewLevelsHaveTheExactSolver) { EXPECT_EQ(Tuning().solver, SolverKind::exact); }

}  // namespace talus::tuning_test
