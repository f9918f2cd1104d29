// PNG by stb. stb's reader drops the palette and unpacks anything, so the chunks are checked first.
#include "png_picture.h"

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>

#include "../files/atomic_file.h"
#include "../last_catch.h"
#include "../text/unpack.h"

namespace {
// Level of zlib. The best one takes nine times as long for the picture of a map, and saves only 2 %.
constexpr int kPngLevel = 7;

// Replaces stb's compression, whose files are twice as large. The caller frees the result.
unsigned char* compress_for_png(unsigned char* data, int size, int* compressed_size, int) {
  uLongf length = compressBound(static_cast<uLong>(size));
  auto* compressed = static_cast<unsigned char*>(std::malloc(length));
  if (compressed != nullptr &&
      compress2(compressed, &length, data, static_cast<uLong>(size), kPngLevel) != Z_OK) {
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

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

std::string size_text(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

// What a file contains besides its pixels.
struct Header {
  std::uint32_t width = 0, height = 0;
  std::vector<Rgb> palette;
  std::string needed;  // the file again, with only the chunks that make its pixels
  std::string packed;  // the zlib stream of its rows, from all chunks
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

// bytes: those of a chunk besides its content; those of IHDR.
constexpr std::size_t kAround = 12, kHeaderSize = 13;

struct Chunk {
  std::string_view whole, type, content;
};

FormatResult<Chunk> chunk_at(std::string_view bytes, std::size_t at) {
  const std::size_t left = bytes.size() - at;
  const std::size_t length = left < kAround ? left : u32_at(bytes, at);
  if (left < kAround || length > left - kAround)
    return error_at(at, "the picture ends in the middle of a chunk");
  return Chunk{bytes.substr(at, length + kAround), bytes.substr(at + 4, 4), bytes.substr(at + 8, length)};
}

constexpr std::size_t kMaxColors = 256;

// For pixels that are indices. stb reads beyond a short palette, so it gets a full one.
void add_palette(std::string_view content, Header& header) {
  constexpr std::size_t kFull = 3 * kMaxColors;
  header.palette = palette_of(content);
  std::string colors(content.substr(0, kFull));
  colors.resize(kFull);
  constexpr std::string_view kLength("\0\0\3\0", 4), kChecksum("\0\0\0\0", 4);  // stb does not check it
  header.needed.append(kLength).append("PLTE").append(colors).append(kChecksum);
}

FormatResult<Header> read_header(std::string_view bytes) {
  constexpr std::size_t kColorType = 9;  // in IHDR
  constexpr char kIndexed = 3;
  Header header;
  header.needed = kSignature;
  bool indexed = false, has_palette = false, has_opacities = false;
  for (std::size_t at = kSignature.size(); at < bytes.size();) {
    const auto chunk = chunk_at(bytes, at);
    if (!chunk) return tl::unexpected(chunk.error());
    const bool first = at == kSignature.size();
    if (first != (chunk->type == "IHDR") || (first && chunk->content.size() != kHeaderSize))
      return error_at(at, "the header of the picture is missing, repeated or damaged");
    if (first) {
      header.width = u32_at(chunk->content, 0);
      header.height = u32_at(chunk->content, 4);
      indexed = chunk->content[kColorType] == kIndexed;
    }
    if (chunk->type == "IDAT") header.packed += chunk->content;
    if (chunk->type == "PLTE" && std::exchange(has_palette, true))
      return error_at(at, "the picture has a second palette");
    if (chunk->type == "tRNS" && std::exchange(has_opacities, true))
      return error_at(at, "the picture has a second list of opacities");
    if (chunk->type == "tRNS" && chunk->content.size() > kMaxColors)
      return error_at(at, "the picture has more than 256 opacities");
    // Stb copies it, without memory for it.
    const bool empty_data = chunk->type == "IDAT" && chunk->content.empty();
    if (chunk->type == "PLTE" && indexed)
      add_palette(chunk->content, header);
    else if (first || (chunk->type == "IDAT" && !empty_data) || chunk->type == "tRNS" ||
             chunk->type == "IEND")
      header.needed += chunk->whole;
    if (chunk->type == "IEND") break;
    at += chunk->whole.size();
  }
  if (header.width == 0 || header.height == 0) return tl::unexpected(FormatError{"", "is an empty picture"});
  return header;
}

// The header of a picture, which is not refused for its size.
FormatResult<Header> read_small_header(std::string_view bytes, int most_side) {
  if (!is_png(bytes)) return tl::unexpected(FormatError{"", "is not a PNG picture"});
  auto header = read_header(bytes);
  if (!header) return header;
  const auto most = static_cast<std::uint32_t>(most_side);
  const std::string is_large =
      "is " + size_text(header->width, header->height) + " px, but may have at most ";
  if (header->width > most || header->height > most)
    return tl::unexpected(FormatError{"", is_large + size_text(most, most) + " px"});
  if (std::size_t{header->width} * header->height > kMaxSheetPicturePixels)
    return tl::unexpected(FormatError{"", is_large + std::to_string(kMaxSheetPicturePixels) + " px in all"});
  return header;
}

tl::unexpected<FormatError> damaged_png(const std::string& reason) {
  return tl::unexpected(FormatError{"", "is a damaged PNG picture: " + reason});
}

FormatResult<RgbaPicture> decode(const Header& header) {
  // At most eight bytes for each pixel, and one before each row. Interlaced rows come in up to twice as many
  // parts.
  const std::size_t largest = (std::size_t{8} * header.width + 2) * header.height + 64;
  const auto rows = unpack_zlib(header.packed, largest);
  if (header.packed.size() > 2 * largest || (!rows && rows.error().is_too_large))
    return tl::unexpected(FormatError{"", "has more data than a picture of its size can have"});
  if (!rows && !header.packed.empty())
    return damaged_png("its pixels cannot be unpacked, " + rows.error().reason);
  // The rest is small, and each packed byte has at most a chunk of its own around it: far from 2 GiB.
  constexpr int kChannels = 4;
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> rgba(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(header.needed.data()),
                            static_cast<int>(header.needed.size()), &width, &height, &channels, kChannels),
      stbi_image_free);
  if (!rgba) return damaged_png(stbi_failure_reason());
  const std::size_t count = std::size_t{kChannels} * header.width * header.height;
  return RgbaPicture{width, height, {reinterpret_cast<const char*>(rgba.get()), count}};
}

// In pictures without a palette any colour is possible.
bool has_color(const PngPicture& picture, Rgb color) {
  const auto& palette = picture.palette;
  return palette.empty() || std::find(palette.begin(), palette.end(), color) != palette.end();
}

void append_bytes(void* text, void* data, int size) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

std::shared_ptr<const SheetPicture> shared_picture(const RgbaPicture& picture) {
  return std::make_shared<const SheetPicture>(
      SheetPicture{picture.width, picture.height, {picture.bytes.begin(), picture.bytes.end()}});
}

bool is_png(std::string_view bytes) { return bytes.starts_with(kSignature); }

FormatResult<std::string_view> find_png_chunk(std::string_view bytes, std::string_view type) {
  if (!is_png(bytes)) return tl::unexpected(FormatError{"", "is not a PNG picture"});
  for (std::size_t at = kSignature.size(); at < bytes.size();) {
    const auto chunk = chunk_at(bytes, at);
    if (!chunk) return tl::unexpected(chunk.error());
    if (chunk->type == type) return chunk->content;
    if (chunk->type == "IEND") break;
    at += chunk->whole.size();
  }
  return std::string_view();
}

FormatResult<RgbaPicture> read_rgba(std::string_view bytes, int most_side) {
  const auto header = read_small_header(bytes, most_side);
  if (!header) return tl::unexpected(header.error());
  return decode(*header);
}

FormatResult<PngPicture> read_png(std::string_view bytes) {
  auto header = read_small_header(bytes, kMaxPngSide);
  if (!header) return tl::unexpected(header.error());
  const auto rgba = decode(*header);
  if (!rgba) return tl::unexpected(rgba.error());
  PngPicture picture{rgba->width, rgba->height, {}, {}, std::move(header->palette)};
  for (std::size_t i = 0; i < rgba->bytes.size(); i += 4) {
    const auto* c = reinterpret_cast<const std::uint8_t*>(rgba->bytes.data()) + i;
    const bool transparent = c[3] < kHalfOpaque;
    picture.transparent.push_back(transparent);
    picture.pixels.push_back(transparent ? Rgb{} : Rgb{c[0], c[1], c[2]});
    if (!transparent && !has_color(picture, picture.pixels.back()))
      return tl::unexpected(FormatError{"", "has a pixel whose colour is not in its palette"});
  }
  return picture;
}

FormatResult<PngPicture> load_png(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return read_guarded([&] { return read_png(*bytes); });
}

std::string encode_png(int width, int height, int channels, const std::uint8_t* bytes) {
  std::string png;
  stbi_write_force_png_filter = 0;  // flat colours pack best without filters
  if (!stbi_write_png_to_func(append_bytes, &png, width, height, channels, bytes, width * channels))
    return {};
  return png;
}

}  // namespace talus
