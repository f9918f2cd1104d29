#include "raw_ground.h"

#include <cmath>
#include <map>
#include <utility>

#include "collision/outline_compiler.h"

namespace talus {
namespace {

__extension__ using Wide = __int128;  // products of two lengths

constexpr Fine kFineWeld = kFinePx / kWeldParts;

Fine welded(double px) { return fine(weld(px)); }

// Rounded down; divisor > 0.
template <class Number>
Fine floor_of(Number number, Number divisor) {
  return static_cast<Fine>(number >= 0 ? number / divisor : -((-number + divisor - 1) / divisor));
}

// The sign of y minus the height of a straight line at x; the line goes on beyond its ends.
int side_of(const RawLine& line, Fine x, Fine y) {
  const Wide left = Wide{y - line.y0} * (line.x1 - line.x0), right = Wide{x - line.x0} * (line.y1 - line.y0);
  return left < right ? -1 : left > right ? 1 : 0;
}

RawLine line_from(Fine x0, Fine y0, Fine x1, Fine y1) { return {x0, y0, x1, y1}; }

void add(std::vector<RawPart>& out, const TileShape& shape, const RawLine& top, const RawLine& bottom) {
  const bool is_floor = shape.side == TileShape::Side::floor;
  if (!shape.one_way) {
    out.push_back({RawPart::Kind::solid, top, bottom});
  } else {
    const RawLine& line = is_floor ? top : bottom;
    out.push_back({is_floor ? RawPart::Kind::floor : RawPart::Kind::ceiling, line, line});
  }
}

void add_full(std::vector<RawPart>& out, const TileShape& shape, TileSize tile) {
  const Fine w = tile.width * kFinePx, h = tile.height * kFinePx;
  add(out, shape, line_from(0, 0, w, 0), line_from(0, h, w, h));
}

void add_heights(std::vector<RawPart>& out, const TileShape& shape, TileSize tile) {
  const bool is_floor = shape.side == TileShape::Side::floor;
  const Fine base = is_floor ? tile.height * kFinePx : 0;
  const double width = 1.0 * shape.tiles * tile.width, parts = static_cast<double>(shape.heights.size() - 1);
  for (std::size_t i = 0; i + 1 < shape.heights.size(); ++i) {
    const Fine x0 = welded(width * static_cast<double>(i) / parts);
    const Fine x1 = welded(width * static_cast<double>(i + 1) / parts);
    const Fine h0 = welded(shape.heights[i]), h1 = welded(shape.heights[i + 1]);
    if (x0 == x1 || (h0 == 0 && h1 == 0 && !shape.one_way)) continue;
    const RawLine line = is_floor ? line_from(x0, base - h0, x1, base - h1) : line_from(x0, h0, x1, h1);
    const RawLine flat = line_from(x0, base, x1, base);
    add(out, shape, is_floor ? line : flat, is_floor ? flat : line);
  }
}

// Cuts a polygon at the x of its points. Between two of them its sides do not meet, so every other space
// between two sides, from the top, is ground.
void add_polygon(std::vector<RawPart>& out, const TileShape& shape) {
  std::vector<RawLine> sides;
  std::vector<Fine> cuts;
  const auto point = [&](std::size_t i) {
    return shape.lines.empty() ? weld(shape.points[i]) : shape.points[i];
  };
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    const Vec2 a = point(i), b = point((i + 1) % shape.points.size());
    cuts.push_back(fine(a.x));
    if (a.x == b.x) continue;
    const Vec2 &first = a.x < b.x ? a : b, &second = a.x < b.x ? b : a;
    sides.push_back(line_from(fine(first.x), fine(first.y), fine(second.x), fine(second.y)));
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Fine from = cuts[i], to = cuts[i + 1], middle = from + (to - from) / 2;
    std::vector<RawLine> here;
    for (const RawLine& side : sides)
      if (side.x0 <= from && side.x1 >= to) here.push_back(side);
    std::sort(here.begin(), here.end(), [&](const RawLine& a, const RawLine& b) {
      return a.at(middle) != b.at(middle) ? a.at(middle) < b.at(middle)
                                          : a.at(from) + a.at(to) < b.at(from) + b.at(to);
    });
    for (std::size_t side = 0; side + 1 < here.size(); side += 2) {
      const auto cut = [&](const RawLine& line) { return line_from(from, line.at(from), to, line.at(to)); };
      add(out, shape, cut(here[side]), cut(here[side + 1]));
    }
  }
}

int cells_beyond(Fine length, Fine tile) {
  return length <= 0 ? 0 : static_cast<int>((length + tile - 1) / tile);
}

constexpr double kUpright = 64;  // |dy/dx| of a curve that is a wall

// The free ends of lines that stop bodies from both sides: an end stops what comes from the side, too.
std::vector<RawPart> free_ends(std::span<const Piece<double>> pieces) {
  struct Ends {
    bool floor = false, ceiling = false;  // begin, or end, there
  };
  std::map<std::pair<double, double>, Ends> first, last;
  for (const Piece<double>& piece : pieces) {
    if (piece.is_wall()) continue;
    for (Ends* ends : {&first[{piece.x0, piece.y0}], &last[{piece.x1, piece.y1}]})
      (piece.facing == Facing::up ? ends->floor : ends->ceiling) = true;
  }
  std::vector<RawPart> parts;
  const auto add_free = [&](const auto& ends, const auto& others, RawPart::Kind kind) {
    for (const auto& [point, end] : ends) {
      if (!end.floor || !end.ceiling || others.contains(point)) continue;
      const Fine x = fine(point.first), y = fine(point.second);
      parts.push_back({kind, line_from(x, y, x, y), line_from(x, y, x, y)});
    }
  };
  add_free(first, last, RawPart::Kind::left);
  add_free(last, first, RawPart::Kind::right);
  return parts;
}

}  // namespace

Fine RawLine::at(Fine x) const {
  if (x <= x0) return y0;
  if (x >= x1) return y1;
  if (curve != nullptr) return std::clamp(fine(curve->y_at(px_of(x))), std::min(y0, y1), std::max(y0, y1));
  if (y0 == y1) return y0;
  // Of most lines the product fits into 64 bits, where a division is much quicker.
  constexpr Fine kShort = Fine{1} << 31;
  const Fine width = x1 - x0, height = y1 - y0;
  if (width < kShort && std::abs(height) < kShort) return y0 + floor_of<Fine>((x - x0) * height, width);
  return y0 + floor_of<Wide>(Wide{x - x0} * height, width);
}

bool RawLine::is_steeper_than(double limit, Fine x) const {
  if (x0 == x1) return true;
  if (curve == nullptr) return std::abs(static_cast<double>(y1 - y0)) > limit * static_cast<double>(x1 - x0);
  const Vec2 along = curve->tangent_at(px_of(std::clamp(x, x0, x1)));
  return std::abs(along.y) > limit * std::abs(along.x);
}

bool RawLine::is_upright_curve(Fine x) const { return curve != nullptr && is_steeper_than(kUpright, x); }

bool RawPart::meets(const FineBox& box) const {
  const bool is_wall = top.x0 == top.x1;
  const bool is_beside =
      is_wall ? top.x0 <= box.x0 || top.x0 >= box.x1 : top.x0 >= box.x1 || top.x1 <= box.x0;
  if (is_beside || std::min(top.y0, top.y1) >= box.y1 || std::max(bottom.y0, bottom.y1) <= box.y0)
    return false;
  if (is_wall) return true;
  const Fine from = std::max(top.x0, box.x0), to = std::min(top.x1, box.x1);
  if (top.curve != nullptr) return top.highest(from, to) < box.y1 && top.lowest(from, to) > box.y0;
  // Two convex figures are apart only if a side of one of them has the other one behind it.
  const bool below_top = side_of(top, top.y1 > top.y0 ? box.x0 : box.x1, box.y1) > 0;
  return below_top && side_of(bottom, bottom.y1 > bottom.y0 ? box.x1 : box.x0, box.y0) < 0;
}

bool RawPart::stops(const FineBox& from, const FineBox& to) const {
  if (kind == Kind::left || kind == Kind::right) {
    // The middle of a body, which is a line, may be just at a wall, and pass it whole.
    const FineBox swept{std::min(from.x0, to.x0), to.y0, std::max(from.x1, to.x1), to.y1};
    const bool faces = kind == Kind::left ? to.x0 > from.x0 && top.x0 >= from.x1 - 1
                                          : to.x0 < from.x0 && top.x0 <= from.x0 + 1;
    return faces && meets(swept);
  }
  if (!meets(to)) return false;
  if (kind == Kind::solid) return true;
  // A curve has a slope of its own at each place: all that counts is on which side the body comes from. Where
  // it is upright, as at the end of a semicircle, a body beside it is in it by rounding.
  const Fine x0 = std::max(from.x0, top.x0), x1 = std::min(from.x1, top.x1);
  if (top.curve != nullptr && x0 <= x1) {
    const Fine depth = kind == Kind::floor ? from.y1 - top.highest(x0, x1) : top.lowest(x0, x1) - from.y0;
    return depth <= (top.is_upright_curve(x0) ? kFinePx / kWeldParts : 0);
  }
  if (meets(from)) return false;
  const Wide dx = to.x0 - from.x0, dy = to.y0 - from.y0;
  // Against the normal, which points up from a floor, or against an end.
  const Wide into = dy * (top.x1 - top.x0) - dx * (top.y1 - top.y0);
  return kind == Kind::floor ? into > 0 || dy > 0 : into < 0 || dy < 0;
}

RawGround::RawGround(const TerrainSource& source)
    : width_(source.width),
      height_(source.height),
      tile_(source.tile),
      tile_width_(source.tile.width * kFinePx),
      tile_height_(source.tile.height * kFinePx),
      cells_(source.cells.begin(), source.cells.end()) {
  first_.push_back(0);
  for (const TileShape& shape : source.shapes) {
    add_shape(shape);
    first_.push_back(static_cast<std::uint32_t>(parts_.size()));
  }
  for (const RawPart& part : parts_) {
    left_ = std::max(left_, cells_beyond(-part.top.x0, tile_width_));
    right_ = std::max(right_, cells_beyond(part.top.x1 - tile_width_, tile_width_));
    up_ = std::max(up_, cells_beyond(-std::min(part.top.y0, part.top.y1), tile_height_));
    down_ =
        std::max(down_, cells_beyond(std::max(part.bottom.y0, part.bottom.y1) - tile_height_, tile_height_));
  }
  add_curves(source.curves);
}

bool RawGround::is_same_in(const RawGround& other, Cell first, Cell last) const {
  first = {std::max(first.x, 0), std::max(first.y, 0)};
  last = {std::min(last.x, width_ - 1), std::min(last.y, height_ - 1)};
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      const std::span<const RawPart> here = parts_in(x, y), there = other.parts_in(x, y);
      if (!std::equal(here.begin(), here.end(), there.begin(), there.end())) return false;
    }
  }
  const FineBox area{first.x * tile_width_, first.y * tile_height_, (last.x + 1) * tile_width_,
                     (last.y + 1) * tile_height_};
  const auto curves_of = [&](const RawGround& ground) {
    std::vector<RawPart> curves;
    if (ground.curves_.empty()) return curves;
    ground.for_curves(area, [&](const RawPart& part) {
      if (touches(part, area)) curves.push_back(part);
      return true;
    });
    return curves;
  };
  return curves_of(*this) == curves_of(other);
}

void RawGround::add_shape(const TileShape& shape) {
  switch (shape.kind) {
    case TileShape::Kind::none:
      break;
    case TileShape::Kind::solid:
      add_full(parts_, shape, tile_);
      break;
    case TileShape::Kind::slope:
    case TileShape::Kind::profile:
      add_heights(parts_, shape, tile_);
      break;
    case TileShape::Kind::polygon:
      add_polygon(parts_, shape);
      break;
    case TileShape::Kind::group:
      for (const TileShape& part : shape.parts) add_shape(part);
      break;
  }
}

// The part of a line between the map's upper and lower edge, beyond which nothing stops bodies.
std::optional<RawLine> RawGround::between_edges(const RawLine& line) const {
  const Fine lowest = height_ * tile_height_;
  if (has_row_at(line.y0) && has_row_at(line.y1)) return line;
  if (std::max(line.y0, line.y1) < 0 || std::min(line.y0, line.y1) > lowest) return std::nullopt;
  if (line.x0 == line.x1)
    return RawLine{line.x0, std::clamp<Fine>(line.y0, 0, lowest), line.x1,
                   std::clamp<Fine>(line.y1, 0, lowest), nullptr};
  const bool falls = line.y0 < line.y1;
  // Where it comes from an end to the edge beyond which that end is.
  const auto cut = [&](Fine from, Fine to, Fine edge, bool begins_above) {
    while (std::abs(to - from) > 1) {
      const Fine middle = from + (to - from) / 2;
      (begins_above == (line.at(middle) < edge) ? from : to) = middle;
    }
    return to;
  };
  RawLine between = line;
  if (!has_row_at(line.y0)) between.x0 = cut(line.x0, line.x1, falls ? 0 : lowest, falls);
  if (!has_row_at(line.y1)) between.x1 = cut(line.x1, line.x0, falls ? lowest : 0, !falls);
  between.y0 = std::clamp<Fine>(line.at(between.x0), 0, lowest);
  between.y1 = std::clamp<Fine>(line.at(between.x1), 0, lowest);
  return between;
}

// Where a curve runs at an x is computed as the solvers do; everything else about it is not.
void RawGround::add_curves(std::span<const Curve> curves) {
  if (curves.empty()) return;
  CurveOutline outline = cut_curves(curves);
  stretches_ = std::make_shared<const std::vector<CurveStretch<double>>>(std::move(outline.stretches));
  curves_in_.resize(static_cast<std::size_t>(width_));
  const auto add = [&](RawPart part) {
    const auto line = between_edges(part.top);
    if (!line) return;
    part.top = part.bottom = *line;
    const int from = std::clamp(column_of(part.top.x0), 0, width_ - 1);
    const int to = std::clamp(column_of(part.top.x1), 0, width_ - 1);
    for (int column = from; column <= to; ++column)
      curves_in_[static_cast<std::size_t>(column)].push_back(static_cast<std::uint32_t>(curves_.size()));
    curves_.push_back(part);
  };
  for (const Piece<double>& piece : outline.pieces) {
    const RawLine line{fine(piece.x0), fine(piece.y0), fine(piece.x1), fine(piece.y1),
                       piece.stretch == 0 ? nullptr : &(*stretches_)[piece.stretch - 1]};
    constexpr RawPart::Kind kinds[] = {RawPart::Kind::floor, RawPart::Kind::ceiling, RawPart::Kind::left,
                                       RawPart::Kind::right};
    add({kinds[static_cast<int>(piece.facing)], line, line});
  }
  for (const RawPart& end : free_ends(outline.pieces)) add(end);
}

}  // namespace talus
