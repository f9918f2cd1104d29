// Native levels as text, and the errors of invalid ones.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "formats/native/native.h"

namespace talus {

// A level with its version and these members.
inline std::string native_with(const std::string& members) { return R"({"talus": 1, )" + members + "}"; }

inline Level level_of_native(const std::string& text) { return read_native(text, {}).value(); }
inline std::string native_of_level(const Level& level) { return write_native(level, {}).value().bytes; }

inline void expect_native_error(const std::string& text, const std::string& place,
                                const std::string& message) {
  const auto level = read_native(text, {});
  ASSERT_FALSE(level) << text;
  EXPECT_EQ(level.error().place, place) << text;
  EXPECT_EQ(level.error().message, message) << text;
}

}  // namespace talus
