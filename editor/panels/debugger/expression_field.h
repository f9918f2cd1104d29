// A field for an expression: completes names as they are typed, and says what is wrong and where.
#pragma once

#include <string>
#include <string_view>

#include "debug/expression.h"
#include "panels/ui/ui.h"

namespace talus {

// Where a key asks to go from a field.
enum class FieldWay { none, up, down, on };

class ExpressionField {
 public:
  // condition: it must be a truth value. width: px of the screen. True when a text without a mistake was
  // entered, by Enter or by leaving the field; an empty one by Enter alone.
  bool draw(std::string_view name, std::string& text, bool condition, float width, std::string_view hint,
            Ui& ui);

  // Of the last draw():
  FieldWay way() const { return way_; }
  bool is_open() const { return open_; }  // it has the keys, and its candidates are shown
  bool by_enter() const { return by_enter_; }

 private:
  static int on_edit(ImGuiInputTextCallbackData* data);
  void draw_error(const std::string& text, const ExpressionError& error, Ui& ui) const;
  void draw_candidates(std::string_view name, float edge, std::string& text, Ui& ui);

  std::size_t cursor_ = 0;
  FieldWay way_ = FieldWay::none;
  bool by_enter_ = false;
  bool open_ = false;  // the field had the keys in the last frame: the candidates are shown
};

}  // namespace talus
