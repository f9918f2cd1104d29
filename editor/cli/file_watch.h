// Watching a level's file until the user ends it.
#pragma once

#include <functional>
#include <string>

namespace talus {

// Calls `look` at once and after each change of what the file or its companion holds, when it has come to
// rest; `is_gone` when the file goes away, is not there, or cannot be read. Returns when one of them is
// false, or when the calling thread gets SIGINT (Ctrl+C) or SIGTERM, which it holds back while it calls (see
// EndSignals).
void watch_file(const std::string& path, const std::function<bool()>& look,
                const std::function<bool()>& is_gone);

}  // namespace talus
