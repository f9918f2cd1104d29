// Reads and writes hex digits.
#include "sprite_clipboard.h"
#include "flag_lamps.h"
#include "level_settings.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <charconv>
#include <span>

namespace talus {
namespace {

constexpr int kMaxSide = 2048;                                  // tiles or px, of what is copied
constexpr int kDigitsOfPixels = kCartTileSize * kCartTileSize;  // of a tile
constexpr int kBitsOfADigit = 4;
constexpr std::size_t kDigitsOfAColor = 6, kDigitsOfRgba = 8;
constexpr std::string_view kTilesWord = "tiles", kFlagsWord = "flags", kPixelsWord = "pixels",
                           kRgbaWord = "rgba", kSpace = " \t\r\n";

// Of the flags of a tile. all: also those that no cart has.
constexpr int digits_of_flags(bool all) { return (all ? kMaxFlags : kCartFlags) / kBitsOfADigit; }

char to_digit(unsigned value) { return "0123456789abcdef"[value & 15]; }

std::optional<int> from_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

// The values of the digits; nothing if there is any other character.
std::optional<std::vector<std::uint8_t>> digits_of(std::string_view text) {
  std::vector<std::uint8_t> digits;
  for (char c : text) {
    const auto digit = from_digit(c);
    if (!digit) return std::nullopt;
    digits.push_back(static_cast<std::uint8_t>(*digit));
  }
  return digits;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kSpace);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string without_space(std::string_view text) {
  std::string kept;
  std::copy_if(text.begin(), text.end(), std::back_inserter(kept),
               [](char c) { return kSpace.find(c) == kSpace.npos; });
  return kept;
}

struct Size {
  int w, h;
  friend bool operator==(const Size&, const Size&) = default;
};
std::string to_string(Size size) { return std::to_string(size.w) + "x" + std::to_string(size.h); }

// Takes the line "<word> 3x2" from the beginning of the text. Sides may be up to kMaxSide.
std::optional<Size> take_size(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return std::nullopt;
  std::string_view rest = trimmed(text.substr(word.size()));
  const auto take_number = [&](int& number) {
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return error == std::errc() && number >= 1 && number <= kMaxSide;
  };
  Size size{};
  if (!take_number(size.w) || !rest.starts_with('x')) return std::nullopt;
  rest.remove_prefix(1);
  if (!take_number(size.h)) return std::nullopt;
  text = rest;
  return size;
}

struct CopiedTiles {
  Size size;  // in tiles
  PixelBlock pixels;
  std::vector<FlagSet> flags;
};

// The flags of tiles, the low digit of each first.
std::vector<FlagSet> flags_of_digits(std::span<const std::uint8_t> digits, int of_a_tile) {
  std::vector<FlagSet> flags;
  for (auto low = digits.begin(); low != digits.end(); low += of_a_tile) {
    FlagSet of_one = 0;
    for (int digit = of_a_tile; digit-- > 0;) of_one = of_one << kBitsOfADigit | low[digit];
    flags.push_back(of_one);
  }
  return flags;
}

std::vector<PixelColor> rgba_of_digits(std::span<const std::uint8_t> digits) {
  std::vector<PixelColor> colors;
  colors.reserve(digits.size() / kDigitsOfRgba);
  for (auto digit = digits.begin(); digit != digits.end(); digit += kDigitsOfRgba) {
    const auto byte = [&](int i) { return static_cast<std::uint8_t>(digit[2 * i] << 4 | digit[2 * i + 1]); };
    colors.push_back(pixel_color({byte(0), byte(1), byte(2), byte(3)}));
  }
  return colors;
}

void add_rgba(PixelColor color, std::string& text) {
  const Rgba c = rgba_of(color);
  for (const int channel : {c.r, c.g, c.b, c.a}) {
    text += to_digit(static_cast<unsigned>(channel) >> 4);
    text += to_digit(static_cast<unsigned>(channel));
  }
}

// Of "tiles 3x2 rgba 48x32".
std::optional<CopiedTiles> rgba_tiles_from_text(std::string_view text) {
  text = trimmed(text);
  const auto tiles = take_size(text, kTilesWord);
  if (!tiles) return std::nullopt;
  text = trimmed(text);
  const auto size = take_size(text, kRgbaWord);
  if (!size) return std::nullopt;
  const auto digits = digits_of(without_space(text));
  const std::size_t of_pixels =
      static_cast<std::size_t>(size->w) * static_cast<std::size_t>(size->h) * kDigitsOfRgba;
  const int of_flags = digits_of_flags(true);
  const std::size_t of_all_flags = static_cast<std::size_t>(tiles->w * tiles->h * of_flags);
  if (!digits || digits->size() != of_pixels + of_all_flags) return std::nullopt;
  const std::span<const std::uint8_t> all(*digits);
  return CopiedTiles{*tiles,
                     {size->w, size->h, rgba_of_digits(all.first(of_pixels)), true},
                     flags_of_digits(all.subspan(of_pixels), of_flags)};
}

std::optional<CopiedTiles> tiles_from_text(std::string_view text) {
  if (auto in_rgba = rgba_tiles_from_text(text)) return in_rgba;
  text = trimmed(text);
  auto size = take_size(text, kTilesWord);
  const bool has_all = size && trimmed(text).starts_with(kFlagsWord);
  if (has_all) text = trimmed(text).substr(kFlagsWord.size());
  const auto digits = digits_of(without_space(text));
  const int of_flags = digits_of_flags(has_all), of_tile = kDigitsOfPixels + of_flags;
  if (!digits || digits->empty() || digits->size() % static_cast<std::size_t>(of_tile) != 0)
    return std::nullopt;
  const int count = static_cast<int>(digits->size()) / of_tile;
  for (int side = 1; !size && side <= kMaxSide; ++side)
    if (side * side == count) size = Size{side, side};
  if (!size || size->w * size->h != count) return std::nullopt;
  const auto flags = digits->begin() + static_cast<std::ptrdiff_t>(count) * kDigitsOfPixels;
  return CopiedTiles{*size,
                     {size->w * kCartTileSize, size->h * kCartTileSize, {digits->begin(), flags}},
                     flags_of_digits({flags, digits->end()}, of_flags)};
}

}  // namespace

std::string tiles_to_text(const Level& level, const SpriteArea& area) {
  const CellRect& t = area.tiles;
  const bool in_rgba = is_in_rgba(level, area.sheet);
  const bool has_more = in_rgba || (flags_in(level, area).any & ~kCartFlagSet) != 0;
  const PixelBlock pixels = copy_pixels(level, area, area.canvas());
  std::string text;
  if (t.w != t.h || has_more) {
    text = std::string(kTilesWord) + " " + to_string(Size{t.w, t.h}) + " ";
    if (in_rgba)
      text += std::string(kRgbaWord) + " " + to_string(Size{pixels.w, pixels.h});
    else if (has_more)
      text += kFlagsWord;
    text = std::string(trimmed(text)) + "\n";
  }
  for (const PixelColor color : pixels.colors) {
    if (in_rgba)
      add_rgba(color, text);
    else
      text += to_digit(color);
  }
  for (int y = 0; y < t.h; ++y) {
    for (int x = 0; x < t.w; ++x) {
      const FlagSet flags = level.sheet(area.sheet).flags[area.tile_at(level, x, y)];
      for (int digit = 0; digit < digits_of_flags(has_more); ++digit)
        text += to_digit(flags >> kBitsOfADigit * digit);
    }
  }
  return text;
}

tl::expected<Edit, std::string> paste_tiles(const Level& level, const SpriteArea& area,
                                            std::string_view text) {
  const auto tiles = tiles_from_text(text);
  if (!tiles || tiles->pixels.in_rgba != is_in_rgba(level, area.sheet))
    return tl::unexpected<std::string>("The clipboard holds no sprites: copy some here or in TIC-80 first.");
  const Size here{area.tiles.w, area.tiles.h};
  if (tiles->size != here) {
    const std::string copied = to_string(tiles->size);
    return tl::unexpected("The clipboard holds " + copied + " tiles, and " + to_string(here) +
                          " are selected: select " + copied + " to paste them.");
  }
  Edit edit = put_pixels(level, area, tiles->pixels, {0, 0}, "Paste tiles");
  merge_edit(edit, set_flags(level, area, tiles->flags));
  return edit;
}

std::string pixels_to_text(const PixelBlock& block) {
  std::string text(block.in_rgba ? kRgbaWord : kPixelsWord);
  text += " " + to_string(Size{block.w, block.h}) + "\n";
  for (const PixelColor color : block.colors) {
    if (!block.in_rgba) {
      text += to_digit(color);
      continue;
    }
    add_rgba(color, text);
  }
  return text;
}

bool has_tiles_for(const Level& level, const SpriteArea& area, std::string_view text) {
  const auto tiles = rgba_tiles_from_text(text);
  const CellRect canvas = area.canvas();
  return tiles && is_in_rgba(level, area.sheet) && tiles->size == Size{area.tiles.w, area.tiles.h} &&
         tiles->pixels.w == canvas.w && tiles->pixels.h == canvas.h;
}

std::optional<PixelBlock> pixels_from_text(std::string_view text) {
  text = trimmed(text);
  const bool in_rgba = text.starts_with(kRgbaWord);
  const auto size = take_size(text, in_rgba ? kRgbaWord : kPixelsWord);
  if (!size) return std::nullopt;
  const auto digits = digits_of(without_space(text));
  const std::size_t count = static_cast<std::size_t>(size->w) * static_cast<std::size_t>(size->h);
  if (!digits || digits->size() != count * (in_rgba ? kDigitsOfRgba : 1)) return std::nullopt;
  if (!in_rgba) return PixelBlock{size->w, size->h, {digits->begin(), digits->end()}};
  return PixelBlock{size->w, size->h, rgba_of_digits(*digits), true};
}

std::optional<PixelBlock> tile_pixels_from_text(std::string_view text) {
  auto tiles = tiles_from_text(text);
  return tiles ? std::optional(std::move(tiles->pixels)) : std::nullopt;
}

std::string palette_to_text(const Palette& palette) {
  std::string text;
  for (const Rgb& color : palette) {
    for (const unsigned channel : {color.r, color.g, color.b}) {
      text += to_digit(channel >> 4);
      text += to_digit(channel);
    }
  }
  return text;
}

tl::expected<Edit, std::string> paste_palette(const Level& level, int color, std::string_view text) {
  assert(color >= 0 && color < kColorCount);
  const auto digits = digits_of(without_space(text));
  const std::size_t count = digits ? digits->size() : 0;
  if (count != kDigitsOfAColor && count != kDigitsOfAColor * kColorCount)
    return tl::unexpected<std::string>(
        "The clipboard holds no palette: it must be 96 hex digits, as TIC-80 copies it, or 6 for one "
        "colour.");
  const auto byte = [&](std::size_t at) {
    return static_cast<std::uint8_t>((*digits)[at] << 4 | (*digits)[at + 1]);
  };
  Edit edit{count == kDigitsOfAColor ? "Paste a colour" : "Paste a palette", {}};
  for (std::size_t at = 0; at < count; at += kDigitsOfAColor) {
    const int to = count == kDigitsOfAColor ? color : static_cast<int>(at / kDigitsOfAColor);
    merge_edit(edit, set_color(level, to, {byte(at), byte(at + 2), byte(at + 4)}));
  }
  return edit;
}

}  // namespace talus
