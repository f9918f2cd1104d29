#include "expression_lexer.h"

#include <array>
#include <charconv>

namespace talus {
namespace {

using Token = ExpressionToken;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  tl::expected<Token, ExpressionError> next() {
    while (is_space(peek(0))) ++at_;
    if (at_ >= text_.size()) return Token{Token::Kind::end, text_.size(), {}, 0};
    if (is_digit(peek(0)) || (peek(0) == '.' && is_digit(peek(1)))) return number();
    if (is_name_start(peek(0))) return name();
    return symbol();
  }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  Token take(Token::Kind kind, std::size_t size) {
    const Token token{kind, at_, text_.substr(at_, size), 0};
    at_ += size;
    return token;
  }

  tl::expected<Token, ExpressionError> number() {
    double value = 0;
    const char* begin = text_.data() + at_;
    const auto [end, problem] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (problem != std::errc()) return fail("the number is too large or too small for a double");
    Token token = take(Token::Kind::number, static_cast<std::size_t>(end - begin));
    token.number = value;
    if (is_name_part(peek(0))) return fail("a letter follows the number directly");
    return token;
  }

  Token name() {
    std::size_t size = 1;
    while (is_name_part(peek(size)) || (peek(size) == '.' && is_name_start(peek(size + 1)))) ++size;
    return take(Token::Kind::name, size);
  }

  tl::expected<Token, ExpressionError> symbol() {
    constexpr std::array<std::string_view, 6> kTwo = {"||", "&&", "==", "!=", "<=", ">="};
    for (const std::string_view two : kTwo) {
      if (text_.substr(at_, 2) == two) return take(Token::Kind::symbol, 2);
    }
    const char c = peek(0);
    if (std::string_view("<>+-*/%!(),.").find(c) != std::string_view::npos)
      return take(Token::Kind::symbol, 1);
    if (c == '=') return fail("'=' is not a comparison; write '=='");
    if (c == '&') return fail("'&' is not an operator; write '&&'");
    if (c == '|') return fail("'|' is not an operator; write '||'");
    if (c > ' ' && c <= '~') return fail(std::string("unexpected character '") + c + "'");
    return fail("unexpected character");
  }

  tl::unexpected<ExpressionError> fail(std::string message) const {
    return tl::unexpected(ExpressionError{at_, std::move(message)});
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_part(char c) { return is_name_start(c) || is_digit(c); }

tl::expected<std::vector<Token>, ExpressionError> expression_tokens(std::string_view text) {
  Lexer lexer(text);
  std::vector<Token> tokens;
  do {
    auto token = lexer.next();
    if (!token) return tl::unexpected(token.error());
    tokens.push_back(*token);
  } while (tokens.back().kind != Token::Kind::end);
  return tokens;
}

}  // namespace talus
