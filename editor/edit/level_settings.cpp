// Single changes of a level.
#include "level_settings.h"

#include <cassert>
#include <utility>

#include "level/single_change.h"

namespace talus {

Edit set_color(const Level& level, int color, Rgb rgb) {
  assert(color >= 0 && color < kColorCount);
  return single_change("Change colour " + std::to_string(color),
                       ColorChange{color, level.palette[color], rgb});
}

Edit set_background(const Level& level, std::optional<Rgba> background) {
  return single_change("Change the background", BackgroundChange{level.background, background});
}

Edit rename_flag(const Level& level, int flag, std::string name) {
  assert(flag >= 0 && flag < kMaxFlags);
  return single_change("Rename flag " + std::to_string(flag),
                       FlagNameChange{flag, level.flag_names[flag], std::move(name)});
}

Edit set_roles(const Level& level, const FlagRoles& roles) {
  return single_change("Change flag roles", RolesChange{level.roles, roles});
}

Edit set_tuning(const Level& level, const Tuning& tuning) {
  return single_change("Change tuning", TuningChange{level.tuning, tuning});
}

Edit set_spawns(const Level& level, std::vector<Spawn> spawns, std::string label) {
  return single_change(std::move(label), SpawnsChange{level.spawns, std::move(spawns)});
}

}  // namespace talus
