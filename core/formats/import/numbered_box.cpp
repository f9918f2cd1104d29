// Draws the numbers of boxes with digits of 3x5 px.
#include "numbered_box.h"

#include <array>
#include <string_view>

namespace talus {
namespace {

// Row by row.
constexpr std::array<std::string_view, 10> kDigitForms = {
    "#### ## ## ####", " # ##  #  # ###", "##   # # #  ###", "##   # #   ### ", "# ## ####  #  #",
    "####  ##   ### ", " ###  #### ####", "###  # #  #  # ", "#### ##### ####", "#### ####  ### "};
constexpr int kDigitWidth = 3, kDigitHeight = 5;

bool is_in_digit(int digit, int x, int y) {
  if (x < 0 || y < 0 || x >= kDigitWidth || y >= kDigitHeight) return false;
  return kDigitForms[static_cast<std::size_t>(digit)][static_cast<std::size_t>(y * kDigitWidth + x)] == '#';
}

}  // namespace

Rgb color_of_box(int number, int x, int y) {
  constexpr std::array<std::size_t, 5> kBoxes = {8, 1, 7, 2, 15};  // dark colours of the palette
  constexpr std::size_t kText = 12, kEdge = 0;
  static const Palette palette = default_palette();
  constexpr int kLast = kCartTileSize - 1;
  const bool is_text = is_in_digit(number / 10 % 10, x, y - 1) || is_in_digit(number % 10, x - 4, y - 1);
  if (is_text) return palette[kText];
  if (x == kLast || y == kLast) return palette[kEdge];
  return palette[kBoxes[static_cast<std::size_t>(number / 100) % kBoxes.size()]];
}

}  // namespace talus
