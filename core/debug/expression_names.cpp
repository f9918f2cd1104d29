#include "expression_names.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace talus {
namespace {

std::vector<ExpressionName> make_names() {
  using enum Operation;
  constexpr ValueType kNumber = ValueType::number, kTruth = ValueType::truth;
  std::vector<ExpressionName> names;
  for (const MetricInfo& info : metric_infos()) {
    names.push_back({info.name, "", info.unit, info.help, metric, info.is_truth ? kTruth : kNumber, 0, true,
                     info.metric});
  }
  const ExpressionName others[] = {
      {"touches", "(column, row)", "", "a contact with the tile in this cell changed its way", touches,
       kTruth, 2, true},
      {"touches_body", "(id)", "", "a contact with this body changed its way", touches_body, kTruth, 1, true},
      {"touches_curve", "(number)", "", "a contact with this curve of the level, from 0, changed its way",
       touches_curve, kTruth, 1, true},
      {"in_cell", "(column, row)", "", "its box overlaps the cell", in_cell, kTruth, 2, true},
      {"in_rect", "(x, y, w, h)", "", "its box overlaps the rectangle, in px", in_rect, kTruth, 4, true},
      {"enters_cell", "(column, row)", "", "its box overlaps the cell, and did not a frame before",
       enters_cell, kTruth, 2, true},
      {"enters_rect", "(x, y, w, h)", "", "its box overlaps the rectangle, and did not a frame before",
       enters_rect, kTruth, 4, true},
      {"frame", "", "", "number of the frame, from 0", frame, kNumber},
      {"input.left", "", "", "the key to the left is held", input_left, kTruth},
      {"input.right", "", "", "the key to the right is held", input_right, kTruth},
      {"input.jump", "", "", "the key to jump is held", input_jump, kTruth},
      {"input.mouse", "", "", "the mouse's button is held", input_mouse, kTruth},
      {"input.mouse.x", "", "px", "the mouse, from the level's left side", input_mouse_x, kNumber},
      {"input.mouse.y", "", "px", "the mouse, from the level's top", input_mouse_y, kNumber},
      {"before", "(value)", "", "the value in the frame before", before, kNumber, 1},
      {"changed", "(value)", "", "the value is not that of the frame before", changed, kTruth, 1},
      {"abs", "(a)", "", "the number without its sign", abs, kNumber, 1},
      {"min", "(a, b)", "", "the smaller number", min, kNumber, 2},
      {"max", "(a, b)", "", "the larger number", max, kNumber, 2},
      {"floor", "(a)", "", "the next whole number down", floor, kNumber, 1},
      {"ceil", "(a)", "", "the next whole number up", ceil, kNumber, 1},
      {"round", "(a)", "", "the nearest whole number", round, kNumber, 1},
      {"sqrt", "(a)", "", "the square root", sqrt, kNumber, 1},
      {"true", "", "", "the truth value", literal, kTruth},
      {"false", "", "", "its opposite", literal, kTruth},
  };
  names.insert(names.end(), std::begin(others), std::end(others));
  return names;
}

// The number of letters to insert, leave out, exchange or swap with the next one.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two_above, above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_above = above;
    above = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], two_above[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::span<const ExpressionName> expression_names() {
  static const std::vector<ExpressionName> names = make_names();
  return names;
}

const ExpressionName* find_expression_name(std::string_view name) {
  const auto names = expression_names();
  const auto at =
      std::find_if(names.begin(), names.end(), [&](const ExpressionName& n) { return n.name == name; });
  return at == names.end() ? nullptr : &*at;
}

std::string_view nearest_expression_name(std::string_view name, bool of_body) {
  std::string_view nearest;
  std::size_t least = std::min<std::size_t>(2, name.size() / 2);
  for (const ExpressionName& known : expression_names()) {
    if (of_body && !known.of_body) continue;
    const std::size_t distance = edit_distance(name, known.name);
    if (distance > least) continue;
    least = distance;
    nearest = known.name;
  }
  return nearest;
}

}  // namespace talus
