// Completion: the names that may stand at a place of an expression while the user types.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace talus {

struct Candidate {
  std::string text;       // text to insert: "grounded", or "touches(" for a name with arguments
  std::string label;      // "touches(column, row)"
  std::string_view help;  // one sentence
};

struct Completion {
  std::size_t from = 0, to = 0;       // bytes of the text that a candidate replaces
  std::vector<Candidate> candidates;  // begin with the text before the cursor
};

// cursor: byte of the text, 0 to its length; a larger number counts as the length.
Completion complete(std::string_view text, std::size_t cursor);

}  // namespace talus
