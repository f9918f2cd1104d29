// Takes word after word into a line.
#include "wrapped_text.h"

#include <algorithm>

namespace talus {

std::vector<std::string_view> lines_between_words(std::string_view text,
                                                  const std::function<bool(std::string_view)>& fits) {
  std::vector<std::string_view> lines;
  std::size_t begin = 0, end = 0;  // of the line under way, which `end` is behind
  while (end < text.size()) {
    const std::size_t next = std::min(text.find(' ', end + 1), text.size());
    if (end > begin && !fits(text.substr(begin, next - begin))) {
      lines.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
    end = next;
  }
  lines.push_back(text.substr(std::min(begin, text.size())));
  return lines;
}

}  // namespace talus
