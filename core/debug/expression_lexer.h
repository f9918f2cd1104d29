// Cuts the text of an expression into words.
#pragma once

#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "expression.h"

namespace talus {

struct ExpressionToken {
  enum class Kind { number, name, symbol, end };
  Kind kind = Kind::end;
  std::size_t position = 0;  // bytes
  std::string_view text;     // of a name with its dots: "normal.x"; of the end: empty
  double number = 0;         // of a number, finite
};

bool is_name_start(char c);
bool is_name_part(char c);  // not the dots between parts

// The last token is the end. The tokens refer to the text.
tl::expected<std::vector<ExpressionToken>, ExpressionError> expression_tokens(std::string_view text);

}  // namespace talus
