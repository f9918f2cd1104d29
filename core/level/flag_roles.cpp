#include "flag_roles.h"

namespace talus {

const std::array<FlagRoleInfo, 4>& flag_role_infos() {
  static constexpr std::array<FlagRoleInfo, 4> kInfos = {{
      {"solid", "solid", &FlagRoles::solid, TileRole::solid},
      {"up_slope", "up-slope", &FlagRoles::up_slope, TileRole::up_slope},
      {"down_slope", "down-slope", &FlagRoles::down_slope, TileRole::down_slope},
      {"ball", "ball", &FlagRoles::ball, TileRole::ball},
  }};
  return kInfos;
}

TileRole role_of(std::uint8_t flags, const FlagRoles& roles) {
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = roles.*info.flag;
    if (flag != FlagRoles::kUnused && ((flags >> flag) & 1) != 0) return info.role;
  }
  return TileRole::none;
}

}  // namespace talus
