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
  std::string_view text;     // for a name with its dots: "normal.x"; empty at the end
  double number = 0;         // value of a number; finite
};

bool is_name_start(char c);
bool is_name_part(char c);  // the dots between parts do not count

// The last token is the end. Tokens refer to the text, which must outlive them.
tl::expected<std::vector<ExpressionToken>, ExpressionError> expression_tokens(std::string_view text);

}  // namespace talus
