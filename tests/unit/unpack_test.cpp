// Packed content of files, which may claim to be larger or smaller than it is.
#include <gtest/gtest.h>
#include <zstd.h>

#include "formats/text/unpack.h"

namespace talus::unpack_test {

using namespace std::string_literals;

std::string packed(const std::string& bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 19));
  return out;
}

TEST(UnpackZstd, GivesTheContentUpToTheLimit) {
  const std::string content(100'000, 'a');
  EXPECT_EQ(unpack_zstd(packed(content), 100'000), content);
  EXPECT_EQ(unpack_zstd(packed(""), 0), "");
  const auto larger = unpack_zstd(packed(content), 99'999);
  ASSERT_FALSE(larger);
  EXPECT_TRUE(larger.error().is_too_large);
}

TEST(UnpackZstd, SeveralFramesAreOneContent) {
  EXPECT_EQ(unpack_zstd(packed("one, ") + packed("") + packed("two"), 100), "one, two");
  EXPECT_TRUE(unpack_zstd(packed("one, ") + packed("two"), 7).error().is_too_large);
}

TEST(UnpackZstd, DamagedStreamsAreErrors) {
  const std::string good = packed("a short text, which is not repeated");
  EXPECT_EQ(unpack_zstd("", 100).error().reason, "the end is missing");
  EXPECT_EQ(unpack_zstd(good.substr(0, good.size() - 1), 100).error().reason, "the end is missing");
  EXPECT_EQ(unpack_zstd("text", 100).error().reason, "Unknown frame descriptor");
  EXPECT_EQ(unpack_zstd(good + "more", 100).error().reason, "Unknown frame descriptor");
}

// Frames that are made by hand: magic number, descriptor, window or size, and a last block of one byte.
TEST(UnpackZstd, ClaimedSizesDoNotCount) {
  const std::string magic = "\x28\xb5\x2f\xfd", block = "\x09\0\0x"s;
  EXPECT_EQ(unpack_zstd(magic + "\0\x88"s + block, 1), "x") << "a window of 128 MiB, for one byte";
  EXPECT_EQ(unpack_zstd(magic + "\0\x90"s + block, 1).error().reason,
            "Frame requires too much memory for decoding");
  EXPECT_EQ(unpack_zstd(magic + "\xe0\0\0\0\0\0\1\0\0"s + block, 1).error().reason,
            "Frame requires too much memory for decoding")
      << "a content of 1 TiB";
}

}  // namespace talus::unpack_test
