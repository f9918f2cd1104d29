// Colours and spacing of the window.
#pragma once

#include <imgui.h>

#include <cstdint>

#include <talus/level/tileset.h>
#include "panels/preferences.h"

namespace talus::theme {

// 0xRRGGBB and an opacity, as Dear ImGui wants it.
constexpr ImU32 color(std::uint32_t rgb, int alpha = 255) {
  return IM_COL32((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255, alpha);
}
// A colour of a panel; the theme in use may replace a colour of the list below. Canvases and art have dark
// ground in every theme and use color().
ImU32 tone(std::uint32_t rgb, int alpha = 255);
// Whether the light theme is in use.
bool is_light();
inline ImU32 color(Rgb c, int alpha = 255) { return IM_COL32(c.r, c.g, c.b, alpha); }

inline constexpr std::uint32_t kBackground = 0x1a1c2c;
inline constexpr std::uint32_t kPanel = 0x212438;
inline constexpr std::uint32_t kControl = 0x31364f;
inline constexpr std::uint32_t kControlHot = 0x414868;
inline constexpr std::uint32_t kPressed = 0x4d5680;
inline constexpr std::uint32_t kPopup = 0x262a42;
inline constexpr std::uint32_t kTableHeader = 0x2a2e46;
inline constexpr std::uint32_t kNote = 0x24405c;            // ground of a message
inline constexpr std::uint32_t kErrorNote = 0x5c1f33;       // the same for an error
inline constexpr std::uint32_t kStripe = 0xffffff;          // rows of a table, faintly
inline constexpr std::uint32_t kOutside = 0x11121c;         // beyond the map's edge
inline constexpr std::uint32_t kCheckered = 0x4a4f63;       // under what is clear in true colour
inline constexpr std::uint32_t kCheckeredLight = 0x6b7086;  // every other square of it
inline constexpr std::uint32_t kLine = 0x3b4160;
inline constexpr std::uint32_t kText = 0xf4f4f4;
inline constexpr std::uint32_t kMuted = 0xa3afc5;
inline constexpr std::uint32_t kAccent = 0x41a6f6;  // of what is chosen or active
inline constexpr std::uint32_t kFocus = 0x73eff7;   // of what has the keys
inline constexpr std::uint32_t kError = 0xf48a98;
inline constexpr std::uint32_t kWarning = 0xffcd75;
inline constexpr std::uint32_t kDark = 0x0b0c14;  // outlines under lines and labels
inline constexpr int kPlateAlpha = 225;           // 0..255, of the dark plates of text on a canvas

inline constexpr float kGap = 4;      // px at scale 1; every distance is a multiple
inline constexpr float kButton = 24;  // px at scale 1, side of an icon button

// Sets the style of the current ImGui context for a scale of the interface.
void apply(float scale, ThemeKind kind);

}  // namespace talus::theme
