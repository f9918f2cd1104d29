// The folders in which the program keeps what is the user's own.
#pragma once

#include <string>

namespace talus {

// Where a variable is not set, or $XDG_... or $HOME is no whole path, it counts for nothing; ~ is that of the
// system's list of users then. $TALUS_... may be any path.

// $TALUS_CONFIG_DIR, else $XDG_CONFIG_HOME/talus, else ~/.config/talus.
std::string config_folder();
// $TALUS_STATE_DIR, else $XDG_STATE_HOME/talus, else ~/.local/state/talus.
std::string state_folder();

}  // namespace talus
