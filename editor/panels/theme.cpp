// The style of the window: a quiet dark theme on a grid of 4 px.
#include "theme.h"

namespace talus::theme {
namespace {

ImVec4 vec(std::uint32_t rgb, float alpha = 1) {
  ImVec4 v = ImGui::ColorConvertU32ToFloat4(color(rgb));
  v.w = alpha;
  return v;
}

void set_colors(ImVec4* c) {
  c[ImGuiCol_Text] = vec(kText);
  c[ImGuiCol_TextDisabled] = vec(kMuted);
  c[ImGuiCol_WindowBg] = vec(kBackground);
  c[ImGuiCol_ChildBg] = vec(kPanel);
  c[ImGuiCol_PopupBg] = vec(0x262a42);
  c[ImGuiCol_Border] = vec(kLine);
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = c[ImGuiCol_Header] = vec(kControl);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = c[ImGuiCol_HeaderHovered] = vec(kControlHot);
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = c[ImGuiCol_HeaderActive] = vec(0x4d5680);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = vec(kControl);
  c[ImGuiCol_MenuBarBg] = vec(kBackground);
  c[ImGuiCol_ScrollbarBg] = vec(kPanel);
  c[ImGuiCol_ScrollbarGrab] = vec(kControlHot);
  c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = vec(kAccent);
  c[ImGuiCol_Separator] = vec(kLine);
  c[ImGuiCol_Tab] = vec(kPanel);
  c[ImGuiCol_TabHovered] = vec(kControlHot);
  c[ImGuiCol_TabActive] = vec(kControl);
  c[ImGuiCol_TableHeaderBg] = vec(0x2a2e46);
  c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = vec(kLine);
  c[ImGuiCol_TableRowBgAlt] = vec(0xffffff, 0.03f);
  c[ImGuiCol_TextSelectedBg] = vec(kAccent, 0.4f);
  c[ImGuiCol_ModalWindowDimBg] = vec(kDark, 0.6f);
}

}  // namespace

void apply(float scale) {
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
  style.ScaleAllSizes(scale);
  set_colors(style.Colors);
  ImGui::GetStyle() = style;
}

}  // namespace talus::theme
