// Numbers in conditions and sentences.
#pragma once

#include <string>

#include <talus/collision/geometry.h>

namespace talus {

// The shortest decimal that reads back as the same double: "0.1".
std::string exact_text(double number);

// For people, with two decimals at most: "0.37", "2"; of what would be 0 with these, one digit: "2e-14".
std::string short_text(double number);
std::string short_text(Vec2 v);  // "(0.37, 2)"; a part below kOnlyRounding is 0

inline constexpr double kOnlyRounding = 1e-9;  // less is nothing but rounding
inline constexpr double kLeastTold = 0.005;    // px, or px/frame: less would be 0 with two decimals

// Of a motion or a velocity, which is not told where it is less than kLeastTold: "(0.37, 2)", "(0, 2)"; "less
// than 0.005" of one that is as small as a whole.
std::string motion_text(Vec2 v);

}  // namespace talus
