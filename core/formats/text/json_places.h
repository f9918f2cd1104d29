// Where values are in a JSON text that parse_json() has accepted.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text_edits.h"

namespace talus {

class JsonPlaces {
 public:
  // text: must live as long as this.
  explicit JsonPlaces(std::string_view text) : text_(text) {}

  TextSpan root() const { return value_at(0); }
  // The values of a list or of an object's members; empty for other values.
  std::vector<TextSpan> values(TextSpan list_or_object) const;
  // The value of the member; nothing if the object has none, or is no object.
  std::optional<TextSpan> member(TextSpan object, std::string_view key) const;
  // The members of an object, each from its key to the end of its value; empty for other values.
  struct Member {
    std::string key;
    TextSpan whole;
  };
  std::vector<Member> members(TextSpan object) const;
  bool is_list(TextSpan value) const { return text_[value.begin] == '['; }
  bool is_object(TextSpan value) const { return text_[value.begin] == '{'; }
  bool is_text(TextSpan value) const { return text_[value.begin] == '"'; }
  // The value of a member that is text or a whole number; else the fallback.
  std::string text_of(TextSpan object, std::string_view key, std::string_view fallback = {}) const;
  int number_of(TextSpan object, std::string_view key, int fallback = 0) const;
  // The blanks before a value or key, from the line break on; empty if it does not begin a line.
  std::string break_before(std::size_t at) const;
  // The place of the first key or value in an object or list; nothing if it is empty.
  std::optional<std::size_t> first_in(TextSpan list_or_object) const;

 private:
  TextSpan value_at(std::size_t at) const;
  std::size_t behind_blanks(std::size_t at) const;

  std::string_view text_;
};

// Sets a member; a new one comes behind the others, in a line of its own if they are.
void set_json_member(const JsonPlaces& places, TextSpan object, std::string_view key, std::string value,
                     TextEdits& edits);
// Puts values behind the last one of a list, each in a line of its own if the others are.
void append_json_values(const JsonPlaces& places, TextSpan list, const std::vector<std::string>& values,
                        TextEdits& edits);

// Changes of a list: the values that go, by their index, and new ones before the value of that index; before
// the list's end if there is no such value.
struct JsonListEdit {
  std::vector<std::size_t> removed = {};
  std::vector<std::pair<std::size_t, std::string>> added = {};
  bool empty() const { return removed.empty() && added.empty(); }
};
void change_json_list(const JsonPlaces& places, TextSpan list, const JsonListEdit& change, TextEdits& edits);

// Sets and removes members of an object. Call it once for an object.
struct JsonMemberEdit {
  std::string key;
  std::optional<std::string> value;  // nothing: the member goes
};
void change_json_members(const JsonPlaces& places, TextSpan object,
                         const std::vector<JsonMemberEdit>& changes, TextEdits& edits);

}  // namespace talus
