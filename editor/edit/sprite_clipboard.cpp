// Reads and writes hex digits.
#include "sprite_clipboard.h"
#include "flag_lamps.h"
#include "level_settings.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <charconv>

namespace talus {
namespace {

constexpr int kMostSide = 2048;                                    // tiles or px, of what is copied
constexpr int kDigitsOfATile = kCartTileSize * kCartTileSize + 2;  // for its pixels and its flags
constexpr std::size_t kDigitsOfAColor = 6;
constexpr std::string_view kTilesWord = "tiles", kPixelsWord = "pixels", kSpace = " \t\r\n";

char to_digit(int value) { return "0123456789abcdef"[value & 15]; }

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

// Takes the line "<word> 3x2" from the beginning of the text. Sides may be up to kMostSide.
std::optional<Size> take_size(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return std::nullopt;
  std::string_view rest = trimmed(text.substr(word.size()));
  const auto take_number = [&](int& number) {
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return error == std::errc() && number >= 1 && number <= kMostSide;
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
  std::vector<std::uint8_t> flags;
};

std::optional<CopiedTiles> tiles_from_text(std::string_view text) {
  text = trimmed(text);
  auto size = take_size(text, kTilesWord);
  const auto digits = digits_of(without_space(text));
  if (!digits || digits->empty() || digits->size() % kDigitsOfATile != 0) return std::nullopt;
  const int count = static_cast<int>(digits->size()) / kDigitsOfATile;
  for (int side = 1; !size && side <= kMostSide; ++side)
    if (side * side == count) size = Size{side, side};
  if (!size || size->w * size->h != count) return std::nullopt;
  const auto flags = digits->begin() + count * kCartTileSize * kCartTileSize;
  CopiedTiles tiles{*size, {size->w * kCartTileSize, size->h * kCartTileSize, {digits->begin(), flags}}, {}};
  for (auto low = flags; low != digits->end(); low += 2)
    tiles.flags.push_back(static_cast<std::uint8_t>(low[0] | low[1] << 4));
  return tiles;
}

}  // namespace

std::string tiles_to_text(const Level& level, const SpriteArea& area) {
  const CellRect& t = area.tiles;
  std::string text = t.w == t.h ? "" : std::string(kTilesWord) + " " + to_string(Size{t.w, t.h}) + "\n";
  for (std::uint8_t color : copy_pixels(level, area, {0, 0, area.width(), area.height()}).colors)
    text += to_digit(color);
  for (int y = 0; y < t.h; ++y) {
    for (int x = 0; x < t.w; ++x) {
      const int flags = level.sheet(area.sheet).flags[area.tile_at(level, x, y)];
      text += to_digit(flags);
      text += to_digit(flags >> 4);
    }
  }
  return text;
}

tl::expected<Edit, std::string> paste_tiles(const Level& level, const SpriteArea& area,
                                            std::string_view text) {
  const auto tiles = tiles_from_text(text);
  if (!tiles)
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
  std::string text = std::string(kPixelsWord) + " " + to_string(Size{block.w, block.h}) + "\n";
  for (std::uint8_t color : block.colors) text += to_digit(color);
  return text;
}

std::optional<PixelBlock> pixels_from_text(std::string_view text) {
  text = trimmed(text);
  const auto size = take_size(text, kPixelsWord);
  if (!size) return std::nullopt;
  auto digits = digits_of(without_space(text));
  if (!digits || digits->size() != static_cast<std::size_t>(size->w) * size->h) return std::nullopt;
  return PixelBlock{size->w, size->h, std::move(*digits)};
}

std::string palette_to_text(const Palette& palette) {
  std::string text;
  for (const Rgb& color : palette) {
    for (int channel : {color.r, color.g, color.b}) {
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
