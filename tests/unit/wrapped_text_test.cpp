// Lines that end between words.
#include "panels/ui/wrapped_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace talus::wrapped_text_test {

using ::testing::ElementsAre;

std::vector<std::string_view> lines(std::string_view text, std::size_t most) {
  return lines_between_words(text, [most](std::string_view line) { return line.size() <= most; });
}

TEST(LinesBetweenWords, KeepNumbersWhole) {
  EXPECT_THAT(lines("went (0.04, 0.02) px. It met", 16), ElementsAre("went (0.04,", "0.02) px. It met"));
  for (std::size_t most = 1; most < 40; ++most) {
    for (const std::string_view line : lines("at 0.37 of 12.5 px", most))
      EXPECT_FALSE(line.ends_with('.') || line.starts_with('.')) << most << ": " << line;
  }
}

TEST(LinesBetweenWords, LinesAreAsLongAsTheWidthAllows) {
  EXPECT_THAT(lines("ab cd ef", 8), ElementsAre("ab cd ef"));
  EXPECT_THAT(lines("ab cd ef", 7), ElementsAre("ab cd", "ef"));
  EXPECT_THAT(lines("ab cd ef", 2), ElementsAre("ab", "cd", "ef"));
}

TEST(LinesBetweenWords, ALongWordGetsItsOwnLine) {
  EXPECT_THAT(lines("a longword b", 4), ElementsAre("a", "longword", "b"));
  EXPECT_THAT(lines("longword", 4), ElementsAre("longword"));
  EXPECT_THAT(lines("", 4), ElementsAre(""));
}

}  // namespace talus::wrapped_text_test
