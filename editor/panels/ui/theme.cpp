// The style of the window on a grid of 4 px: a quiet dark theme and a light one.
#include "theme.h"

#include <algorithm>
#include <array>

namespace talus::theme {
namespace {

struct Tone {
  std::uint32_t dark, light;
};
// The colours of panels in both themes. Text has a contrast of at least 4.5 to what it is on.
constexpr std::array<Tone, 17> kTones = {{{kBackground, 0xdfe3ee},
                                          {kPanel, 0xf3f5fa},
                                          {kControl, 0xd0d7e6},
                                          {kControlHot, 0xb9c4da},
                                          {kPressed, 0x9fadc9},
                                          {kPopup, 0xffffff},
                                          {kTableHeader, 0xdde3f0},
                                          {kLine, 0xb3bdd2},
                                          {kText, 0x1a1c2c},
                                          {kMuted, 0x4e5872},
                                          {kAccent, 0x125a9f},
                                          {kFocus, 0x00686e},
                                          {kError, 0xab1c38},
                                          {kWarning, 0x774d00},
                                          {kNote, 0xd3e6fa},
                                          {kErrorNote, 0xfbdce2},
                                          {kStripe, 0x000000}}};

std::uint32_t in_theme(std::uint32_t rgb, bool light) {
  const auto tone = std::find_if(kTones.begin(), kTones.end(), [&](const Tone& t) { return t.dark == rgb; });
  return light && tone != kTones.end() ? tone->light : rgb;
}

void set_colors(ImVec4* c, bool light) {
  const auto vec = [&](std::uint32_t rgb, float alpha = 1) {
    ImVec4 v = ImGui::ColorConvertU32ToFloat4(color(in_theme(rgb, light)));
    v.w = alpha;
    return v;
  };
  c[ImGuiCol_Text] = vec(kText);
  c[ImGuiCol_TextDisabled] = vec(kMuted);
  c[ImGuiCol_WindowBg] = vec(kBackground);
  c[ImGuiCol_ChildBg] = vec(kPanel);
  c[ImGuiCol_PopupBg] = vec(kPopup);
  c[ImGuiCol_Border] = vec(kLine);
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = c[ImGuiCol_Header] = vec(kControl);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = c[ImGuiCol_HeaderHovered] = vec(kControlHot);
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = c[ImGuiCol_HeaderActive] = vec(kPressed);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = vec(kControl);
  c[ImGuiCol_MenuBarBg] = vec(kBackground);
  c[ImGuiCol_ScrollbarBg] = vec(kPanel);
  c[ImGuiCol_ScrollbarGrab] = vec(kControlHot);
  c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = vec(kAccent);
  c[ImGuiCol_NavHighlight] = vec(kFocus);
  c[ImGuiCol_Separator] = vec(kLine);
  c[ImGuiCol_Tab] = vec(kPanel);
  c[ImGuiCol_TabHovered] = vec(kControlHot);
  c[ImGuiCol_TabActive] = vec(kControl);
  c[ImGuiCol_TableHeaderBg] = vec(kTableHeader);
  c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = vec(kLine);
  c[ImGuiCol_TableRowBgAlt] = vec(kStripe, 0.03f);
  c[ImGuiCol_TextSelectedBg] = vec(kAccent, 0.4f);
  c[ImGuiCol_ModalWindowDimBg] = vec(kDark, light ? 0.35f : 0.6f);
}

}  // namespace

// Dear ImGui keeps the style, and with it the theme.
bool is_light() { return ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x > 0.5f; }

ImU32 tone(std::uint32_t rgb, int alpha) { return color(in_theme(rgb, is_light()), alpha); }

void apply(float scale, ThemeKind kind) {
  ImGuiStyle style;
  style.WindowPadding = {8, 8};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {4, 4};
  style.ItemInnerSpacing = {4, 4};
  style.CellPadding = {4, 2};
  style.ScrollbarSize = 10;
  style.GrabMinSize = 8;
  style.WindowRounding = style.ChildRounding = 0;
  style.FrameRounding = style.PopupRounding = style.TabRounding = style.GrabRounding = 3;
  style.WindowBorderSize = style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.DisabledAlpha = 0.66f;  // its text has a contrast of 4.5, too
  style.ScaleAllSizes(scale);
  set_colors(style.Colors, kind == ThemeKind::light);
  ImGui::GetStyle() = style;
}

}  // namespace talus::theme
