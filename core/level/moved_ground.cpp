// Marks are cells at the sides of what is painted: where ground begins and ends tells most about its place.
#include "moved_ground.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "level_text.h"
#include "resize.h"
#include "transform.h"

namespace talus {
namespace {

// The cells of a layer by their places.
class MarkedCells {
 public:
  MarkedCells(const Level& level, int layer)
      : map_(level.map), cells_(level.cells_of(layer)), width_(static_cast<std::size_t>(map_.width())) {}

  bool contains(Cell c) const { return map_.contains(c); }
  MapCell at(Cell c) const {
    return cells_[static_cast<std::size_t>(c.y) * width_ + static_cast<std::size_t>(c.x)];
  }
  // The places whose cell differs from the one `step` before it.
  std::vector<Cell> sides(Cell step) const {
    std::vector<Cell> places;
    for (Cell c{0, step.y}; c.y < map_.height(); ++c.y) {
      for (c.x = step.x; c.x < map_.width(); ++c.x) {
        if (at(c) != at({c.x - step.x, c.y - step.y})) places.push_back(c);
      }
    }
    return places;
  }

 private:
  const TileMap& map_;
  const MapCells& cells_;
  std::size_t width_;
};

int layer_with_most_tiles(const Level& level) {
  int best = 0;
  std::ptrdiff_t most = -1;
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const std::vector<TileNumber>& tiles = level.cells_of(layer).tiles();
    const std::ptrdiff_t count = std::ssize(tiles) - std::count(tiles.begin(), tiles.end(), TileNumber{0});
    if (count > most) best = layer, most = count;
  }
  return best;
}

// How the marks lie on the ground when they are shifted.
struct MarkFit {
  int fitting = 0, others = 0;
  // Whether so many fit that another place is not likely.
  bool is_close() const { return fitting >= 3 * others && fitting > 0; }
};

// Stops where it has more than `most` that do not fit.
MarkFit fit_of(const std::vector<GroundMark>& marks, Cell by, const MarkedCells& cells, int most) {
  MarkFit fit;
  for (const GroundMark& mark : marks) {
    const Cell place{mark.place.x + by.x, mark.place.y + by.y};
    if (!cells.contains(place)) continue;
    ++(cells.at(place) == mark.cell ? fit.fitting : fit.others);
    if (fit.others > most) break;
  }
  return fit;
}

// The shift of a map with another size: no further than its size has changed.
Cell shift_by_size(const GroundPlace& before, const Level& now) {
  constexpr std::int64_t kMaxTries = 1 << 20;
  const Cell grown{now.map.width() - before.width, now.map.height() - before.height};
  const MarkedCells cells(now, std::min(before.layer, now.layers.count() - 1));
  Cell best{0, 0};
  int fewest = fit_of(before.marks, best, cells, static_cast<int>(kMaxGroundMarks)).others;
  const auto look_at = [&](Cell by) {
    if (fewest == 0) return;
    const MarkFit fit = fit_of(before.marks, by, cells, fewest - 1);
    if (fit.others >= fewest || !fit.is_close()) return;
    best = by;
    fewest = fit.others;
  };
  for (const Cell corner : {grown, Cell{grown.x, 0}, Cell{0, grown.y}}) look_at(corner);
  if ((std::abs(grown.x) + std::int64_t{1}) * (std::abs(grown.y) + std::int64_t{1}) > kMaxTries) return best;
  for (int y = std::min(0, grown.y); y <= std::max(0, grown.y); ++y)
    for (int x = std::min(0, grown.x); x <= std::max(0, grown.x); ++x) look_at({x, y});
  return best;
}

// The shifts that bring a pair of marks onto a side of the ground: those of the pair with the fewest such
// sides first, as many as kMaxTries. Marks lie beside each other as add_marks() makes them.
std::vector<Cell> shifts_onto_sides(const std::vector<GroundMark>& marks, const MarkedCells& cells) {
  constexpr std::size_t kMaxTries = 4096;
  std::vector<std::vector<Cell>> by_pair;
  for (const Cell step : {Cell{1, 0}, Cell{0, 1}}) {
    std::map<std::pair<MapCell, MapCell>, std::vector<Cell>> places;
    const auto is_pair = [&](std::size_t i) {
      return marks[i].place.x + step.x == marks[i + 1].place.x &&
             marks[i].place.y + step.y == marks[i + 1].place.y;
    };
    for (std::size_t i = 0; i + 1 < marks.size(); ++i)
      if (is_pair(i)) places[{marks[i].cell, marks[i + 1].cell}];
    for (const Cell place : cells.sides(step)) {
      const auto found = places.find({cells.at({place.x - step.x, place.y - step.y}), cells.at(place)});
      if (found != places.end() && found->second.size() < kMaxTries) found->second.push_back(place);
    }
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
      if (!is_pair(i)) continue;
      std::vector<Cell>& shifts = by_pair.emplace_back(places[{marks[i].cell, marks[i + 1].cell}]);
      for (Cell& shift : shifts) shift = {shift.x - marks[i + 1].place.x, shift.y - marks[i + 1].place.y};
    }
  }
  std::stable_sort(by_pair.begin(), by_pair.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<Cell> shifts;
  for (const std::vector<Cell>& some : by_pair) {
    if (shifts.size() + some.size() > kMaxTries) break;
    shifts.insert(shifts.end(), some.begin(), some.end());
  }
  return shifts;
}

// The shift of a map of the same size, whose cells another program moved. It must explain far more than cells
// that were painted anew would: nearly all marks fit there, and many do not fit where they were.
Cell shift_in_place(const GroundPlace& before, const Level& now) {
  constexpr int kFewestFitting = 12;
  const MarkedCells cells(now, std::min(before.layer, now.layers.count() - 1));
  const int count = static_cast<int>(before.marks.size());
  int fewest = fit_of(before.marks, {0, 0}, cells, count).others;
  if (4 * fewest <= count) return {0, 0};
  Cell best{0, 0};
  for (const Cell by : shifts_onto_sides(before.marks, cells)) {
    const MarkFit fit = fit_of(before.marks, by, cells, fewest - 1);
    if (fit.others >= fewest || fit.fitting < std::max(kFewestFitting, 8 * fit.others) ||
        2 * fit.fitting < count)
      continue;
    best = by;
    fewest = fit.others;
    if (fewest == 0) break;
  }
  return best;
}

// Adds some of the places, from the first to the last.
void add_marks(const std::vector<Cell>& places, Cell step, const MarkedCells& cells,
               std::vector<GroundMark>& marks) {
  constexpr std::size_t kMax = 16;
  const std::size_t count = std::min(places.size(), kMax);
  for (std::size_t i = 0; i < count; ++i) {
    const Cell place = places[count == 1 ? 0 : i * (places.size() - 1) / (count - 1)];
    const Cell other{place.x - step.x, place.y - step.y};
    marks.push_back({other, cells.at(other)});
    marks.push_back({place, cells.at(place)});
  }
}

std::string words_for_way(int cells, const char* noun, const char* less, const char* more) {
  return count_text(static_cast<std::size_t>(std::abs(cells)), noun) + " further " +
         (cells > 0 ? less : more);
}

}  // namespace

GroundPlace ground_place(const Level& level) {
  GroundPlace place{{}, level.map.width(), level.map.height(), layer_with_most_tiles(level), {}};
  if (level.tiled) place.origin = Cell{level.tiled->frame.x, level.tiled->frame.y};
  const std::vector<TileNumber>& tiles = level.cells_of(place.layer).tiles();
  if (std::all_of(tiles.begin(), tiles.end(), [](TileNumber tile) { return tile == 0; })) return place;
  const MarkedCells cells(level, place.layer);
  for (const Cell step : {Cell{1, 0}, Cell{0, 1}}) add_marks(cells.sides(step), step, cells, place.marks);
  for (const int y : {0, place.height - 1})
    for (const int x : {0, place.width - 1}) place.marks.push_back({{x, y}, cells.at({x, y})});
  return place;
}

Cell ground_shift(const GroundPlace& before, const Level& now) {
  if (before.origin && now.tiled) {
    const TiledFrame& frame = now.tiled->frame;
    const Cell by{before.origin->x - frame.x, before.origin->y - frame.y};
    // Only an infinite map, which says where each of its cells is, begins elsewhere and has all of the old.
    const bool has_old = by.x >= 0 && by.y >= 0 && by.x + before.width <= now.map.width() &&
                         by.y + before.height <= now.map.height();
    if (has_old && by != Cell{0, 0}) return by;
  }
  if (before.marks.empty()) return {0, 0};
  const bool has_size = before.width == now.map.width() && before.height == now.map.height();
  return has_size ? shift_in_place(before, now) : shift_by_size(before, now);
}

Cell growth_at_corner(const GroundPlace& before, const TileMap& now, Cell by) {
  return before.width == now.width() && before.height == now.height() ? Cell{0, 0} : by;
}

Level with_moved_ground(const Level& level, Cell by, int width, int height) {
  ResizedMap there = resized(level, {width, height, by});
  Level moved_level = level;
  moved_level.map = std::move(there.map);
  moved_level.layers = std::move(there.layers);
  moved_level.objects = std::move(there.objects);
  const Vec2 px = level.map.corner_of(by);
  for (Spawn& spawn : moved_level.spawns) spawn.position = spawn.position + px;
  for (LevelCurve& curve : moved_level.curves) curve.curve = moved(curve.curve, px);
  return moved_level;
}

std::string words_for_shift(Cell by) {
  const std::string x = by.x == 0 ? "" : words_for_way(by.x, "column", "left", "right");
  const std::string y = by.y == 0 ? "" : words_for_way(by.y, "row", "up", "down");
  return x + (x.empty() || y.empty() ? "" : " and ") + y;
}

}  // namespace talus
