// Expressions over a frame, for breakpoints, watches and plots: "body.vy > 3 && grounded".
//
//     ||   &&   == !=   < <= > >=   + -   * / %   ! -   ( )      from loose to tight, each from left to right
//
// Values are numbers (doubles) or truth values; the two do not mix. Names are in expression_names.h: those of
// a body may stand alone or after "body.", which both mean the body that the expression is asked about, or
// after "body(3).". before(E) is E one frame earlier, and changed(E) whether that differs; before frame 0 all
// is as in frame 0.
//
// What is not there (the normal of a body in the air, a body that is gone) is NaN. It stays NaN through
// arithmetic, and every comparison with it is false, != too; changed() takes NaN as one more value. What asks
// for the truth about a body that is gone is false. Numbers are those of IEEE 754: 1 / 0 is infinite, % has
// the sign of its left side, round() takes halves away from zero. && and || do not look at their right side
// when the left one decides.
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
inline constexpr int kMaxBefore = 8;                       // how deep before() and changed() may be nested

struct ExpressionError {
  std::size_t position = 0;  // byte of the text at which the mistake begins, 0 to its length
  std::string message;       // one sentence without a full stop
};

enum class ValueType : std::uint8_t { number, truth };

class Expression {
 public:
  struct Node;

  // Never throws, on any bytes.
  static tl::expected<Expression, ExpressionError> parse(std::string_view text);
  // The same for what must be a truth value.
  static tl::expected<Expression, ExpressionError> parse_condition(std::string_view text);

  ValueType type() const { return type_; }
  bool asks_body() const { return asks_body_; }         // its value depends on which body it is asked about
  int frames_before() const { return frames_before_; }  // that it looks back at, 0..kMaxBefore

  // In the frame that is `back` frames before the newest one. body: id; with none of that id, as of a body
  // that is gone. A truth value is 0 or 1. view: of a history of frames_before() + back or more frames
  // before.
  double evaluate(const FrameView& view, int body, std::size_t back = 0) const;

 private:
  friend class ExpressionParser;
  Expression() = default;

  std::shared_ptr<const std::vector<Node>>
      nodes_;  // children before their parents; the last one is the whole
  ValueType type_ = ValueType::number;
  bool asks_body_ = false;
  int frames_before_ = 0;
};

}  // namespace talus
