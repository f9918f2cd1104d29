// The preferences, a part of the settings, as a table.
#pragma once

#include "panels/preferences.h"
#include "settings_fields.h"

namespace talus {

Fields<Preferences> preferences_fields();

}  // namespace talus
