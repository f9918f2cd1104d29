// Files of the state folder that hold lines, the newest at the end, and forget the oldest.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace talus {

// The lines of a file; none if it cannot be read, is not there, or has more than `most` bytes. store: its
// path; empty: there is no file.
std::vector<std::string> read_state_lines(const std::string& store, std::size_t most);

// Lets `change` change the lines, and writes them; the first ones go until the others have at most `most`
// bytes. No other Talus writes meanwhile. The error says why that failed, without a full stop. Does nothing
// without a store.
tl::expected<void, std::string> change_state_lines(
    const std::string& store, std::size_t most, const std::function<void(std::vector<std::string>&)>& change);

}  // namespace talus
