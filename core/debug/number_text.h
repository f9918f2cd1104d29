// Numbers in conditions and sentences.
#pragma once

#include <string>

#include "../collision/geometry.h"

namespace talus {

// The shortest decimal that reads back as the same double: "0.1".
std::string exact_text(double number);

// For people, with two decimals at most: "0.37", "2"; of what would be 0 with these, one digit: "2e-14".
std::string short_text(double number);
std::string short_text(Vec2 v);  // "(0.37, 2)"

}  // namespace talus
