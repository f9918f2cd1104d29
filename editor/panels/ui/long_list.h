// Lists of any length, as files may make them: only the rows in view are drawn.
#pragma once

#include <imgui.h>

namespace talus {

// Draws the rows 0..count-1, all as high as the first one, from the cursor on.
template <class DrawRow>
void draw_rows(int count, DrawRow draw_row) {
  ImGuiListClipper clipper;
  clipper.Begin(count);
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) draw_row(row);
}

// Scrolls the window so that a row of text is in view. Call it before the list is drawn.
inline void scroll_to_row(int row) {
  const float line = ImGui::GetTextLineHeightWithSpacing(), height = ImGui::GetWindowHeight();
  const float top = ImGui::GetCursorPosY() + static_cast<float>(row) * line;
  const float above = ImGui::GetScrollY();
  if (top < above || top + line > above + height) ImGui::SetScrollY(top + line / 2 - height / 2);
}

}  // namespace talus
