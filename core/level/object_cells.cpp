// A vertical line through an outline meets an even number of its sides, and the ground is between the first
// and the second, the third and the fourth, and so on. So the part in a column of cells is made of chains,
// each between an upper and a lower line. A line gets a point at each border between rows, so that the cells
// above and below share it.
#include "object_cells.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr std::size_t kMaxPoints = 1024;                // of an outline
constexpr std::size_t kMaxCrossings = 4096;             // of an outline with itself
constexpr std::size_t kMaxWork = std::size_t{1} << 27;  // of all outlines
constexpr double kOnLine = 1.0 / (1 << 26);             // px; a point that is so near to a line is on it

double height_at(Vec2 from, Vec2 to, double x) {
  if (x <= from.x) return from.y;
  if (x >= to.x) return to.y;
  return from.y + (to.y - from.y) * ((x - from.x) / (to.x - from.x));
}

// Twice the area of the triangle.
double double_area(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// Takes out points that lie between their neighbours, or at the place of one, or where the outline turns
// back. Each point is taken out at most once, so that a long outline takes time by its length.
void simplify(std::vector<Vec2>& points) {
  const auto is_needless = [](Vec2 before, Vec2 at, Vec2 after) {
    return double_area(before, at, after) == 0;
  };
  std::vector<Vec2> kept;
  for (const Vec2 point : points) {
    while (kept.size() > 1 && is_needless(kept[kept.size() - 2], kept.back(), point)) kept.pop_back();
    kept.push_back(point);
  }
  std::size_t first = 0;  // the outline is closed: its ends are neighbours
  while (kept.size() - first > 2) {
    if (is_needless(kept[kept.size() - 2], kept.back(), kept[first]))
      kept.pop_back();
    else if (is_needless(kept.back(), kept[first], kept[first + 1]))
      ++first;
    else
      break;
  }
  points.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
  if (points.size() < 3) points.clear();
}

// The line as far as it is between two heights, and along them elsewhere.
std::vector<Vec2> between(const std::vector<Vec2>& line, double top, double bottom) {
  std::vector<Vec2> part;
  for (const Vec2 point : line) {
    const Vec2 next{point.x, std::clamp(point.y, top, bottom)};
    const std::size_t count = part.size();
    const bool goes_on = count > 1 && part[count - 2].y == next.y && part[count - 1].y == next.y;
    if (goes_on) part.pop_back();
    part.push_back(next);
  }
  return part;
}

// The heights of a line at an x: more than one where it is vertical.
struct Range {
  double least, most;
};
Range range_at(const std::vector<Vec2>& line, double x) {
  Range range{1e300, -1e300};
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].x != x) continue;
    range.least = std::min(range.least, line[i].y);
    range.most = std::max(range.most, line[i].y);
  }
  if (range.least <= range.most) return range;
  const auto after =
      std::upper_bound(line.begin(), line.end(), x, [](double at, Vec2 point) { return at < point.x; });
  const double y = height_at(*(after - 1), *after, x);
  return {y, y};
}

}  // namespace

ObjectCells::ObjectCells(const TileMap& map)
    : width_(map.width()),
      height_(map.height()),
      tile_(map.tile_size()),
      full_(static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height())) {}

bool ObjectCells::works(std::size_t steps) { return (work_ += steps) <= kMaxWork; }

bool ObjectCells::add(std::vector<Vec2> outline) {
  for (Vec2& point : outline) point = weld(point);
  simplify(outline);
  if (outline.empty()) return true;
  if (outline.size() > kMaxPoints || !works(outline.size() * outline.size())) return false;
  std::vector<OutlineLine> lines;
  std::vector<double> cuts;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    cuts.push_back(a.x);
    if (a.x == b.x) continue;
    lines.push_back(a.x < b.x ? line_between(a, b) : line_between(b, a));
    lines.back().precise = true;
  }
  crossings_.clear();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const OutlineLine &a = lines[i], &b = lines[j];
      const double x0 = std::max(a.x0, b.x0), x1 = std::min(a.x1, b.x1);
      if (x0 >= x1) continue;
      const double d0 = a.at(x0) - b.at(x0), d1 = a.at(x1) - b.at(x1);
      if (!(d0 < 0 && d1 > 0) && !(d0 > 0 && d1 < 0)) continue;
      crossings_.push_back(weld(x0 + (x1 - x0) * (d0 / (d0 - d1))));
      if (crossings_.size() > kMaxCrossings) return false;
    }
  }
  std::sort(crossings_.begin(), crossings_.end());
  cuts.insert(cuts.end(), crossings_.begin(), crossings_.end());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  const auto column_at = [&](double x) {
    return static_cast<int>(std::clamp(std::floor(x / tile_.width), -1.0, 1.0 * width_));
  };
  const int first = std::max(column_at(cuts.front()), 0), last = std::min(column_at(cuts.back()), width_ - 1);
  const auto columns = static_cast<std::size_t>(std::max(last - first + 1, 0));
  if (!works(columns * (lines.size() + cuts.size()) + cuts.size() * lines.size())) return false;
  double top = outline.front().y, bottom = top;
  for (const Vec2 point : outline) top = std::min(top, point.y), bottom = std::max(bottom, point.y);
  const double rows = std::min(1.0 * height_, (bottom - top) / tile_.height + 2);
  if (!works(columns * static_cast<std::size_t>(rows))) return false;
  for (int column = first; column <= last && work_ <= kMaxWork; ++column) add_column(lines, cuts, column);
  return work_ <= kMaxWork;
}

// The height at which a side is cut there.
double ObjectCells::cut_y(const OutlineLine& line, double x) const {
  const double y = line.at(x), welded = weld(y);
  const bool is_corner = std::abs(y - welded) <= kOnLine && std::fmod(welded, tile_.height) == 0;
  return is_corner || std::binary_search(crossings_.begin(), crossings_.end(), x) ? welded : y;
}

void ObjectCells::add_column(const std::vector<OutlineLine>& lines, const std::vector<double>& cuts,
                             int column) {
  const double left = static_cast<double>(column) * tile_.width, right = left + tile_.width;
  std::vector<double> xs = {std::max(left, cuts.front())};
  for (auto cut = std::upper_bound(cuts.begin(), cuts.end(), left); cut != cuts.end() && *cut < right; ++cut)
    if (*cut > xs.back()) xs.push_back(*cut);
  if (cuts.back() >= right) xs.push_back(right);
  here_.clear();
  for (const OutlineLine& line : lines)
    if (line.x0 < right && line.x1 > left) here_.push_back(&line);

  std::vector<Chain> open;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    const double x0 = xs[i], x1 = xs[i + 1], middle = (x0 + x1) / 2;
    std::vector<const OutlineLine*> met;
    for (const OutlineLine* line : here_)
      if (line->x0 <= x0 && line->x1 >= x1) met.push_back(line);
    std::stable_sort(met.begin(), met.end(), [&](const OutlineLine* a, const OutlineLine* b) {
      return a->at(middle) < b->at(middle);
    });
    if (!works(here_.size())) return;
    std::vector<Chain> next;
    for (std::size_t n = 0; n + 1 < met.size(); n += 2) {
      const auto at = [&](std::size_t line, double x) { return cut_y(*met[line], x); };
      const Vec2 u0{x0, at(n, x0)}, u1{x1, at(n, x1)};
      const Vec2 l0{x0, std::max(at(n + 1, x0), u0.y)}, l1{x1, std::max(at(n + 1, x1), u1.y)};
      const auto before = std::find_if(open.begin(), open.end(), [&](const Chain& chain) {
        return chain.upper.back() == u0 && chain.lower.back() == l0 && u0.y < l0.y;
      });
      Chain chain{{u0}, {l0}};
      if (before != open.end()) {
        chain = std::move(*before);
        open.erase(before);
      }
      chain.upper.push_back(u1);
      chain.lower.push_back(l1);
      next.push_back(std::move(chain));
    }
    for (const Chain& chain : open) add_chain(chain, column);
    open = std::move(next);
  }
  for (const Chain& chain : open) add_chain(chain, column);
}

// With a point at each border between rows.
ObjectCells::Points ObjectCells::with_borders(const Points& line) {
  Points all = {line.front()};
  const double bottom = static_cast<double>(height_) * tile_.height;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 from = line[i - 1], to = line[i];
    const double high = std::max(std::min(from.y, to.y), 0.0), low = std::min(std::max(from.y, to.y), bottom);
    const std::size_t first = all.size();
    if (!works(low > high ? static_cast<std::size_t>((low - high) / tile_.height) : 0)) return all;
    for (double row = std::ceil(high / tile_.height); row * tile_.height <= low; ++row) {
      const double y = row * tile_.height;
      if (y == from.y || y == to.y || from.y == to.y) continue;
      const double x = from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y)), welded = weld(x);
      const bool is_end = x - from.x <= kOnLine || to.x - x <= kOnLine;
      const bool is_corner = std::abs(x - welded) <= kOnLine && std::fmod(welded, tile_.width) == 0;
      all.push_back({is_end || is_corner ? std::clamp(welded, from.x, to.x) : x, y});
    }
    if (to.y < from.y) std::reverse(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
    all.push_back(to);
  }
  return all;
}

void ObjectCells::add_chain(const Chain& chain, int column) {
  const Points upper = with_borders(chain.upper), lower = with_borders(chain.lower);
  double top = upper.front().y, bottom = top;
  double inner_top = top, inner_bottom = lower.front().y;  // between them, all of its width is inside
  for (const Vec2 point : upper) top = std::min(top, point.y), inner_top = std::max(inner_top, point.y);
  for (const Vec2 p : lower) bottom = std::max(bottom, p.y), inner_bottom = std::min(inner_bottom, p.y);
  const double left = static_cast<double>(column) * tile_.width;
  const bool is_wide = upper.front().x == left && upper.back().x == left + tile_.width;
  const auto row_at = [&](double row) { return static_cast<int>(std::clamp(row, 0.0, 1.0 * height_)); };
  const int end = row_at(std::ceil(bottom / tile_.height));
  for (Cell cell{column, row_at(std::floor(top / tile_.height))}; cell.y < end; ++cell.y) {
    const double y = static_cast<double>(cell.y) * tile_.height;
    const auto at = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(cell.x);
    if (full_[at]) continue;
    if (is_wide && inner_top <= y && inner_bottom >= y + tile_.height) {
      full_[at] = true;
      parts_.erase(at);
      continue;
    }
    if (!works(upper.size() + lower.size())) return;
    add_row(upper, lower, cell);
  }
}

// The parts of a chain in a row, one for each stretch of x in which it has a height there.
void ObjectCells::add_row(const Points& whole_upper, const Points& whole_lower, Cell cell) {
  const double y0 = static_cast<double>(cell.y) * tile_.height, y1 = y0 + tile_.height;
  const Points upper = between(whole_upper, y0, y1), lower = between(whole_lower, y0, y1);
  std::vector<double> xs;
  for (const Vec2 point : upper) xs.push_back(point.x);
  for (const Vec2 point : lower) xs.push_back(point.x);
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  std::size_t begin = xs.size();
  const auto close = [&](std::size_t end) {
    if (begin < end) add_part(upper, lower, xs[begin], xs[end], cell);
    begin = xs.size();
  };
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    const double middle = (xs[i] + xs[i + 1]) / 2;
    const bool is_inside = range_at(upper, middle).least < y1 && range_at(lower, middle).most > y0;
    const bool is_tip = range_at(upper, xs[i]).most >= range_at(lower, xs[i]).least;
    if (!is_inside || is_tip) close(i);
    if (is_inside && begin == xs.size()) begin = i;
  }
  close(xs.size() - 1);
}

void ObjectCells::add_part(const Points& upper, const Points& lower, double from, double to, Cell cell) {
  const Vec2 corner{static_cast<double>(cell.x) * tile_.width, static_cast<double>(cell.y) * tile_.height};
  const auto along = [&](const Points& line) {
    Points part;
    const auto is_end = [&](double x) {
      return std::any_of(line.begin(), line.end(), [x](Vec2 p) { return p.x == x; });
    };
    if (!is_end(from)) part.push_back({from, range_at(line, from).least});
    for (const Vec2 point : line)
      if (point.x >= from && point.x <= to) part.push_back(point);
    if (!is_end(to)) part.push_back({to, range_at(line, to).least});
    return part;
  };
  Points polygon = along(upper), below = along(lower);
  polygon.insert(polygon.end(), below.rbegin(), below.rend());
  simplify(polygon);
  if (polygon.empty()) return;
  Part part;
  const bool is_welded =
      std::all_of(polygon.begin(), polygon.end(), [](Vec2 point) { return weld(point) == point; });
  if (!is_welded && !works(polygon.size() * here_.size())) return;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    part.points.push_back(a - corner);
    if (is_welded) continue;
    const bool is_forward = a.x < b.x || (a.x == b.x && a.y < b.y);
    Segment line = is_forward ? Segment{a, b} : Segment{b, a};
    if (const OutlineLine* whole = line_through(a, b))
      line = {{whole->x0, whole->y0}, {whole->x1, whole->y1}};
    part.lines.push_back({line.from - corner, line.to - corner});
  }
  const auto at =
      static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(cell.x);
  parts_[at].push_back(std::move(part));
}

// The side that both points lie on; null if there is none.
const OutlineLine* ObjectCells::line_through(Vec2 a, Vec2 b) const {
  if (a.x == b.x) return nullptr;
  const auto is_on = [](const OutlineLine& line, Vec2 p) {
    return line.x0 <= p.x && p.x <= line.x1 && std::abs(line.at(p.x) - p.y) <= kOnLine;
  };
  const auto found = std::find_if(here_.begin(), here_.end(), [&](const OutlineLine* line) {
    return is_on(*line, a) && is_on(*line, b);
  });
  return found == here_.end() ? nullptr : *found;
}

}  // namespace talus
