// Unpacks streams of zlib and zstd in carts, pictures and maps, up to a size that the caller sets, and packs
// those of maps.
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

// Returns the content of one zlib or gzip stream; bytes after its end are ignored. A stream that unpacks to
// more than `limit` bytes, or is damaged or cut off, is an error.
tl::expected<std::string, UnpackError> unpack_zlib(std::string_view packed, std::size_t limit);

// Returns the content of one or more frames of zstd. The sizes that frames claim do not count. A frame that
// needs a window of more than 128 MiB is an error; so are the same streams as above, and bytes that are no
// frame after the last one.
tl::expected<std::string, UnpackError> unpack_zstd(std::string_view packed, std::size_t limit);

// Return a stream or a frame of the content.
std::string pack_zlib(std::string_view content);
std::string pack_gzip(std::string_view content);
std::string pack_zstd(std::string_view content);

}  // namespace talus
