// The box is swept against the outline grown by the box: a floor rises by the box's height and reaches to the
// left by its width. The box's corner is then a point on a straight way. Ends that two pieces share are
// computed alike for both, so that nothing slips through between them.
#include <talus/collision/cast.h>

#include <algorithm>
#include <cmath>

#include "box_on_piece.h"
#include "cast_cells.h"
#include "cast_log.h"
#include "cast_rounding.h"
#include "curve_cast.h"
#include "twofold.h"

namespace talus {
namespace {

constexpr int kMaxColumns = 62;  // cells of a row looked at in one go: a word minus both neighbours

// The work charged for a slice of a long motion, with the few cells that an ordinary box leads with. For a
// large box, this many rows of cells cost 1.
constexpr std::int64_t kSliceWork = 4;
constexpr int kRowsPerWork = 4;

// A gap that closes more slowly than by this share of the motion needs twice the precision.
constexpr int kSlowShare = 16;
constexpr int kSteepestLine = 1 << 14;  // px down for each px to the right; steeper ones are hardly drawn

// Whether two pieces are the same one: a long piece is in the list of each cell that it meets.
template <class Real>
bool is_copy(const Piece<Real>& a, const Piece<Real>& b) {
  return a.origin == b.origin && a.stretch == b.stretch && a.facing == b.facing && a.x0 == b.x0 &&
         a.y0 == b.y0;
}

// kSunk: whether a part of the box's corners meets no ground; see Cast::sunk. Log: receives the cells and
// pieces that the cast tests; see NoLog.
template <class Real, bool kSunk = false, class Log = NoLog>
class Caster {
 public:
  // budget: null means no limit. with_curves: false lets curves stop the box with their ends alone.
  Caster(const BasicTerrain<Real>& terrain, const Cast<Real>& cast, Ignored<Real> ignored, CastBudget* budget,
         bool with_curves, Log log = {})
      : terrain_(terrain),
        has_pieces_(terrain.has_pieces()),
        with_curves_(with_curves),
        ignored_(ignored),
        box_(cast.box),
        dx_(moves_sideways(cast) ? cast.motion.x : 0),
        dy_(cast.motion.y),
        foot_(cast.foot),
        sunk_(cast.sunk),
        inverse_(dx_ == 0 ? 0 : 1 / dx_),
        speed_(std::abs(dx_) + std::abs(dy_)),
        slack_(rounding_slack(cast)),
        budget_(budget),
        log_(log) {}

  void against(const BasicRect<Real>& other, std::int32_t number) {
    origin_ = -1 - number;
    is_other_ = true;
    const Real right = other.x + other.w, bottom = other.y + other.h;
    if (dy_ > 0) flat(true, other.y, other.x, right, true, true);
    if (dy_ < 0) flat(false, bottom, other.x, right, true, true);
    if (dx_ > 0) wall(Facing::left, other.x, other.y, bottom, true, true);
    if (dx_ < 0) wall(Facing::right, right, other.y, bottom, true, true);
    is_other_ = false;
  }

  [[gnu::always_inline]] void against_terrain() {
    const Real length = std::max(std::abs(dx_), std::abs(dy_));
    const auto slice_length = Real(talus::slice_length(terrain_.tile_size()));
    if (length <= slice_length) return slice(0, 1);
    in_slices(length, slice_length);
  }

  std::int64_t work() const { return work_; }

  Contact<Real> contact() const {
    Contact<Real> c;
    if (!(best_.t <= 1)) return c;
    c.t = best_.t;
    c.facing = best_.facing;
    c.origin = best_.origin;
    c.piece = best_.piece;
    c.is_other = best_.is_other;
    c.on_end = best_.cap;
    c.position = position();
    c.normal =
        best_.mirrored ? BasicVec2<Real>{0, best_.facing == Facing::up ? Real(-1) : Real(1)} : normal(best_);
    return c;
  }

 private:
  struct Hit {
    Real t = std::numeric_limits<Real>::infinity();
    Facing facing = Facing::up;
    bool cap = false;       // a flat side of the box meets the end of a slope
    bool mirrored = false;  // two hits at the same time, mirror images of one another
    bool is_other = false;
    std::int32_t origin = 0;
    const Piece<Real>* piece = nullptr;
    Real at = 0;                   // a wall's x, a flat piece's y
    Real first_x = 0, last_x = 0;  // of a floor or ceiling: the range of x where the box may be
    bool is_level() const { return cap || piece == nullptr; }
    bool is_wall() const { return facing == Facing::left || facing == Facing::right; }
  };

  // The box's place at that time, on the surface that it hit. Along the surface the place is exact to the
  // rounding of the result, however flat the angle between the surface and the motion is.
  BasicVec2<Real> position() const {
    const Twofold<Real> t = time_of_best();
    if (best_.is_wall()) return {limit(best_.facing, best_.at), (box_.y + t * dy_).rounded()};
    // A box that falls straight down keeps its x. On a steep line y determines the place, as one rounding of
    // x there moves y by many roundings; but not at an end, where the next line may be much less steep.
    const bool by_y = dx_ != 0 && !best_.is_level() && is_steep(*best_.piece);
    Real x = best_.t == 0 ? box_.x : exact_x(t * dx_);
    if (by_y && best_.t == 0) x = moved_x(box_, (box_.y - rest(*best_.piece, x)) / best_.piece->slope);
    x = std::clamp(x, best_.first_x, best_.last_x);
    if (by_y && x != best_.first_x && x != best_.last_x) return {x, (box_.y + t * dy_).rounded()};
    return {x, best_.is_level() ? limit(best_.facing, best_.at) : rest(*best_.piece, x)};
  }

  Twofold<Real> time_of_best() const {
    const bool is_curve = best_.piece != nullptr && !best_.cap && best_.piece->stretch != 0;
    // The x of a box that goes straight up or down does not depend on the time.
    if (best_.t == 0 || dx_ == 0 || is_curve) return best_.t;
    // A time that differs by more than rounding belongs to the end of the line, or of the motion.
    const Twofold<Real> exact = exact_time(best_);
    return std::abs(exact.rounded() - best_.t) * speed_ <= slack_ ? exact : best_.t;
  }

  // The time at which the box meets the line, or the side, that it hit.
  Twofold<Real> exact_time(const Hit& hit) const {
    if (hit.is_wall()) return wall_time(hit.facing, hit.at);
    const bool up = hit.facing == Facing::up;
    return hit.is_level() ? level_time(up, hit.at) : line_time(up, *hit.piece);
  }
  Twofold<Real> wall_time(Facing facing, Real at) const {
    return (Twofold<Real>(at) - (facing == Facing::left ? box_.w : 0) - box_.x) / dx_;
  }
  Twofold<Real> level_time(bool up, Real at) const {
    return (Twofold<Real>(at) - (up ? box_.h : 0) - box_.y) / dy_;
  }
  Twofold<Real> line_time(bool up, const Piece<Real>& piece) const {
    using Exact = Twofold<Real>;
    const Exact x = Exact(box_.x) + foot_offset(piece, box_.w, foot_) - piece.base_x;
    const Exact slope(piece.slope, piece.slope_rest);
    return (x * slope + piece.base_y - (up ? box_.h : 0) - box_.y) / (Exact(dy_) - slope * dx_);
  }

  // The same as moved_x, rounded once.
  Real exact_x(Twofold<Real> dx) const {
    const Twofold<Real> left = box_.x + dx, right = left + box_.w;
    return std::abs(right.rounded()) > std::abs(left.rounded()) ? right.rounded() - box_.w : left.rounded();
  }

  // The x of the box's left side, or the y of its top, when it touches.
  Real limit(Facing facing, Real at) const {
    return facing == Facing::left ? at - box_.w : facing == Facing::up ? at - box_.h : at;
  }

  // The stretch of a floor or ceiling, in x of the box's left side.
  struct Reach {
    Real first, last;            // the box's x from which and to which it touches
    Real first_y, last_y;        // the box's y there
    bool open_first, open_last;  // the outline ends there: a box beside that end does not touch
  };
  using Window = CastWindow<Real>;

  Real rest(const Piece<Real>& piece, Real x) const {
    return rest_on(piece, terrain_.stretches(), {x, 0, box_.w, box_.h}, foot_);
  }

  // The contact lies beyond the cells that were tested.
  void give_up(Real end) {
    best_ = {};
    budget_->seen = static_cast<double>(end);
  }

  // A motion of any length, in parts.
  [[gnu::noinline]] void in_slices(Real length, Real slice_length) {
    // There is nothing outside the map, however far the motion goes there. A slice is added at both ends,
    // which costs nothing and forgives the rounding.
    Real from = 0, to = 1;
    clip_to_map<Real>(box_.x, box_.w, dx_, terrain_.x_of(terrain_.width()), slice_length, from, to);
    clip_to_map<Real>(box_.y, box_.h, dy_, terrain_.y_of(terrain_.height()), slice_length, from, to);
    if (from > to) return;
    const auto slices = static_cast<int>(std::ceil((to - from) * length / slice_length)) + 1;
    for (int i = 0; i < slices; ++i) {
      const Real end = from + (to - from) * (Real(i + 1) / Real(slices));
      slice(from + (to - from) * (Real(i) / Real(slices)), end);
      if (best_.t <= end) return;
      work_ += kSliceWork;
      if (budget_ != nullptr && work_ > budget_->left && i + 1 < slices) return give_up(end);
    }
  }

  // ---- Which cells ----

  // The cell at a coordinate: 0 for what is before the first one, `count` for what is beyond the last one.
  // per_px: cells. Its rounding is far below slack_, by which every range that is looked up is grown.
  static int cell_at(Real at, Real per_px, int count) {
    return static_cast<int>(std::min<Real>(std::max<Real>(at, 0) * per_px, Real(count)));
  }
  // Compilers would not inline them on their own, though a cast calls them four times: a twentieth of a step.
  [[gnu::always_inline]] CellSpan columns_between(Real first, Real last) const {
    const int count = terrain_.width();
    const Real per_px = terrain_.columns_per_px();
    return {cell_at(first, per_px, count), std::min(cell_at(last, per_px, count), count - 1)};
  }
  [[gnu::always_inline]] CellSpan rows_between(Real first, Real last) const {
    const int count = terrain_.height();
    const Real per_px = terrain_.rows_per_px();
    return {cell_at(first, per_px, count), std::min(cell_at(last, per_px, count), count - 1)};
  }

  // A box meets the ground with its leading sides alone, or with the centre of its bottom.
  void slice(Real from, Real to) {
    const Real x0 = box_.x + from * dx_, x1 = box_.x + to * dx_;
    const Real y0 = box_.y + from * dy_, y1 = box_.y + to * dy_;
    const Real left = std::min(x0, x1) - slack_, right = std::max(x0, x1) + slack_;
    const Real top = std::min(y0, y1) - slack_, bottom = std::max(y0, y1) + slack_;
    const Real lead_y = dy_ < 0 ? 0 : box_.h, lead_x = dx_ > 0 ? box_.w : 0;
    const CellSpan columns = columns_between(left, right + box_.w);
    const CellSpan lead_rows = rows_between(top + lead_y, bottom + lead_y);
    if (dx_ == 0) return cells<true>(columns, columns, lead_rows, lead_rows);
    const CellSpan lead_columns =
        foot_ == Foot::centre ? columns : columns_between(left + lead_x, right + lead_x);
    cells<false>(columns, lead_columns, rows_between(top, bottom + box_.h), lead_rows);
  }

  // Tests the cells of `rows`: all columns of the leading rows, and the leading columns of the others.
  template <bool kVertical>
  void cells(CellSpan columns, CellSpan lead_columns, CellSpan rows, CellSpan lead_rows) {
    using Terrain = BasicTerrain<Real>;
    for (int first = columns.first; first <= columns.last; first += kMaxColumns) {
      // Bit i of a word is the cell at (first - 1 + i), so that both neighbours are in the word.
      const int count = std::min(columns.last - first + 1, kMaxColumns);
      const std::uint64_t all = ((std::uint64_t{1} << count) - 1) << 1;
      std::uint64_t lead = all;
      if constexpr (!kVertical)
        lead &= bits_between(lead_columns.first - first + 1, lead_columns.last - first + 1);
      const auto wanted = [=](int row) { return kVertical || lead_rows.contains(row) ? all : lead; };
      if (Terrain::OneChunk::covers(first - 1, count + 2, rows.first - 1, rows.last + 1)) {
        const typename Terrain::OneChunk words(terrain_, first - 1, rows.first);
        if (words) cells_in<kVertical>(words, first - 1, rows, wanted);
      } else {
        cells_in<kVertical>(typename Terrain::Window(terrain_, first - 1, count + 2), first - 1, rows,
                            wanted);
      }
    }
  }

  // column: the column of bit 0. wanted(row): the bits of the cells to test.
  template <bool kVertical, class Words, class Wanted>
  void cells_in(Words words, int column, CellSpan rows, Wanted wanted) {
    const bool up = dy_ > 0, right = dx_ > 0;
    const Facing floor = up ? Facing::up : Facing::down, side = right ? Facing::left : Facing::right;
    work_ += std::max(rows.last - rows.first, 0) / kRowsPerWork;
    for (int row = rows.first; row <= rows.last; ++row) {
      const auto here = words.row(row);
      const std::uint64_t cells = wanted(row);
      log_.looks_at(column, row, cells);
      if (has_pieces_) {
        std::uint64_t pieces = here.faced(floor);
        if constexpr (!kVertical) pieces |= here.faced(up ? Facing::down : Facing::up) | here.faced(side);
        for (pieces &= cells; pieces != 0; pieces &= pieces - 1) {
          const std::span<const Piece<Real>> in_cell = words.pieces(std::countr_zero(pieces), row);
          work_ += static_cast<std::int64_t>(in_cell.size());
          for (const Piece<Real>& piece : in_cell) {
            log_.begin({column + std::countr_zero(pieces), row}, piece);
            against_piece(piece);
          }
        }
      }
      const std::uint64_t open = dy_ == 0 ? 0 : here.open(floor) & cells;
      if (open != 0) surface(up, column, row, open, here);
      if constexpr (!kVertical) {
        const std::uint64_t open_sides = here.open(side) & cells;
        if (open_sides != 0) walls(side, column, row, open_sides, words);
      }
    }
  }

  // ---- Full tiles ----

  template <class Words>
  void walls(Facing facing, int column, int row, std::uint64_t open, Words& words) {
    const Real top = terrain_.y_of(row), bottom = terrain_.y_of(row + 1);
    const std::uint64_t above = words.row(row - 1).solid(), below = words.row(row + 1).solid();
    for (; open != 0; open &= open - 1) {
      const int i = std::countr_zero(open);
      ++work_;
      origin_ = row * terrain_.width() + column + i;
      log_.begin({column + i, row}, facing, 1);
      wall(facing, terrain_.x_of(column + i + (facing == Facing::left ? 0 : 1)), top, bottom,
           (above >> i & 1) == 0, (below >> i & 1) == 0);
    }
  }

  // Full tiles side by side with an open top, or an open bottom, are tested as one.
  template <class Row>
  void surface(bool up, int column, int row, std::uint64_t open, Row here) {
    const Real y = terrain_.y_of(up ? row : row + 1);
    while (open != 0) {
      const int first = std::countr_zero(open);
      const int length = std::countr_one(open >> first);
      ++work_;
      open &= ~(((std::uint64_t{1} << length) - 1) << first);
      Real x0 = terrain_.x_of(column + first), x1 = terrain_.x_of(column + first + length);
      const bool open0 = (here.solid() >> (first - 1) & 1) == 0;
      const bool open1 = (here.solid() >> (first + length) & 1) == 0;
      if (foot_ == Foot::centre && up) {
        // Where slopes may continue, only the centre counts. Over a ledge the whole bottom counts.
        const std::uint64_t sloped = kSunk ? ~std::uint64_t{0} : here.solid() & here.detailed();
        if (sloped >> (first - 1) & 1) x0 += box_.w / 2;
        if (sloped >> (first + length) & 1) x1 -= box_.w / 2;
      }
      origin_ = row * terrain_.width() + column + first;
      log_.begin({column + first, row}, up ? Facing::up : Facing::down, length);
      flat(up, y, x0, x1, open0, open1);
    }
  }

  void flat(bool up, Real y, Real x0, Real x1, bool open0, bool open1, const Piece<Real>* piece = nullptr) {
    const Facing facing = up ? Facing::up : Facing::down;
    const Real limit = this->limit(facing, y), first = x0 - box_.w;
    // Most pieces are out of reach, or are met well between their ends.
    const Real gap = up ? limit - box_.y : box_.y - limit, closing = up ? dy_ : -dy_;
    if (gap > closing || gap < -slack_) return;
    const Real t = gap <= 0 ? 0 : is_slow(closing) ? after_now(level_time(up, y)) : gap / closing;
    const Real x = box_.x + t * dx_;
    if (std::min(box_.x, x) > first + slack_ && std::max(box_.x, x) < x1 - slack_) {
      offer_flat(t, {first, x1, limit, limit, open0, open1}, up, y, piece);
    } else {
      flat({first, x1, limit, limit, open0, open1}, up, y, piece);
    }
  }

  // is_covered: a box that comes along the line that covers the end touches the end by rounding alone.
  void flat(const Reach& reach, bool up, Real y, const Piece<Real>* piece, bool is_covered = false) {
    const Real closing = up ? dy_ : -dy_;
    if (!(closing > 0)) return;
    const auto window = window_of(reach, up, [&](Real) { return reach.first_y; });
    if (is_covered && window.last_gap >= -slack_) return;
    Real t;
    const auto exact = [&] { return level_time(up, y); };
    if (straight_time(window, closing, slack_, t, exact)) offer_flat(t, reach, up, y, piece);
  }

  void offer_flat(Real t, const Reach& reach, bool up, Real y, const Piece<Real>* piece) {
    offer({.t = t,
           .facing = up ? Facing::up : Facing::down,
           .cap = piece != nullptr,
           .piece = piece,
           .at = y,
           .first_x = reach.first,
           .last_x = reach.last});
  }

  void wall(Facing facing, Real at, Real y0, Real y1, bool open0, bool open1,
            const Piece<Real>* piece = nullptr) {
    const Real limit = this->limit(facing, at);
    const Real gap = facing == Facing::left ? limit - box_.x : box_.x - limit;
    if (gap < -slack_) return;
    const Real t = gap <= 0                 ? 0
                   : is_slow(std::abs(dx_)) ? after_now(wall_time(facing, at))
                                            : gap * std::abs(inverse_);
    if (t > 1 || is_later(t)) return;
    const Real y = box_.y + t * dy_;
    const Real h = kSunk && !is_other_ ? box_.h - sunk_ : box_.h;
    // Rounded as the gaps to the floor and the ceiling at its ends, so that the box meets one of the two. A
    // corner of a box on its centre, in the floor, does not touch what is below it.
    const bool is_above = !((y0 - h) - y < (open0 || foot_ == Foot::centre ? -slack_ : slack_));
    if (is_above || !(y - y1 < (open1 ? -slack_ : slack_))) return;
    offer({.t = t, .facing = facing, .piece = piece, .at = at});
  }

  // ---- Pieces ----

  bool is_ignored(const Piece<Real>& piece) const {
    if (is_copy(piece, *ignored_.first)) return true;
    return std::any_of(ignored_.more.begin(), ignored_.more.end(),
                       [&](const Piece<Real>* other) { return is_copy(piece, *other); });
  }

  void against_piece(const Piece<Real>& piece) {
    if (ignored_.first != nullptr && is_ignored(piece)) return;
    origin_ = piece.origin;
    if (piece.is_wall()) {
      if (piece.facing == Facing::left ? dx_ > 0 : dx_ < 0)
        wall(piece.facing, piece.x0, piece.y0, piece.y1, piece.convex0, piece.convex1, &piece);
      return;
    }
    const bool up = piece.facing == Facing::up;
    const bool level = piece.y0 == piece.y1 && piece.stretch == 0;
    const bool centre = up && foot_ == Foot::centre;
    const Real lift = up ? box_.h : 0;
    if (level && !centre) {
      if (up ? dy_ > 0 : dy_ < 0)
        flat(up, piece.y0, piece.x0, piece.x1, piece.is_open0(), piece.is_open1(), &piece);
      return;
    }
    const Real offset = foot_offset(piece, box_.w, foot_);
    const Reach reach = {piece.x0 - offset,
                         piece.x1 - offset,
                         piece.y0 - lift,
                         piece.y1 - lift,
                         centre ? piece.far0 : piece.is_open0(),
                         centre ? piece.far1 : piece.is_open1()};
    if (piece.stretch == 0) {
      sloped(reach, up, piece);
    } else if (with_curves_) {
      curved(reach, up, piece, offset, lift);
    }
    ends(up, piece, lift);
  }

  // The end of a slope that the flat bottom of the box stands on: a crest, or the end of the floor.
  void ends(bool up, const Piece<Real>& piece, Real lift) {
    const Real half = box_.w / 2;
    if (up && foot_ == Foot::centre) {
      if constexpr (kSunk) return;
      if (piece.last0)
        flat({piece.x0 - box_.w, piece.x0 - half, piece.y0 - lift, piece.y0 - lift, true, piece.covered0}, up,
             piece.y0, &piece, piece.covered0);
      if (piece.last1)
        flat({piece.x1 - half, piece.x1, piece.y1 - lift, piece.y1 - lift, piece.covered1, true}, up,
             piece.y1, &piece, piece.covered1);
      return;
    }
    // Beyond a crest the ground continues. Unlike beside a ledge, nothing may slip through there.
    if (piece.rises_to_the_right() == up) {
      if (piece.convex1 || piece.covered1)
        flat({piece.x1 - box_.w, piece.x1, piece.y1 - lift, piece.y1 - lift, piece.covered1, piece.last1}, up,
             piece.y1, &piece, piece.covered1);
    } else {
      if (piece.convex0 || piece.covered0)
        flat({piece.x0 - box_.w, piece.x0, piece.y0 - lift, piece.y0 - lift, piece.last0, piece.covered0}, up,
             piece.y0, &piece, piece.covered0);
    }
  }

  void sloped(const Reach& reach, bool up, const Piece<Real>& piece) {
    const Real rise = piece.slope * dx_;
    const Real closing = up ? dy_ - rise : rise - dy_;
    // A box that slides along the line does not approach it, even if rounding says so.
    if (!(closing > kRounding<Real> * (std::abs(dy_) + std::abs(rise)))) return;
    const auto window = window_of(reach, up, [&](Real x) { return rest(piece, x); });
    const Real slack = slack_on_line(slack_, piece.slope);
    // A box that comes to the line's very end meets what follows.
    if (window.to < 1 && window.last_gap >= -slack) return;
    Real t;
    if (!straight_time(window, closing, slack, t, [&] { return line_time(up, piece); })) return;
    offer({.t = t, .facing = piece.facing, .piece = &piece, .first_x = reach.first, .last_x = reach.last});
  }

  template <class RestAt>
  Window window_of(const Reach& reach, bool up, RestAt rest_at) const {
    const Real sign = up ? 1 : -1;
    const auto gap_at = [&](Real limit, Real t) { return sign * (limit - (box_.y + t * dy_)); };
    constexpr Window kNever{1, 0, 0, 0};
    Window w{0, 1, 0, 0};
    if (dx_ == 0) {
      // If one stretch is open at a border, the next one is closed there: the next one has the places on the
      // border.
      const bool in_first = reach.open_first ? box_.x > reach.first + slack_ : box_.x >= reach.first - slack_;
      const bool in_last = reach.open_last ? box_.x < reach.last - slack_ : box_.x <= reach.last + slack_;
      if (!in_first || !in_last) return kNever;
      w.gap = gap_at(rest_at(box_.x), 0);
      w.last_gap = gap_at(rest_at(box_.x), 1);
      return w;
    }
    const bool right = dx_ > 0;
    const Real enter = right ? reach.first : reach.last, leave = right ? reach.last : reach.first;
    const bool open_leave = right ? reach.open_last : reach.open_first;
    const Real to_leave = (leave - box_.x) * inverse_;
    // The box leaves the end of a piece: where the outline continues, the next piece has the contact.
    const bool at_end = to_leave * speed_ <= slack_;
    if (at_end && (open_leave || to_leave <= 1)) return kNever;
    if (right ? box_.x < enter : box_.x > enter) {
      w.from = (enter - box_.x) * inverse_;
      if (w.from > 1) return kNever;
      w.gap = gap_at(right ? reach.first_y : reach.last_y, w.from);
      // A box that comes along a steep line may be off it by a rounding of its x, here as on that line.
      const Real off = slack_ * std::min<Real>(std::abs(dy_ * inverse_), kSteepestLine);
      if (w.gap < 0 && w.gap >= -off) w.gap = 0;
    } else {
      w.gap = gap_at(rest_at(box_.x), 0);
    }
    if (to_leave < 1) {
      w.to = to_leave;
      w.last_gap = gap_at(right ? reach.last_y : reach.first_y, w.to);
    } else {
      w.last_gap = gap_at(rest_at(box_.x + dx_), 1);
    }
    return w;
  }

  // Whether the box approaches so slowly that a rounding of the gap is worth many roundings of the motion.
  bool is_slow(Real closing) const { return kSlowShare * closing < speed_; }

  static Real after_now(Twofold<Real> t) { return std::max<Real>(t.rounded(), 0); }

  // The time at which the gap closes at a constant rate. Returns false if the gap never closes, or was closed
  // before. exact(): computes the same to twice the precision.
  template <class Exact>
  bool straight_time(const Window& w, Real closing, Real slack, Real& t, Exact exact) const {
    if (w.from > w.to || w.gap < -slack) return false;
    if (w.gap <= 0) {
      t = w.from;
      return true;
    }
    if (w.last_gap >= 0 && !(w.to == 1 && w.last_gap == 0)) return false;
    t = std::clamp(is_slow(closing) ? exact().rounded() : w.from + w.gap / closing, w.from, w.to);
    return true;
  }

  void curved(const Reach& reach, bool up, const Piece<Real>& piece, Real offset, Real lift) {
    const auto window = window_of(reach, up, [&](Real x) { return rest(piece, x); });
    const CurveCast<Real> cast{piece,  terrain_.stretches(), box_.position(), {dx_, dy_}, offset, lift,
                               slack_, kRounding<Real>};
    if (const auto t = cast.time(window))
      offer({.t = *t, .facing = piece.facing, .piece = &piece, .first_x = reach.first, .last_x = reach.last});
  }

  // ---- The first ----

  BasicVec2<Real> normal(const Hit& hit) const {
    switch (hit.facing) {
      case Facing::left:
        return {-1, 0};
      case Facing::right:
        return {1, 0};
      case Facing::up:
      case Facing::down:
        break;
    }
    const bool up = hit.facing == Facing::up;
    const Real sign = up ? 1 : -1;
    if (hit.cap || hit.piece == nullptr) return {0, -sign};
    const Piece<Real>& piece = *hit.piece;
    if (piece.stretch == 0) {
      const Real length = std::sqrt(1 + piece.slope * piece.slope);
      return {sign * piece.slope / length, -sign / length};
    }
    const Real x = std::clamp(box_.x + hit.t * dx_ + foot_offset(piece, box_.w, foot_), piece.x0, piece.x1);
    const BasicVec2<Real> along = terrain_.stretches()[piece.stretch - 1].tangent_at(x);
    return {sign * along.y, -sign * along.x};
  }

  // Whether a time is after that of the first hit, and not by rounding alone.
  bool is_later(Real t) const { return t > best_.t && (t - best_.t) * speed_ > kSlowShare * slack_; }

  [[gnu::always_inline]] void offer(Hit hit) {
    log_.meets(hit.t);
    // Where no part of the corners meets ground, floors alone stop the box, on its centre.
    if (kSunk && sunk_ >= box_.h && !is_other_ && hit.facing != Facing::up) return;
    if (is_later(hit.t)) return;
    hit.origin = origin_;
    hit.is_other = is_other_;
    const bool is_first = best_.t > 1 || (best_.t - hit.t) * speed_ > kSlowShare * slack_;
    if (!is_first) return offer_at_about_the_same_time(hit);
    take(hit);
  }

  [[gnu::always_inline]] void take(const Hit& hit) {
    log_.is_first();
    best_ = hit;
  }

  // Whether the box only just comes to the end of a floor or ceiling. A wall that it meets at the same time
  // keeps it from getting over it, or under it. A corner of a box on its centre may be behind that wall.
  bool is_at_border(const Hit& hit) const {
    if (hit.is_wall() || dx_ == 0 || box_.w == 0 || foot_ == Foot::centre) return false;
    const Real x = box_.x + hit.t * dx_;
    return dx_ > 0 ? x <= hit.first_x + slack_ : x >= hit.last_x - slack_;
  }

  // Seldom called, and so kept out of what is inlined. Rounding alone does not decide which hit counts: at
  // the time of the first one, the box may be off the other by half of the slack.
  [[gnu::noinline]] void offer_at_about_the_same_time(const Hit& hit) {
    const bool are_one = hit.is_level() && best_.is_level() && hit.facing == best_.facing;
    const BasicVec2<Real> ours = normal(hit), theirs = normal(best_), d{dx_, dy_};
    const Real a = dot(ours, d), b = dot(theirs, d), first = std::min(hit.t, best_.t);
    const Real off = hit.t > first ? (first - hit.t) * a : (first - best_.t) * b;
    if (are_one || off > slack_ / 2) {
      if (hit.t < best_.t) take(hit);
      return;
    }
    const bool is_corner = hit.is_wall() ? is_at_border(best_) : best_.is_wall() && is_at_border(hit);
    if (is_corner ? hit.is_wall() : a < b || (a == b && std::abs(ours.y) > std::abs(theirs.y)))
      take(hit);
    else if (a == b && ours.x == -theirs.x && ours.x != 0 && hit.facing == best_.facing)
      best_.mirrored = true;
    best_.t = first;
  }

  const BasicTerrain<Real>& terrain_;
  const bool has_pieces_;
  const bool with_curves_;
  Ignored<Real> ignored_;
  const BasicRect<Real> box_;
  const Real dx_, dy_;
  const Foot foot_;
  const Real sunk_;
  const Real inverse_;
  const Real speed_;  // px in the motion, sideways and up or down
  const Real slack_;
  CastBudget* const budget_;
  std::int64_t work_ = 0;  // cells, pieces and boxes tested so far
  [[no_unique_address]] Log log_;
  Hit best_;
  std::int32_t origin_ = 0;  // origin of the piece or tile under test
  bool is_other_ = false;
};

// The same motion for the upright middle line of the box.
template <class Real>
Cast<Real> middle_of(const Cast<Real>& cast) {
  return {{cast.box.x + cast.box.w / 2, cast.box.y, 0, cast.box.h}, cast.motion, Foot::box};
}

// The contact of the whole box: with all pieces of curves, or with their ends alone.
template <bool kSunk = false, class Real>
[[gnu::always_inline]] inline Contact<Real> contact_of_box(const BasicTerrain<Real>& terrain,
                                                           const Cast<Real>& cast,
                                                           std::span<const BasicRect<Real>> others,
                                                           Ignored<Real> ignored, CastBudget* budget,
                                                           bool with_curves) {
  if (budget != nullptr) budget->seen = 1;
  Caster<Real, kSunk> caster(terrain, cast, ignored, budget, with_curves);
  for (std::size_t i = 0; i < others.size(); ++i) caster.against(others[i], static_cast<std::int32_t>(i));
  caster.against_terrain();
  if (budget != nullptr) budget->left -= caster.work() + static_cast<std::int64_t>(others.size()) + 1;
  return caster.contact();
}

// The contact of a box that stands on its centre. Its corners may be in a slope, and behind the ends of walls
// and ceilings that the slope covers; its middle may not.
template <class Real>
[[gnu::noinline]] Contact<Real> contact_on_centre(const BasicTerrain<Real>& terrain, const Cast<Real>& cast,
                                                  std::span<const BasicRect<Real>> others,
                                                  Ignored<Real> ignored, CastBudget* budget) {
  const Contact<Real> contact = cast.sunk > 0
                                    ? contact_of_box<true>(terrain, cast, others, ignored, budget, true)
                                    : contact_of_box(terrain, cast, others, ignored, budget, true);
  // Straight down a box meets only floors, and what stops its middle stops the whole box as soon.
  if (cast.motion.y > 0 && !moves_sideways(cast)) return contact;
  const Cast<Real> middle = middle_of(cast);
  const double seen = budget != nullptr ? budget->seen : 1;
  Contact<Real> hit = contact_of_box(terrain, middle, {}, ignored, budget, false);
  if (budget != nullptr) budget->seen = std::min(budget->seen, seen);
  const bool is_known = budget == nullptr || static_cast<double>(hit.t) <= budget->seen;
  if (is_known && hit.t < contact.t) {
    hit.position.x = moved_x(cast.box, hit.position.x - middle.box.x);
    // The middle is on the line of a level floor, where the flat bottom of a box would be on its end.
    hit.on_end = hit.on_end && hit.piece->y0 != hit.piece->y1;
    return hit;
  }
  if (budget != nullptr && static_cast<double>(contact.t) > budget->seen) return {};
  return contact;
}

CastTrace traced(const Terrain& terrain, const Cast<double>& cast, bool with_curves) {
  CastTrace trace;
  CastBudget budget{TraceLog::kMax};
  Caster<double, false, TraceLog> caster(terrain, cast, {}, &budget, with_curves, TraceLog(terrain, trace));
  caster.against_terrain();
  trace.contact = caster.contact();
  return trace;
}

}  // namespace

template <class Real>
Contact<Real> cast_box(const BasicTerrain<Real>& terrain, const Cast<Real>& cast,
                       std::span<const BasicRect<Real>> others, std::type_identity_t<Ignored<Real>> ignored,
                       CastBudget* budget) {
  if (!is_usable(cast)) return {};
  if (cast.foot == Foot::centre && terrain.has_pieces())
    return contact_on_centre(terrain, cast, others, ignored, budget);
  return contact_of_box(terrain, cast, others, ignored, budget, true);
}

CastTrace trace_cast(const Terrain& terrain, const Cast<double>& cast) {
  if (!is_usable(cast)) return {};
  CastTrace trace = traced(terrain, cast, true);
  if (cast.foot == Foot::centre) add_trace(trace, traced(terrain, middle_of(cast), false));
  trace.contact = cast_box(terrain, cast);
  return trace;
}

template <class Real>
Real rest_on(const Piece<Real>& piece, std::span<const CurveStretch<Real>> stretches,
             const BasicRect<Real>& box, Foot foot) {
  const bool up = piece.facing == Facing::up;
  const Real offset = foot_offset(piece, box.w, foot);
  return piece.y_at(box.x + offset, stretches) - (up ? box.h : 0);
}

#define TALUS_CAST(Real)                                                                                 \
  template Real rest_on(const Piece<Real>&, std::span<const CurveStretch<Real>>, const BasicRect<Real>&, \
                        Foot);                                                                           \
  template Contact<Real> cast_box(const BasicTerrain<Real>&, const Cast<Real>&,                          \
                                  std::span<const BasicRect<Real>>, Ignored<Real>, CastBudget*)
TALUS_CAST(double);
TALUS_CAST(float);
#undef TALUS_CAST

}  // namespace talus
