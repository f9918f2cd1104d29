// Which flag means what to the physics.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <talus/level/flag_set.h>

namespace talus {

// What a tile is to the physics. If a tile has several of these flags, the first of solid, up_slope,
// down_slope, ball wins (the order of the article's is_obj).
enum class TileRole : std::uint8_t { none, solid, up_slope, down_slope, ball };

// For each role, and for each change of the shape that the other flags give, the flag, 0..31, that stands for
// it; kUnused if no flag does. The defaults are the article's.
struct FlagRoles {
  static constexpr int kUnused = -1;  // no flag
  int solid = 0;                      // a full tile of ground
  int ball = 1;                       // a body that starts there
  int up_slope = 2;                   // low on the left, high on the right
  int down_slope = 3;                 // high on the left, low on the right
  int one_way = kUnused;              // makes the shape one-way
  int ceiling = kUnused;              // puts the shape upside down
  friend bool operator==(const FlagRoles&, const FlagRoles&) = default;
};

// The role of a tile with these flags.
TileRole role_of(FlagSet flags, const FlagRoles& roles);

// One row for each role, for everything that lists the roles: files, flags panel, documentation.
struct FlagRoleInfo {
  std::string_view key;    // in files: "up_slope"
  std::string_view label;  // on screen: "up-slope"
  int FlagRoles::*flag;    // where FlagRoles keeps the flag
  TileRole role;           // what the flag makes of a tile; none: it only changes the shape
};
const std::array<FlagRoleInfo, 6>& flag_role_infos();  // all of them

// Whether a tile with these flags has the flag, 0..31 or kUnused.
inline bool has_flag(FlagSet flags, int flag) {
  return flag != FlagRoles::kUnused && (flags >> flag & 1) != 0;
}

}  // namespace talus
