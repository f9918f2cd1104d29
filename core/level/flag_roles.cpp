#include <talus/level/flag_roles.h>

namespace talus {

const std::array<FlagRoleInfo, 6>& flag_role_infos() {
  static constexpr std::array<FlagRoleInfo, 6> kInfos = {{
      {"solid", "solid", &FlagRoles::solid, TileRole::solid},
      {"up_slope", "up-slope", &FlagRoles::up_slope, TileRole::up_slope},
      {"down_slope", "down-slope", &FlagRoles::down_slope, TileRole::down_slope},
      {"ball", "ball", &FlagRoles::ball, TileRole::ball},
      {"one_way", "one-way", &FlagRoles::one_way, TileRole::none},
      {"ceiling", "ceiling", &FlagRoles::ceiling, TileRole::none},
  }};
  return kInfos;
}

TileRole role_of(FlagSet flags, const FlagRoles& roles) {
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (has_flag(flags, roles.*info.flag)) return info.role;
  }
  return TileRole::none;
}

}  // namespace talus
