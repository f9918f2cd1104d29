// A field for an expression: completes names as they are typed, and says what is wrong and where.
#pragma once

#include <string>
#include <string_view>

#include "debug/expression.h"
#include "panels/ui/ui.h"

namespace talus {

// Where a key moves to from a field.
enum class FieldWay { none, up, down, on };

class ExpressionField {
 public:
  // condition: the expression must have a truth value. width: px of the screen. Returns true when a correct
  // text was entered, by Enter or by leaving the field; an empty one only by Enter.
  bool draw(std::string_view name, std::string& text, bool condition, float width, std::string_view hint,
            Ui& ui);

  // About the last draw():
  FieldWay way() const { return way_; }
  bool is_open() const { return open_; }  // whether it has the focus and shows its candidates
  bool by_enter() const { return by_enter_; }

 private:
  static int on_edit(ImGuiInputTextCallbackData* data);
  void draw_error(const std::string& text, const ExpressionError& error, Ui& ui) const;
  void draw_candidates(std::string_view name, float edge, std::string& text, Ui& ui);

  std::size_t cursor_ = 0;
  FieldWay way_ = FieldWay::none;
  bool by_enter_ = false;
  bool open_ = false;  // whether the field had the focus in the last frame, so that candidates are shown
};

}  // namespace talus
