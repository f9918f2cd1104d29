// The tree of an expression, which the parser builds and evaluate() walks.
#pragma once

#include <array>

#include "expression_names.h"

namespace talus {

struct Expression::Node {
  Operation operation = Operation::literal;
  ValueType type = ValueType::number;
  double number = 0;           // value of a literal; a truth value is 0 or 1
  Metric metric = Metric::id;  // for Operation::metric
  int body = kNone;            // index of the node that computes the body's id; kNone: the body asked about
  std::array<int, 4> arguments{};  // indices of nodes, as many as the operation has

  static constexpr int kNone = -1;
};

}  // namespace talus
