// The flags of a tile or a sprite: marks, each with a meaning of its own, such as "solid".
#pragma once

#include <cstdint>

namespace talus {

using FlagSet = std::uint32_t;                 // bit n is flag n
inline constexpr int kMaxFlags = 32;           // of a tile, numbered from 0
inline constexpr int kCartFlags = 8;           // of a tile of a cart, the first ones
inline constexpr FlagSet kCartFlagSet = 0xff;  // all flags of a cart

// The set of one flag. flag: 0..kMaxFlags - 1 (not checked).
constexpr FlagSet flag_bit(int flag) { return FlagSet{1} << flag; }

}  // namespace talus
