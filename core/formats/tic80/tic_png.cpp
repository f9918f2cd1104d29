// PNG carts: finds the packed cart in the picture, unpacks it, and reads it like any other cart.
#include "tic_png.h"

#include "../pictures/png_picture.h"
#include "../text/unpack.h"
#include "tic_cart.h"

namespace talus {
namespace {

constexpr std::size_t kHiddenHeader = 8;  // in the bytes of the pixels

tl::unexpected<FormatError> no_cart() {
  return tl::unexpected(FormatError{"",
                                    "is a picture without a TIC-80 cartridge; to take its pixels, use File > "
                                    "Import a picture or talus import --into"});
}

// Joins the low bits of the bytes from `first` on to `size` bytes. There must be enough.
std::string low_bits(std::string_view bytes, std::size_t first, std::size_t bits, std::size_t size) {
  std::string out(size, '\0');
  for (std::size_t bit = 0; bit < 8 * size; ++bit) {
    const auto source = static_cast<std::uint8_t>(bytes[first + bit / bits]);
    if (source >> bit % bits & 1) out[bit / 8] = static_cast<char>(out[bit / 8] | 1 << bit % 8);
  }
  return out;
}

// Returns what the pixels hide; empty if it cannot be a cart.
std::string hidden_in(std::string_view pixels) {
  if (pixels.size() < kHiddenHeader) return {};
  const std::string header = low_bits(pixels, 0, 4, 4);
  const auto byte = [&](std::size_t i) { return std::size_t{static_cast<std::uint8_t>(header[i])}; };
  const std::size_t bits = byte(0), size = byte(1) | byte(2) << 8 | byte(3) << 16;
  if (bits < 1 || bits > 8 || 8 * size > bits * (pixels.size() - kHiddenHeader)) return {};
  return low_bits(pixels, kHiddenHeader, bits, size);
}

// Whether it begins like a zlib stream: all pixels hide some bytes, but few hide this.
bool looks_packed(std::string_view bytes) {
  if (bytes.size() < 2) return false;
  const int method = static_cast<std::uint8_t>(bytes[0]), check = static_cast<std::uint8_t>(bytes[1]);
  return (method & 15) == 8 && (256 * method + check) % 31 == 0;
}

FormatResult<std::string> packed_cart(std::string_view bytes) {
  const auto chunk = find_png_chunk(bytes, "caRt");
  if (!chunk) return tl::unexpected(chunk.error());
  if (!chunk->empty()) return std::string(*chunk);
  const auto picture = read_rgba(bytes);
  if (!picture) return tl::unexpected(picture.error());
  std::string hidden = hidden_in(picture->bytes);
  if (!looks_packed(hidden)) return no_cart();
  return hidden;
}

}  // namespace

bool accepts_tic_png(std::string_view bytes, const FormatContext&) { return is_png(bytes); }

bool has_tic_cart(std::string_view png) { return packed_cart(png).has_value(); }

FormatResult<Level> read_tic_png(std::string_view bytes, const FormatContext& context) {
  const auto packed = packed_cart(bytes);
  if (!packed) return tl::unexpected(packed.error());
  const auto cart = unpack_zlib(*packed, kMaxCartBytes);
  if (!cart && cart.error().is_too_large)
    return tl::unexpected(FormatError{"", "has a cartridge in it that unpacks to more than 4 MB"});
  if (!cart)
    return tl::unexpected(
        FormatError{"", "has a damaged cartridge in it, which cannot be unpacked: " + cart.error().reason});
  if (cart->empty()) return tl::unexpected(FormatError{"", "has an empty cartridge in it"});
  auto level = read_tic(*cart, context);
  if (!level && !level.error().place.empty()) level.error().place += " of the cartridge in it";
  return level;
}

}  // namespace talus
