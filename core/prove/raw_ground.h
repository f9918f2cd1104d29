// RawGround: the ground as a level gives it, one tile beside the other, for questions with exact answers. It
// shares nothing with the outline that the solvers use, so that it can judge them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <talus/collision/terrain.h>

namespace talus {

// A length in 2^-24 px. Ends of lines are multiples of 1/256 px, and so are whole numbers of these; places of
// bodies are rounded to them. All comparisons with straight lines are exact.
using Fine = std::int64_t;
inline constexpr int kFineBits = 24;
inline constexpr Fine kFinePx = Fine{1} << kFineBits;
// Rounded to the nearest; px: finite, at most 2^38. std::llround is a call, and a proof asks for this most of
// all.
inline Fine fine(double px) {
  const double length = px * static_cast<double>(kFinePx);
  return static_cast<Fine>(length + (length < 0 ? -0.5 : 0.5));
}
inline double px_of(Fine length) { return static_cast<double>(length) / static_cast<double>(kFinePx); }

struct FineBox {
  Fine x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  Fine middle() const { return x0 + (x1 - x0) / 2; }
  FineBox middle_line() const { return {middle() - 1, y0, middle() + 1, y1}; }
  FineBox moved(Fine dx, Fine dy) const { return {x0 + dx, y0 + dy, x1 + dx, y1 + dy}; }
  FineBox shrunk(Fine by) const { return {x0 + by, y0 + by, x1 - by, y1 - by}; }
};
inline FineBox fine_box(const Rect& box) {
  const Fine x = fine(box.x), y = fine(box.y);
  return {x, y, x + fine(box.w), y + fine(box.h)};
}
// The smallest box around two others.
inline FineBox hull(const FineBox& a, const FineBox& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// A straight line, or a stretch of a curve that rises or falls throughout; x0 <= x1.
struct RawLine {
  Fine x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  const CurveStretch<double>* curve = nullptr;  // null: a straight line

  RawLine moved(Fine dx, Fine dy) const { return {x0 + dx, y0 + dy, x1 + dx, y1 + dy, curve}; }
  Fine at(Fine x) const;  // its y, rounded down (upwards on the screen); beyond its ends that of the end
  // Its highest or lowest y between two x, which meet it.
  Fine highest(Fine from, Fine to) const { return std::min(at(from), at(to)); }
  Fine lowest(Fine from, Fine to) const { return std::max(at(from), at(to)); }
  bool is_steeper_than(double limit, Fine x) const;  // |dy/dx| at x
  bool is_upright_curve(Fine x) const;               // whether it is a curve that is like a wall at x
  bool is_level_at(Fine y) const { return y0 == y && y1 == y && curve == nullptr; }
  friend bool operator==(const RawLine&, const RawLine&) = default;
};

// A part of the ground.
struct RawPart {
  enum class Kind : std::uint8_t {
    solid,    // what is between `top` and `bottom`
    floor,    // `top` alone, which stops what comes from above
    ceiling,  // the same from below
    left,     // a vertical line that stops what comes from the left
    right     // the same from the right
  };
  Kind kind = Kind::solid;
  RawLine top, bottom;  // with the same x; of a line alone both are the line

  // Whether its upper or its lower side is not level.
  bool is_sloped() const { return top.y0 != top.y1 || bottom.y0 != bottom.y1; }
  bool is_floor() const { return kind == Kind::solid || kind == Kind::floor; }
  RawPart moved(Fine dx, Fine dy) const { return {kind, top.moved(dx, dy), bottom.moved(dx, dy)}; }
  // Whether its inside, or for a line a point of it, is inside of the box.
  bool meets(const FineBox& box) const;
  // Whether a box that goes straight from one place to another is stopped by it. What it is in already does
  // not stop it if it is a line.
  bool stops(const FineBox& from, const FineBox& to) const;
  friend bool operator==(const RawPart&, const RawPart&) = default;
};

class RawGround {
 public:
  // Copies what it needs.
  explicit RawGround(const TerrainSource& source);

  int columns() const { return width_; }
  int rows() const { return height_; }
  TileSize tile_size() const { return tile_; }
  // The number of the shape in a cell; 0 outside of the map.
  TileNumber number_at(Cell cell) const {
    const bool is_inside = cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_;
    return is_inside ? cells_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(cell.x)]
                     : TileNumber{0};
  }
  // Whether a line that is free of the grid may meet the area.
  bool has_curve_in(const FineBox& area) const {
    return !curves_.empty() && !for_curves(area, [&](const RawPart& part) { return !touches(part, area); });
  }

  // Whether there may be ground at that y.
  bool has_row_at(Fine y) const { return y >= 0 && y <= height_ * tile_height_; }
  bool is_solid_at(Fine x, Fine y) const {
    const FineBox point{x - 1, y - 1, x + 1, y + 1};
    return !for_parts(
        point, [&](const RawPart& part) { return part.kind != RawPart::Kind::solid || !part.meets(point); });
  }

  // Calls use(part) for each part that may meet the area, or touch it. use returns false to end the search;
  // then for_parts() does.
  template <class Use>
  bool for_parts(const FineBox& area, Use use) const {
    // What ends at the border of a cell touches the next one.
    const int first_column = column_of(area.x0 - 1) - right_, last_column = column_of(area.x1) + left_;
    const int first_row = row_of(area.y0 - 1) - down_, last_row = row_of(area.y1) + up_;
    // Whether a part of one of the cells may touch an edge of the map, or reach over it.
    const bool may_leave_map = first_column < left_ || last_column + right_ >= width_ || first_row <= up_ ||
                               last_row + down_ + 1 >= height_;
    for (int y = std::max(first_row, 0); y <= std::min(last_row, height_ - 1); ++y) {
      for (int x = std::max(first_column, 0); x <= std::min(last_column, width_ - 1); ++x) {
        const std::span<const RawPart> parts = parts_in(x, y);
        if (parts.empty()) continue;
        const Fine cell_x = x * tile_width_, cell_y = y * tile_height_;
        const FineBox from_cell = area.moved(-cell_x, -cell_y);
        for (const RawPart& part : parts) {
          if (!touches(part, from_cell)) continue;
          RawPart here = part.moved(cell_x, cell_y);
          if (may_leave_map) {
            here = on_map(here);
            if (is_empty(here) || !touches(here, area)) continue;
          }
          if (!use(here)) return false;
        }
      }
    }
    return curves_.empty() ||
           for_curves(area, [&](const RawPart& part) { return !touches(part, area) || use(part); });
  }

  // Whether a ground of the same size is the same in these cells, which are clamped to the map. Round curves
  // are never the same.
  bool is_same_in(const RawGround& other, Cell first, Cell last) const;

 private:
  static bool touches(const RawPart& part, const FineBox& area) {
    return part.top.x0 <= area.x1 && part.top.x1 >= area.x0 &&
           std::min(part.top.y0, part.top.y1) <= area.y1 &&
           std::max(part.bottom.y0, part.bottom.y1) >= area.y0;
  }
  static bool is_empty(const RawPart& part) {
    return part.top.x0 > part.top.x1 || (part.kind == RawPart::Kind::solid && part.top.x0 == part.top.x1);
  }
  // A part without what reaches over the left or the right edge of the map, where nothing stops bodies; empty
  // if that is all of it, or if it is a level line that counts to the row outside of the map.
  RawPart on_map(const RawPart& part) const {
    const Fine end = width_ * tile_width_;
    const bool is_outside =
        (part.kind == RawPart::Kind::floor && part.top.is_level_at(height_ * tile_height_)) ||
        (part.kind == RawPart::Kind::ceiling && part.bottom.is_level_at(0));
    if (part.top.x0 >= 0 && part.top.x1 <= end && !is_outside) return part;
    const Fine x0 = std::max<Fine>(part.top.x0, 0), x1 = is_outside ? x0 - 1 : std::min(part.top.x1, end);
    const auto cut = [&](const RawLine& line) {
      return RawLine{x0, line.at(x0), x1, line.at(x1), line.curve};
    };
    return {part.kind, cut(part.top), cut(part.bottom)};
  }
  // The cell at a coordinate: -1 for all before the first one, `cells` for all behind the last one. Whole px
  // are divided, as 32-bit numbers, as that is much quicker.
  static int cell_at(Fine at, int side, int cells) {
    if (at < 0) return -1;
    const Fine px = at >> kFineBits;
    if (px >= Fine{side} * cells) return cells;
    return static_cast<int>(static_cast<unsigned>(px) / static_cast<unsigned>(side));
  }
  int column_of(Fine x) const { return cell_at(x, tile_.width, width_); }
  int row_of(Fine y) const { return cell_at(y, tile_.height, height_); }
  // Of a cell of the map.
  std::span<const RawPart> parts_in(int x, int y) const {
    const std::size_t cell =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    const std::uint32_t* first = &first_[cells_[cell]];
    return {parts_.data() + first[0], parts_.data() + first[1]};
  }
  template <class Use>
  bool for_curves(const FineBox& area, Use use) const {
    const int from = std::clamp(column_of(area.x0), 0, width_ - 1);
    const int to = std::clamp(column_of(area.x1), 0, width_ - 1);
    for (int column = from; column <= to; ++column) {
      for (const std::uint32_t index : curves_in_[static_cast<std::size_t>(column)]) {
        const RawPart& part = curves_[index];
        const int its_first = std::clamp(column_of(part.top.x0), 0, width_ - 1);
        if (column == std::max(from, its_first) && !use(part)) return false;
      }
    }
    return true;
  }
  void add_shape(const TileShape& shape);
  std::optional<RawLine> between_edges(const RawLine& line) const;
  void add_curves(std::span<const Curve> curves);

  int width_, height_;  // cells
  TileSize tile_;
  Fine tile_width_, tile_height_;
  int left_ = 0, right_ = 0, up_ = 0, down_ = 0;  // cells by which shapes reach beyond their own
  std::vector<TileNumber> cells_;
  std::vector<RawPart> parts_;        // of all shapes, from the corner of their own cell
  std::vector<std::uint32_t> first_;  // by number, its first part; and the end
  std::vector<RawPart> curves_;
  std::vector<std::vector<std::uint32_t>> curves_in_;  // by column
  std::shared_ptr<const std::vector<CurveStretch<double>>> stretches_;
};

}  // namespace talus
