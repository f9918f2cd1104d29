// A short fingerprint of a file's content.
#pragma once

#include <cstdint>
#include <string_view>

namespace talus {

// FNV-1a of the bytes; the same on every machine.
std::uint64_t content_hash(std::string_view bytes);

}  // namespace talus
