// Goes over the chunks of the first frame. Numbers have their lowest byte first.
#include "aseprite_picture.h"

#include <algorithm>
#include <array>

#include "../text/unpack.h"

namespace talus {
namespace {

constexpr std::size_t kAseHeader = 128, kAseFrameHeader = 16, kAseChunkHeader = 6;  // bytes
constexpr std::uint32_t kAseMagic = 0xa5e0, kAseFrameMagic = 0xf1fa;
constexpr std::uint32_t kAseLayer = 0x2004, kAseCel = 0x2005, kAsePalette = 0x2019;  // types of chunks

// Reads numbers one after the other. What is behind the end is 0.
class AseReader {
 public:
  AseReader(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  std::uint32_t number(std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size && at_ + i < bytes_.size(); ++i)
      value |= std::uint32_t{static_cast<std::uint8_t>(bytes_[at_ + i])} << (8 * i);
    at_ += size;
    return value;
  }
  std::uint32_t byte() { return number(1); }
  std::uint32_t word() { return number(2); }
  std::uint32_t dword() { return number(4); }
  int offset() {  // with a sign
    constexpr int kNegative = 0x8000, kAll = 0x10000;
    const int value = static_cast<int>(word());
    return value < kNegative ? value : value - kAll;
  }
  void skip(std::size_t size) { at_ += size; }
  std::string_view rest() const { return bytes_.substr(std::min(at_, bytes_.size())); }

 private:
  std::string_view bytes_;
  std::size_t at_;
};

struct AseLayer {
  bool is_shown = true;  // it and its groups
  bool is_tilemap = false;
  std::uint32_t opacity = 255;
};

class AsePicture {
 public:
  FormatResult<RgbaPicture> read(std::string_view bytes, int most_side);

 private:
  using Color = std::array<std::uint8_t, 4>;

  static tl::unexpected<FormatError> wrong(std::size_t byte, std::string message) {
    return tl::unexpected(FormatError{"byte " + std::to_string(byte), std::move(message)});
  }
  FormatResult<void> read_chunk(std::uint32_t type, std::string_view content, std::size_t at);
  void read_layer(AseReader reader);
  void read_palette(AseReader reader);
  FormatResult<void> read_cel(AseReader reader, std::size_t at);
  Color color_at(std::string_view pixels, std::size_t index) const;
  void draw(const Color& color, int x, int y, std::uint32_t opacity);

  RgbaPicture picture_;
  std::size_t depth_ = 4;          // bytes of a pixel: 4 for RGBA, 2 for grey and opacity, 1 for an index
  std::uint32_t transparent_ = 0;  // index
  bool has_opacities_ = false;     // whether layers have an opacity
  std::vector<AseLayer> layers_;
  std::vector<bool> shown_at_;  // by depth of nesting, whether the last layer there is shown
  std::vector<Color> palette_;
  std::size_t cel_pixels_ = 0;
};

FormatResult<RgbaPicture> AsePicture::read(std::string_view bytes, int most_side) {
  if (!is_aseprite(bytes)) return tl::unexpected(FormatError{"", "is not a picture of Aseprite"});
  const auto [width, height] = size_of_aseprite(bytes);
  AseReader header(bytes, 12);
  const std::uint32_t bits = header.word();
  has_opacities_ = (header.dword() & 1) != 0;
  header.skip(10);
  transparent_ = header.byte();
  if (bits != 32 && bits != 16 && bits != 8)
    return wrong(12, "has pixels of " + std::to_string(bits) + " bits, but must have 8, 16 or 32");
  if (width > most_side || height > most_side ||
      std::int64_t{width} * height > std::int64_t{kMaxSheetPicturePixels}) {
    return tl::unexpected(FormatError{"", "is " + std::to_string(width) + "x" + std::to_string(height) +
                                              " px, but may have at most " + std::to_string(most_side) + "x" +
                                              std::to_string(most_side) + " px"});
  }
  depth_ = bits / 8;
  picture_.width = width;
  picture_.height = height;
  picture_.bytes.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), '\0');
  AseReader frame(bytes, kAseHeader);
  const std::size_t length = frame.dword();
  if (frame.word() != kAseFrameMagic || length < kAseFrameHeader || length > bytes.size() - kAseHeader)
    return wrong(kAseHeader, "must have a frame of the picture");
  const std::size_t end = kAseHeader + length;
  for (std::size_t at = kAseHeader + kAseFrameHeader; at < end;) {
    AseReader chunk(bytes, at);
    const std::size_t size = chunk.dword();
    if (size < kAseChunkHeader || size > end - at)
      return wrong(at, "the picture ends in the middle of a chunk");
    const std::uint32_t type = chunk.word();
    const auto read = read_chunk(type, bytes.substr(at + kAseChunkHeader, size - kAseChunkHeader), at);
    if (!read) return tl::unexpected(read.error());
    at += size;
  }
  return std::move(picture_);
}

FormatResult<void> AsePicture::read_chunk(std::uint32_t type, std::string_view content, std::size_t at) {
  const AseReader reader(content, 0);
  if (type == kAseLayer) read_layer(reader);
  if (type == kAsePalette) read_palette(reader);
  if (type == kAseCel) return read_cel(reader, at);
  return {};
}

void AsePicture::read_layer(AseReader reader) {
  constexpr std::uint32_t kVisible = 1, kTilemap = 2;
  constexpr std::size_t kMaxNested = 256;
  AseLayer layer;
  layer.is_shown = (reader.word() & kVisible) != 0;
  layer.is_tilemap = reader.word() == kTilemap;
  const std::size_t nested = std::min<std::size_t>(reader.word(), kMaxNested);
  reader.skip(6);
  const std::uint32_t opacity = reader.byte();
  if (has_opacities_) layer.opacity = opacity;
  shown_at_.resize(nested, true);
  layer.is_shown = layer.is_shown && (nested == 0 || shown_at_.back());
  shown_at_.push_back(layer.is_shown);
  layers_.push_back(layer);
}

void AsePicture::read_palette(AseReader reader) {
  constexpr std::uint32_t kMaxColors = 256, kHasName = 1;
  palette_.resize(std::min(reader.dword(), kMaxColors));
  const std::uint32_t first = reader.dword(), last = reader.dword();
  reader.skip(8);
  for (std::uint32_t i = first; i <= last && i < palette_.size(); ++i) {
    const bool has_name = (reader.word() & kHasName) != 0;
    for (std::uint8_t& part : palette_[i]) part = static_cast<std::uint8_t>(reader.byte());
    if (has_name) reader.skip(reader.word());
  }
}

FormatResult<void> AsePicture::read_cel(AseReader reader, std::size_t at) {
  constexpr std::uint32_t kRaw = 0, kPacked = 2, kOpaque = 255;
  const std::uint32_t index = reader.word();
  const int left = reader.offset(), top = reader.offset();
  const std::uint32_t opacity = reader.byte(), type = reader.word();
  reader.skip(7);
  if (index >= layers_.size()) return wrong(at, "has pixels of a layer that it does not have");
  const AseLayer& layer = layers_[index];
  if (!layer.is_shown) return {};
  if (layer.is_tilemap || (type != kRaw && type != kPacked))
    return wrong(at, "has a layer of another kind than pixels");
  const auto width = static_cast<int>(reader.word()), height = static_cast<int>(reader.word());
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (count > kMaxCelPixels - cel_pixels_)
    return wrong(at, "has layers of more than " + std::to_string(kMaxCelPixels) + " pixels in all");
  cel_pixels_ += count;
  std::string pixels;
  if (type == kPacked) {
    auto unpacked = unpack_zlib(reader.rest(), count * depth_);
    if (!unpacked) return wrong(at, "has pixels that cannot be unpacked");
    pixels = *std::move(unpacked);
  } else {
    pixels = std::string(reader.rest().substr(0, count * depth_));
  }
  if (pixels.size() != count * depth_) return wrong(at, "has fewer pixels than it says");
  for (int y = std::max(0, -top); y < std::min(height, picture_.height - top); ++y) {
    for (int x = std::max(0, -left); x < std::min(width, picture_.width - left); ++x) {
      const Color color = color_at(pixels, static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                               static_cast<std::size_t>(x));
      draw(color, left + x, top + y, opacity * layer.opacity / kOpaque);
    }
  }
  return {};
}

AsePicture::Color AsePicture::color_at(std::string_view pixels, std::size_t index) const {
  const auto part = [&](std::size_t i) { return static_cast<std::uint8_t>(pixels[index * depth_ + i]); };
  if (depth_ == 4) return {part(0), part(1), part(2), part(3)};
  if (depth_ == 2) return {part(0), part(0), part(0), part(1)};
  if (part(0) == transparent_ || part(0) >= palette_.size()) return {};
  return palette_[part(0)];
}

void AsePicture::draw(const Color& color, int x, int y, std::uint32_t opacity) {
  constexpr std::uint32_t kOpaque = 255, kHalf = kOpaque / 2;
  auto* pixel = &picture_.bytes[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                                     static_cast<std::size_t>(x))];
  const auto below = [&](std::size_t i) { return std::uint32_t{static_cast<std::uint8_t>(pixel[i])}; };
  const std::uint32_t over = (color[3] * opacity + kHalf) / kOpaque;
  const std::uint32_t under = (below(3) * (kOpaque - over) + kHalf) / kOpaque;
  if (over == 0) return;
  for (std::size_t i = 0; i < 3; ++i)
    pixel[i] = static_cast<char>((color[i] * over + below(i) * under + (over + under) / 2) / (over + under));
  pixel[3] = static_cast<char>(over + under);
}

}  // namespace

bool is_aseprite(std::string_view bytes) {
  return bytes.size() >= kAseHeader && AseReader(bytes, 4).word() == kAseMagic;
}

TileSize size_of_aseprite(std::string_view bytes) {
  if (!is_aseprite(bytes)) return {0, 0};
  AseReader reader(bytes, 8);
  const auto width = static_cast<int>(reader.word());
  return {width, static_cast<int>(reader.word())};
}

FormatResult<RgbaPicture> read_aseprite(std::string_view bytes, int most_side) {
  return AsePicture().read(bytes, most_side);
}

}  // namespace talus
