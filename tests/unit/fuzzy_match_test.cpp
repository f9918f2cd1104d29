// Finding names by a few letters.
#include "panels/ui/fuzzy_match.h"

#include <gtest/gtest.h>

namespace talus::fuzzy_match_test {

TEST(FuzzyScore, LettersMustComeInOrder) {
  EXPECT_TRUE(fuzzy_score("Screen borders", "scb"));
  EXPECT_TRUE(fuzzy_score("Screen borders", "SCREEN"));
  EXPECT_TRUE(fuzzy_score("Screen borders", "s b"));
  EXPECT_FALSE(fuzzy_score("Screen borders", "bs c"));
  EXPECT_FALSE(fuzzy_score("Screen borders", "screens borders"));
  EXPECT_FALSE(fuzzy_score("", "a"));
}

TEST(FuzzyScore, LettersMatchWithoutTheirAccents) {
  EXPECT_TRUE(fuzzy_score("Run in LÖVE", "run in love"));
  EXPECT_TRUE(fuzzy_score("Run in LÖVE", "löv"));
  EXPECT_TRUE(fuzzy_score("Cave", "CÀVÉ"));
  EXPECT_FALSE(fuzzy_score("Cave", "cav\xC3")) << "half a letter";
  EXPECT_FALSE(fuzzy_score("1 \xC3\x97 2", "x")) << "a times sign is no letter";
}

TEST(FuzzyScore, AnEmptyPatternMatchesEverything) {
  EXPECT_TRUE(fuzzy_score("Save", ""));
  EXPECT_TRUE(fuzzy_score("", ""));
  EXPECT_TRUE(fuzzy_score("Save", "  "));
}

TEST(FuzzyScore, BeginningsOfWordsAndLettersInARowComeFirst) {
  EXPECT_GT(fuzzy_score("Save as...", "sa"), fuzzy_score("Reset all", "sa"));
  EXPECT_GT(fuzzy_score("Step one frame", "sof"), fuzzy_score("Shows the offset", "sof"));
  EXPECT_GT(fuzzy_score("Fill", "fill"), fuzzy_score("Flip it all", "fill"));
  EXPECT_GT(fuzzy_score("Save", "save"), fuzzy_score("Save as...", "save")) << "the shorter of equals";
}

TEST(FuzzyScore, TakesTheBestOfSeveralWays) {
  EXPECT_GT(fuzzy_score("a cat", "ca"), fuzzy_score("ac a", "ca"));
  EXPECT_GT(fuzzy_score("aab ab", "ab"), fuzzy_score("xab", "ab"));
}

}  // namespace talus::fuzzy_match_test
