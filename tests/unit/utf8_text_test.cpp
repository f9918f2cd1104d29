// Text of files, as it is shown to the user.
#include "formats/text/utf8_text.h"

#include <gtest/gtest.h>

#include <talus/formats/format.h>

namespace talus::utf8_text_test {

TEST(Utf8Text, IsTold) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("a\n\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\xf4\x8f\xbf\xbf"));
  for (const char* bad : {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80",
                          "\xf4\x90\x80\x80", "\xff", "a\xe2\x82"})
    EXPECT_FALSE(is_utf8(bad)) << printable(bad);
}

TEST(Utf8Text, BytesThatAreNoTextAreEscaped) {
  EXPECT_EQ(printable("caf\xc3\xa9 \xe2\x82\xac"), "caf\xc3\xa9 \xe2\x82\xac");
  EXPECT_EQ(printable(std::string_view("a\nb\r\t\0\x7f", 7)), R"(a\nb\r\t\x00\x7f)");
  EXPECT_EQ(printable("\x1b[31mred"), R"(\x1b[31mred)");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            R"(\u009b31m)")
      << "another way to write ESC [";
  EXPECT_EQ(printable("a\xe2\x80\xa8"
                      "b"),
            R"(a\u2028b)");
  EXPECT_EQ(printable("\xe2\x80\xaetxt.exe"), R"(\u202etxt.exe)");
  EXPECT_EQ(printable("\xe2\x81\xa6"), R"(\u2066)");
  EXPECT_EQ(printable("a\xff\xc3"), R"(a\xff\xc3)");
  EXPECT_EQ(printable(R"(a\nb)"), R"(a\nb)") << "backslashes stay";
  EXPECT_EQ(printable(printable("a\n\x1b")), printable("a\n\x1b"));
}

TEST(Utf8Text, NoLineCanBecomeACommandOfALog) {
  EXPECT_EQ(printable_line("::error file=a::b"), R"(\x3a:error file=a::b)");
  EXPECT_EQ(printable_line("  ::error"), R"(  \x3a:error)");
  EXPECT_EQ(printable_line("\u00a0\u2003 \u3000::error"), "\u00a0\u2003 \u3000\\x3a:error")
      << "all white space";
  EXPECT_EQ(printable_line("\u00a0a::b"), "\u00a0a::b");
  EXPECT_EQ(printable_line("a.tmx\n::error"), R"(a.tmx\n::error)") << "it is one line";
  EXPECT_EQ(printable_line("a ##[error] ##vso[task] ## b"), R"(a \x23#[error] \x23#vso[task] ## b)");
  EXPECT_EQ(printable_line("###teamcity[x] ##a b["), R"(#\x23#teamcity[x] ##a b[)");
}

TEST(Utf8Text, LongTextIsCutBetweenCharacters) {
  EXPECT_EQ(shortened("abcdef", 6), "abcdef");
  EXPECT_EQ(shortened("abcdefg", 6), "abc...");
  EXPECT_EQ(shortened("ab\xc3\xa9"
                      "efg",
                      6),
            "ab...");
}

TEST(Utf8Text, ErrorsAreOneLineOfBoundedLength) {
  EXPECT_EQ(to_string({"layer \"a\n\"", "is \x1b[2J", "try\r"}, "b\n::error::.tmx"),
            R"(b\n::error::.tmx:layer "a\n": error: is \x1b[2J: try\r)");
  EXPECT_LT(to_string({std::string(1 << 20, 'a'), std::string(1 << 20, 'b')}, "f").size(), 5000u);
}

}  // namespace talus::utf8_text_test
