#include "resize.h"

#include <algorithm>
#include <utility>

#include "transform.h"

namespace talus {
namespace {

int wrapped(int value, int period) { return (value % period + period) % period; }

class Resizer {
 public:
  Resizer(const Level& level, const MapFrame& frame)
      : level_(level),
        frame_(frame),
        period_{std::max(level.map.width(), frame.width), std::max(level.map.height(), frame.height)},
        result_{TileMap(frame.width, frame.height, level.map.tile_size()), level.layers, {}, {}, {}} {
    if (!frame.wrap) return;
    frame_.shift = {wrapped(frame.shift.x, period_.x), wrapped(frame.shift.y, period_.y)};
  }

  ResizedMap run() {
    shift_layers();
    for (const Spawn& spawn : level_.spawns) shift(spawn);
    for (const LevelCurve& curve : level_.curves) shift(curve);
    result_.objects = level_.objects;
    const Vec2 by = level_.map.corner_of(frame_.shift);
    for (ObjectLayer& layer : result_.objects) {
      if (layer.image) layer.offset = layer.offset + by;
      for (MapObject& object : layer.objects) object.position = object.position + by;
    }
    return std::move(result_);
  }

 private:
  void shift_layers() {
    for (int layer = 0; layer < level_.layers.count(); ++layer) {
      MapCells cells = shifted(level_.cells_of(layer));
      if (layer == level_.layers.chosen)
        result_.map.cells() = std::move(cells);
      else
        result_.layers.list[static_cast<std::size_t>(layer)].cells =
            std::make_shared<const MapCells>(std::move(cells));
    }
  }

  MapCells shifted(const MapCells& cells) {
    TileMap there(frame_.width, frame_.height, level_.map.tile_size());
    std::size_t i = 0;
    for (Cell from{0, 0}; from.y < level_.map.height(); ++from.y) {
      for (from.x = 0; from.x < level_.map.width(); ++from.x, ++i) {
        if (cells.tiles()[i] == 0) continue;
        Cell to{from.x + frame_.shift.x, from.y + frame_.shift.y};
        if (frame_.wrap) to = {to.x % period_.x, to.y % period_.y};
        if (there.contains(to))
          there.set(to, cells[i]);
        else
          ++result_.lost_tiles;
      }
    }
    return std::move(there.cells());
  }

  // The distances, px, that may lead something to its new place; with wrap, also to the other side.
  std::vector<Vec2> ways() const {
    const Vec2 by = level_.map.corner_of(frame_.shift);
    if (!frame_.wrap) return {by};
    const Vec2 back = level_.map.corner_of({-period_.x, -period_.y});
    return {by, by + Vec2{back.x, 0}, by + Vec2{0, back.y}, by + back};
  }

  static bool meets(const Spawn& spawn, Vec2 by, const TileMap& map) {
    const Vec2 at = spawn.position + by;
    return at.x < map.px_width() && at.y < map.px_height() && at.x + spawn.size.x > 0 &&
           at.y + spawn.size.y > 0;
  }

  void shift(const Spawn& spawn) {
    const std::vector<Vec2> all = ways();
    const auto lies_there = [&](Vec2 by) { return meets(spawn, by, result_.map); };
    // What lies across an edge belongs to the side of its corner, if possible.
    const auto lies_well = [&](Vec2 by) {
      const Vec2 at = spawn.position + by;
      return lies_there(by) && at.x >= 0 && at.y >= 0;
    };
    auto way = std::find_if(all.begin(), all.end(), lies_well);
    if (way == all.end()) way = std::find_if(all.begin(), all.end(), lies_there);
    if (way == all.end() && !meets(spawn, {}, level_.map)) way = all.begin();
    if (way == all.end()) {
      ++result_.lost_spawns;
      return;
    }
    result_.spawns.push_back(spawn);
    result_.spawns.back().position = spawn.position + *way;
  }

  void shift(const LevelCurve& curve) {
    const bool was_usable = !problem_of(curve.curve, level_.map);
    for (const Vec2 by : ways()) {
      const Curve there = moved(curve.curve, by);
      if (was_usable && problem_of(there, result_.map)) continue;
      result_.curves.push_back(curve);
      result_.curves.back().curve = there;
      return;
    }
    ++result_.lost_curves;
  }

  const Level& level_;
  MapFrame frame_;
  Cell period_;  // cells
  ResizedMap result_;
};

}  // namespace

ResizedMap resized(const Level& level, const MapFrame& frame) { return Resizer(level, frame).run(); }

}  // namespace talus
