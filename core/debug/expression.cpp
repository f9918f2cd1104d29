// Evaluates expressions.
#include "expression.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <talus/sim/scene.h>
#include "../collision/sweep.h"
#include "expression_nodes.h"

namespace talus {
namespace {

using Node = Expression::Node;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// The arguments need not be whole.
Rect cell_box(const Scene& scene, double column, double row) {
  const double width = scene.tile_size.width, height = scene.tile_size.height;
  return {column * width, row * height, width, height};
}

// Whether the tile of a contact is in the cell, or is a slope that reaches over it.
bool is_at(const Scene& scene, const Obstacle& other, double column, double row) {
  if (other.body != 0 || other.curve >= 0) return false;
  if (other.cell.x == column && other.cell.y == row) return true;
  const bool is_slope = other.role == TileRole::up_slope || other.role == TileRole::down_slope;
  return is_slope && intersect(other.box, cell_box(scene, column, row));
}

template <class Matches>
bool touches(const Frame& frame, int body, Matches matches) {
  const auto contacts = contacts_of(frame.record, body);
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const ContactRecord& c) { return has_effect(c) && matches(c.other); });
}

class Evaluator {
 public:
  Evaluator(const std::vector<Node>& nodes, const FrameView& view, int body)
      : nodes_(nodes), view_(view), body_(body) {}

  // back: how many frames before the newest one.
  double value(int index, std::size_t back) const {
    const Node& node = nodes_[index];
    switch (node.operation) {
      case Operation::literal:
        return node.number;
      case Operation::before:
        return value(node.arguments[0], back + 1);
      case Operation::changed:
        return changed(value(node.arguments[0], back), value(node.arguments[0], back + 1));
      case Operation::either:
        return value(node.arguments[0], back) == 1 || value(node.arguments[1], back) == 1;
      case Operation::both:
        return value(node.arguments[0], back) == 1 && value(node.arguments[1], back) == 1;
      default:
        break;
    }
    if (node.operation >= Operation::negation && node.operation <= Operation::sqrt)
      return computed(node, back);
    if (node.operation >= Operation::metric && node.operation <= Operation::in_rect)
      return of_body(node, back);
    return of_frame(node, view_.before(back));
  }

 private:
  static bool changed(double now, double before) {
    return std::isnan(now) != std::isnan(before) || now < before || now > before;
  }

  static double of_frame(const Node& node, const Frame& frame) {
    switch (node.operation) {
      case Operation::frame:
        return static_cast<double>(frame.state.frame);
      case Operation::input_left:
        return frame.input.left;
      case Operation::input_right:
        return frame.input.right;
      case Operation::input_jump:
        return frame.input.jump;
      case Operation::input_mouse:
        return frame.input.mouse_down;
      case Operation::input_mouse_x:
        return frame.input.mouse.x;
      default:
        assert(node.operation == Operation::input_mouse_y);
        return frame.input.mouse.y;
    }
  }

  double of_body(const Node& node, std::size_t back) const {
    const Frame& frame = view_.before(back);
    const double id = node.body == Node::kNone ? body_ : value(node.body, back);
    const bool is_id = id >= 1 && id <= std::numeric_limits<int>::max() && id == std::floor(id);
    const Body* body = is_id ? frame.state.find(static_cast<int>(id)) : nullptr;
    if (body == nullptr) return node.type == ValueType::truth ? 0 : kNoNumber;

    const auto argument = [&](int i) { return value(node.arguments[i], back); };
    switch (node.operation) {
      case Operation::metric:
        return measure(node.metric, frame, *body);
      case Operation::touches: {
        const double column = argument(0), row = argument(1);
        return touches(frame, body->id,
                       [&](const Obstacle& o) { return is_at(*frame.scene, o, column, row); });
      }
      case Operation::touches_body: {
        const double other = argument(0);
        return touches(frame, body->id, [&](const Obstacle& o) { return o.body != 0 && o.body == other; });
      }
      case Operation::touches_curve: {
        const double curve = argument(0);
        return touches(frame, body->id, [&](const Obstacle& o) { return o.curve >= 0 && o.curve == curve; });
      }
      case Operation::in_cell:
        return intersect(body->box, cell_box(*frame.scene, argument(0), argument(1)));
      default:
        assert(node.operation == Operation::in_rect);
        return intersect(body->box, {argument(0), argument(1), argument(2), argument(3)});
    }
  }

  double computed(const Node& node, std::size_t back) const {
    const double a = value(node.arguments[0], back);
    const bool is_binary = node.operation >= Operation::equal && node.operation <= Operation::remainder;
    const bool has_two = is_binary || node.operation == Operation::min || node.operation == Operation::max;
    const double b = has_two ? value(node.arguments[1], back) : 0;
    switch (node.operation) {
      case Operation::negation:
        return a == 0;
      case Operation::equal:
        return a == b;
      case Operation::unequal:
        return a < b || a > b;
      case Operation::less:
        return a < b;
      case Operation::less_equal:
        return a <= b;
      case Operation::greater:
        return a > b;
      case Operation::greater_equal:
        return a >= b;
      case Operation::plus:
        return a + b;
      case Operation::minus:
        return a - b;
      case Operation::times:
        return a * b;
      case Operation::divided:
        return a / b;
      case Operation::remainder:
        return std::fmod(a, b);
      case Operation::opposite:
        return -a;
      default:
        return of_function(node.operation, a, b);
    }
  }

  static double of_function(Operation operation, double a, double b) {
    switch (operation) {
      case Operation::abs:
        return std::abs(a);
      case Operation::min:
        return std::isnan(a) || a < b ? a : b;
      case Operation::max:
        return std::isnan(a) || a > b ? a : b;
      case Operation::floor:
        return std::floor(a);
      case Operation::ceil:
        return std::ceil(a);
      case Operation::round:
        return std::round(a);
      default:
        assert(operation == Operation::sqrt);
        return std::sqrt(a);
    }
  }

  const std::vector<Node>& nodes_;
  const FrameView& view_;
  const int body_;
};

}  // namespace

double Expression::evaluate(const FrameView& view, int body, std::size_t back) const {
  return Evaluator(*nodes_, view, body).value(static_cast<int>(nodes_->size()) - 1, back);
}

}  // namespace talus
