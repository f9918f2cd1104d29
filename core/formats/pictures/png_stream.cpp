// Rows without filters, as those of encode_png().
#include "png_stream.h"

#include <zlib.h>

namespace talus {
namespace {

constexpr int kStreamLevel = 7;  // of zlib, as in encode_png()

void append_big_endian(std::uint32_t number, std::string& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
}

}  // namespace

struct PngStream::Packer {
  z_stream stream = {};
  bool is_good = false;
  std::string packed;  // of the chunk that is being made
};

PngStream::PngStream(int width, int height, int channels)
    : row_(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels)),
      png_("\x89PNG\r\n\x1a\n"),
      packer_(std::make_unique<Packer>()) {
  constexpr char kRgb = 2, kRgba = 6, kBits = 8;
  packer_->is_good = deflateInit(&packer_->stream, kStreamLevel) == Z_OK;
  std::string header;
  append_big_endian(static_cast<std::uint32_t>(width), header);
  append_big_endian(static_cast<std::uint32_t>(height), header);
  header += {kBits, channels == 4 ? kRgba : kRgb, 0, 0, 0};
  add_chunk("IHDR", header);
}

PngStream::~PngStream() { deflateEnd(&packer_->stream); }

void PngStream::add_chunk(const char* type, const std::string& content) {
  append_big_endian(static_cast<std::uint32_t>(content.size()), png_);
  const std::string checked = type + content;
  png_ += checked;
  append_big_endian(static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                                                     static_cast<uInt>(checked.size()))),
                    png_);
}

void PngStream::pack(const std::uint8_t* bytes, std::size_t count, bool is_last) {
  constexpr std::size_t kRoom = 65'536;  // bytes
  z_stream& stream = packer_->stream;
  stream.next_in = const_cast<Bytef*>(bytes);  // zlib only reads it
  stream.avail_in = static_cast<uInt>(count);
  do {
    const std::size_t before = packer_->packed.size();
    packer_->packed.resize(before + kRoom);
    stream.next_out = reinterpret_cast<Bytef*>(packer_->packed.data() + before);
    stream.avail_out = static_cast<uInt>(kRoom);
    packer_->is_good =
        packer_->is_good && deflate(&stream, is_last ? Z_FINISH : Z_NO_FLUSH) != Z_STREAM_ERROR;
    packer_->packed.resize(packer_->packed.size() - stream.avail_out);
  } while (packer_->is_good && stream.avail_out == 0);
}

void PngStream::add(const std::vector<std::uint8_t>& rows) {
  constexpr std::uint8_t kNoFilter = 0;
  for (std::size_t at = 0; at + row_ <= rows.size(); at += row_) {
    pack(&kNoFilter, 1, false);
    pack(&rows[at], row_, false);
  }
  if (packer_->packed.empty()) return;
  add_chunk("IDAT", packer_->packed);
  packer_->packed.clear();
}

std::string PngStream::finish() {
  pack(nullptr, 0, true);
  add_chunk("IDAT", packer_->packed);
  add_chunk("IEND", "");
  return packer_->is_good ? std::move(png_) : std::string();
}

}  // namespace talus
