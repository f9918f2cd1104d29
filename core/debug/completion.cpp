#include "completion.h"

#include <algorithm>

#include "expression_lexer.h"
#include "expression_names.h"

namespace talus {
namespace {

bool is_word_part(char c) { return is_name_part(c) || c == '.'; }

// Whether the text ends with "body(...)", to which a name may be added after a dot.
bool ends_with_body(std::string_view text) {
  int open = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == ')') ++open;
    if (text[i] == '(') --open;
    if (open != 0) continue;
    text = text.substr(0, i);
    return text.ends_with("body") && (text.size() == 4 || !is_word_part(text[text.size() - 5]));
  }
  return false;
}

Candidate candidate_of(const ExpressionName& name) {
  std::string text(name.name);
  return {name.arguments > 0 ? text + "(" : text, text + std::string(name.parameters), name.help};
}

}  // namespace

Completion complete(std::string_view text, std::size_t cursor) {
  cursor = std::min(cursor, text.size());
  std::size_t from = cursor, to = cursor;
  while (from > 0 && is_word_part(text[from - 1])) --from;
  while (to < text.size() && is_name_part(text[to])) ++to;

  constexpr std::string_view kBody = "body.";
  bool of_body = false;
  if (text.substr(from, cursor - from).starts_with(kBody)) {
    of_body = true;
    from += kBody.size();
  } else if (from < cursor && text[from] == '.' && from > 0 && text[from - 1] == ')') {
    if (!ends_with_body(text.substr(0, from))) return {cursor, cursor, {}};
    of_body = true;
    ++from;
  }
  const std::string_view typed = text.substr(from, cursor - from);
  Completion completion{from, to, {}};
  for (const ExpressionName& name : expression_names()) {
    if (name.name.starts_with(typed) && (name.of_body || !of_body))
      completion.candidates.push_back(candidate_of(name));
  }
  constexpr std::string_view kAnother = "body";
  if (!of_body && kAnother.starts_with(typed)) {
    completion.candidates.push_back({"body.", "body.NAME", "a name of the body that is asked about"});
    completion.candidates.push_back({"body(", "body(id).NAME", "a name of the body with this id"});
  }
  return completion;
}

}  // namespace talus
