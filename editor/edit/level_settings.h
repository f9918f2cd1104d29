// Edits what a level has once: colours, names and roles of flags, tuning, and bodies placed by hand. Each
// function makes an Edit and changes nothing itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "level/edit.h"

namespace talus {

Edit set_color(const Level& level, int color, Rgb rgb);  // color: 0..15 (asserted)
Edit set_background(const Level& level, std::optional<Rgba> background);
Edit rename_flag(const Level& level, int flag, std::string name);  // flag: 0..31 (asserted)
Edit set_roles(const Level& level, const FlagRoles& roles);
Edit set_tuning(const Level& level, const Tuning& tuning);
Edit set_spawns(const Level& level, std::vector<Spawn> spawns, std::string label);

}  // namespace talus
