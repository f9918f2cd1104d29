// The preferences as JSON, a part of the settings.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "panels/preferences.h"

namespace talus {

nlohmann::json to_json(const Preferences& preferences);
// A value that is missing or out of range gets its default; keys that nobody knows are no keys.
Preferences preferences_of_json(const nlohmann::json& value);

}  // namespace talus
