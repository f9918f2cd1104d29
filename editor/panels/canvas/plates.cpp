#include "plates.h"

#include <algorithm>

#include "panels/ui/theme.h"
#include "panels/ui/wrapped_text.h"

namespace talus {
namespace {

ImVec2 pad_of_plate(const Ui& ui) { return {ui.px(6), ui.px(2)}; }

}  // namespace

ImVec2 size_of_plate(const std::string& text, const Ui& ui) {
  const ImVec2 size = size_of_text(text), pad = pad_of_plate(ui);
  return {size.x + 2 * pad.x, size.y + 2 * pad.y};
}

void draw_plate(ImDrawList& list, ImVec2 at, const std::string& text, ImU32 color, const Ui& ui) {
  const ImVec2 size = size_of_plate(text, ui), pad = pad_of_plate(ui);
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, theme::color(theme::kDark, theme::kPlateAlpha),
                     ui.px(3));
  add_text(list, {at.x + pad.x, at.y + pad.y}, color, text);
}

std::vector<std::string> plate_lines(const std::string& text, const CanvasView& view, const Ui& ui) {
  const float width = view.max.x - view.min.x - ui.px(4 + 12 + 4);
  const auto fits = [width](std::string_view line) { return size_of_text(line).x <= width; };
  const auto lines = lines_between_words(text, fits);
  return {lines.begin(), lines.end()};
}

void draw_low_plates(ImDrawList& list, const CanvasView& view, const std::string& text, float low,
                     bool in_middle, ImU32 color, const Ui& ui) {
  const std::vector<std::string> lines = plate_lines(text, view, ui);
  const float left = view.min.x + ui.px(4), height = ImGui::GetTextLineHeight() + ui.px(4);
  float at = view.max.y - low - height * static_cast<float>(lines.size());
  for (const std::string& line : lines) {
    const float room = view.max.x - view.min.x - size_of_plate(line, ui).x;
    draw_plate(list, {in_middle ? std::max(left, view.min.x + room / 2) : left, at}, line, color, ui);
    at += height;
  }
}

}  // namespace talus
