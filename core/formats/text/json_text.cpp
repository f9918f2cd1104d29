// nlohmann's parser with a builder of its own: hostile nesting and counts cost no memory, and no value is
// replaced in silence. And a printer that gives a line to each thing that a diff should show alone.
#include "json_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include <talus/level/limits.h>

namespace talus {
namespace {

constexpr std::size_t kMaxInline = 140;  // a tile with all its flags fits
// Deeper values, which Talus never writes, go on one line: lines would be mostly blanks.
constexpr int kMaxIndent = 32;

// Thrown out of nlohmann's parser, which cannot be stopped within a value in another way. parse_json catches
// it.
struct Stopped {};

// Position of the parser, which it does not report for valid text.
struct Reading {
  std::string_view text;
  const Progress& progress;
  std::size_t bytes = 0;
};

// Goes through the text and reports the progress.
class ReadingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  ReadingIterator(Reading& reading, const char* at) : reading_(&reading), at_(at) {}
  reference operator*() const { return *at_; }
  ReadingIterator& operator++() {
    reading_->bytes = static_cast<std::size_t>(++at_ - reading_->text.data());
    if (reading_->bytes % kStep == 0 && !reading_->progress.at(reading_->bytes, reading_->text.size()))
      throw Stopped();
    return *this;
  }
  bool operator==(const ReadingIterator& other) const { return at_ == other.at_; }

 private:
  static constexpr std::size_t kStep = 1 << 14;  // bytes
  Reading* reading_;
  const char* at_;
};

// Takes what the parser finds (nlohmann's SAX interface), and stops it at anything that no file may have.
class StrictBuilder {
 public:
  enum class Problem { none, invalid, too_large, too_deep, too_many_keys, twice };

  explicit StrictBuilder(int most_deep) : most_deep_(most_deep) {}

  Problem problem() const { return problem_; }
  int most_deep() const { return most_deep_; }
  // bytes that the parser had read at the error; 0: there was no error
  std::size_t bytes() const { return bytes_; }
  Json take() { return std::move(root_); }

  // The value at which the parser stopped: "curves[2].radius". Empty: the whole text.
  std::string path() const {
    std::string path;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Json* const next = i + 1 < open_.size() ? open_[i + 1] : nullptr;
      if (open_[i]->is_array()) {
        const std::size_t index = open_[i]->size() - (next != nullptr ? 1 : 0);
        path.append("[").append(std::to_string(index)).append("]");
      } else {
        path.append(path.empty() ? "" : ".").append(key_of(*open_[i], next));
      }
    }
    return path;
  }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }  // text has no binary values
  bool start_object(std::size_t) { return open(Json::value_t::object); }
  bool start_array(std::size_t) { return open(Json::value_t::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& key) {
    auto& members = open_.back()->get_ref<Json::object_t&>();
    const auto [member, is_new] = members.try_emplace(std::move(key));
    member_ = &member->second;
    if (members.size() > kMaxJsonKeys) return stop(Problem::too_many_keys);
    return is_new || stop(Problem::twice);
  }
  bool parse_error(std::size_t bytes, const std::string&, const Json::exception& error) {
    constexpr int kNumberOverflow = 406;
    bytes_ = bytes;
    return stop(error.id == kNumberOverflow ? Problem::too_large : Problem::invalid);
  }

 private:
  bool stop(Problem problem) {
    problem_ = problem;
    return false;
  }

  // next: what is open in the object; null: the value of its last key is being read.
  std::string key_of(const Json& object, const Json* next) const {
    const Json* const wanted = next != nullptr ? next : member_;
    for (const auto& [key, value] : object.get_ref<const Json::object_t&>()) {
      if (&value == wanted) return key;
    }
    return "";
  }

  // The place for the next value.
  template <class Value>
  Json& put(Value&& value) {
    if (open_.empty()) return root_ = std::forward<Value>(value);
    if (open_.back()->is_array())
      return open_.back()->get_ref<Json::array_t&>().emplace_back(std::forward<Value>(value));
    return *member_ = std::forward<Value>(value);
  }
  template <class Value>
  bool add(Value&& value) {
    put(std::forward<Value>(value));
    return true;
  }

  bool open(Json::value_t kind) {
    if (std::ssize(open_) >= most_deep_) return stop(Problem::too_deep);
    open_.push_back(&put(Json(kind)));
    return true;
  }
  // In an object, a key comes next.
  bool close() {
    open_.pop_back();
    return true;
  }

  int most_deep_;
  Json root_;
  std::vector<Json*> open_;  // objects and lists that have not ended, from the outermost
  Json* member_ = nullptr;   // the value of the last key of the innermost object
  std::size_t bytes_ = 0;
  Problem problem_ = Problem::none;
};

// Takes the keys of the outermost object, and stops at one of the wanted ones.
class KeyFinder {
 public:
  explicit KeyFinder(std::span<const std::string_view> keys) : keys_(keys) {}
  bool found() const { return found_; }

  bool null() { return true; }
  bool boolean(bool) { return true; }
  bool number_integer(std::int64_t) { return true; }
  bool number_unsigned(std::uint64_t) { return true; }
  bool number_float(double, const std::string&) { return true; }
  bool string(std::string&) { return true; }
  bool binary(Json::binary_t&) { return true; }
  bool start_object(std::size_t) { return open(); }
  bool start_array(std::size_t) { return depth_ > 0 && open(); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(const std::string& key) {
    found_ = depth_ == 1 && std::find(keys_.begin(), keys_.end(), key) != keys_.end();
    return !found_;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) { return false; }

 private:
  bool open() {
    ++depth_;
    return true;
  }
  bool close() {
    --depth_;
    return true;
  }

  std::span<const std::string_view> keys_;
  std::size_t depth_ = 0;  // of the objects and lists that have not ended
  bool found_ = false;
};

// Column of the offset in its line, from 1.
std::size_t column_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_break = before.rfind('\n');
  return line_break == before.npos ? before.size() + 1 : before.size() - line_break;
}

std::string line_of(std::string_view text, std::size_t offset, std::int64_t first_line) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(offset);
  return "line " + std::to_string(first_line + std::count(text.begin(), end, '\n'));
}

FormatError error_of(const StrictBuilder& builder, std::string_view text, std::size_t offset,
                     std::int64_t first_line) {
  using Problem = StrictBuilder::Problem;
  std::string place = line_of(text, offset, first_line);
  const std::string path = builder.path();
  const std::string at_key = path.empty() ? place : place + ", key " + path;
  switch (builder.problem()) {
    case Problem::too_large:
      return {at_key, "has a number that is too large"};
    case Problem::twice:
      return {at_key, "is twice in one object"};
    case Problem::too_deep:
      return {place,
              "the JSON is nested deeper than " + std::to_string(builder.most_deep()) + " levels here"};
    case Problem::too_many_keys:
      return {place, "the JSON has an object with more than " + std::to_string(kMaxJsonKeys) + " keys"};
    case Problem::none:
    case Problem::invalid:
      break;
  }
  return {place + ", column " + std::to_string(column_of(text, offset)), "this is not valid JSON"};
}

// Returns the offset in valid JSON of the first value beyond the limit; npos if there are not so many. It
// counts before any value is made, as making them takes seconds and hundreds of MB.
std::size_t value_too_many(std::string_view json) {
  constexpr std::size_t kMaxWithout =
      2 * std::size_t{kMaxJsonValues} - 1;  // bytes: a value and a comma take 2
  if (json.size() <= kMaxWithout) return json.npos;
  int values = 1;
  bool in_string = false, opened = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
      continue;
    }
    if (c == ' ' || c == '\n' || c == '\t' || c == '\r') continue;
    if (c == ',' || (opened && c != ']' && c != '}')) ++values;
    if (values > kMaxJsonValues) return i;
    opened = c == '[' || c == '{';
    in_string = c == '"';
  }
  return json.npos;
}

bool is_row(const Json& value) {
  return value.is_array() && std::all_of(value.begin(), value.end(),
                                         [](const Json& v) { return v.is_primitive() && !v.is_string(); });
}

class Printer {
 public:
  explicit Printer(std::span<const std::string_view> order) : order_(order) {}

  void print(const Json& value, int indent) {
    if (value.is_primitive() || indent > kMaxIndent) {
      text_ += value.dump();
    } else if (value.empty()) {
      text_ += value.is_array() ? "[]" : "{}";
    } else if (!print_inline(value)) {
      print_lines(value, indent);
    }
  }

  std::string take() { return std::move(text_); }

 private:
  struct Member {
    const std::string* key;  // null in an array
    const Json* value;
    std::size_t rank;  // of the key, in the order
  };

  std::vector<Member> members(const Json& value) const {
    std::vector<Member> list;
    list.reserve(value.size());
    if (value.is_array()) {
      for (const Json& element : value) list.push_back({nullptr, &element, 0});
      return list;
    }
    for (auto it = value.begin(); it != value.end(); ++it) {
      const auto rank = std::find(order_.begin(), order_.end(), it.key()) - order_.begin();
      list.push_back({&it.key(), &it.value(), static_cast<std::size_t>(rank)});
    }
    std::sort(list.begin(), list.end(), [](const Member& a, const Member& b) {
      if (a.rank != b.rank) return a.rank < b.rank;
      if (a.key->size() != b.key->size()) return a.key->size() < b.key->size();
      return *a.key < *b.key;
    });
    return list;
  }

  void print_key(const Member& member) {
    if (member.key) text_ += Json(*member.key).dump() + ": ";
  }

  bool print_inline(const Json& value) {
    const bool flat =
        is_row(value) || (value.is_object() && std::all_of(value.begin(), value.end(), [](const Json& v) {
                            return v.is_primitive() || is_row(v);
                          }));
    if (!flat || value.size() > kMaxInline) return false;
    const std::size_t begin = text_.size();
    text_ += value.is_array() ? "[" : "{";
    const char* separator = "";
    for (const Member& member : members(value)) {
      text_ += separator;
      separator = ", ";
      print_key(member);
      print(*member.value, 0);
      if (text_.size() - begin > kMaxInline) {
        text_.resize(begin);
        return false;
      }
    }
    text_ += value.is_array() ? "]" : "}";
    return true;
  }

  void print_lines(const Json& value, int indent) {
    text_ += value.is_array() ? "[" : "{";
    const char* separator = "\n";
    for (const Member& member : members(value)) {
      text_.append(separator).append(static_cast<std::size_t>(indent) + 2, ' ');
      separator = ",\n";
      print_key(member);
      print(*member.value, indent + 2);
    }
    text_.append("\n").append(static_cast<std::size_t>(indent), ' ').append(value.is_array() ? "]" : "}");
  }

  std::span<const std::string_view> order_;
  std::string text_;
};

}  // namespace

Json json_part(std::string_view text) { return Json::parse(text, nullptr, false); }

FormatResult<Json> parse_json(std::string_view text, const Progress& progress, std::int64_t first_line,
                              int most_deep) {
  if (const std::size_t excess = value_too_many(text); excess != text.npos)
    return tl::unexpected(
        FormatError{line_of(text, excess, first_line),
                    "the JSON has more than " + std::to_string(kMaxJsonValues) + " values"});
  Reading reading{text, progress};
  const ReadingIterator begin(reading, text.data()), end(reading, text.data() + text.size());
  StrictBuilder builder(most_deep);
  const std::size_t zero = text.find('\0');  // the parser would take NUL for the end
  std::size_t bytes = 0;
  try {
    const bool is_good = Json::sax_parse(begin, end, &builder);
    if (is_good && zero == text.npos) return builder.take();
    bytes = is_good ? zero + 1 : builder.bytes() > 0 ? builder.bytes() : reading.bytes;
  } catch (const Stopped&) {
    return was_cancelled();
  }
  const std::size_t offset = std::min(std::max<std::size_t>(bytes, 1) - 1, text.size());
  return tl::unexpected(error_of(builder, text, offset, first_line));
}

bool has_key(std::string_view text, std::span<const std::string_view> keys) {
  KeyFinder finder(keys);
  (void)Json::sax_parse(text.begin(), text.end(), &finder);
  return finder.found();
}

int depth_of(const Json& value) {
  if (!value.is_structured()) return 0;
  int deepest = 0;
  for (const Json& member : value) deepest = std::max(deepest, depth_of(member));
  return 1 + deepest;
}

bool is_whole(const Json& value, std::int64_t min, std::int64_t max) {
  if (!value.is_number_integer()) return false;
  const bool fits = !value.is_number_unsigned() ||
                    value.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<std::int64_t>::max()};
  return fits && value.get<std::int64_t>() >= min && value.get<std::int64_t>() <= max;
}

std::string print_json(const Json& value, std::span<const std::string_view> order) {
  Printer printer(order);
  printer.print(value, 0);
  return printer.take() + "\n";
}

std::optional<std::string> problem_of_size(std::string_view printed) {
  if (printed.size() > kMaxFileBytes) {
    return "takes " + std::to_string(printed.size() >> 20) + " MiB as a file, but Talus reads only up to " +
           std::to_string(kMaxFileBytes >> 20);
  }
  if (value_too_many(printed) != printed.npos)
    return "has more lines and numbers than Talus reads from one file";
  return std::nullopt;
}

Json json_number(double value) {
  constexpr double kExact = 9007199254740992;  // 2^53; up to there a double holds every whole number
  const bool whole =
      std::abs(value) < kExact && value == std::trunc(value) && !(value == 0 && std::signbit(value));
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

}  // namespace talus
