// Rectangles that can be clicked.
#include "world_picture.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "panels/ui/shown_text.h"
#include "panels/ui/theme.h"

namespace talus {
namespace {

constexpr float kWorldMargin = 8;         // px at scale 1
constexpr float kLeastOfLevel = 3;        // px at scale 1, that is seen of a small level
constexpr std::size_t kMaxLevels = 2000;  // levels of a world
constexpr int kNoPlace = -1;              // x and y of levels that LDtk shows in a row
constexpr double kRowGap = 16;            // px of the world

struct WorldView {
  double zoom = 1;      // px of the screen for each of the world
  double x = 0, y = 0;  // px of the screen, of the world's origin
  ImVec2 at(double world_x, double world_y) const {
    return {static_cast<float>(x + world_x * zoom), static_cast<float>(y + world_y * zoom)};
  }
};

WorldView view_of(const std::vector<Rect>& places, ImVec2 min, ImVec2 size, float margin) {
  constexpr double kFar = std::numeric_limits<double>::max();
  double left = kFar, top = kFar, right = -kFar, bottom = -kFar;
  for (const Rect& place : places) {
    if (place.w <= 0) continue;
    left = std::min(left, place.x);
    top = std::min(top, place.y);
    right = std::max(right, place.right());
    bottom = std::max(bottom, place.bottom());
  }
  const double room_x = std::max(1.0, 1.0 * size.x - 2 * margin),
               room_y = std::max(1.0, 1.0 * size.y - 2 * margin);
  WorldView view;
  view.zoom = std::min(room_x / (right - left), room_y / (bottom - top));
  view.x = min.x + size.x / 2.0 - (left + right) / 2 * view.zoom;
  view.y = min.y + size.y / 2.0 - (top + bottom) / 2 * view.zoom;
  return view;
}

// From the lowest.
std::vector<int> by_depth(const std::vector<LdtkLevelName>& levels, const std::vector<Rect>& places) {
  std::vector<int> order;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (places[i].w > 0 && order.size() < kMaxLevels) order.push_back(static_cast<int>(i));
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return levels[static_cast<std::size_t>(a)].depth < levels[static_cast<std::size_t>(b)].depth;
  });
  return order;
}

}  // namespace

std::vector<Rect> places_in_world(const std::vector<LdtkLevelName>& levels, int chosen) {
  const std::string& world = levels[static_cast<std::size_t>(chosen)].world;
  const bool is_row = std::all_of(levels.begin(), levels.end(), [&](const LdtkLevelName& level) {
    return level.world != world || (level.x == kNoPlace && level.y == kNoPlace);
  });
  std::vector<Rect> places;
  double x = 0;
  for (const LdtkLevelName& level : levels) {
    if (level.world != world) {
      places.emplace_back();
      continue;
    }
    places.push_back({is_row ? x : level.x, is_row ? 0.0 : level.y, 1.0 * level.width, 1.0 * level.height});
    x += level.width + kRowGap;
  }
  return places;
}

int draw_world(const std::vector<LdtkLevelName>& levels,
               const std::vector<std::shared_ptr<const SheetPicture>>& pictures, int chosen, ImVec2 size,
               Ui& ui) {
  const std::vector<Rect> places = places_in_world(levels, chosen);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const WorldView view = view_of(places, min, size, ui.px(kWorldMargin));
  const bool is_clicked = ImGui::InvisibleButton("world", size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, {min.x + size.x, min.y + size.y}, theme::color(theme::kOutside));
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  std::optional<int> hovered;
  const auto corner = [&](const Rect& place) {
    const ImVec2 from = view.at(place.x, place.y), to = view.at(place.right(), place.bottom());
    return ImVec2{std::max(to.x, from.x + ui.px(kLeastOfLevel)),
                  std::max(to.y, from.y + ui.px(kLeastOfLevel))};
  };
  const std::vector<int> order = by_depth(levels, places);
  for (const int i : order) {
    const Rect& place = places[static_cast<std::size_t>(i)];
    const ImVec2 from = view.at(place.x, place.y), to = corner(place);
    list.AddRectFilled(from, to, theme::color(levels[static_cast<std::size_t>(i)].color));
    const auto index = static_cast<std::size_t>(i);
    if (index < pictures.size() && pictures[index] != nullptr)
      list.AddImage(ui.small_pictures->texture(pictures[index]), from, to);
    list.AddRect(from, to, theme::color(theme::kMuted), 0, 0, ui.px(1));
    const bool is_over = mouse.x >= from.x && mouse.y >= from.y && mouse.x < to.x && mouse.y < to.y;
    if (ImGui::IsItemHovered() && is_over) hovered = i;
    ui.place("choose/world/level" + std::to_string(i + 1), from, to);
  }
  const auto frame = [&](int i, std::uint32_t rgb) {
    const Rect& place = places[static_cast<std::size_t>(i)];
    const ImVec2 from = view.at(place.x, place.y);
    list.AddRect(from, corner(place), theme::color(rgb), 0, 0, ui.px(2));
    add_short_text(list, {from.x + ui.px(4), from.y + ui.px(4)}, min.x + size.x, theme::color(theme::kText),
                   levels[static_cast<std::size_t>(i)].name);
  };
  frame(chosen, theme::kAccent);
  if (hovered && *hovered != chosen) frame(*hovered, theme::kWarning);
  return is_clicked && hovered ? *hovered : chosen;
}

}  // namespace talus
