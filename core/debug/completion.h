// What may stand at a place of an expression that is being typed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace talus {

struct Candidate {
  std::string text;       // to put in: "grounded", or "touches(" of what takes arguments
  std::string label;      // "touches(column, row)"
  std::string_view help;  // one sentence
};

struct Completion {
  std::size_t from = 0, to = 0;       // bytes of the text that a candidate takes the place of
  std::vector<Candidate> candidates;  // that begin with what is typed before the cursor
};

// cursor: byte of the text, 0 to its length; a larger one counts as that.
Completion complete(std::string_view text, std::size_t cursor);

}  // namespace talus
