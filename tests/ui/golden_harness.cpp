// Pictures of the window, compared with stored ones.
#include "golden_harness.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>

#include "paths.h"
#include "unit/png_bytes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr int kFarOff = 48;  // of 255: a larger difference in one channel is another colour
constexpr int kBlock = 32;   // side of the compared blocks, px
constexpr double kMaxFarOff =
    0.12;  // share of a block's pixels: with more pixels of another colour it is another picture

std::size_t pixel_index(const Picture& picture, int x, int y) {
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(x)) *
         4;
}

bool is_far_off(const Picture& a, const Picture& b, std::size_t pixel) {
  for (std::size_t i = pixel; i < pixel + 3; ++i)
    if (std::abs(int{a.rgba[i]} - int{b.rgba[i]}) > kFarOff) return true;
  return false;
}

// Reduces the picture to 256 colours, which takes a third of the bytes: the commonest colours, and the
// nearest of them for the others. The error is far below the limit for another colour.
std::string small_png(const Picture& picture) {
  std::map<std::array<std::uint8_t, 3>, int> counts;
  const auto color_at = [&](std::size_t i) {
    return std::array{picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
  };
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) ++counts[color_at(i)];
  std::vector<std::pair<int, std::array<std::uint8_t, 3>>> commonest;
  for (const auto& [color, count] : counts) commonest.emplace_back(-count, color);
  std::sort(commonest.begin(), commonest.end());
  commonest.resize(std::min<std::size_t>(commonest.size(), 256));
  std::vector<Rgb> palette;
  for (const auto& [count, c] : commonest) palette.push_back({c[0], c[1], c[2]});
  std::map<std::array<std::uint8_t, 3>, char> numbers;
  for (const auto& [color, count] : counts) {
    int best = 1 << 30;
    for (std::size_t i = 0; i < palette.size(); ++i) {
      const int r = palette[i].r - color[0], g = palette[i].g - color[1], b = palette[i].b - color[2];
      const int distance = std::max({std::abs(r), std::abs(g), std::abs(b)});
      if (distance >= best) continue;
      best = distance;
      numbers[color] = static_cast<char>(i);
    }
  }
  std::vector<std::string> rows;
  for (int y = 0; y < picture.height; ++y) {
    rows.emplace_back();
    for (int x = 0; x < picture.width; ++x) rows.back() += numbers[color_at(pixel_index(picture, x, y))];
  }
  constexpr char kIndexed = 3;
  return png_of(static_cast<std::uint32_t>(picture.width), kIndexed, rows, palette);
}

}  // namespace

Picture load_picture(const std::string& path) {
  Picture picture;
  int channels = 0;
  stbi_uc* pixels = stbi_load(path.c_str(), &picture.width, &picture.height, &channels, 4);
  if (pixels == nullptr) return {};
  picture.rgba.assign(pixels, pixels + std::size_t{4} * picture.width * picture.height);
  stbi_image_free(pixels);
  return picture;
}

Picture cut(const Picture& picture, ImVec2 min, ImVec2 max) {
  const int x0 = std::clamp(static_cast<int>(min.x), 0, picture.width);
  const int y0 = std::clamp(static_cast<int>(min.y), 0, picture.height);
  Picture part{.width = std::clamp(static_cast<int>(max.x), x0, picture.width) - x0,
               .height = std::clamp(static_cast<int>(max.y), y0, picture.height) - y0,
               .rgba = {}};
  for (int y = 0; y < part.height; ++y) {
    const auto row = picture.rgba.begin() + static_cast<std::ptrdiff_t>(pixel_index(picture, x0, y0 + y));
    part.rgba.insert(part.rgba.end(), row, row + part.width * 4);
  }
  return part;
}

std::string first_difference(const Picture& a, const Picture& b, Picture& shown) {
  if (a.width != b.width || a.height != b.height) return "the size";
  shown = a;
  std::string first;
  // The blocks overlap by half, so that a difference cannot hide in the corners of all blocks.
  for (int top = 0; top < a.height; top += kBlock / 2) {
    for (int left = 0; left < a.width; left += kBlock / 2) {
      int far_off = 0;
      for (int y = top; y < std::min(top + kBlock, a.height); ++y) {
        for (int x = left; x < std::min(left + kBlock, a.width); ++x) {
          const std::size_t pixel = pixel_index(a, x, y);
          if (!is_far_off(a, b, pixel)) continue;
          ++far_off;
          shown.rgba[pixel] = 255;
          shown.rgba[pixel + 1] = shown.rgba[pixel + 2] = 0;
        }
      }
      if (far_off > kMaxFarOff * kBlock * kBlock && first.empty())
        first = std::to_string(left) + "," + std::to_string(top);
    }
  }
  return first;
}

void UiGolden::settle() {
  move({2, 2});
  do frames(5);
  while (session().debugger().is_busy() || session().timeline().behind() || session().is_linting() ||
         session().reach().running());
  session().apply(action::DismissMessage{});
  frames(2);
}

Picture UiGolden::picture_of_window() {
  settle();
  const std::string taken = path("window.png");
  const auto shot = app().screenshot(taken);
  EXPECT_TRUE(shot) << shot.error();
  return load_picture(taken);
}

void UiGolden::expect_as_before(const std::string& name, ImVec2 min, ImVec2 max) {
  const Picture now = cut(picture_of_window(), min, max);
  const std::string golden = source_path("tests/ui/golden/") + name + ".png";
  if (std::getenv("TALUS_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(golden, std::ios::binary) << small_png(now);
    return;
  }
  const Picture before = load_picture(golden);
  ASSERT_GT(before.width, 0) << "no picture " << golden;
  Picture shown;
  const std::string where = first_difference(now, before, shown);
  if (where.empty()) return;
  const fs::path folder = build_path("ui-failures");
  fs::create_directories(folder);
  EXPECT_TRUE(write_png(now, (folder / (name + "-now.png")).string()));
  if (!shown.rgba.empty()) {
    EXPECT_TRUE(write_png(shown, (folder / (name + "-far-off.png")).string()));
  }
  ADD_FAILURE() << name << " differs from " << golden << " at " << where << ": see " << folder;
}

void UiGolden::expect_widget(const std::string& name, const std::string& widget) {
  const Widget* found = find(widget);
  ASSERT_NE(found, nullptr) << widget;
  expect_as_before(name, found->min, found->max);
}

}  // namespace talus
