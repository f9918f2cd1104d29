// Breaking of sentences into lines, between words alone: ImGui breaks after a full stop too, and so inside of
// numbers.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace talus {

// The lines of a text, which stay parts of it, without the spaces at which it was broken. fits: whether a
// line is short enough; a word that is not has a line for itself. There is always one line at least.
std::vector<std::string_view> lines_between_words(std::string_view text,
                                                  const std::function<bool(std::string_view)>& fits);

}  // namespace talus
