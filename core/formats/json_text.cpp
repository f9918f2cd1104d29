// A look over the text before nlohmann's parser builds anything, so that hostile nesting and counts cost no
// memory; and a printer with a line for what a diff should show alone.
#include "json_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace talus {
namespace {

constexpr std::size_t kMaxInline = 140;  // a tile with all its flags fits

FormatResult<void> check_limits(std::string_view text) {
  int depth = 0, values = 1;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
      continue;
    }
    in_string = c == '"';
    const bool opens = c == '[' || c == '{';
    if (c == ']' || c == '}') --depth;
    if (opens && ++depth > kMaxJsonDepth)
      return error_at_line(text, i, "JSON is nested deeper here than 64 levels");
    if ((opens || c == ',') && ++values > kMaxJsonValues)
      return error_at_line(text, i, "JSON has too many values");
  }
  return {};
}

// Finds the value that cannot be read, by its keys and its numbers in lists: "curves[2].radius".
class PlaceFinder : public nlohmann::json_sax<Json> {
 public:
  std::string path() const {
    std::string path;
    for (const Level& level : levels_) {
      if (level.is_array) {
        path.append("[").append(std::to_string(level.index)).append("]");
      } else {
        path.append(path.empty() ? "" : ".").append(level.key);
      }
    }
    return path;
  }
  std::size_t offset() const { return offset_; }

  bool null() override { return next(); }
  bool boolean(bool) override { return next(); }
  bool number_integer(number_integer_t) override { return next(); }
  bool number_unsigned(number_unsigned_t) override { return next(); }
  bool number_float(number_float_t, const string_t&) override { return next(); }
  bool string(string_t&) override { return next(); }
  bool binary(binary_t&) override { return next(); }
  bool start_object(std::size_t) override { return begin(false); }
  bool start_array(std::size_t) override { return begin(true); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(string_t& key) override {
    levels_.back().key = key;
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    offset_ = position == 0 ? 0 : position - 1;
    return false;
  }

 private:
  struct Level {
    bool is_array;
    std::size_t index;
    std::string key;
  };

  bool next() {
    if (!levels_.empty()) ++levels_.back().index;
    return true;
  }
  bool begin(bool is_array) {
    levels_.push_back({is_array, 0, ""});
    return true;
  }
  bool end() {
    levels_.pop_back();
    return next();
  }

  std::vector<Level> levels_;
  std::size_t offset_ = 0;
};

tl::unexpected<FormatError> invalid_json(std::string_view text, std::size_t offset) {
  auto error = error_at_line(text, offset, "this is not valid JSON");
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_break = before.rfind('\n');
  const std::size_t column = line_break == before.npos ? before.size() + 1 : before.size() - line_break;
  error.value().place += ", column " + std::to_string(column);
  return error;
}

FormatError too_large_number(std::string_view text) {
  PlaceFinder finder;
  Json::sax_parse(text, &finder);
  FormatError error = error_at_line(text, finder.offset(), "has a number that is too large").value();
  if (const std::string path = finder.path(); !path.empty()) error.place += ", key " + path;
  return error;
}

// Thrown out of nlohmann's parser, which cannot be stopped otherwise, and caught by parse_json.
struct Stopped {};

// A place in a text that tells, while the parser goes on, how far it is.
class ToldIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  // Both must stay.
  ToldIterator(std::string_view text, const char* at, const Progress& progress)
      : text_(text), at_(at), progress_(&progress) {}
  reference operator*() const { return *at_; }
  ToldIterator& operator++() {
    const auto done = static_cast<std::size_t>(++at_ - text_.data());
    if (done % kStep == 0 && !progress_->at(done, text_.size())) throw Stopped();
    return *this;
  }
  bool operator==(const ToldIterator& other) const { return at_ == other.at_; }

 private:
  static constexpr std::size_t kStep = 1 << 14;  // bytes
  std::string_view text_;
  const char* at_;
  const Progress* progress_;
};

bool is_row(const Json& value) {
  return value.is_array() && std::all_of(value.begin(), value.end(),
                                         [](const Json& v) { return v.is_primitive() && !v.is_string(); });
}

class Printer {
 public:
  explicit Printer(std::span<const std::string_view> order) : order_(order) {}

  void print(const Json& value, int indent) {
    if (value.is_primitive()) {
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
  };

  std::vector<Member> members(const Json& value) const {
    std::vector<Member> list;
    list.reserve(value.size());
    if (value.is_array()) {
      for (const Json& element : value) list.push_back({nullptr, &element});
      return list;
    }
    for (auto it = value.begin(); it != value.end(); ++it) list.push_back({&it.key(), &it.value()});
    std::sort(list.begin(), list.end(), [this](const Member& a, const Member& b) {
      const auto rank = [this](const std::string& key) {
        return std::find(order_.begin(), order_.end(), key);
      };
      const auto rank_a = rank(*a.key), rank_b = rank(*b.key);
      if (rank_a != rank_b) return rank_a < rank_b;
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

FormatResult<Json> parse_json(std::string_view text, const Progress& progress) {
  if (const auto good = check_limits(text); !good) return tl::unexpected(good.error());
  try {
    return Json::parse(ToldIterator(text, text.data(), progress),
                       ToldIterator(text, text.data() + text.size(), progress));
  } catch (const Stopped&) {
    return was_cancelled();
  } catch (const Json::parse_error& error) {
    return invalid_json(text, error.byte == 0 ? 0 : error.byte - 1);
  } catch (const Json::exception&) {  // a number that no double holds; nlohmann does not say where
    return tl::unexpected(too_large_number(text));
  }
}

std::string print_json(const Json& value, std::span<const std::string_view> order) {
  Printer printer(order);
  printer.print(value, 0);
  return printer.take() + "\n";
}

bool is_utf8(std::string_view text) {
  try {
    Json(text).dump();  // the same check that printing makes
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

Json json_number(double value) {
  constexpr double kExact = 9007199254740992;  // 2^53, up to where a double holds every whole number
  const bool whole =
      std::abs(value) < kExact && value == std::trunc(value) && !(value == 0 && std::signbit(value));
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

}  // namespace talus
