// Decodes, changes, encodes, and takes over the other chunks.
#include "png_patch.h"

#include <algorithm>

#include <talus/level/limits.h>
#include "../import/linked_files.h"
#include "png_picture.h"

namespace talus {
namespace {

constexpr std::size_t kSignatureBytes = 8, kAroundChunk = 12;  // bytes
constexpr std::size_t kBitDepthAt = 24, kColorTypeAt = 25;     // in the file

// Bytes of the chunk that begins there; nothing left: 0.
std::size_t chunk_length(std::string_view bytes, std::size_t at) {
  if (bytes.size() - at < kAroundChunk) return 0;
  std::size_t length = 0;
  for (std::size_t i = at; i < at + 4; ++i) length = length << 8 | static_cast<std::uint8_t>(bytes[i]);
  return length > bytes.size() - at - kAroundChunk ? 0 : length + kAroundChunk;
}

// Whether a chunk says something about the picture that still holds in another kind of colours.
bool is_kept(std::string_view type, bool has_same_kind) {
  constexpr char kAncillary = 0x20;  // bit of the first letter
  if ((type[0] & kAncillary) == 0 || type == "tRNS") return false;
  return has_same_kind || (type != "bKGD" && type != "sBIT" && type != "hIST");
}

// The new file with the kept chunks of the old one: those before its pixels there, the others at the end.
std::string with_chunks_of(std::string_view before, const std::string& made, bool has_same_kind) {
  std::string first, last;
  bool has_pixels = false;
  for (std::size_t at = kSignatureBytes; at < before.size();) {
    const std::size_t length = chunk_length(before, at);
    if (length == 0) break;
    const std::string_view type = before.substr(at + 4, 4);
    if (type == "IDAT") has_pixels = true;
    if (is_kept(type, has_same_kind)) (has_pixels ? last : first) += before.substr(at, length);
    at += length;
  }
  const std::size_t after_header = kSignatureBytes + chunk_length(made, kSignatureBytes);
  const std::size_t end = made.size() - kAroundChunk;  // IEND is empty
  return made.substr(0, after_header) + first + made.substr(after_header, end - after_header) + last +
         made.substr(end);
}

}  // namespace

PngKind kind_of_png(std::string_view start) {
  if (!is_png(start) || start.size() < kPngKindBytes) return PngKind::other;
  if (start[kBitDepthAt] == 16) return PngKind::deep;
  if (start[kBitDepthAt] != 8) return PngKind::palette;
  return start[kColorTypeAt] == 2   ? PngKind::rgb
         : start[kColorTypeAt] == 6 ? PngKind::rgba
                                    : PngKind::palette;
}

FormatResult<std::string> patch_png(std::string_view bytes, const std::vector<PngPixel>& pixels) {
  const PngKind kind = kind_of_png(bytes);
  if (kind == PngKind::other)
    return tl::unexpected(FormatError{"", "is not a PNG picture, so it cannot be painted"});
  if (kind == PngKind::deep)
    return tl::unexpected(FormatError{"", "has 16 bits a channel, of which painting would lose half"});
  auto picture = read_rgba(bytes, kMaxLinkedPictureSide);
  if (!picture) return tl::unexpected(picture.error());
  const std::string before = picture->bytes;
  for (const PngPixel& pixel : pixels) {
    const bool is_inside =
        pixel.at.x >= 0 && pixel.at.y >= 0 && pixel.at.x < picture->width && pixel.at.y < picture->height;
    if (!is_inside) continue;
    const std::size_t at =
        4 * (static_cast<std::size_t>(pixel.at.y) * static_cast<std::size_t>(picture->width) +
             static_cast<std::size_t>(pixel.at.x));
    std::copy(pixel.rgba.begin(), pixel.rgba.end(), picture->bytes.begin() + static_cast<std::ptrdiff_t>(at));
  }
  if (picture->bytes == before) return std::string(bytes);
  constexpr char kOpaque = '\xff';
  bool is_opaque = true;
  for (std::size_t i = 3; i < picture->bytes.size(); i += 4)
    is_opaque = is_opaque && picture->bytes[i] == kOpaque;
  const bool stays_rgb = kind == PngKind::rgb && is_opaque;
  std::string made = picture->bytes;
  if (stays_rgb) {
    made.clear();
    for (std::size_t i = 0; i < picture->bytes.size(); i += 4) made += picture->bytes.substr(i, 3);
  }
  const std::string png = encode_png(picture->width, picture->height, stays_rgb ? 3 : 4,
                                     reinterpret_cast<const std::uint8_t*>(made.data()));
  if (png.empty()) return tl::unexpected(FormatError{"", "there is not enough memory for it"});
  return with_chunks_of(bytes, png, stays_rgb || kind == PngKind::rgba);
}

}  // namespace talus
