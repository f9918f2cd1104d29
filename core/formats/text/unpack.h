// Unpacking zlib's streams, as carts, pictures and maps hold them, to a size that the caller bounds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace talus {

enum class UnpackError { too_large, damaged };

// The content of one zlib or gzip stream; what follows its end is ignored. An error when it unpacks to more
// than `limit` bytes, or is damaged or cut off.
tl::expected<std::string, UnpackError> unpack_zlib(std::string_view packed, std::size_t limit);

}  // namespace talus
