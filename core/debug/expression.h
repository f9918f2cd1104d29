// Expressions over a frame, for breakpoints and plots: "body.vy > 3 && grounded".
//
//     ||   &&   == !=   < <= > >=   + -   * / %   ! -   ( )      from loose to tight, each from left to right
//
// Values are numbers (doubles) or truth values; the two do not mix. Names are in expression_names.h. Names of
// a body may stand alone or after "body.", both for the body that the expression is asked about, or after
// "body(3).". before(E) is E one frame earlier. changed(E) is true if that differs from E. Before frame 0
// everything is as in frame 0.
//
// A value that does not exist (the normal of a body in the air, a number of a body that is gone) is NaN. It
// stays NaN through arithmetic, and every comparison with it is false, also !=; for changed(), NaN is one
// more value. A truth value of a body that is gone is false. Numbers follow IEEE 754: 1 / 0 is infinite, %
// has the sign of its left side, round() rounds halves away from zero. && and || skip their right side when
// the left one decides.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "frame.h"

namespace talus {

inline constexpr std::size_t kMaxExpressionLength = 1000;  // bytes
inline constexpr int kMaxBefore = 8;                       // limit for the nesting of before() and changed()

struct ExpressionError {
  std::size_t position = 0;  // byte of the text at which the mistake begins, 0 to its length
  std::string message;       // one sentence without a full stop
};

enum class ValueType : std::uint8_t { number, truth };

class Expression {
 public:
  struct Node;

  // Never throws, whatever the bytes.
  static tl::expected<Expression, ExpressionError> parse(std::string_view text);
  // The same for an expression that must have a truth value.
  static tl::expected<Expression, ExpressionError> parse_condition(std::string_view text);

  ValueType type() const { return type_; }
  bool asks_body() const { return asks_body_; }  // whether its value depends on the body it is asked about
  int frames_before() const { return frames_before_; }  // how many frames it looks back, 0..kMaxBefore

  // Evaluates in the frame that is `back` frames before the newest one. body: id; an unknown id counts as a
  // body that is gone. A truth value is 0 or 1. view: must have a history of at least frames_before() + back
  // frames.
  double evaluate(const FrameView& view, int body, std::size_t back = 0) const;

 private:
  friend class ExpressionParser;
  Expression() = default;

  std::shared_ptr<const std::vector<Node>>
      nodes_;  // children before their parents; the last node is the root
  ValueType type_ = ValueType::number;
  bool asks_body_ = false;
  int frames_before_ = 0;
};

}  // namespace talus
