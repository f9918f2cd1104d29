// An unexpected exception becomes the error of one file.
#include "formats/last_catch.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace talus::last_catch_test {

template <class Exception>
std::string error_of(Exception exception) {
  const auto read = read_guarded([&]() -> FormatResult<int> { throw exception; });
  return read ? "" : read.error().message;
}

TEST(LastCatch, AnExceptionOfAReaderBecomesAnError) {
  EXPECT_EQ(error_of(std::bad_alloc()), "cannot be read: there is not enough memory");
  EXPECT_EQ(error_of(std::out_of_range("index 7")), "cannot be read: an unexpected error: index 7");
  EXPECT_EQ(error_of(3), "cannot be read: an unexpected error");
}

TEST(LastCatch, TheResultOfAReaderIsKept) {
  EXPECT_EQ(read_guarded([]() -> FormatResult<int> { return 3; }).value(), 3);
  const auto bad = read_guarded([]() -> FormatResult<int> {
    return tl::unexpected(FormatError{"line 1", "is bad"});
  });
  EXPECT_EQ(bad.error().place, "line 1");
}

}  // namespace talus::last_catch_test
