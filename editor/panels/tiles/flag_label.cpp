// Names flags, fields and their values as panels show them.
#include "flag_label.h"

#include <bit>

#include "panels/ui/shown_text.h"
#include "shape_editor.h"

namespace talus {

const FlagRoleInfo* role_of_flag(const FlagRoles& roles, int flag) {
  for (const FlagRoleInfo& info : flag_role_infos())
    if (roles.*info.flag == flag) return &info;
  return nullptr;
}

std::string flag_name(const Level& level, int flag) {
  const std::string& own = level.flag_names[static_cast<std::size_t>(flag)];
  if (!own.empty()) return shown_line(own, kMaxLabel);
  const FlagRoleInfo* role = role_of_flag(level.roles, flag);
  if (role) return std::string(role->label);
  const TileShape& shape = level.flag_shapes[static_cast<std::size_t>(flag)];
  return shape.kind == TileShape::Kind::none ? "" : std::string(kind_label(shape));
}

int shown_flags(const Level& level) {
  const int last = kMaxFlags - 1 - std::countl_zero(used_flags(level) | 1);
  return (last / kCartFlags + 1) * kCartFlags;
}

std::string flag_label(const Level& level, int flag) {
  const std::string name = flag_name(level, flag);
  return "flag " + std::to_string(flag) + (name.empty() ? "" : "  " + name);
}

std::string field_name(const FlagField& field) {
  if (!field.name.empty()) return shown_line(field.name, kMaxLabel);
  return "flags " + std::to_string(field.first) + "-" + std::to_string(field.last());
}

std::string value_name(const FlagField& field, int value) {
  const auto index = static_cast<std::size_t>(value);
  const bool named = index < field.values.size() && !field.values[index].empty();
  return named ? shown_line(field.values[index], kMaxLabel) : std::to_string(value);
}

std::vector<FlagPattern> flag_patterns(const Level& level) {
  std::vector<FlagPattern> patterns;
  const int shown = shown_flags(level);
  for (int flag = 0; flag < shown; ++flag) {
    const FlagField* field = field_of_flag(level.flag_fields, flag);
    if (field == nullptr) patterns.push_back(pattern_of_flag(flag));
    if (field == nullptr || field->first != flag) continue;
    for (int value = 0; value < field->value_count(); ++value) patterns.push_back(field->pattern(value));
  }
  return patterns;
}

std::string pattern_label(const Level& level, FlagPattern pattern) {
  const int lowest = pattern.lowest_flag();
  if (pattern == pattern_of_flag(lowest)) return flag_label(level, lowest);
  const FlagField* field = field_of_flag(level.flag_fields, lowest);
  if (field == nullptr || field->mask() != pattern.mask)  // its field is gone
    return "flags from " + std::to_string(lowest);
  return field_name(*field) + ": " + value_name(*field, field->value_of(pattern.bits));
}

}  // namespace talus
