#include "short_names.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "lua_text.h"

namespace talus {
namespace {

constexpr std::string_view kGlobals[] = {"assert",  "error",    "getmetatable", "ipairs",       "math",
                                         "next",    "pairs",    "print",        "rawget",       "rawset",
                                         "require", "select",   "self",         "setmetatable", "string",
                                         "table",   "tonumber", "tostring",     "type",         "unpack"};

// A name, a string in quotes, a number, or one other character.
std::vector<std::string_view> tokens_of(std::string_view text) {
  std::vector<std::string_view> tokens;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (is_lua_word(text[i])) {
      while (end < text.size() && is_lua_word(text[end])) ++end;
    } else if (text[i] == '"') {
      while (end < text.size() && text[end] != '"') ++end;
      end = std::min(end + 1, text.size());
    }
    tokens.push_back(text.substr(i, end - i));
    i = end;
  }
  return tokens;
}

struct Names {
  std::set<std::string_view> all, locals, fields, methods;

  bool are_renamed(std::string_view name) const {
    if (fields.count(name) != 0) return false;
    if (std::find(std::begin(kGlobals), std::end(kGlobals), name) != std::end(kGlobals)) return false;
    return locals.count(name) != 0 || methods.count(name) != 0;
  }
};

// `spaced` has the blanks and line breaks between the tokens, too. inner: tables whose methods may get other
// names.
Names names_in(const std::vector<std::string_view>& spaced, std::initializer_list<std::string_view> inner) {
  std::vector<std::string_view> tokens;  // a line break ends a list of locals
  std::copy_if(spaced.begin(), spaced.end(), std::back_inserter(tokens),
               [](auto token) { return token != " "; });
  Names names;
  enum class List { none, locals, parameters } list = List::none;
  int braces = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string_view token = tokens[i], before = i > 0 ? tokens[i - 1] : "";
    const std::string_view after = i + 1 < tokens.size() ? tokens[i + 1] : "";
    if (token == "{") ++braces;
    if (token == "}") --braces;
    if (token == "local" || token == "for") list = List::locals;
    if (token == "function") list = List::parameters;
    const bool ends_locals = token == "=" || token == "in" || token == "\n";
    if ((list == List::locals && ends_locals) || (list == List::parameters && token == ")"))
      list = List::none;
    if (!is_lua_name(token)) continue;
    names.all.insert(token);
    const bool is_key = braces > 0 && (before == "{" || before == ",") && after == "=" && list == List::none;
    const bool is_concatenated = before == "." && i > 1 && tokens[i - 2] == ".";
    const bool is_field = before == "." && !is_concatenated;
    if (is_field || before == ":") {
      const std::string_view of = i > 1 ? tokens[i - 2] : "";
      const bool is_inner = std::find(inner.begin(), inner.end(), of) != inner.end();
      const bool is_defined = i > 2 && tokens[i - 3] == "function";
      if (is_inner && is_defined) names.methods.insert(token);
      // Who has a method that is called is not known here.
      if (!is_inner && (is_field || is_defined)) names.fields.insert(token);
    } else if (is_key) {
      names.fields.insert(token);
    } else if (list == List::locals || (list == List::parameters && (before == "(" || before == ",")) ||
               (before == "function" && i > 1 && tokens[i - 2] == "local")) {
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

std::string with_short_names(const std::string& lua, std::initializer_list<std::string_view> inner) {
  const std::vector<std::string_view> tokens = tokens_of(lua);
  const Names names = names_in(tokens, inner);
  std::map<std::string_view, std::size_t> bytes;  // that each name takes
  for (const std::string_view token : tokens) {
    if (names.are_renamed(token)) bytes[token] += token.size();
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
  for (const std::string_view token : tokens) {
    const auto found = renamed.find(token);
    text += found == renamed.end() ? token : std::string_view(found->second);
  }
  return text;
}

}  // namespace talus
