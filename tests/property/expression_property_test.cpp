// Random expressions have the values that they were built to have, and no text crashes the parser.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "debug/completion.h"
#include "debug/expression.h"

namespace talus::expression_property_test {

// A text with its value, and how tightly its outermost operator binds (7: no parentheses are needed).
struct Built {
  std::string text;
  double value;
  int tightness;
};

std::string parenthesised(const Built& part, int tightness) {
  return part.tightness < tightness ? "(" + part.text + ")" : part.text;
}

int random_to(int end) { return *rc::gen::inRange(0, end); }

Built number(int depth);

Built truth(int depth) {
  if (depth == 0) return random_to(2) == 0 ? Built{"false", 0, 7} : Built{"true", 1, 7};
  const int kind = random_to(5);
  if (kind == 0) {
    const Built inner = truth(depth - 1);
    return {"!" + parenthesised(inner, 7), inner.value == 0 ? 1.0 : 0.0, 7};
  }
  if (kind == 1) {
    const Built a = truth(depth - 1), b = truth(depth - 1);
    return {parenthesised(a, 1) + "||" + parenthesised(b, 2), a.value + b.value > 0 ? 1.0 : 0.0, 1};
  }
  if (kind == 2) {
    const Built a = truth(depth - 1), b = truth(depth - 1);
    return {parenthesised(a, 2) + " && " + parenthesised(b, 3), a.value * b.value, 2};
  }
  const Built a = number(depth - 1), b = number(depth - 1);
  if (kind == 3) return {parenthesised(a, 3) + "==" + parenthesised(b, 4), a.value == b.value ? 1.0 : 0.0, 3};
  return {parenthesised(a, 4) + " <= " + parenthesised(b, 5), a.value <= b.value ? 1.0 : 0.0, 4};
}

Built number(int depth) {
  if (depth == 0) {
    const int value = random_to(100);
    return {std::to_string(value), static_cast<double>(value), 7};
  }
  const Built a = number(depth - 1), b = number(depth - 1);
  switch (random_to(6)) {
    case 0:
      return {parenthesised(a, 5) + " + " + parenthesised(b, 6), a.value + b.value, 5};
    case 1:
      return {parenthesised(a, 5) + "-" + parenthesised(b, 6), a.value - b.value, 5};
    case 2:
      return {parenthesised(a, 6) + "*" + parenthesised(b, 7), a.value * b.value, 6};
    case 3:
      return {parenthesised(a, 6) + " / " + parenthesised(b, 7), a.value / b.value, 6};
    case 4:
      return {"-" + parenthesised(a, 7), -a.value, 7};
    default:
      return {"abs(" + a.text + ")", std::abs(a.value), 7};
  }
}

double value_of(const Expression& expression) {
  Frame frame;
  frame.scene = std::make_shared<const Scene>();
  return expression.evaluate(FrameView({&frame}), 0);
}

RC_GTEST_PROP(ExpressionProperty, HasTheValueThatItWasBuiltToHave, ()) {
  const int depth = random_to(5);
  const Built built = random_to(2) == 0 ? truth(depth) : number(depth);
  RC_PRE(built.text.size() <= kMaxExpressionLength);
  const auto expression = Expression::parse(built.text);
  RC_LOG() << built.text;
  RC_ASSERT(expression.has_value());
  const double value = value_of(*expression);
  RC_ASSERT(value == built.value || (std::isnan(value) && std::isnan(built.value)));
}

// Words of expressions in any order: nearly all are invalid, and each error has a place in the text.
RC_GTEST_PROP(ExpressionProperty, NoTextCrashesTheParser, ()) {
  const auto word =
      rc::gen::element<std::string>("body", "body.", "body(", ")", "(", "x", "vy", "grounded", "touches",
                                    "before", "changed", ",", ".", "1", ".5", "+", "-", "!", "&&", "==", "=",
                                    " ", "\n", "\xff", std::string(1, '\0'), "enters_cell(1,2)", "id");
  const auto words = *rc::gen::container<std::vector<std::string>>(word);
  std::string text;
  for (const std::string& w : words) text += w;
  const auto expression = Expression::parse(text);
  if (expression) {
    value_of(*expression);
  } else {
    RC_ASSERT(expression.error().position <= text.size());
    RC_ASSERT(!expression.error().message.empty());
  }
  const std::size_t cursor = static_cast<std::size_t>(random_to(static_cast<int>(text.size()) + 2));
  const Completion completion = complete(text, cursor);
  RC_ASSERT(completion.from <= completion.to);
  RC_ASSERT(completion.to <= text.size());
}

}  // namespace talus::expression_property_test
