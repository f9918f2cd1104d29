// Names of flags.
#include "flag_label.h"

namespace talus {

const FlagRoleInfo* role_of_flag(const FlagRoles& roles, int flag) {
  for (const FlagRoleInfo& info : flag_role_infos())
    if (roles.*info.flag == flag) return &info;
  return nullptr;
}

std::string flag_name(const Level& level, int flag) {
  const std::string& own = level.flag_names[static_cast<std::size_t>(flag)];
  if (!own.empty()) return own;
  const FlagRoleInfo* role = role_of_flag(level.roles, flag);
  return role ? std::string(role->label) : "";
}

std::string flag_label(const Level& level, int flag) {
  const std::string name = flag_name(level, flag);
  return "flag " + std::to_string(flag) + (name.empty() ? "" : "  " + name);
}

}  // namespace talus
