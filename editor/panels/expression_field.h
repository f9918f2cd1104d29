// A field for an expression: completes names as they are typed, and says what is wrong and where.
#pragma once

#include <string>
#include <string_view>

#include "debug/expression.h"
#include "ui.h"

namespace talus {

class ExpressionField {
 public:
  // condition: it must be a truth value. width: px of the screen. True when a text without a mistake was
  // entered, by Enter or by leaving the field.
  bool draw(std::string_view name, std::string& text, bool condition, float width, std::string_view hint,
            Ui& ui);

 private:
  void draw_error(const std::string& text, const ExpressionError& error, Ui& ui) const;
  void draw_candidates(std::string_view name, std::string& text, Ui& ui);

  std::size_t cursor_ = 0;
  bool open_ = false;  // the field had the keys in the last frame: the candidates are shown
};

}  // namespace talus
