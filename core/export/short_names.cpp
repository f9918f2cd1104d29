#include "short_names.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "lua_text.h"

namespace talus {
namespace {

constexpr std::string_view kGlobals[] = {"assert",   "error",    "getmetatable", "ipairs", "math",
                                         "next",     "pairs",    "print",        "rawget", "rawset",
                                         "require",  "select",   "setmetatable", "string", "table",
                                         "tonumber", "tostring", "type",         "unpack"};

template <class List>
bool has(const List& list, std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

enum class Use : std::uint8_t { none, variable, field };  // none: it is no name

struct Token {
  std::string_view text;
  Use use = Use::none;
};

// A name, a string in quotes, a number, or one other character.
std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (is_lua_word(text[i])) {
      while (end < text.size() && is_lua_word(text[end])) ++end;
    } else if (text[i] == '"') {
      while (end < text.size() && text[end] != '"') ++end;
      end = std::min(end + 1, text.size());
    }
    tokens.push_back({text.substr(i, end - i)});
    i = end;
  }
  return tokens;
}

// With the first parameter of methods by name, as one that can be short: `function Walk.at(self, x)` for
// `function Walk:at(x)`.
std::vector<Token> with_named_self(const std::vector<Token>& tokens) {
  std::vector<Token> named;
  bool is_head = false, is_method = false;  // of a function, up to its parameters
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    if (text == "function") is_head = true;
    const bool is_colon = is_head && text == ":";
    named.push_back(is_colon ? Token{"."} : tokens[i]);
    is_method = is_method || is_colon;
    if (text != "(") continue;
    if (is_method) named.push_back({"self"});
    if (is_method && i + 1 < tokens.size() && tokens[i + 1].text != ")") named.push_back({","});
    is_head = is_method = false;
  }
  return named;
}

// What a token stands in: a table's braces, or the blocks of statements in them.
class Nesting {
 public:
  void read(std::string_view token) {
    if (token == "{" || has(kBegins, token)) is_table_.push_back(token == "{");
    if ((token == "}" || token == "end" || token == "until") && !is_table_.empty()) is_table_.pop_back();
  }
  bool is_table() const { return !is_table_.empty() && is_table_.back(); }

 private:
  static constexpr std::string_view kBegins[] = {"function", "do", "if", "repeat"};
  std::vector<bool> is_table_;
};

struct LuaNames {
  std::set<std::string_view> all, locals, fields, methods;

  bool are_renamed(const Token& token) const {
    if (token.use == Use::variable) return locals.count(token.text) != 0 && !has(kGlobals, token.text);
    return token.use == Use::field && methods.count(token.text) != 0 && fields.count(token.text) == 0;
  }
};

// Finds the names, and how each token uses one.
LuaNames names_in(std::vector<Token>& spaced, const InnerNames& inner) {
  std::vector<Token*> tokens;
  for (Token& token : spaced) {
    if (token.text != " ") tokens.push_back(&token);  // a line break ends a list of locals
  }
  const auto text_at = [&](std::size_t i) { return i < tokens.size() ? tokens[i]->text : ""; };
  LuaNames names;
  enum class List { none, locals, parameters } list = List::none;
  Nesting nesting;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string_view token = tokens[i]->text, before = text_at(i - 1), after = text_at(i + 1);
    nesting.read(token);
    if (token == "local" || token == "for") list = List::locals;
    if (token == "function") list = List::parameters;
    const bool ends_locals = token == "=" || token == "in" || token == "\n";
    if ((list == List::locals && ends_locals) || (list == List::parameters && token == ")"))
      list = List::none;
    if (!is_lua_name(token)) continue;
    names.all.insert(token);
    const bool is_key = nesting.is_table() && after == "=" && text_at(i + 2) != "=";
    const bool is_concatenated = before == "." && text_at(i - 2) == ".";
    const bool is_member = (before == "." && !is_concatenated) || before == ":";
    tokens[i]->use = is_key || is_member ? Use::field : Use::variable;
    if (is_member) {
      const bool is_inner = has(inner.tables, text_at(i - 2));
      const bool is_defined = text_at(i - 3) == "function";
      if (is_inner && is_defined) names.methods.insert(token);
      // Who has a method that is called is not known here.
      if (!is_inner && (before == "." || is_defined)) names.fields.insert(token);
    } else if (is_key) {
      names.fields.insert(token);
    } else if (list == List::locals || (list == List::parameters && (before == "(" || before == ",")) ||
               (before == "function" && text_at(i - 2) == "local")) {
      names.locals.insert(token);
    }
  }
  return names;
}

// The n-th of a, b .. z, A .. Z, aa, ba ..
std::string short_name(std::size_t n) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::string name;
  for (++n; n > 0; n = (n - 1) / kLetters.size()) name += kLetters[(n - 1) % kLetters.size()];
  return name;
}

}  // namespace

std::string with_short_names(const std::string& lua, const InnerNames& inner) {
  std::vector<Token> tokens = with_named_self(tokens_of(lua));
  LuaNames names = names_in(tokens, inner);
  for (const std::string_view field : inner.fields) {
    names.methods.insert(field);
    names.fields.erase(field);
  }
  std::map<std::string_view, std::size_t> bytes;  // that each name takes
  for (const Token& token : tokens) {
    if (names.are_renamed(token)) bytes[token.text] += token.text.size();
  }
  std::vector<std::pair<std::string_view, std::size_t>> by_size(bytes.begin(), bytes.end());
  std::stable_sort(by_size.begin(), by_size.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::map<std::string_view, std::string> renamed;
  std::size_t next = 0;
  for (const auto& [name, size] : by_size) {
    std::string shorter = short_name(next);
    while (names.all.count(shorter) != 0 || !is_lua_name(shorter)) shorter = short_name(++next);
    if (shorter.size() >= name.size()) continue;
    ++next;
    renamed.emplace(name, std::move(shorter));
  }
  std::string text;
  for (const Token& token : tokens) {
    const auto found = names.are_renamed(token) ? renamed.find(token.text) : renamed.end();
    text += found == renamed.end() ? token.text : std::string_view(found->second);
  }
  return text;
}

}  // namespace talus
