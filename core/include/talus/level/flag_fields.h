// Flags read together: patterns of flags to look for and to paint, and fields, numbers over several flags.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/level/tileset.h>

namespace talus {

// Some of a tile's eight flags, and the values that they must have: one flag set, or the value of a field.
struct FlagPattern {
  std::uint8_t mask = 1;  // the flags that count, at least one
  std::uint8_t bits = 1;  // those of them that must be set; lies within the mask

  // Whether a tile with these flags matches.
  bool matches(std::uint8_t flags) const { return (flags & mask) == bits; }
  // Flags that match, and are the same otherwise.
  std::uint8_t put_in(std::uint8_t flags) const { return static_cast<std::uint8_t>((flags & ~mask) | bits); }
  int lowest_flag() const;  // 0..7, of the mask
  friend bool operator==(const FlagPattern&, const FlagPattern&) = default;
};

// flag: 0..7
inline FlagPattern pattern_of_flag(int flag) {
  const auto bit = static_cast<std::uint8_t>(1 << flag);
  return {bit, bit};
}

// A number that adjacent flags form together, such as the kind of a slope. Flag `first` is its lowest bit.
// The flags keep their own roles, shapes and names.
struct FlagField {
  static constexpr int kLeastBits = 2;  // one bit is a flag

  std::string name;                 // for people; may be empty
  int first = 0;                    // 0..6
  int bits = kLeastBits;            // kLeastBits..8, up to flag 7
  std::vector<std::string> values;  // names of the values from 0; at most 2^bits; empty: unnamed
  std::string extra;                // JSON object of keys that this version does not know, or empty

  int last() const { return first + bits - 1; }  // the highest flag, 0..7
  int value_count() const { return 1 << bits; }  // 4..256
  // The flags of the field.
  std::uint8_t mask() const { return static_cast<std::uint8_t>((value_count() - 1) << first); }
  // The value of a tile with these flags, 0..value_count()-1.
  int value_of(std::uint8_t flags) const { return (flags & mask()) >> first; }
  // value: 0..value_count()-1
  FlagPattern pattern(int value) const { return {mask(), static_cast<std::uint8_t>(value << first)}; }
  friend bool operator==(const FlagField&, const FlagField&) = default;
};

// Why a field is invalid: flags outside 0..7, fewer than kLeastBits, or too many names; nothing if it is
// valid.
std::optional<std::string> problem_of(const FlagField& field);
// The field that a flag belongs to; null if there is none.
const FlagField* field_of_flag(std::span<const FlagField> fields, int flag);
// The index of the second of two fields that share a flag; nothing if no fields do.
std::optional<std::size_t> overlapping_field(std::span<const FlagField> fields);
// The number of flags that a field from `first` on can have beside these others: 1 if the next flag is taken.
int most_bits(std::span<const FlagField> others, int first);

}  // namespace talus
