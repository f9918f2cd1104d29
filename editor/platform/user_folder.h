// The folders for what belongs to the user.
#pragma once

#include <string>

namespace talus {

// A variable that is not set is skipped, and so is $XDG_... or $HOME if it is not an absolute path; ~ comes
// from the system's list of users then. $TALUS_... may be any path.

// $TALUS_CONFIG_DIR, else $XDG_CONFIG_HOME/talus, else ~/.config/talus.
std::string config_folder();
// $TALUS_STATE_DIR, else $XDG_STATE_HOME/talus, else ~/.local/state/talus.
std::string state_folder();

}  // namespace talus
