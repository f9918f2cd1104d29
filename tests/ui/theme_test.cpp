// The colours of both themes can be read.
#include <algorithm>
#include <cmath>

#include "harness.h"
#include "overlay/overlay_table.h"
#include "panels/ui/theme.h"

namespace talus::theme_test {

// Of WCAG 2, 0 to 1.
double luminance(ImU32 color) {
  const auto linear = [&](int shift) {
    const double c = static_cast<double>(color >> shift & 0xFF) / 255;
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(IM_COL32_R_SHIFT) + 0.7152 * linear(IM_COL32_G_SHIFT) +
         0.0722 * linear(IM_COL32_B_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
  const auto [low, high] = std::minmax(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

using UiTheme = UiTest;

TEST_F(UiTheme, TextHasEnoughContrastToWhatItIsOn) {
  start();
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    app().ui().view.preferences.theme = kind;
    frames(3);
    ASSERT_EQ(theme::is_light(), kind == ThemeKind::light);
    for (const std::uint32_t text : {theme::kText, theme::kMuted, theme::kError, theme::kWarning})
      for (const std::uint32_t surface : {theme::kBackground, theme::kPanel, theme::kControl, theme::kPopup,
                                          theme::kTableHeader, theme::kNote, theme::kErrorNote})
        EXPECT_GE(contrast(theme::tone(text), theme::tone(surface)), 4.5)
            << std::hex << text << " on " << surface << (theme::is_light() ? ", light" : ", dark");
    for (const std::uint32_t text : {theme::kAccent, theme::kFocus})
      for (const std::uint32_t surface : {theme::kBackground, theme::kPanel, theme::kControl, theme::kPopup})
        EXPECT_GE(contrast(theme::tone(text), theme::tone(surface)), 4.5)
            << std::hex << text << " on " << surface << (theme::is_light() ? ", light" : ", dark");
  }
}

TEST_F(UiTheme, DisabledButtonsCanBeRead) {
  start();
  const auto over = [](ImU32 top, ImU32 below) {
    const auto part = [&](int shift) {
      const double a = ImGui::GetStyle().DisabledAlpha;
      return static_cast<int>(std::lround((top >> shift & 0xFF) * a + (below >> shift & 0xFF) * (1 - a)));
    };
    return IM_COL32(part(IM_COL32_R_SHIFT), part(IM_COL32_G_SHIFT), part(IM_COL32_B_SHIFT), 255);
  };
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    app().ui().view.preferences.theme = kind;
    frames(3);
    for (const std::uint32_t surface : {theme::kBackground, theme::kPanel, theme::kPopup}) {
      const ImU32 button = over(theme::tone(theme::kControl), theme::tone(surface));
      EXPECT_GE(contrast(over(theme::tone(theme::kText), button), button), 4.5) << theme::is_light();
    }
  }
}

// Plates lie on art of any colour.
TEST_F(UiTheme, TextOnACanvasHasEnoughContrastToItsPlate) {
  const auto plate_over = [](int art) {
    const auto part = [art](std::uint32_t color, int shift) {
      const int dark = static_cast<int>(color >> shift & 0xff);
      return (dark * theme::kPlateAlpha + art * (255 - theme::kPlateAlpha)) / 255;
    };
    return IM_COL32(part(theme::kDark, 16), part(theme::kDark, 8), part(theme::kDark, 0), 255);
  };
  std::vector<std::pair<std::string, std::uint32_t>> texts = {
      {"text", theme::kText}, {"muted", theme::kMuted}, {"warning", theme::kWarning}};
  for (const Overlay* overlay : all_overlays())
    for (const OverlayPalette palette : {OverlayPalette::standard, OverlayPalette::colour_blind})
      texts.emplace_back(overlay->key, overlay_text_color(*overlay, palette));
  for (const auto& [name, color] : texts)
    for (const int art : {0, 255})
      EXPECT_GE(contrast(theme::color(color), plate_over(art)), 4.5) << name << " over " << art;
}

TEST_F(UiTheme, WhatHasTheKeysIsAnotherColourThanWhatIsActive) {
  start();
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    app().ui().view.preferences.theme = kind;
    frames(3);
    const ImU32 focus = ImGui::ColorConvertFloat4ToU32(ImGui::GetStyle().Colors[ImGuiCol_NavHighlight]);
    EXPECT_EQ(focus, theme::tone(theme::kFocus));
    EXPECT_NE(focus, theme::tone(theme::kAccent));
  }
}

}  // namespace talus::theme_test
