// The tree of an expression, which the parser builds and evaluate() walks.
#pragma once

#include <array>

#include "expression_names.h"

namespace talus {

struct Expression::Node {
  Operation operation = Operation::literal;
  ValueType type = ValueType::number;
  double number = 0;               // of a literal; a truth value is 0 or 1
  Metric metric = Metric::id;      // of Operation::metric
  int body = kNone;                // index of the node that says which body; kNone: the one asked about
  std::array<int, 4> arguments{};  // indices of nodes, as many as the operation has

  static constexpr int kNone = -1;
};

}  // namespace talus
