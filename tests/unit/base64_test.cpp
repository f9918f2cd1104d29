#include "formats/text/base64.h"

#include <gtest/gtest.h>

namespace talus {
namespace {

// The vectors of RFC 4648, and bytes that use every bit of a digit.
TEST(Base64, EncodesAndDecodesTheVectorsOfTheRfc) {
  const std::pair<std::string, std::string> kVectors[] = {
      {"", ""},
      {"f", "Zg=="},
      {"fo", "Zm8="},
      {"foo", "Zm9v"},
      {"foob", "Zm9vYg=="},
      {"fooba", "Zm9vYmE="},
      {"foobar", "Zm9vYmFy"},
      {"\xfb\xff\xbf", "+/+/"},
  };
  for (const auto& [bytes, text] : kVectors) {
    EXPECT_EQ(encode_base64(bytes), text);
    EXPECT_EQ(decode_base64(text), bytes);
  }
}

TEST(Base64, DecodesAllBytesAndSkipsBlanks) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) bytes += static_cast<char>(byte);
  EXPECT_EQ(decode_base64(encode_base64(bytes)), bytes);
  EXPECT_EQ(decode_base64(" Zm9v\r\n\tYmFy\n"), "foobar");
}

TEST(Base64, OtherCharactersDecodeToNothing) {
  for (const char* text : {"Zm9*", "Zm9-", "_m9v", "Zm9v,", "\xc3\xa4"})
    EXPECT_EQ(decode_base64(text), std::nullopt);
}

}  // namespace
}  // namespace talus
