// Flags read together: patterns of flags to look for and to paint, and fields, numbers over several flags.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/level/flag_set.h>

namespace talus {

// Some of a tile's flags, and the values that they must have: one flag set, or the value of a field.
struct FlagPattern {
  FlagSet mask = 1;  // the flags that count, at least one
  FlagSet bits = 1;  // those of them that must be set; lies within the mask

  // Whether a tile with these flags matches.
  bool matches(FlagSet flags) const { return (flags & mask) == bits; }
  // Flags that match, and are the same otherwise.
  FlagSet put_in(FlagSet flags) const { return (flags & ~mask) | bits; }
  int lowest_flag() const;  // 0..31, of the mask
  friend bool operator==(const FlagPattern&, const FlagPattern&) = default;
};

// flag: 0..31
inline FlagPattern pattern_of_flag(int flag) { return {flag_bit(flag), flag_bit(flag)}; }

// A number that adjacent flags form together, such as the kind of a slope. Flag `first` is its lowest bit.
// The flags keep their own roles, shapes and names.
struct FlagField {
  static constexpr int kLeastBits = 2;  // one bit is a flag
  static constexpr int kMaxBits = 8;    // more values could not be chosen from a list

  std::string name;                 // for people; may be empty
  int first = 0;                    // 0..30
  int bits = kLeastBits;            // kLeastBits..kMaxBits, up to flag 31
  std::vector<std::string> values;  // names of the values from 0; at most 2^bits; empty: unnamed
  std::string extra;                // JSON object of keys that this version does not know, or empty

  int last() const { return first + bits - 1; }  // the highest flag, 1..31
  int value_count() const { return 1 << bits; }  // 4..256
  // The flags of the field.
  FlagSet mask() const { return (flag_bit(bits) - 1) << first; }
  // The value of a tile with these flags, 0..value_count()-1.
  int value_of(FlagSet flags) const { return static_cast<int>((flags & mask()) >> first); }
  // value: 0..value_count()-1
  FlagPattern pattern(int value) const { return {mask(), static_cast<FlagSet>(value) << first}; }
  friend bool operator==(const FlagField&, const FlagField&) = default;
};

// Why a field is invalid: flags outside 0..31, fewer than kLeastBits or more than
// kMaxBits of them, or too many names; nothing if it is
// valid.
std::optional<std::string> problem_of(const FlagField& field);
// The field that a flag belongs to; null if there is none.
const FlagField* field_of_flag(std::span<const FlagField> fields, int flag);
// The index of the second of two fields that share a flag; nothing if no fields do.
std::optional<std::size_t> overlapping_field(std::span<const FlagField> fields);
// The number of flags that a field from `first` on can have beside these others, at most kMaxBits: 1 if the
// next flag is taken.
int most_bits(std::span<const FlagField> others, int first);

}  // namespace talus
