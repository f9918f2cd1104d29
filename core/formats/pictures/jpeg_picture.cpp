// By TurboJPEG, which reads within the bytes, but repeats the parts of a JPEG as often as it says.
#include "jpeg_picture.h"

#include <turbojpeg.h>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>

#include <talus/level/limits.h>

#include "picture_size.h"

namespace talus {
namespace {

struct DestroyDecoder {
  void operator()(void* decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<std::remove_pointer_t<tjhandle>, DestroyDecoder>;

struct JpegHeader {
  TileSize size = {0, 0};
  bool is_cmyk = false;
};

const unsigned char* jpeg_bytes(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

JpegHeader read_header(const Decoder& decoder, std::string_view bytes) {
  int width = 0, height = 0, samples = 0, colors = 0;
  const bool is_read = decoder && bytes.size() <= kMaxFileBytes &&
                       tjDecompressHeader3(decoder.get(), jpeg_bytes(bytes), bytes.size(), &width, &height,
                                           &samples, &colors) == 0;
  if (!is_read || width < 1 || height < 1) return {};
  return {{width, height}, colors == TJCS_CMYK || colors == TJCS_YCCK};
}

// Each scan goes over the whole picture. A usual one has up to ten.
bool has_too_many_scans(std::string_view jpeg) {
  constexpr int kMax = 100;
  constexpr std::string_view kScan = "\xff\xda";
  int scans = 0;
  for (std::size_t at = jpeg.find(kScan); at != jpeg.npos; at = jpeg.find(kScan, at + kScan.size())) {
    if (++scans > kMax) return true;
  }
  return false;
}

// Files in CMYK hold 255 minus the amount of ink, as Adobe's programs write it.
void cmyk_to_rgba(std::string& pixels) {
  constexpr int kMax = 255;
  for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
    const int key = static_cast<unsigned char>(pixels[i + 3]);
    for (std::size_t color = i; color < i + 3; ++color)
      pixels[color] = static_cast<char>(static_cast<unsigned char>(pixels[color]) * key / kMax);
    pixels[i + 3] = static_cast<char>(kMax);
  }
}

}  // namespace

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

TileSize size_of_jpeg(std::string_view bytes) { return read_header(Decoder(tjInitDecompress()), bytes).size; }

FormatResult<RgbaPicture> read_jpeg(std::string_view bytes, int most_side) {
  const Decoder decoder(tjInitDecompress());
  const JpegHeader header = read_header(decoder, bytes);
  const auto [width, height] = header.size;
  if (width < 1) return tl::unexpected(FormatError{"", "is a damaged JPEG: its header cannot be read"});
  if (const auto fits = check_picture_size(header.size, most_side); !fits)
    return tl::unexpected(fits.error());
  if (has_too_many_scans(bytes)) return tl::unexpected(FormatError{"", "is a JPEG of more than 100 scans"});
  std::string pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), '\0');
  const int done = tjDecompress2(decoder.get(), jpeg_bytes(bytes), bytes.size(),
                                 reinterpret_cast<unsigned char*>(pixels.data()), width, 0, height,
                                 header.is_cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_ACCURATEDCT);
  if (done != 0 && tjGetErrorCode(decoder.get()) == TJERR_FATAL)
    return tl::unexpected(
        FormatError{"", std::string("is a damaged JPEG: ") + tjGetErrorStr2(decoder.get())});
  if (header.is_cmyk) cmyk_to_rgba(pixels);
  return RgbaPicture{width, height, std::move(pixels)};
}

}  // namespace talus
