// The exact solver moves bodies over random ground of every kind as its geometry says. TALUS_PROVE_LEVELS:
// the number of levels, at least kLevels.
#include <gtest/gtest.h>

#include "prove/proof.h"
#include "random_levels.h"
#include "tries.h"

namespace talus::prove_property_test {

constexpr int kLevels = 200;
constexpr int kShares = 8;  // tests, so that they run side by side

class ProveProperty : public testing::TestWithParam<int> {};

TEST_P(ProveProperty, RandomLevelsHaveNoFindingOfTheSolver) {
  const auto levels = static_cast<std::uint64_t>(tries("TALUS_PROVE_LEVELS", kLevels));
  for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < levels; seed += kShares) {
    Dice dice(seed);
    const Proof proof = *prove(ProveScene(random_level(dice), {}), 1);
    for (const Finding& finding : proof.findings)
      EXPECT_TRUE(info_of(finding.kind).of_level) << "level " << seed << ": " << message_of(finding);
  }
}
INSTANTIATE_TEST_SUITE_P(, ProveProperty, testing::Range(0, kShares));

}  // namespace talus::prove_property_test
