// Numbers in conditions and sentences.
#pragma once

#include <string>

#include <talus/collision/geometry.h>

namespace talus {

// The shortest decimal that reads back as the same double: "0.1".
std::string exact_text(double number);

// For people, with two decimals at most: "0.37", "2". A number that would be 0 with two decimals keeps one
// digit: "2e-14".
std::string short_text(double number);
std::string short_text(Vec2 v);  // "(0.37, 2)"; a part below kOnlyRounding is 0

inline constexpr double kOnlyRounding = 1e-9;  // smaller numbers are only rounding
inline constexpr double kLeastShown = 0.005;  // px or px/frame; a smaller number would be 0 with two decimals

// A motion or a velocity: "(0.37, 2)". A part below kLeastShown is 0: "(0, 2)". If both are: "less than
// 0.005".
std::string motion_text(Vec2 v);

}  // namespace talus
