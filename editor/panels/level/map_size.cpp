// Checks sizes of maps, and draws their fields.
#include "map_size.h"

#include <algorithm>
#include <cstdint>

namespace talus {
namespace {

constexpr float kField = 72;  // px at scale 1

// The longest side of a map, in cells. tile: px, of a cell.
int longest_side(int tile) { return std::min(kMaxTerrainSide, static_cast<int>(kMaxCoordinate) / tile); }

}  // namespace

std::string problem_of_map_size(int width, int height, TileSize tile) {
  const int widest = longest_side(tile.width), highest = longest_side(tile.height);
  if (width < 1 || width > widest) return "The width must be 1 to " + std::to_string(widest) + " cells.";
  if (height < 1 || height > highest) return "The height must be 1 to " + std::to_string(highest) + " cells.";
  const auto cells = std::int64_t{width} * height;
  if (cells > kMaxTerrainCells)
    return "These are " + std::to_string(cells) + " cells; a map has at most " +
           std::to_string(kMaxTerrainCells) + ".";
  return "";
}

std::string text_of_map_limits() {
  return "1 to " + std::to_string(kMaxTerrainSide) + ", and no more than " +
         std::to_string(kMaxTerrainCells) + " cells in all.";
}

void draw_map_number(const char* name, const char* label, int& value, const std::string& help, Ui& ui) {
  ImGui::AlignTextToFramePadding();
  draw_text(label);
  ImGui::SameLine(ui.px(kMapLabel));
  ImGui::SetNextItemWidth(ui.px(kField));
  ImGui::InputInt((std::string("##") + name).c_str(), &value, 0);
  ui.item(name, help);
}

void draw_map_note(const std::string& text, std::uint32_t color) {
  ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(color));
  draw_text(text);
  ImGui::PopStyleColor();
}

}  // namespace talus
