// Changes of a text at places of it, made at once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

// Bytes of a text, from `begin` to the one before `end`.
struct TextSpan {
  std::size_t begin = 0, end = 0;
  std::string_view in(std::string_view text) const { return text.substr(begin, end - begin); }
};

class TextEdits {
 public:
  // The spans must not overlap (asserted by applied_to). Insertions at one place keep their order.
  void replace(TextSpan span, std::string text) { edits_.push_back({span, std::move(text)}); }
  void insert(std::size_t at, std::string text) { replace({at, at}, std::move(text)); }
  std::string applied_to(std::string_view text) const;

 private:
  struct Edit {
    TextSpan span;
    std::string text;
  };
  std::vector<Edit> edits_;
};

}  // namespace talus
