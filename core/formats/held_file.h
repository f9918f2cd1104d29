// Locks on files, that tell other processes whether who made a file still runs: the system gives them back
// however a process ends.
#pragma once

#include <string>

namespace talus {

// Takes the lock of an open file that has this name, until the descriptor is closed. False with errno: with
// EWOULDBLOCK another one holds it, with ENOENT the file has lost its name, as one that nobody held; with
// others there are no locks here.
bool try_lock(int descriptor, const std::string& name);

// Removes a file whose lock nobody holds; false: it is held, or cannot be removed.
bool remove_if_unlocked(const std::string& name);

}  // namespace talus
