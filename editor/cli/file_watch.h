// Watching a level's file until the user ends it.
#pragma once

#include <functional>
#include <string>

namespace talus {

// Calls `look` at once and after each change of what the file or its companion holds, when it has come to
// rest; `is_gone` when the file goes away, or is not there. Returns when the calling thread gets SIGINT
// (Ctrl+C) or SIGTERM, which it holds back while it calls.
void watch_file(const std::string& path, const std::function<void()>& look,
                const std::function<void()>& is_gone);

}  // namespace talus
