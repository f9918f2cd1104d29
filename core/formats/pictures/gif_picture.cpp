// Goes over the blocks up to the first picture, whose pixels are packed by LZW: a code stands for the pixels
// of an earlier code and one more.
#include "gif_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture_size.h"

namespace talus {
namespace {

constexpr std::size_t kGifHeader = 13, kGifImage = 9;  // bytes
constexpr unsigned kHasColors = 0x80, kColorsBits = 7, kIsInterlaced = 0x40;
constexpr int kMaxCodeBits = 12, kCodes = 1 << kMaxCodeBits;

unsigned gif_byte(std::string_view bytes, std::size_t at) {
  return at < bytes.size() ? static_cast<std::uint8_t>(bytes[at]) : 0U;
}
int gif_word(std::string_view bytes, std::size_t at) {
  return static_cast<int>(gif_byte(bytes, at) | gif_byte(bytes, at + 1) << 8);
}

// The colours of a list whose size is in `flags`; none if it has no list. Moves `at` behind it.
std::vector<Rgb> gif_colors(std::string_view bytes, unsigned flags, std::size_t& at) {
  std::vector<Rgb> colors;
  if ((flags & kHasColors) == 0) return colors;
  for (unsigned i = 0; i < 2U << (flags & kColorsBits); ++i, at += 3)
    colors.push_back({static_cast<std::uint8_t>(gif_byte(bytes, at)),
                      static_cast<std::uint8_t>(gif_byte(bytes, at + 1)),
                      static_cast<std::uint8_t>(gif_byte(bytes, at + 2))});
  return colors;
}

// The content of sub-blocks. Moves `at` behind them.
std::string gif_blocks(std::string_view bytes, std::size_t& at) {
  std::string content;
  while (at < bytes.size()) {
    const std::size_t size = gif_byte(bytes, at++);
    if (size == 0) break;
    content += bytes.substr(std::min(at, bytes.size()), size);
    at += size;
  }
  return content;
}

class GifUnpacker {
 public:
  // bits: of a colour, 1 to 8. count: pixels that are wanted.
  GifUnpacker(std::string_view packed, unsigned bits, std::size_t count)
      : packed_(packed), bits_(bits), count_(count) {}

  // Indices of colours, at most `count`.
  std::vector<std::uint8_t> unpack();

 private:
  std::optional<int> next_code(int size);
  void put(int code);

  std::string_view packed_;
  unsigned bits_;
  std::size_t count_;
  std::size_t at_ = 0;  // bits
  std::vector<std::uint8_t> pixels_;
  std::array<int, kCodes> before_ = {};            // the code whose pixels come first; -1: none
  std::array<std::uint8_t, kCodes> last_ = {};     // the last pixel
  std::array<std::uint8_t, kCodes> first_ = {};    // the first pixel
  std::array<std::uint16_t, kCodes> length_ = {};  // pixels
};

std::optional<int> GifUnpacker::next_code(int size) {
  if (at_ + static_cast<std::size_t>(size) > 8 * packed_.size()) return std::nullopt;
  int code = 0;
  for (int i = 0; i < size; ++i, ++at_)
    code |= static_cast<int>(gif_byte(packed_, at_ / 8) >> (at_ % 8) & 1U) << i;
  return code;
}

// Only as many pixels as still fit, so that all codes together take no more time than there are pixels.
void GifUnpacker::put(int code) {
  const std::size_t start = pixels_.size();
  const std::size_t end = std::min(count_, start + length_[static_cast<std::size_t>(code)]);
  std::size_t length = length_[static_cast<std::size_t>(code)];
  pixels_.resize(end);
  for (int of = code; of >= 0; of = before_[static_cast<std::size_t>(of)]) {
    if (start + --length < end) pixels_[start + length] = last_[static_cast<std::size_t>(of)];
  }
}

std::vector<std::uint8_t> GifUnpacker::unpack() {
  const int clear = 1 << bits_, stop = clear + 1;
  int size = static_cast<int>(bits_) + 1, next = stop + 1, previous = -1;
  for (int i = 0; i < clear; ++i) {
    const auto at = static_cast<std::size_t>(i);
    before_[at] = -1;
    first_[at] = last_[at] = static_cast<std::uint8_t>(i);
    length_[at] = 1;
  }
  while (pixels_.size() < count_) {
    const auto code = next_code(size);
    if (!code || *code == stop) break;
    if (*code == clear) {
      size = static_cast<int>(bits_) + 1, next = stop + 1, previous = -1;
      continue;
    }
    const bool is_new = *code == next && previous >= 0;
    if (*code > next || (*code == next && !is_new)) break;  // damaged
    if (previous >= 0 && next < kCodes) {
      const auto at = static_cast<std::size_t>(next), old = static_cast<std::size_t>(previous);
      before_[at] = previous;
      first_[at] = first_[old];
      last_[at] = is_new ? first_[old] : first_[static_cast<std::size_t>(*code)];
      length_[at] = static_cast<std::uint16_t>(length_[old] + 1);
      ++next;
      if (next == 1 << size && size < kMaxCodeBits) ++size;
    }
    put(*code);
    previous = *code;
  }
  return std::move(pixels_);
}

// The row in the picture of each row in the data.
std::vector<int> gif_rows(int height, bool is_interlaced) {
  std::vector<int> rows;
  if (!is_interlaced) {
    for (int y = 0; y < height; ++y) rows.push_back(y);
    return rows;
  }
  for (const auto& [first, step] : {std::pair{0, 8}, {4, 8}, {2, 4}, {1, 2}})
    for (int y = first; y < height; y += step) rows.push_back(y);
  return rows;
}

}  // namespace

bool is_gif(std::string_view bytes) { return bytes.starts_with("GIF87a") || bytes.starts_with("GIF89a"); }

TileSize size_of_gif(std::string_view bytes) {
  if (!is_gif(bytes) || bytes.size() < kGifHeader) return {0, 0};
  return {gif_word(bytes, 6), gif_word(bytes, 8)};
}

FormatResult<RgbaPicture> read_gif(std::string_view bytes, int most_side) {
  const auto damaged = [](const char* why) {
    return tl::unexpected(FormatError{"", std::string("is a damaged GIF: ") + why});
  };
  const TileSize size = size_of_gif(bytes);
  if (const auto fits = check_picture_size(size, most_side); !fits) return tl::unexpected(fits.error());
  std::size_t at = kGifHeader;
  const std::vector<Rgb> shared = gif_colors(bytes, gif_byte(bytes, 10), at);
  int clear = -1;  // index of the transparent colour; -1: none
  constexpr unsigned kExtension = 0x21, kImage = 0x2c, kGraphics = 0xf9;
  while (gif_byte(bytes, at) == kExtension) {
    const bool has_clear = gif_byte(bytes, at + 1) == kGraphics && (gif_byte(bytes, at + 3) & 1U) != 0;
    if (has_clear) clear = static_cast<int>(gif_byte(bytes, at + 6));
    at += 2;
    gif_blocks(bytes, at);
  }
  if (gif_byte(bytes, at) != kImage || bytes.size() < at + kGifImage + 2) return damaged("it has no picture");
  const std::size_t image = at + 1;
  const int left = gif_word(bytes, image), top = gif_word(bytes, image + 2);
  const int width = gif_word(bytes, image + 4), height = gif_word(bytes, image + 6);
  const unsigned flags = gif_byte(bytes, image + 8);
  if (left + width > size.width || top + height > size.height)
    return damaged("its first frame is larger than the picture");
  at = image + kGifImage;
  const std::vector<Rgb> own = gif_colors(bytes, flags, at);
  const std::vector<Rgb>& colors = own.empty() ? shared : own;
  const unsigned bits = gif_byte(bytes, at++);
  if (bits < 1 || bits > 8) return damaged("its colours have no size");
  const std::string packed = gif_blocks(bytes, at);
  const auto pixels =
      GifUnpacker(packed, bits, static_cast<std::size_t>(width) * static_cast<std::size_t>(height)).unpack();
  RgbaPicture picture{size.width, size.height, {}};
  picture.bytes.resize(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  const std::vector<int> rows = gif_rows(height, (flags & kIsInterlaced) != 0);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t color = pixels[i], wide = static_cast<std::size_t>(width);
    if (static_cast<int>(color) == clear || color >= colors.size()) continue;
    const std::size_t y = static_cast<std::size_t>(top + rows[i / wide]);
    char* const pixel = &picture.bytes[4 * (y * static_cast<std::size_t>(size.width) +
                                            static_cast<std::size_t>(left) + i % wide)];
    pixel[0] = static_cast<char>(colors[color].r);
    pixel[1] = static_cast<char>(colors[color].g);
    pixel[2] = static_cast<char>(colors[color].b);
    pixel[3] = '\xff';
  }
  return picture;
}

}  // namespace talus
