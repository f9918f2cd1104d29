// Breaks sentences into lines only between words: ImGui also breaks after a full stop, and so inside of
// numbers.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace talus {

// The lines of a text, as parts of it, without the spaces at which it was broken. fits: whether a line is
// short enough; a word that does not fit has a line for itself. There is always at least one line.
std::vector<std::string_view> lines_between_words(std::string_view text,
                                                  const std::function<bool(std::string_view)>& fits);

}  // namespace talus
