// Large numbers in sentences.
#pragma once

#include <cstddef>
#include <string>

namespace talus {

// "1,234,567"
inline std::string with_commas(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

}  // namespace talus
