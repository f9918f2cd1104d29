// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "level_camera.h"

#include <algorithm>
#include <cmath>

namespace game {
namespace {

// Columns or rows that are used, from the first to before the last.
struct Used {
  int from, to;
  void note(int cell) { from = std::min(from, cell), to = std::max(to, cell + 1); }
  // The same in whole screens, within so many cells; px.
  std::pair<double, double> in_screens(int screen, int count, int side) const {
    const auto at = [&](int number) { return 1.0 * std::clamp(number * screen, 0, count) * side; };
    if (from >= to) return {0, 1.0 * count * side};
    return {at(static_cast<int>(std::floor(1.0 * from / screen))), at((to + screen - 1) / screen)};
  }
};

talus::Rect used_area(const talus::Level& level) {
  const talus::TileMap& map = level.map;
  Used columns{map.width(), 0}, rows{map.height(), 0};
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    if (!level.layers.list[static_cast<std::size_t>(layer)].is_ground) continue;
    const auto& tiles = level.cells_of(layer).tiles();
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      if (tiles[i] == 0) continue;
      columns.note(static_cast<int>(i % static_cast<std::size_t>(map.width())));
      rows.note(static_cast<int>(i / static_cast<std::size_t>(map.width())));
    }
  }
  for (const talus::Spawn& spawn : level.spawns) {
    columns.note(map.column_at(spawn.position.x));
    rows.note(map.row_at(spawn.position.y));
  }
  const auto [left, right] = columns.in_screens(talus::kScreenColumns, map.width(), map.tile_size().width);
  const auto [top, bottom] = rows.in_screens(talus::kScreenRows, map.height(), map.tile_size().height);
  return {left, top, right - left, bottom - top};
}

constexpr double kDeadZone = 0.25;  // share of the view, in its middle

// Where a view of this length begins that began at `from` and follows a place.
double follow(double place, std::optional<double> from, double length, double least, double most) {
  if (most - least < length) return (least + most - length) / 2;
  const double middle = place - length / 2, slack = length * kDeadZone / 2;
  const double start = std::clamp(from.value_or(middle), middle - slack, middle + slack);
  return std::clamp(start, least, most - length);
}

}  // namespace

Camera::Camera(const talus::Level& level) : area_(used_area(level)), tile_(level.map.tile_size()) {}

void Camera::place(Painter& painter, const talus::State& state) {
  const auto [width, height] = painter.size();
  const double screen = std::min(1.0 * width / (talus::kScreenColumns * tile_.width),
                                 1.0 * height / (talus::kScreenRows * tile_.height));
  const double whole = std::min(width / area_.w, height / area_.h);
  const int zoom = std::max({1, static_cast<int>(screen + 0.5), static_cast<int>(whole)});
  const auto& bodies = state.bodies;
  auto seen = std::find_if(bodies.begin(), bodies.end(),
                           [](const talus::Body& body) { return talus::traits_of(body.kind).takes_keys; });
  if (seen == bodies.end()) seen = bodies.begin();
  const talus::Rect box = bodies.empty() ? talus::Rect{area_.x, area_.y, 0, 0} : seen->box;
  left_ = follow(box.x + box.w / 2, left_, 1.0 * width / zoom, area_.x, area_.right());
  top_ = follow(box.y + box.h / 2, top_, 1.0 * height / zoom, area_.y, area_.bottom());
  painter.look_at({*left_, *top_}, zoom);
}

}  // namespace game
