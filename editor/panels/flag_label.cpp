// Names of flags.
#include "flag_label.h"

#include "shape_editor.h"

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
  if (role) return std::string(role->label);
  const TileShape& shape = level.flag_shapes[static_cast<std::size_t>(flag)];
  return shape.kind == TileShape::Kind::none ? "" : std::string(kind_label(shape));
}

std::string flag_label(const Level& level, int flag) {
  const std::string name = flag_name(level, flag);
  return "flag " + std::to_string(flag) + (name.empty() ? "" : "  " + name);
}

}  // namespace talus
