// Looks at the byte order mark, and at the XML declaration.
#include "xml_encoding.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "../import/import_drops.h"
#include "text_edits.h"
#include "utf8_text.h"

namespace talus {
namespace {

using namespace std::string_view_literals;

// What bytes from 0x80 on are in windows-1252; all others are as in ISO-8859-1.
constexpr std::array<std::uint16_t, 32> kWindows1252 = {
    0x20ac, 0x0081, 0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x008d, 0x017d, 0x008f, 0x0090, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0x009d, 0x017e, 0x0178};

constexpr std::array kUtf8Names = {"utf-8"sv, "utf8"sv};
constexpr std::array kLatin1Names = {"iso-8859-1"sv, "iso_8859-1"sv, "iso8859-1"sv, "latin1"sv, "latin-1"sv};
constexpr std::array kWindows1252Names = {"windows-1252"sv, "cp1252"sv, "cp-1252"sv};

template <std::size_t count>
bool is_among(const std::array<std::string_view, count>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto add_rest = [&](int shift) { add(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xc0 | code >> 6);
  } else if (code < 0x10000) {
    add(0xe0 | code >> 12);
    add_rest(6);
  } else {
    add(0xf0 | code >> 18);
    add_rest(12);
    add_rest(6);
  }
  add_rest(0);
}

FormatResult<std::string> utf8_of_utf16(std::string_view bytes) {
  const bool is_big = bytes.starts_with("\xfe\xff"sv) || bytes.starts_with("\0<"sv);
  const auto unit_at = [&](std::size_t at) {
    const auto first = static_cast<std::uint8_t>(bytes[at]),
               second = static_cast<std::uint8_t>(bytes[at + 1]);
    return static_cast<std::uint32_t>(is_big ? first << 8 | second : second << 8 | first);
  };
  const auto is_half = [](std::uint32_t unit, std::uint32_t first) { return unit >> 10 == first >> 10; };
  std::string text;
  text.reserve(bytes.size() / 2);
  const bool has_mark = !bytes.starts_with('<') && !bytes.starts_with('\0');
  for (std::size_t at = has_mark ? 2 : 0; at < bytes.size(); at += 2) {
    const std::size_t begin = at;
    const bool is_whole = at + 2 <= bytes.size();
    std::uint32_t code = is_whole ? unit_at(at) : 0;
    bool is_good = is_whole && !is_half(code, 0xdc00);
    if (is_good && is_half(code, 0xd800)) {
      at += 2;
      const std::uint32_t low = at + 2 <= bytes.size() ? unit_at(at) : 0;
      is_good = is_half(low, 0xdc00);
      code = 0x10000 + ((code & 0x3ff) << 10 | (low & 0x3ff));
    }
    if (!is_good)
      return tl::unexpected(FormatError{"byte " + std::to_string(begin), "has a half character of UTF-16"});
    append_utf8(text, code);
  }
  return text;
}

std::string utf8_of_bytes(std::string_view bytes, bool is_windows) {
  std::string text;
  text.reserve(bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<std::uint8_t>(c);
    const bool is_own = is_windows && byte >= 0x80 && byte < 0xa0;
    append_utf8(text, is_own ? kWindows1252[byte - 0x80U] : byte);
  }
  return text;
}

// Where the name of the encoding is in a declaration, `<?xml version="1.0" encoding="UTF-8"?>`; nothing if
// there is none.
std::optional<TextSpan> declared_encoding(std::string_view text) {
  constexpr std::size_t kLongest = 1024;  // bytes
  const std::string_view head = text.substr(0, std::min(text.substr(0, kLongest).find("?>"), kLongest));
  const std::size_t key = head.starts_with("<?xml") ? head.find("encoding") : head.npos;
  if (key == head.npos) return std::nullopt;
  const std::size_t open = head.find_first_of("\"'", key);
  const std::size_t close = open == head.npos ? open : head.find(head[open], open + 1);
  if (close == head.npos) return std::nullopt;
  return TextSpan{open + 1, close};
}

std::string declared_as_utf8(std::string text) {
  if (const auto name = declared_encoding(text)) text.replace(name->begin, name->end - name->begin, "UTF-8");
  return text;
}

}  // namespace

bool is_utf16(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 2);
  return start == "\xff\xfe"sv || start == "\xfe\xff"sv || start == "<\0"sv || start == "\0<"sv;
}

FormatResult<std::optional<std::string>> xml_in_utf8(std::string_view bytes) {
  if (is_utf16(bytes)) {
    auto text = utf8_of_utf16(bytes);
    if (!text) return tl::unexpected(text.error());
    return declared_as_utf8(*std::move(text));
  }
  const auto span = declared_encoding(bytes);
  if (!span) return std::nullopt;
  std::string name(span->in(bytes));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (is_among(kUtf8Names, name)) return std::nullopt;
  if (is_among(kLatin1Names, name)) return declared_as_utf8(utf8_of_bytes(bytes, false));
  if (is_among(kWindows1252Names, name)) return declared_as_utf8(utf8_of_bytes(bytes, true));
  if (is_utf8(bytes)) return declared_as_utf8(std::string(bytes));  // programs declare what they do not write
  return tl::unexpected(FormatError{"", "is text in the encoding " + quoted_name(name) +
                                            ", but must be in UTF-8, UTF-16, ISO-8859-1 or windows-1252"});
}

}  // namespace talus
