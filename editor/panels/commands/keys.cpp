// Turns chords of keys into text, and text into chords.
#include "keys.h"

namespace talus {
namespace {

std::string key_name(int key) {
  switch (key) {
    case kNoKey:
      return "";
    case kKeyTab:
      return "Tab";
    case kKeyDelete:
      return "Del";
    case kKeyEscape:
      return "Esc";
    case kKeyHome:
      return "Home";
    case kKeyEnd:
      return "End";
    case kKeyLeft:
      return "Left";
    case kKeyRight:
      return "Right";
    case kKeyUp:
      return "Up";
    case kKeyDown:
      return "Down";
    case kKeyEnter:
      return "Enter";
    case kKeyPageUp:
      return "PageUp";
    case kKeyPageDown:
      return "PageDown";
    case kKeyBackspace:
      return "Backspace";
    case ' ':
      return "Space";
    case ',':  // characters that are too small to read in a tooltip
      return "Comma";
    case '.':
      return "Period";
    case '`':
      return "Backquote";
    default:
      break;
  }
  if (key >= kKeyF1 && key <= kKeyF12) return "F" + std::to_string(key - kKeyF1 + 1);
  if (key >= 'a' && key <= 'z') key += 'A' - 'a';
  return std::string(1, static_cast<char>(key));
}

}  // namespace

std::string to_string(KeyChord chord) {
  if (!chord) return "";
  return std::string(chord.ctrl ? "Ctrl+" : "") + (chord.alt ? "Alt+" : "") + (chord.shift ? "Shift+" : "") +
         key_name(chord.key);
}

std::optional<KeyChord> parse_chord(std::string_view text) {
  KeyChord chord;
  const auto take = [&](std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
  };
  chord.ctrl = take("Ctrl+");
  chord.alt = take("Alt+");
  chord.shift = take("Shift+");
  constexpr int kLastKey = kKeyF12, kLastCharacter = '~';
  for (int key = ' '; key <= kLastKey; ++key) {
    if (key == kLastCharacter + 1) key = kKeyTab;
    if ((key < 'A' || key > 'Z') && key_name(key) == text) chord.key = key;
  }
  if (!chord && (!text.empty() || chord != KeyChord{})) return std::nullopt;
  return chord;
}

}  // namespace talus
