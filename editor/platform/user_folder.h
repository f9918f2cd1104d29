// The folders in which the program keeps what is the user's own.
#pragma once

#include <string>

namespace talus {

// $TALUS_CONFIG_DIR, else $XDG_CONFIG_HOME/talus, else ~/.config/talus.
std::string config_folder();
// $TALUS_STATE_DIR, else $XDG_STATE_HOME/talus, else ~/.local/state/talus.
std::string state_folder();

}  // namespace talus
