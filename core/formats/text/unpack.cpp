// Unpacking zlib's streams.
#include "unpack.h"

#include <zlib.h>

#include <array>
#include <new>

namespace talus {

tl::expected<std::string, UnpackError> unpack_zlib(std::string_view packed, std::size_t limit) {
  z_stream stream = {};
  constexpr int kEitherHeader = 32;
  // It fails only if memory runs out.
  if (inflateInit2(&stream, MAX_WBITS + kEitherHeader) != Z_OK) throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib does not write to it
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string content;
  std::array<char, 32'768> piece;
  int status = Z_OK;
  while (status == Z_OK && content.size() <= limit) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    status = inflate(&stream, Z_NO_FLUSH);
    content.append(piece.data(), piece.size() - stream.avail_out);
  }
  const std::string reason = stream.msg != nullptr ? stream.msg : "the end is missing";
  inflateEnd(&stream);
  if (content.size() > limit) return tl::unexpected(UnpackError{.is_too_large = true});
  if (status != Z_STREAM_END) return tl::unexpected(UnpackError{.reason = reason});
  return content;
}

std::string pack_zlib(std::string_view content) {
  uLongf length = compressBound(static_cast<uLong>(content.size()));
  std::string packed(length, '\0');
  // It fails only if memory runs out.
  if (compress(reinterpret_cast<Bytef*>(packed.data()), &length,
               reinterpret_cast<const Bytef*>(content.data()), static_cast<uLong>(content.size())) != Z_OK)
    throw std::bad_alloc();
  packed.resize(length);
  return packed;
}

}  // namespace talus
