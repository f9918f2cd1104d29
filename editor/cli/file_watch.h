// Watches a level's file until the user ends it.
#pragma once

#include <functional>
#include <string>

namespace talus {

// Calls `look` at once, and after each change of the content of the file or its companion, once they are at
// rest. Calls `is_gone` when the file goes away, is missing, or cannot be read. Returns when one of them
// returns false, or when the calling thread gets SIGINT (Ctrl+C) or SIGTERM, which it holds back during the
// calls (see EndSignals).
void watch_file(const std::string& path, const std::function<bool()>& look,
                const std::function<bool()>& is_gone);

}  // namespace talus
