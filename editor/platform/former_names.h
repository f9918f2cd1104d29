// The names that older settings have for what has another name today.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

namespace talus {

struct FormerName {
  std::string_view former;
  std::string_view today;  // the key of a setting, or the id of a panel or a command
};
std::span<const FormerName> former_names();

// settings: the object of a settings file. Gives keys of settings, tabs and keys of commands today's names.
// What has today's name stays, and takes the place of the same thing with its former name.
void rename_former(nlohmann::json& settings);

}  // namespace talus
