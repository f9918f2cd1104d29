// How often a random test tries something: fewer times in the ordinary run than at night (tests/nightly).
#pragma once

#include <algorithm>
#include <cstdlib>

namespace talus {

// Returns `least`, or the number in the environment variable if that is larger.
inline double tries(const char* variable, double least) {
  const char* text = std::getenv(variable);
  return text == nullptr ? least : std::max(least, std::atof(text));
}

}  // namespace talus
