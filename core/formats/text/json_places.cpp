// Skips over values without reading them.
#include "json_places.h"

#include <algorithm>

#include "json_text.h"

namespace talus {
namespace {

// Behind the closing quote of a string that begins at `at`.
std::size_t behind_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

std::string read_string(std::string_view quoted) {
  const Json value = json_part(quoted);
  return value.is_string() ? value.get<std::string>() : std::string();
}

}  // namespace

std::size_t JsonPlaces::behind_blanks(std::size_t at) const {
  if (at == 0 && text_.starts_with("\xef\xbb\xbf")) at = 3;
  return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size());
}

TextSpan JsonPlaces::value_at(std::size_t at) const {
  at = behind_blanks(at);
  const std::size_t begin = at;
  int depth = 0;
  while (at < text_.size()) {
    const char c = text_[at];
    if (c == '"') {
      at = behind_string(text_, at);
    } else if (c == '{' || c == '[') {
      ++depth, ++at;
    } else if (c == '}' || c == ']') {
      --depth, ++at;
    } else if (depth > 0) {
      ++at;
      continue;
    } else {  // a number or a word
      at = std::min(text_.find_first_of(",]} \t\r\n", at), text_.size());
    }
    if (depth == 0) break;
  }
  return {begin, at};
}

std::optional<std::size_t> JsonPlaces::first_in(TextSpan list_or_object) const {
  const std::size_t at = behind_blanks(list_or_object.begin + 1);
  return at + 1 >= list_or_object.end ? std::nullopt : std::optional(at);
}

std::vector<TextSpan> JsonPlaces::values(TextSpan list_or_object) const {
  std::vector<TextSpan> all;
  if (!is_list(list_or_object) && !is_object(list_or_object)) return all;
  const auto first = first_in(list_or_object);
  if (!first) return all;
  std::size_t at = *first;
  while (true) {
    if (is_object(list_or_object)) at = behind_blanks(behind_string(text_, at)) + 1;  // the key and its colon
    all.push_back(value_at(at));
    at = behind_blanks(all.back().end);
    if (at + 1 >= list_or_object.end) return all;
    at = behind_blanks(at + 1);
  }
}

std::vector<JsonPlaces::Member> JsonPlaces::members(TextSpan object) const {
  std::vector<Member> all;
  if (!is_object(object)) return all;
  std::optional<std::size_t> at = first_in(object);
  for (const TextSpan value : values(object)) {
    all.push_back({read_string(text_.substr(*at, behind_string(text_, *at) - *at)), {*at, value.end}});
    const std::size_t comma = behind_blanks(value.end);
    at = behind_blanks(std::min(comma + 1, text_.size()));
  }
  return all;
}

std::optional<TextSpan> JsonPlaces::member(TextSpan object, std::string_view key) const {
  if (!is_object(object)) return std::nullopt;
  for (std::optional<std::size_t> at = first_in(object); at;) {
    const std::size_t key_end = behind_string(text_, *at);
    const std::string_view quoted = text_.substr(*at, key_end - *at);
    const TextSpan value = value_at(behind_blanks(key_end) + 1);
    const bool is_plain = quoted.find('\\') == quoted.npos;
    if (is_plain ? quoted.substr(1, quoted.size() - 2) == key : read_string(quoted) == key) return value;
    const std::size_t comma = behind_blanks(value.end);
    if (comma + 1 >= object.end) return std::nullopt;
    at = behind_blanks(comma + 1);
  }
  return std::nullopt;
}

std::string JsonPlaces::text_of(TextSpan object, std::string_view key, std::string_view fallback) const {
  const auto value = member(object, key);
  return value && is_text(*value) ? read_string(value->in(text_)) : std::string(fallback);
}

int JsonPlaces::number_of(TextSpan object, std::string_view key, int fallback) const {
  const auto value = member(object, key);
  const Json number = value ? json_part(value->in(text_)) : Json();
  constexpr double kMax = 2e9;
  const bool fits = number.is_number() && number.get<double>() >= -kMax && number.get<double>() <= kMax;
  return fits ? static_cast<int>(number.get<double>()) : fallback;
}

std::string JsonPlaces::break_before(std::size_t at) const {
  std::size_t begin = at;
  while (begin > 0 && (text_[begin - 1] == ' ' || text_[begin - 1] == '\t')) --begin;
  if (begin == 0 || text_[begin - 1] != '\n') return "";
  --begin;
  if (begin > 0 && text_[begin - 1] == '\r') --begin;
  return std::string(text_.substr(begin, at - begin));
}

void set_json_member(const JsonPlaces& places, TextSpan object, std::string_view key, std::string value,
                     TextEdits& edits) {
  if (const auto known = places.member(object, key)) return edits.replace(*known, std::move(value));
  const std::vector<TextSpan> values = places.values(object);
  const auto first = places.first_in(object);
  const std::string member = "\"" + std::string(key) + "\":" + value;
  if (!first || values.empty()) return edits.insert(object.begin + 1, member);
  const std::string line = places.break_before(*first);
  edits.insert(values.back().end, "," + (line.empty() ? " " : line) + member);
}

void append_json_values(const JsonPlaces& places, TextSpan list, const std::vector<std::string>& values,
                        TextEdits& edits) {
  const std::vector<TextSpan> known = places.values(list);
  const std::string line = known.empty() ? "" : places.break_before(known.front().begin);
  std::string text;
  for (const std::string& value : values)
    text += (known.empty() && text.empty() ? "" : "," + (line.empty() ? " " : line)) + value;
  edits.insert(known.empty() ? list.begin + 1 : known.back().end, text);
}

namespace {

// Changes values or members, which are parts of `whole` with commas between them.
void change_parts(const JsonPlaces& places, TextSpan whole, const std::vector<TextSpan>& parts,
                  const JsonListEdit& change, TextEdits& edits) {
  if (change.empty()) return;
  std::vector<bool> is_removed(parts.size());
  for (const std::size_t i : change.removed) is_removed[i] = true;
  const auto goes = [&](std::size_t i) { return is_removed[i]; };
  const std::string line = parts.empty() ? "" : places.break_before(parts.front().begin);
  const std::string separator = "," + (line.empty() ? " " : line);
  std::size_t first_kept = 0;
  while (first_kept < parts.size() && goes(first_kept)) ++first_kept;
  if (first_kept == parts.size()) {
    std::string text;
    for (const auto& [before, value] : change.added) text += (text.empty() ? "" : separator) + value;
    const std::size_t begin = whole.begin + 1;
    return edits.replace(
        parts.empty() ? TextSpan{begin, begin} : TextSpan{parts.front().begin, parts.back().end}, text);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i < first_kept) edits.replace({parts[i].begin, parts[i + 1].begin}, "");
    if (i > first_kept && goes(i)) edits.replace({parts[i - 1].end, parts[i].end}, "");
  }
  for (const auto& [place, value] : change.added) {
    std::size_t before = place;
    while (before < parts.size() && goes(before)) ++before;  // what goes takes the text around it along
    if (before < parts.size())
      edits.insert(parts[before].begin, value + separator);
    else
      edits.insert(parts.back().end, separator + value);
  }
}

}  // namespace

void change_json_list(const JsonPlaces& places, TextSpan list, const JsonListEdit& change, TextEdits& edits) {
  change_parts(places, list, places.values(list), change, edits);
}

void change_json_members(const JsonPlaces& places, TextSpan object,
                         const std::vector<JsonMemberEdit>& changes, TextEdits& edits) {
  std::vector<TextSpan> parts;
  const std::vector<JsonPlaces::Member> members = places.members(object);
  parts.reserve(members.size());
  for (const JsonPlaces::Member& member : members) parts.push_back(member.whole);
  JsonListEdit change;
  for (const JsonMemberEdit& edit : changes) {
    const auto known =
        std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.key == edit.key; });
    if (known == members.end()) {
      if (edit.value) change.added.emplace_back(parts.size(), "\"" + edit.key + "\":" + *edit.value);
    } else if (edit.value) {
      edits.replace(*places.member(object, edit.key), *edit.value);
    } else {
      change.removed.push_back(static_cast<std::size_t>(known - members.begin()));
    }
  }
  change_parts(places, object, parts, change, edits);
}

}  // namespace talus
