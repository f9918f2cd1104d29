// Unpacking zlib's streams, as carts, pictures and maps hold them, to a size that the caller bounds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace talus {

// Why a stream cannot be unpacked.
struct UnpackError {
  bool is_too_large = false;  // it unpacks to more than the limit
  std::string reason = {};    // of a damaged stream: a few words, such as "incorrect data check"
};

// The content of one zlib or gzip stream; what follows its end is ignored. limit: bytes that it may unpack to.
tl::expected<std::string, UnpackError> unpack_zlib(std::string_view packed, std::size_t limit);

}  // namespace talus
