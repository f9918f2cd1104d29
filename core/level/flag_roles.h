// Which flag means what to the physics.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tileset.h"

namespace talus {

// What a tile is to the physics. When a tile has several of these flags the first of solid, up_slope,
// down_slope, ball wins (the order of the article's is_obj).
enum class TileRole : std::uint8_t { none, solid, up_slope, down_slope, ball };

// The flag, 0..7, that stands for a role; kUnused where no flag does. The defaults are the article's.
struct FlagRoles {
  static constexpr int kUnused = -1;
  int solid = 0;
  int ball = 1;
  int up_slope = 2;    // low on the left, high on the right
  int down_slope = 3;  // high on the left, low on the right
  friend bool operator==(const FlagRoles&, const FlagRoles&) = default;
};

// The role that a tile with these flags has.
TileRole role_of(std::uint8_t flags, const FlagRoles& roles);

// One row for everything that lists the roles: the files, the flags panel, the documentation.
struct FlagRoleInfo {
  std::string_view key;    // in files: "up_slope"
  std::string_view label;  // on screen: "up-slope"
  int FlagRoles::*flag;
  TileRole role;
};
const std::array<FlagRoleInfo, 4>& flag_role_infos();

}  // namespace talus
