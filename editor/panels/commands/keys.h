// Keys and their names, without any windowing library.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus {

// A key. A printable key is its character in lower case ('a', '[', '`'); the others have values from 256 on.
enum Key : int {
  kNoKey = 0,
  kKeyTab = 256,
  kKeyDelete,
  kKeyEscape,
  kKeyHome,
  kKeyEnd,
  kKeyPageUp,
  kKeyPageDown,
  kKeyLeft,
  kKeyRight,
  kKeyUp,
  kKeyDown,
  kKeyEnter,
  kKeyBackspace,
  kKeyF1,
  kKeyF2,
  kKeyF3,
  kKeyF4,
  kKeyF5,
  kKeyF6,
  kKeyF7,
  kKeyF8,
  kKeyF9,
  kKeyF10,
  kKeyF11,
  kKeyF12,
};

struct KeyChord {
  int key = kNoKey;
  bool ctrl = false, shift = false, alt = false;
  explicit operator bool() const { return key != kNoKey; }
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

constexpr KeyChord ctrl(int key) { return {key, true, false, false}; }
constexpr KeyChord shift(int key) { return {key, false, true, false}; }
constexpr KeyChord ctrl_shift(int key) { return {key, true, true, false}; }
constexpr KeyChord alt(int key) { return {key, false, false, true}; }
constexpr KeyChord alt_shift(int key) { return {key, false, true, true}; }

std::string to_string(KeyChord chord);                       // "Ctrl+Shift+S"; empty for no key
std::optional<KeyChord> parse_chord(std::string_view text);  // reads the result of to_string(), also that of
                                                             // no key; empty: the text is no chord

}  // namespace talus
