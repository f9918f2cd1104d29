// The words of messages about a level.
#include "level_text.h"

namespace talus {

std::string cell_text(Cell cell) {
  return std::string("(")
      .append(std::to_string(cell.x))
      .append(", ")
      .append(std::to_string(cell.y))
      .append(")");
}

std::string px_text(double px) {
  std::string text = std::to_string(px);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string count_text(std::size_t count, std::string_view noun) {
  return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

std::string role_label(TileRole role) {
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (info.role == role) return std::string(info.label);
  }
  return "";
}

std::string role_with_article(TileRole role) {
  return (role == TileRole::up_slope ? "an " : "a ") + role_label(role);
}

std::string spawn_name(const Level& level, int index) {
  const std::string& name = level.spawns[static_cast<std::size_t>(index)].name;
  return name.empty() ? kind_and_number(level, index) : "body \"" + name + "\"";
}

std::string kind_and_number(const Level& level, int index) {
  const BodyKind kind = level.spawns[static_cast<std::size_t>(index)].kind;
  return std::string(traits_of(kind).word) + " " + std::to_string(index + 1);
}

}  // namespace talus
