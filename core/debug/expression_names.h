// The names that expressions know.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "expression.h"
#include "metrics.h"

namespace talus {

// The operation of a node of an expression.
enum class Operation : std::uint8_t {
  // values
  literal,
  frame,
  input_left,
  input_right,
  input_jump,
  input_mouse,
  input_mouse_x,
  input_mouse_y,
  metric,
  // of contacts and places of a body
  touches,
  touches_body,
  touches_curve,
  in_cell,
  in_rect,
  // operators
  either,
  both,
  negation,
  equal,
  unequal,
  less,
  less_equal,
  greater,
  greater_equal,
  plus,
  minus,
  times,
  divided,
  remainder,
  opposite,
  // functions
  abs,
  min,
  max,
  floor,
  ceil,
  round,
  sqrt,
  before,
  changed,
  // shorthands
  enters_cell,
  enters_rect
};

// Arguments are numbers; the argument of before() and changed() may also be a truth value.
struct ExpressionName {
  std::string_view name;
  std::string_view parameters;  // "(x, y)"; empty: takes no arguments, and is written without parentheses
  std::string_view unit;        // of a number; may be empty
  std::string_view help;        // one sentence
  Operation operation;
  ValueType type;              // for before(), the type of its argument
  int arguments = 0;           // 0..4
  bool of_body = false;        // whether it may follow "body."
  Metric metric = Metric::id;  // for Operation::metric
};
std::span<const ExpressionName> expression_names();
const ExpressionName* find_expression_name(std::string_view name);  // null if there is no such name

// The name that was probably meant, without a prefix "body."; empty if no name is near. of_body: looks only
// at names that may follow "body.".
std::string_view nearest_expression_name(std::string_view name, bool of_body);

}  // namespace talus
