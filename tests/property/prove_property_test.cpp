// The exact solver moves bodies over random ground of every kind as its geometry says. TALUS_PROVE_LEVELS:
// the number of levels, at least kLevels.
#include <gtest/gtest.h>

#include <array>

#include "level/resize.h"
#include "prove/proof.h"
#include "random_levels.h"
#include "tries.h"

namespace talus::prove_property_test {

constexpr int kLevels = 200;
constexpr int kMeetLevels = 24;
constexpr int kShares = 8;  // tests, so that they run side by side

class ProveProperty : public testing::TestWithParam<int> {};

void expect_no_finding_of_the_solver(const Level& level, std::uint64_t seed) {
  const Proof proof = *prove(ProveScene(level, {}), 1);
  for (const Finding& finding : proof.findings)
    EXPECT_TRUE(info_of(finding.kind).of_level) << "level " << seed << ": " << message_of(finding);
}

void expect_no_finding_of_the_solver(std::uint64_t seed) {
  Dice dice(seed);
  expect_no_finding_of_the_solver(random_level(dice), seed);
}

TEST_P(ProveProperty, RandomLevelsHaveNoFindingOfTheSolver) {
  const auto levels = static_cast<std::uint64_t>(tries("TALUS_PROVE_LEVELS", kLevels));
  for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < levels; seed += kShares)
    expect_no_finding_of_the_solver(seed);
}

// The same level, with one body of each kind that meets others.
Level level_of_bodies_that_meet(std::uint64_t seed) {
  Dice dice(seed);
  Level level = random_level(dice);
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  level.tuning.exact.gravity = dice.one_in(2) ? 0 : 0.2;
  const Vec2 usual = new_body_size(BodyKind::ball, level.map.tile_size());
  level.spawns.clear();
  for (const BodyKind kind : {BodyKind::ball, BodyKind::crate, BodyKind::disc, BodyKind::marble}) {
    Spawn spawn;
    spawn.kind = kind;
    spawn.size = usual * dice.step(0.5, 1.75, 4);
    if (kind == BodyKind::crate) spawn.size.y = usual.y;
    level.spawns.push_back(spawn);
  }
  return level;
}

TEST_P(ProveProperty, BodiesThatMeetHaveNoFindingOfTheSolver) {
  const auto levels = static_cast<std::uint64_t>(tries("TALUS_PROVE_LEVELS", kMeetLevels));
  for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < levels; seed += kShares)
    expect_no_finding_of_the_solver(level_of_bodies_that_meet(seed), seed);
}

// What the nightly run has found.
TEST_P(ProveProperty, LevelsThatOnceHadAFindingOfTheSolverHaveNone) {
  constexpr std::array<std::uint64_t, 29> kSeeds = {
      561,  654,  716,  1020, 1240, 1337, 1503, 2132, 2203, 2632, 2644, 2712, 2855, 2940, 3157,
      3787, 4034, 4815, 5025, 5075, 5140, 5317, 6240, 7275, 7485, 7902, 7957, 8556, 9421};
  for (auto i = static_cast<std::size_t>(GetParam()); i < kSeeds.size(); i += kShares)
    expect_no_finding_of_the_solver(kSeeds[i]);
}

std::string text_of(const Proof& proof) {
  std::string text = summary_of(proof);
  for (const Finding& finding : proof.findings)
    text += "\n" + message_of(finding) + " x" + std::to_string(finding.count);
  return text;
}

// What is taken over from the proof before an edit is what would be found anew.
TEST(ProveAgain, AfterAnEditTheProofIsThatOfTheEditedLevel) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Dice dice(seed);
    Level level = random_level(dice);
    ResizedMap wide = resized(level, {.width = 100, .height = level.map.height()});
    level.map = wide.map;
    level.layers = wide.layers;
    const auto scene_of = [&] { return std::make_shared<const ProveScene>(level, ProveOptions()); };
    ProofRun before(scene_of());
    ASSERT_TRUE(before.run(1));
    level.map.set({80, 9}, 1);
    level.map.set({81, 10}, 1);
    ProofRun after(scene_of(), &before, {80, 9});
    ASSERT_TRUE(after.run(2));
    ProofRun anew(scene_of());
    ASSERT_TRUE(anew.run(1));
    EXPECT_EQ(text_of(after.proof()), text_of(anew.proof())) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(, ProveProperty, testing::Range(0, kShares));

}  // namespace talus::prove_property_test
