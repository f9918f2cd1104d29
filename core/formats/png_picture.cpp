// PNG by stb. Its reader keeps nothing of a palette, so the chunks are looked through first, which also
// bounds what is unpacked.
#include "png_picture.h"

#include <zlib.h>

#include <cstdlib>
#include <memory>
#include <optional>

#include "atomic_file.h"

namespace {
// In stb's place, whose own compression gives files twice as large. Its caller frees the result.
unsigned char* compress_for_png(unsigned char* data, int size, int* compressed_size, int) {
  uLongf length = compressBound(static_cast<uLong>(size));
  auto* compressed = static_cast<unsigned char*>(std::malloc(length));
  if (compressed != nullptr &&
      compress2(compressed, &length, data, static_cast<uLong>(size), Z_BEST_COMPRESSION) != Z_OK) {
    std::free(compressed);
    return nullptr;
  }
  *compressed_size = static_cast<int>(length);
  return compressed;
}
}  // namespace

#define STBIW_ZLIB_COMPRESS compress_for_png
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#include <stb_image.h>

namespace talus {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
// Stored without compression, the largest picture of 16 bits a channel takes 132,000 bytes.
constexpr std::size_t kMaxPacked = 200'000;
constexpr int kHalfOpaque = 128;

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

std::string size_text(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

struct Header {
  std::uint32_t width = 0, height = 0;
  std::vector<Rgb> palette;
};

std::vector<Rgb> palette_of(std::string_view chunk) {
  std::vector<Rgb> palette;
  for (std::size_t i = 0; i + 3 <= chunk.size(); i += 3)
    palette.push_back({static_cast<std::uint8_t>(chunk[i]), static_cast<std::uint8_t>(chunk[i + 1]),
                       static_cast<std::uint8_t>(chunk[i + 2])});
  return palette;
}

tl::unexpected<FormatError> error_at(std::size_t byte, std::string message) {
  return tl::unexpected(FormatError{"byte " + std::to_string(byte), std::move(message)});
}

FormatResult<Header> read_header(std::string_view bytes) {
  constexpr std::size_t kAround = 12, kHeaderSize = 13;  // bytes: of a chunk besides its content; of IHDR
  Header header;
  std::size_t packed = 0;
  for (std::size_t at = kSignature.size(); at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    const std::size_t length = left < kAround ? left : u32_at(bytes, at);
    if (left < kAround || length > left - kAround)
      return error_at(at, "the picture ends in the middle of a chunk");
    const std::string_view type = bytes.substr(at + 4, 4), content = bytes.substr(at + 8, length);
    const bool first = at == kSignature.size();
    if (first != (type == "IHDR") || (first && length != kHeaderSize))
      return error_at(at, "must be the picture's one header, and is not");
    if (first) {
      header.width = u32_at(content, 0);
      header.height = u32_at(content, 4);
    }
    // Only in pictures of palette colours it is what their pixels are made of.
    constexpr std::size_t kColorType = 9;
    constexpr char kIndexed = 3;
    const char color_type = bytes[kSignature.size() + 8 + kColorType];
    if (type == "PLTE" && color_type == kIndexed) header.palette = palette_of(content);
    if (type == "IDAT") packed += length;
    if (type == "IEND") break;
    at += kAround + length;
  }
  if (header.width == 0 || header.height == 0) return tl::unexpected(FormatError{"", "is an empty picture"});
  if (header.width > kMaxPngSide || header.height > kMaxPngSide) {
    return tl::unexpected(
        FormatError{"", "is " + size_text(header.width, header.height) + " px, and a sheet is 128x128 px"});
  }
  if (packed > kMaxPacked)
    return tl::unexpected(FormatError{"", "has more data than a picture of its size can have"});
  return header;
}

void append_bytes(void* text, void* data, int size) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with(kSignature); }

FormatResult<PngPicture> read_png(std::string_view bytes) {
  if (!is_png(bytes)) return tl::unexpected(FormatError{"", "is no PNG picture"});
  auto header = read_header(bytes);
  if (!header) return tl::unexpected(header.error());
  constexpr int kChannels = 4;
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> rgba(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &width, &height, &channels, kChannels),
      stbi_image_free);
  if (!rgba)
    return tl::unexpected(FormatError{"", std::string("is a damaged PNG picture: ") + stbi_failure_reason()});
  PngPicture picture{width, height, {}, {}, std::move(header->palette)};
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < count; ++i) {
    const stbi_uc* c = rgba.get() + kChannels * i;
    const bool transparent = c[3] < kHalfOpaque;
    picture.transparent.push_back(transparent);
    picture.pixels.push_back(transparent ? Rgb{} : Rgb{c[0], c[1], c[2]});
  }
  return picture;
}

FormatResult<PngPicture> load_png(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return read_png(*bytes);
}

std::string encode_png(int width, int height, int channels, const std::uint8_t* bytes) {
  std::string png;
  stbi_write_force_png_filter = 0;  // flat colours pack best as they are
  if (!stbi_write_png_to_func(append_bytes, &png, width, height, channels, bytes, width * channels))
    return {};
  return png;
}

}  // namespace talus
