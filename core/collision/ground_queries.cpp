#include "ground_queries.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "box_on_piece.h"
#include "cast_rounding.h"
#include "cell_block.h"
#include "tile_outlines.h"

namespace talus {
namespace {

// The rounding error that a cast of the box would tolerate.
template <class Real>
Real slack_of(const BasicRect<Real>& box) {
  return rounding_slack<Real>({box, {}, Foot::box});
}

template <class Real>
bool is_box(const BasicRect<Real>& box) {
  return is_usable<Real>({box, {}, Foot::box});
}

// px; nothing of a terrain is further away
double within_reach(double reach) { return std::min(reach, kMaxCastReach / 2); }

// Rows and cells that are tested in the time of one unit of work.
constexpr std::int64_t kCellsPerWork = 2;

// skip_detailed: leaves out the tiles that slopes lead to. looks: counts the tested rows.
template <class Real>
bool overlaps_tile(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Real slack,
                   bool skip_detailed, std::int64_t& looks) {
  const CellBlock block = cells_met(ground, box, -slack).on(ground);
  for (int column = block.left; column <= block.right; column += 64) {
    const int count = std::min(block.right - column + 1, 64);
    typename BasicTerrain<Real>::Window window(ground, column, count);
    for (int row = block.top; row <= block.bottom; ++row) {
      ++looks;
      const auto here = window.row(row);
      const std::uint64_t tiles = here.solid() & ~(skip_detailed ? here.detailed() : 0);
      if ((tiles & (~std::uint64_t{0} >> (64 - count))) != 0) return true;
    }
  }
  return false;
}

// Whether the upright middle line of the box is in a full tile, or between two that are side by side.
template <class Real>
bool middle_is_in_tile(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Real slack,
                       std::int64_t& looks) {
  const BasicRect<Real> middle{box.x + box.w / 2, box.y, 0, box.h};
  const CellBlock block = cells_met(ground, middle, -slack);
  for (int row = std::max(block.top, 0); row <= std::min(block.bottom, ground.height() - 1); ++row) {
    ++looks;
    if (ground.is_solid({block.left, row}) && ground.is_solid({block.right, row})) return true;
  }
  return false;
}

// The part of a box that ground is looked for in. foot: the middle of its bottom, or the whole of it.
template <class Real>
struct Probe {
  const BasicRect<Real>& box;
  Foot foot;
  Real slack;
  Real from(bool stands_on_middle) const {
    return stands_on_middle && foot == Foot::centre ? box.x + box.w / 2 : box.x + slack;
  }
  Real to(bool stands_on_middle) const {
    return stands_on_middle && foot == Foot::centre ? box.x + box.w / 2 : box.x + box.w - slack;
  }
  // Casts forgive half of that: a box that is deeper would fall into the ground.
  Real forgiven(const OutlineLine& line) const { return 2 * slack_on_line(slack, Real(line.slope)); }
};

// Whether the box is in the part of a slope, of a profile or of a full tile in a column.
template <class Real>
bool overlaps_column(const TileColumn& column, BasicVec2<Real> corner, Real side, const Probe<Real>& probe) {
  const bool floor = column.is_floor;
  const BasicRect<Real>& box = probe.box;
  const Real base = floor ? corner.y + side : corner.y;
  if (floor ? box.y >= base - probe.slack : box.y + box.h <= base + probe.slack) return false;
  for (const OutlineLine& line : floor ? column.top : column.bottom) {
    const Real x0 = std::max(probe.from(floor), corner.x + Real(line.x0));
    const Real x1 = std::min(probe.to(floor), corner.x + Real(line.x1));
    if (!(x0 <= x1)) continue;
    for (const Real x : {x0, x1}) {
      const Real y = corner.y + Real(line.at(double(x - corner.x)));
      if (y == base) continue;
      const Real forgiven = probe.forgiven(line);
      if (floor ? box.y + box.h > y + forgiven : box.y < y - forgiven) return true;
    }
  }
  return false;
}

// Whether the box is in a part of a polygon: at some x it reaches below the top and above the bottom there.
// How far it does so changes evenly with x, so the best x is an end, or where both are equal.
template <class Real>
bool overlaps_part(const TileColumn& part, BasicVec2<Real> corner, const Probe<Real>& probe) {
  const Real x0 = std::max(probe.from(true), corner.x + Real(part.left));
  const Real x1 = std::min(probe.to(true), corner.x + Real(part.right));
  if (!(x0 <= x1)) return false;
  const BasicRect<Real>& box = probe.box;
  const auto below_top = [&](Real x) {
    return box.y + box.h - (corner.y + Real(part.top.front().at(double(x - corner.x))));
  };
  const auto above_bottom = [&](Real x) {
    return corner.y + Real(part.bottom.front().at(double(x - corner.x))) - box.y;
  };
  const Real a0 = below_top(x0), a1 = below_top(x1), b0 = above_bottom(x0), b1 = above_bottom(x1);
  Real most = std::max(std::min(a0, b0), std::min(a1, b1));
  if ((a0 < b0) != (a1 < b1)) {
    const Real share = (a0 - b0) / ((a0 - b0) - (a1 - b1));
    most = std::max(most, a0 + share * (a1 - a0));
  }
  return most > std::max(probe.forgiven(part.top.front()), probe.forgiven(part.bottom.front()));
}

// Whether the box is in the ground of a slope, a profile, a polygon or a group in the cell.
template <class Real>
bool overlaps_shape(const BasicTerrain<Real>& ground, const TileOutline& shape, Cell cell,
                    const BasicRect<Real>& box, Foot foot, Real slack) {
  const BasicVec2<Real> corner{ground.x_of(cell.x), ground.y_of(cell.y)};
  const Real side = Real(ground.tile_size().height);
  const Probe<Real> probe{box, foot, slack};
  return std::any_of(shape.columns.begin(), shape.columns.end(), [&](const TileColumn& column) {
    if (column.one_way) return false;
    return column.polygon >= 0 ? overlaps_part(column, corner, probe)
                               : overlaps_column(column, corner, side, probe);
  });
}

// A box deep in ground of many lines has more ways out than anybody would wait for.
constexpr std::size_t kMaxExits = 1024;

template <class Real>
struct Exit {
  Real distance;
  BasicVec2<Real> motion;
};

// How far the box is behind a piece that it overlaps, and the way back to the front of the piece.
template <class Real>
std::optional<Exit<Real>> exit_past(const BasicTerrain<Real>& ground, const Piece<Real>& piece,
                                    const BasicRect<Real>& box, Foot foot, Real slack) {
  if (piece.one_way) return std::nullopt;
  if (piece.is_wall()) {
    if (!(box.y + box.h > piece.y0 + slack && box.y < piece.y1 - slack)) return std::nullopt;
    const Real limit = piece.facing == Facing::left ? piece.x0 - box.w : piece.x0;
    const Real distance = piece.facing == Facing::left ? box.x - limit : limit - box.x;
    if (!(distance > slack)) return std::nullopt;
    return Exit<Real>{distance, {limit - box.x, 0}};
  }
  if (!(box.x + box.w > piece.x0 + slack && box.x < piece.x1 - slack)) return std::nullopt;
  const Real limit = rest_on(piece, ground.stretches(), box, foot);
  const Real distance = piece.facing == Facing::up ? box.y - limit : limit - box.y;
  if (!(distance > slack)) return std::nullopt;
  return Exit<Real>{distance, {0, limit - box.y}};
}

// The sides of a full tile that no other tile covers, as pieces.
template <class Real, class Use>
void for_open_sides(const BasicTerrain<Real>& ground, Cell c, Use use) {
  const auto solid = [&](int x, int y) { return ground.is_solid({x, y}); };
  const Real x0 = ground.x_of(c.x), y0 = ground.y_of(c.y), x1 = ground.x_of(c.x + 1),
             y1 = ground.y_of(c.y + 1);
  Piece<Real> side;
  const auto put = [&](Facing facing, Real ax, Real ay, Real bx, Real by) {
    side.x0 = side.base_x = ax, side.y0 = side.base_y = ay, side.x1 = bx, side.y1 = by;
    side.facing = facing;
    use(side);
  };
  if (!solid(c.x, c.y - 1)) put(Facing::up, x0, y0, x1, y0);
  if (!solid(c.x, c.y + 1)) put(Facing::down, x0, y1, x1, y1);
  if (!solid(c.x - 1, c.y)) put(Facing::left, x0, y0, x0, y1);
  if (!solid(c.x + 1, c.y)) put(Facing::right, x1, y0, x1, y1);
}

// Whether a way leads a box that stands on its middle through the ground there, or further up than the floor
// is below it. Its corners may be in the ground beside the floor.
template <class Real>
bool leads_off_floor(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Foot foot,
                     BasicVec2<Real> way, CastBudget* budget) {
  if (foot != Foot::centre) return false;
  const BasicRect<Real> middle{box.x + box.w / 2, box.y, 0, box.h};
  return bool(cast_box<Real>(ground, {middle, {way.x, std::abs(way.y)}, Foot::box}, {}, nullptr, budget));
}

// overlaps_ground(), which counts the rows and cells that it tests.
template <class Real>
bool overlaps_counted(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Foot foot,
                      std::int64_t& looks) {
  if (!is_box(box)) return false;
  const Real slack = slack_of(box);
  const bool centre = foot == Foot::centre;
  if (overlaps_tile(ground, box, slack, centre, looks)) return true;
  if (centre && middle_is_in_tile(ground, box, slack, looks)) return true;
  if (!ground.has_pieces()) return false;
  // The body of a slope may lie some cells away from its own cell.
  const CellBlock met = cells_met(ground, box, slack);
  const TileOutlines& outlines = ground.outlines();
  const auto [first, last] = outlines.sources_of({Cell{met.left, met.top}, Cell{met.right, met.bottom}});
  const CellBlock block = CellBlock{first.x, first.y, last.x, last.y}.on(ground);
  for (Cell c{0, block.top}; c.y <= block.bottom; ++c.y) {
    for (c.x = block.left; c.x <= block.right; ++c.x) {
      ++looks;
      const TileOutline& shape = outlines[ground.tile_at(c)];
      if (shape.line && overlaps_shape(ground, shape, c, box, foot, slack)) return true;
    }
  }
  return false;
}

// The mean speed of the ground along a side of a box, from `from` to `to`, px. Sums are of what speeds have
// more than the first one, so that ground of one speed has exactly that.
class MeanSpeed {
 public:
  MeanSpeed(double from, double to) : from_(from), to_(to) {}
  // Ground that only touches an end of the side counts where nothing else is.
  void add(double from, double to, double speed) {
    const double shared = std::min(to, to_) - std::max(from, from_);
    if (shared < 0) return;
    if (count_ == 0) first_ = speed;
    ++count_;
    touched_ += speed - first_;
    length_ += shared;
    along_ += shared * (speed - first_);
  }
  std::optional<double> get() const {
    if (count_ == 0) return std::nullopt;
    return first_ + (length_ > 0 ? along_ / length_ : touched_ / count_);
  }

 private:
  double from_, to_;
  double first_ = 0, touched_ = 0, length_ = 0, along_ = 0;
  int count_ = 0;
};

// The cells of level or upright ground along a line: `i` counts them along it.
struct CellsOfLine {
  bool is_upright;
  int tiles, curves;  // the row, or the column, of the tiles and of the curves on the line
  Cell of_tiles(int i) const { return is_upright ? Cell{tiles, i} : Cell{i, tiles}; }
  Cell of_curves(int i) const { return is_upright ? Cell{curves, i} : Cell{i, curves}; }
};

// Adds those pieces in a cell that lie on a line, or end on it, and face as a contact, either of curves or of
// tiles, and of them what is from `from` to `to`.
template <class Real>
void add_pieces(const BasicTerrain<Real>& ground, Cell cell, Facing facing, double line, bool of_curves,
                double from, double to, MeanSpeed& mean) {
  for (const Piece<Real>& piece : ground.pieces_in(cell)) {
    if (piece.facing != facing || (piece.origin < 0) != of_curves) continue;
    const bool is_wall = piece.is_wall();
    const bool ends_on_it = !is_wall && (piece.y0 == line) != (piece.y1 == line);
    if (ends_on_it) {
      const double end = piece.y0 == line ? piece.x0 : piece.x1;
      if (end >= from && end <= to) mean.add(end, end, ground.conveyor_of(piece.origin));
    }
    if (is_wall ? piece.x0 != line : piece.y0 != line || piece.y1 != line) continue;
    // The walls of tiles above one another are one, which has the origin of the first.
    const bool is_of_tile = is_wall && !of_curves && ground.shape_at(cell).kind != TileShape::Kind::none;
    mean.add(std::max(double(is_wall ? piece.y0 : piece.x0), from),
             std::min(double(is_wall ? piece.y1 : piece.x1), to),
             is_of_tile ? ground.shape_at(cell).conveyor : ground.conveyor_of(piece.origin));
  }
}

// px: the y of level ground that was met, or the x of upright ground.
template <class Real>
double line_of(const BasicTerrain<Real>& ground, const Contact<Real>& contact, bool is_upright) {
  if (const Piece<Real>* piece = contact.piece) {
    if (is_upright) return piece->x0;
    return contact.facing == Facing::up ? std::min(piece->y0, piece->y1) : std::max(piece->y0, piece->y1);
  }
  const int after = contact.facing == Facing::right || contact.facing == Facing::down ? 1 : 0;
  return is_upright ? ground.x_of(contact.origin % ground.width() + after)
                    : ground.y_of(contact.origin / ground.width() + after);
}

// The mean speed of the level or upright ground that the side of a box touches.
template <class Real>
std::optional<double> mean_conveyor(const BasicTerrain<Real>& ground, const Contact<Real>& contact,
                                    const BasicRect<Real>& box) {
  const Facing facing = contact.facing;
  const bool is_upright = facing == Facing::left || facing == Facing::right;
  const TileSize tile = ground.tile_size();
  const double across = is_upright ? tile.width : tile.height, side = is_upright ? tile.height : tile.width;
  const int last_across = (is_upright ? ground.width() : ground.height()) - 1;
  const int last_along = (is_upright ? ground.height() : ground.width()) - 1;
  const double line = line_of(ground, contact, is_upright);
  const bool is_before = facing == Facing::up || facing == Facing::left;  // the line, of its ground
  const int here = static_cast<int>(std::floor(line / across));
  const CellsOfLine cells{is_upright, is_before ? here : static_cast<int>(std::ceil(line / across)) - 1,
                          std::clamp(here, 0, last_across)};
  const double from = is_upright ? box.y : box.x, to = from + (is_upright ? box.h : box.w);
  const auto within = [&](double at) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(last_along)));
  };
  MeanSpeed mean(from, to);
  for (int i = within(std::ceil(from / side) - 1); i <= within(std::floor(to / side)); ++i) {
    const double begin = i * side, end = (i + 1) * side;
    const Cell cell = cells.of_tiles(i);
    if (ground.is_detailed(cell))
      add_pieces(ground, cell, facing, line, false, begin, end, mean);
    else if (ground.is_solid(cell))
      mean.add(begin, end, ground.shape_at(cell).conveyor);
    // The cells at the sides of the terrain have the curves beyond it, too.
    add_pieces(ground, cells.of_curves(i), facing, line, true, i == 0 ? -HUGE_VAL : begin,
               i == last_along ? HUGE_VAL : end, mean);
  }
  return mean.get();
}

}  // namespace

std::optional<Surface> floor_below(const Terrain& ground, const Rect& box, double reach, Foot foot,
                                   CastBudget* budget) {
  if (!(reach >= 0) || (budget != nullptr && budget->left <= 0)) return std::nullopt;
  const auto contact = cast_box<double>(ground, {box, {0, within_reach(reach)}, foot}, {}, nullptr, budget);
  if (!contact || overlaps_ground(ground, box, foot)) return std::nullopt;
  return Surface{contact.position.y + box.h, contact.normal, contact.origin};
}

std::optional<Surface> ceiling_above(const Terrain& ground, const Rect& box, double reach) {
  if (!(reach >= 0)) return std::nullopt;
  const auto contact = cast_box(ground, {box, {0, -within_reach(reach)}, Foot::box});
  if (!contact || overlaps_ground(ground, box)) return std::nullopt;
  return Surface{contact.position.y, contact.normal, contact.origin};
}

std::optional<Contact<double>> cast_segment(const Terrain& ground, Vec2 from, Vec2 to) {
  const auto contact = cast_box(ground, {{from.x, from.y, 0, 0}, to - from, Foot::box});
  if (!contact) return std::nullopt;
  return contact;
}

template <class Real>
bool overlaps_ground(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Foot foot) {
  std::int64_t looks = 0;
  return overlaps_counted(ground, box, foot, looks);
}

template <class Real>
std::optional<BasicVec2<Real>> way_out(const BasicTerrain<Real>& ground, const BasicRect<Real>& box,
                                       Foot foot, CastBudget* budget) {
  const std::int64_t most = budget != nullptr ? budget->left : std::numeric_limits<std::int64_t>::max();
  std::int64_t looks = 0;
  const auto answer = [&](std::optional<BasicVec2<Real>> way) {
    if (budget != nullptr) budget->left -= looks / kCellsPerWork;
    return way;
  };
  if (!overlaps_counted(ground, box, foot, looks)) return answer(std::nullopt);
  const Real slack = slack_of(box);
  std::vector<Exit<Real>> exits;
  const auto consider = [&](const Piece<Real>& piece) {
    ++looks;
    if (const auto exit = exit_past(ground, piece, box, foot, slack)) exits.push_back(*exit);
  };
  const CellBlock block = cells_met(ground, box, slack).on(ground);
  for (Cell c{0, block.top}; c.y <= block.bottom; ++c.y) {
    for (c.x = block.left; c.x <= block.right; ++c.x) {
      if (looks / kCellsPerWork > most) return answer(std::nullopt);
      ++looks;
      if (ground.is_detailed(c)) {
        for (const Piece<Real>& piece : ground.pieces_in(c)) consider(piece);
      } else if (ground.is_solid(c)) {
        for_open_sides(ground, c, consider);
      }
    }
  }
  // Of two equally long ways the vertical one counts, so that mirrored boxes leave alike.
  std::stable_sort(exits.begin(), exits.end(), [](const Exit<Real>& a, const Exit<Real>& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.motion.x == 0 && b.motion.x != 0;
  });
  // Many pieces lead out by the same motion, which is tried only once.
  exits.erase(std::unique(exits.begin(), exits.end(),
                          [](const Exit<Real>& a, const Exit<Real>& b) { return a.motion == b.motion; }),
              exits.end());
  if (exits.size() > kMaxExits) exits.resize(kMaxExits);
  for (const Exit<Real>& exit : exits) {
    if (looks / kCellsPerWork > most) break;
    if (leads_off_floor(ground, box, foot, exit.motion, budget)) continue;
    const BasicRect<Real> there{box.x + exit.motion.x, box.y + exit.motion.y, box.w, box.h};
    if (!overlaps_counted(ground, there, foot, looks)) return answer(exit.motion);
  }
  return answer(std::nullopt);
}

template <class Real>
std::optional<Real> free_above(const BasicTerrain<Real>& ground, const BasicRect<Real>& box, Foot foot) {
  if (!is_box(box)) return std::nullopt;
  const auto tile = static_cast<Real>(ground.tile_size().height);
  const Real bottom = std::floor(box.bottom() / tile) * tile;
  for (int i = 0; i <= kMaxCellsUp; ++i) {
    const BasicRect<Real> up{box.x, bottom - static_cast<Real>(i) * tile - box.h, box.w, box.h};
    if (up.y >= box.y || overlaps_ground(ground, up, foot)) continue;
    const auto floor = cast_box<Real>(ground, {up, {0, box.y - up.y}, foot});
    return floor ? floor.position.y : up.y;
  }
  return std::nullopt;
}

template <class Real>
double conveyor_at(const BasicTerrain<Real>& ground, const Contact<Real>& contact,
                   const BasicRect<Real>& box) {
  if (!ground.has_conveyors() || contact.is_other) return 0;
  const Piece<Real>* piece = contact.piece;
  // A flat side may lie on the ends of slopes, beside level ground.
  const bool is_straight = piece == nullptr || piece->is_wall() || piece->y0 == piece->y1 ||
                           (contact.on_end && contact.normal.x == 0);
  const std::optional<double> mean = is_straight ? mean_conveyor(ground, contact, box) : std::nullopt;
  return mean ? *mean : ground.conveyor_of(contact.origin);
}

template bool overlaps_ground(const BasicTerrain<double>&, const BasicRect<double>&, Foot);
template bool overlaps_ground(const BasicTerrain<float>&, const BasicRect<float>&, Foot);
template std::optional<BasicVec2<double>> way_out(const BasicTerrain<double>&, const BasicRect<double>&, Foot,
                                                  CastBudget*);
template std::optional<BasicVec2<float>> way_out(const BasicTerrain<float>&, const BasicRect<float>&, Foot,
                                                 CastBudget*);

template double conveyor_at(const BasicTerrain<double>&, const Contact<double>&, const BasicRect<double>&);
template double conveyor_at(const BasicTerrain<float>&, const Contact<float>&, const BasicRect<float>&);
template std::optional<double> free_above(const BasicTerrain<double>&, const BasicRect<double>&, Foot);
template std::optional<float> free_above(const BasicTerrain<float>&, const BasicRect<float>&, Foot);

}  // namespace talus
