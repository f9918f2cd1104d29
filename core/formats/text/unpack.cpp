// Unpacking by zlib and zstd, piece by piece.
#include "unpack.h"

#include <zlib.h>
#include <zstd.h>

#include <array>
#include <memory>
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

tl::expected<std::string, UnpackError> unpack_zstd(std::string_view packed, std::size_t limit) {
  constexpr int kMaxWindowLog = 27;  // 128 MiB, as much as zstd's own program takes
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, kMaxWindowLog);
  ZSTD_inBuffer in = {packed.data(), packed.size(), 0};
  std::string content;
  std::array<char, 32'768> piece;
  std::size_t status = 1;  // 0 at the end of a frame
  bool is_stuck = false;
  while (!is_stuck && (status != 0 || in.pos < in.size)) {
    ZSTD_outBuffer out = {piece.data(), piece.size(), 0};
    const std::size_t before = in.pos;
    status = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(status) != 0) return tl::unexpected(UnpackError{.reason = ZSTD_getErrorName(status)});
    content.append(piece.data(), out.pos);
    if (content.size() > limit) return tl::unexpected(UnpackError{.is_too_large = true});
    is_stuck = out.pos == 0 && in.pos == before;
  }
  if (status != 0) return tl::unexpected(UnpackError{.reason = "the end is missing"});
  return content;
}

namespace {

std::string deflated(std::string_view content, int window_bits) {
  constexpr int kUsualMemory = 8;
  z_stream stream = {};
  // It fails only if memory runs out.
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, window_bits, kUsualMemory,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string packed(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));  // zlib does not write to it
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace

std::string pack_zlib(std::string_view content) { return deflated(content, MAX_WBITS); }

std::string pack_gzip(std::string_view content) {
  constexpr int kGzipHeader = 16;
  return deflated(content, MAX_WBITS + kGzipHeader);
}

std::string pack_zstd(std::string_view content) {
  std::string packed(ZSTD_compressBound(content.size()), '\0');
  const std::size_t length =
      ZSTD_compress(packed.data(), packed.size(), content.data(), content.size(), ZSTD_CLEVEL_DEFAULT);
  if (ZSTD_isError(length) != 0) throw std::bad_alloc();
  packed.resize(length);
  return packed;
}

}  // namespace talus
