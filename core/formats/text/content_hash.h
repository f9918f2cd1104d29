// A short mark of a file's content.
#pragma once

#include <cstdint>
#include <string_view>

namespace talus {

// Of the bytes of a file, equal on every machine: FNV-1a.
std::uint64_t content_hash(std::string_view bytes);

}  // namespace talus
