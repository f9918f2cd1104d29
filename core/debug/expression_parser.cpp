// Builds the tree of an expression by precedence climbing, and checks it on the way.
#include <algorithm>
#include <utility>

#include "expression_lexer.h"
#include "expression_nodes.h"

namespace talus {
namespace {

using Token = ExpressionToken;
using Node = Expression::Node;

struct BinaryOperator {
  std::string_view text;
  int tightness;
  Operation operation;
  ValueType operands, result;  // == and != take truth values too
};
constexpr std::array<BinaryOperator, 13> kBinary = {{
    {"||", 1, Operation::either, ValueType::truth, ValueType::truth},
    {"&&", 2, Operation::both, ValueType::truth, ValueType::truth},
    {"==", 3, Operation::equal, ValueType::number, ValueType::truth},
    {"!=", 3, Operation::unequal, ValueType::number, ValueType::truth},
    {"<", 4, Operation::less, ValueType::number, ValueType::truth},
    {"<=", 4, Operation::less_equal, ValueType::number, ValueType::truth},
    {">", 4, Operation::greater, ValueType::number, ValueType::truth},
    {">=", 4, Operation::greater_equal, ValueType::number, ValueType::truth},
    {"+", 5, Operation::plus, ValueType::number, ValueType::number},
    {"-", 5, Operation::minus, ValueType::number, ValueType::number},
    {"*", 6, Operation::times, ValueType::number, ValueType::number},
    {"/", 6, Operation::divided, ValueType::number, ValueType::number},
    {"%", 6, Operation::remainder, ValueType::number, ValueType::number},
}};

const BinaryOperator* find_binary(const Token& token) {
  if (token.kind != Token::Kind::symbol) return nullptr;
  const auto at = std::find_if(kBinary.begin(), kBinary.end(),
                               [&](const BinaryOperator& op) { return op.text == token.text; });
  return at == kBinary.end() ? nullptr : &*at;
}

std::string_view words_of(ValueType type) { return type == ValueType::number ? "a number" : "a truth value"; }

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

}  // namespace

// A function that builds a node returns its index, or kNone after a mistake. The first mistake is kept.
class ExpressionParser {
 public:
  explicit ExpressionParser(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  tl::expected<Expression, ExpressionError> parse() {
    const int whole = binary(1);
    if (whole != Node::kNone && peek().kind != Token::Kind::end)
      fail(peek(), quoted(peek().text) + " comes after the end of the expression");
    if (error_) return tl::unexpected(*error_);
    Expression made;
    made.type_ = nodes_.back().type;
    made.nodes_ = std::make_shared<const std::vector<Node>>(std::move(nodes_));
    made.asks_body_ = facts_.back().asks_body;
    made.frames_before_ = facts_.back().frames_before;
    return made;
  }

 private:
  // What a node and all nodes below it depend on.
  struct Facts {
    bool asks_body = false;
    int frames_before = 0;
  };
  // The body that a name after "body." or "body(3)." is about.
  struct Owner {
    bool is_written = false;
    int node = Node::kNone;  // kNone: the body asked about
  };

  const Token& peek() const { return tokens_[at_]; }
  const Token& take() { return tokens_[peek().kind == Token::Kind::end ? at_ : at_++]; }
  bool is_symbol(std::string_view text) const {
    return peek().kind == Token::Kind::symbol && peek().text == text;
  }
  bool take_symbol(std::string_view text) {
    if (!is_symbol(text)) return false;
    take();
    return true;
  }

  int fail(const Token& where, std::string message) {
    if (!error_) error_ = ExpressionError{where.position, std::move(message)};
    return Node::kNone;
  }

  int add(const Node& node, int arguments, int own_frames_before = 0) {
    Facts facts;
    const auto include = [&](int child) {
      facts.asks_body = facts.asks_body || facts_[child].asks_body;
      facts.frames_before = std::max(facts.frames_before, facts_[child].frames_before);
    };
    for (int i = 0; i < arguments; ++i) include(node.arguments[i]);
    if (node.body != Node::kNone) include(node.body);
    facts.frames_before += own_frames_before;
    nodes_.push_back(node);
    facts_.push_back(facts);
    return static_cast<int>(nodes_.size()) - 1;
  }

  int binary(int loosest) {
    int left = unary();
    while (left != Node::kNone) {
      const BinaryOperator* op = find_binary(peek());
      if (op == nullptr || op->tightness < loosest) break;
      const Token& token = take();
      const int right = binary(op->tightness + 1);
      left = right == Node::kNone ? Node::kNone : join(*op, token, left, right);
    }
    return left;
  }

  int join(const BinaryOperator& op, const Token& token, int left, int right) {
    const ValueType l = nodes_[left].type, r = nodes_[right].type;
    const bool is_equality = op.operation == Operation::equal || op.operation == Operation::unequal;
    if (is_equality && l != r) {
      return fail(token, quoted(op.text) + " compares " + std::string(words_of(l)) + " with " +
                             std::string(words_of(r)));
    }
    if (!is_equality && (l != op.operands || r != op.operands)) {
      return fail(token, quoted(op.text) + " needs " + std::string(words_of(op.operands)) +
                             " on both sides, but has " + std::string(words_of(l != op.operands ? l : r)) +
                             (l != op.operands ? " on its left" : " on its right"));
    }
    return add({.operation = op.operation, .type = op.result, .arguments = {left, right}}, 2);
  }

  int unary() {
    const Token& token = peek();
    if (token.kind != Token::Kind::symbol || (token.text != "-" && token.text != "!")) return primary();
    take();
    const int operand = unary();
    if (operand == Node::kNone) return operand;
    const bool is_not = token.text == "!";
    const ValueType type = is_not ? ValueType::truth : ValueType::number;
    if (nodes_[operand].type != type) {
      return fail(token, quoted(token.text) + " needs " + std::string(words_of(type)) + ", not " +
                             std::string(words_of(nodes_[operand].type)));
    }
    return add({.operation = is_not ? Operation::negation : Operation::opposite,
                .type = type,
                .arguments = {operand}},
               1);
  }

  int primary() {
    const Token& token = take();
    switch (token.kind) {
      case Token::Kind::number:
        return add({.number = token.number}, 0);
      case Token::Kind::name:
        return token.text == "body" ? other_body(token) : named(token);
      case Token::Kind::symbol:
        break;
      case Token::Kind::end:
        return fail(token, "expected a value at the end");
    }
    if (token.text != "(") return fail(token, "expected a value before " + quoted(token.text));
    const int inner = binary(1);
    if (inner == Node::kNone) return inner;
    return take_symbol(")") ? inner : fail(peek(), "expected ')'");
  }

  // body(ID).NAME
  int other_body(const Token& token) {
    if (!take_symbol("(")) return fail(token, "'body' needs a name after it, as in 'body.x'");
    const int id = binary(1);
    if (id == Node::kNone) return id;
    if (nodes_[id].type != ValueType::number) return fail(token, "'body' needs a number, not a truth value");
    if (!take_symbol(")")) return fail(peek(), "expected ')'");
    if (!take_symbol(".") || peek().kind != Token::Kind::name)
      return fail(peek(), "expected a name of the body, as in 'body(1).x'");
    const Token& name = take();
    return named(name, name.text, {true, id});
  }

  int named(const Token& token) {
    constexpr std::string_view kPrefix = "body.";
    if (!token.text.starts_with(kPrefix)) return named(token, token.text, {});
    return named(token, token.text.substr(kPrefix.size()), {true, Node::kNone});
  }

  int named(const Token& token, std::string_view name, Owner owner) {
    const ExpressionName* known = find_expression_name(name);
    if (known == nullptr || (owner.is_written && !known->of_body)) return unknown(token, name, owner);
    std::array<int, 4> arguments{};
    if (known->arguments > 0) {
      if (!read_arguments(token, *known, arguments)) return Node::kNone;
    } else if (is_symbol("(")) {
      return fail(peek(), quoted(token.text) + " takes no arguments");
    }
    return made(token, *known, owner, arguments);
  }

  int unknown(const Token& token, std::string_view name, Owner owner) {
    const std::string prefix(token.text.substr(0, token.text.size() - name.size()));
    std::string message = "unknown name " + quoted(token.text);
    const std::string_view near = nearest_expression_name(name, owner.is_written);
    if (!near.empty()) message += "; did you mean " + quoted(prefix + std::string(near)) + "?";
    return fail(token, std::move(message));
  }

  bool read_arguments(const Token& token, const ExpressionName& known, std::array<int, 4>& arguments) {
    if (!take_symbol("(")) {
      fail(token, quoted(token.text) + " needs arguments: " + std::string(known.name) +
                      std::string(known.parameters));
      return false;
    }
    int count = 0;
    while (!is_symbol(")")) {
      if (count > 0 && !take_symbol(",")) {
        fail(peek(), "expected ')' or ','");
        return false;
      }
      const Token& start = peek();
      const int argument = binary(1);
      if (argument == Node::kNone) return false;
      const bool takes_both = known.operation == Operation::before || known.operation == Operation::changed;
      if (!takes_both && nodes_[argument].type != ValueType::number) {
        fail(start, quoted(known.name) + " takes numbers, but this is a truth value");
        return false;
      }
      if (count < known.arguments) arguments[count] = argument;
      ++count;
    }
    take();
    if (count == known.arguments) return true;
    fail(token, quoted(known.name) + " takes " + std::to_string(known.arguments) +
                    (known.arguments == 1 ? " argument, not " : " arguments, not ") + std::to_string(count));
    return false;
  }

  int made(const Token& token, const ExpressionName& known, Owner owner,
           const std::array<int, 4>& arguments) {
    Node node{.operation = known.operation,
              .type = known.type,
              .metric = known.metric,
              .body = owner.node,
              .arguments = arguments};
    if (known.name == "true") node.number = 1;
    const bool looks_back = known.operation == Operation::before || known.operation == Operation::changed;
    if (known.operation == Operation::before) node.type = nodes_[arguments[0]].type;
    if (known.operation == Operation::enters_cell) node.operation = Operation::in_cell;
    if (known.operation == Operation::enters_rect) node.operation = Operation::in_rect;
    const int index = add(node, known.arguments, looks_back ? 1 : 0);
    if (known.of_body && owner.node == Node::kNone) facts_[index].asks_body = true;
    const int made = node.operation != known.operation ? began(index) : index;
    if (facts_[made].frames_before > kMaxBefore)
      return fail(token, "this looks back more than " + std::to_string(kMaxBefore) + " frames");
    return made;
  }

  // True now, and false a frame before.
  int began(int truth) {
    const int before =
        add({.operation = Operation::before, .type = ValueType::truth, .arguments = {truth}}, 1, 1);
    const int was_not =
        add({.operation = Operation::negation, .type = ValueType::truth, .arguments = {before}}, 1);
    return add({.operation = Operation::both, .type = ValueType::truth, .arguments = {truth, was_not}}, 2);
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<Node> nodes_;
  std::vector<Facts> facts_;  // one for each node
  std::optional<ExpressionError> error_;
};

tl::expected<Expression, ExpressionError> Expression::parse(std::string_view text) {
  if (text.size() > kMaxExpressionLength) {
    return tl::unexpected(
        ExpressionError{kMaxExpressionLength,
                        "the expression is longer than " + std::to_string(kMaxExpressionLength) + " bytes"});
  }
  auto tokens = expression_tokens(text);
  if (!tokens) return tl::unexpected(tokens.error());
  if (tokens->size() == 1) return tl::unexpected(ExpressionError{0, "the expression is empty"});
  return ExpressionParser(std::move(*tokens)).parse();
}

tl::expected<Expression, ExpressionError> Expression::parse_condition(std::string_view text) {
  auto expression = parse(text);
  if (expression && expression->type() != ValueType::truth)
    return tl::unexpected(ExpressionError{
        0, "a condition must be true or false, but this is a number; compare it, as in 'speed > 3'"});
  return expression;
}

}  // namespace talus
