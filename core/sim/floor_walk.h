// FloorWalk: takes a body that stands along the floor, piece by piece. It turns into the next piece where the
// piece under its foot ends, so that it neither flies on over a crest nor meets what lies below the floor
// that it walks on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <talus/collision/cast.h>
#include "../collision/box_on_piece.h"
#include "../collision/cast_rounding.h"
#include "../collision/ground_queries.h"
#include "exact_mover.h"

namespace talus {

// px; how far ahead the next piece of floor is looked for: half of the shortest piece.
inline constexpr double kFloorStep = 0.001953125;
static_assert(kFloorStep * 2 * kWeldParts == 1);
// How often the way along a curve to what stops the body is halved: to less than 1/1000 px.
inline constexpr int kHalvings = 16;
// px; where a curve leads over an end, its chord may be so much below it.
inline constexpr double kMaxSag = 1.0 / (1 << 20);
// Two curves are compared at both ends of a way, and between so many equal parts of it.
inline constexpr int kPartsOfWay = 16;
// On its chord a body passes so many floors that its curve is above.
inline constexpr std::size_t kMaxPassed = 8;
// The floor under a body is followed over so many pieces to a corner of the body: more than there are under
// any body but on lines with points closer than 1/16 px. The budget of the casts is a limit, too.
inline constexpr int kMaxPiecesUnder = 1024;

// The level piece of floor that a body goes on along, seen from where it stands.
template <class Real>
struct FloorAhead {
  Contact<Real> contact;  // of the body, there or a little further on
  bool on_line = false;   // the foot is on the line of a piece: its height follows the line
  Real end = 0;           // px, x of the box where the piece ends
};

template <class Real>
class FloorWalk {
 public:
  using Vec = BasicVec2<Real>;

  // others: boxes that stop the body as tiles do. direction: -1 or 1. steepest: the largest |dy/dx| of a
  // floor. budget: of all casts together; null: no limit. sunk: px, as Cast::sunk, at first.
  FloorWalk(const BasicTerrain<Real>& ground, std::span<const BasicRect<Real>> others, Real direction,
            Real steepest, CastBudget* budget, Real sunk = 0)
      : ground_(ground),
        others_(others),
        direction_(direction),
        steepest_(steepest),
        budget_(budget),
        sunk_(sunk) {}

  // The floor on which the body goes on, up to `reach` px below it. Nothing: there is none, or it is too
  // steep. One that begins up to kMaxLip higher or lower is one with the floor before: the body is put on
  // it.
  std::optional<FloorAhead<Real>> floor_ahead(Moving<Real>& body, Real reach) {
    auto floor = look_ahead(body, reach);
    if (floor && !floor->on_line && sinks(body, floor->contact, body.box.y)) floor = look_ahead(body, reach);
    if (!floor || body.foot != Foot::centre) return floor;
    const Real y = place_on(*floor, body.box, body.box.x, body.foot).y, way = std::abs(y - body.box.y);
    const Real rounding = settled(body);
    if (way <= rounding || way > Real(kMaxLip) + rounding) return floor;
    sunk_ = std::max(sunk_, Real(kMaxLip + kFloorStep));  // the end that it leaves may be in its corners now
    // A ceiling may hold it below an end that it leaves.
    return joins(*floor, body) || y > body.box.y ? floor : look_ahead(body, reach);
  }

  // The level floor that the body has met, and goes on along. Nothing: it ends there.
  std::optional<FloorAhead<Real>> floor_met(const Moving<Real>& body, const Contact<Real>& contact) const {
    const FloorAhead<Real> floor = floor_of(contact, body.box, body.foot);
    if (!((floor.end - body.box.x) * direction_ > 0)) return std::nullopt;
    return floor;
  }

  // The floor under a body that a low ceiling has stopped on its way to another floor: that was looked for a
  // little further on, and the body goes straight to it from before the joint. Nothing: it is on that floor,
  // or it has not moved since this was asked, or it has met something else.
  std::optional<FloorAhead<Real>> floor_to_joint(const FloorAhead<Real>& floor, const Moving<Real>& body,
                                                 const Contact<Real>& contact) {
    if (contact.facing != Facing::down) return std::nullopt;
    if (joint_asked_ && !((body.box.x - *joint_asked_) * direction_ > 0)) return std::nullopt;
    joint_asked_ = body.box.x;
    const auto is_other = [&](const FloorAhead<Real>& next) {
      return next.end != floor.end || next.contact.normal.x != floor.contact.normal.x;
    };
    const auto here = floor_at(body, Real(kMaxLip), 0);
    if (!here) return std::nullopt;
    const auto under = is_other(*here) ? floor_met(body, here->contact) : std::nullopt;
    if (under) return under;
    // Or its flat bottom has gone on along the end of a floor, from just before that end.
    const auto next = look_ahead(body, Real(kMaxLip));
    return next && is_other(*next) ? next : std::nullopt;
  }

  // Where the body is after it went `way` px to the side on that floor, or to the floor's end.
  Vec goal_on(const FloorAhead<Real>& floor, const BasicRect<Real>& box, Real way, Foot foot) const {
    const Real x = moved_x(box, way);
    return place_on(floor, box, (x - floor.end) * direction_ > 0 ? floor.end : x, foot);
  }
  // The place of the body on that floor at this x.
  Vec place_on(const FloorAhead<Real>& floor, const BasicRect<Real>& box, Real x, Foot foot) const {
    const BasicRect<Real> there{x, box.y, box.w, box.h};
    if (!floor.on_line) return {x, floor.contact.position.y};
    return {x, rest_on(*floor.contact.piece, ground_.stretches(), there, foot)};
  }

  // Ends a floor where the foot of a body on its way to a goal comes below a one-way line that begins up to
  // kMaxLip higher: such a line has no side that the body could meet. Returns the goal, or that end.
  Vec goal_before_line(FloorAhead<Real>& floor, const Moving<Real>& body, Vec goal) const {
    if (!ground_.has_one_way()) return goal;
    const BasicRect<Real>& box = body.box;
    const Real x = foot_of(body), y = box.h - settled(body);
    const Vec from{std::min(box.x, goal.x), std::min(box.y, goal.y)};
    const Vec to{std::max(box.x, goal.x), std::max(box.y, goal.y)};
    const Cell first = cell_near(from + Vec{x, y - Real(kMaxLip)}), last = cell_near(to + Vec{x, y});
    for (Cell cell = first; cell.y <= last.y; ++cell.y) {
      for (cell.x = first.x; cell.x <= last.x; ++cell.x) {
        if (budget_ != nullptr && --budget_->left <= 0) return goal;
        for (const Piece<Real>& piece : ground_.pieces_in(cell)) {
          if (piece.one_way && piece.facing == Facing::up) end_below(floor, body, piece);
        }
      }
    }
    return (goal.x - floor.end) * direction_ > 0 ? place_on(floor, box, floor.end, body.foot) : goal;
  }

  // Whether a way along it is the straight one that is cast.
  static bool is_straight(const FloorAhead<Real>& floor) {
    return !floor.on_line || floor.contact.piece->stretch == 0;
  }
  // Puts a body that something has stopped on its way from x along the chord of that curve on the curve
  // itself, where it may meet that sooner, or as near to it as what else is there lets it.
  void stop_on(FloorAhead<Real> floor, Moving<Real>& body, Real from, const Contact<Real>& contact) {
    const auto place_at = [&](Real x) { return place_on(floor, body.box, x, body.foot); };
    Real free = from, blocked = contact.position.x;
    if (room_at(place_at(blocked), contact) >= 0) {
      free = blocked;
    } else {
      for (int i = 0; i < kHalvings; ++i) {
        const Real x = (free + blocked) / 2;
        (room_at(place_at(x), contact) >= 0 ? free : blocked) = x;
      }
      body = moved_to(body, place_at(from));  // on its way back it would meet what it has passed
    }
    Vec place = place_at(free);
    Contact<Real> met = cast_to(floor, body, place);
    if (met && sinks(moved_to(body, met.position), met, place.y)) met = cast_to(floor, body, place);
    body = moved_to(body, met ? met.position : place);
  }
  // Whether the floor is a curve that goes on above what the body has met below it, on the chord of its way
  // from x to the goal: another floor, or the upper end of a side.
  bool leads_above(const FloorAhead<Real>& floor, const Moving<Real>& body, const Contact<Real>& contact,
                   Real from, Real goal_x) const {
    if (is_straight(floor)) return false;
    const Real at = contact.position.x, slack = settled(body);
    if (contact.normal.y == 0) {
      const Real y = place_on(floor, body.box, at, body.foot).y;
      return !contact.is_other && y < contact.position.y && y + body.box.h <= top_of_side(ground_, contact).y;
    }
    const auto room = [&](Real x) { return room_at(place_on(floor, body.box, x, body.foot), contact); };
    if (std::abs(at - from) > slack) return room(at) > std::max(Real(kMaxSag), slack);
    Real way = (goal_x - at) / 2;
    while (room(at + way) <= slack && std::abs(way) > Real(kFloorStep)) way /= 2;
    return room(at + way) > slack;
  }
  // Puts a body that has come below a curve, on the chord of its way, on the curve, or as near to it as a
  // ceiling lets it.
  void lift_onto(const FloorAhead<Real>& floor, Moving<Real>& body) const {
    if (is_straight(floor)) return;
    const Real y = place_on(floor, body.box, body.box.x, body.foot).y;
    if (!(y < body.box.y)) return;
    const Cast<Real> up{body.box, {0, y - body.box.y}, body.foot, sunk_};
    const Contact<Real> met = cast_box<Real>(ground_, up, others_, nullptr, budget_);
    body.box.y = met ? met.position.y : y;
  }
  // Puts a body that has met something on that floor, which may be a little higher or lower than the one that
  // it came from. Returns whether that moved it, so that it may pass.
  bool joins(const FloorAhead<Real>& floor, Moving<Real>& body) const {
    const Real before = body.box.y, y = place_on(floor, body.box, body.box.x, body.foot).y, way = y - before;
    if (std::abs(way) > settled(body)) {
      const Cast<Real> upright{body.box, {0, way}, body.foot, sunk_};
      const Contact<Real> met = cast_box<Real>(ground_, upright, others_, nullptr, budget_);
      if (met && std::abs(met.position.y - y) > settled(body)) {
        if (way > 0) body.box.y = met.position.y;
        return body.box.y - before > settled(body);
      }
    }
    body.box.y = y;
    return y != before;
  }
  // How far a place is from what the body has met, px; less than 0: it is in that.
  static Real room_at(Vec place, const Contact<Real>& contact) {
    return dot(place - contact.position, contact.normal);
  }

  // What the body meets first on its way to a place on the floor. Where the floor is a curve that goes below
  // another one on the way, it ends, and so does the way.
  Contact<Real> cast_to(FloorAhead<Real>& floor, const Moving<Real>& body, Vec& goal) const {
    if (!is_straight(floor)) return cast_along_chord(floor, body, goal);
    const Piece<Real>* line = floor.on_line ? floor.contact.piece : nullptr;
    Cast<Real> cast{body.box, goal - body.box.position(), body.foot, sunk_};
    const Real slack = kSettledSlacks * rounding_slack(cast);
    // A ceiling that is parallel to the floor must not come nearer by the rounding of the two places.
    const Real along = line != nullptr ? cast.motion.x * line->slope : 0;
    if (std::abs(cast.motion.y - along) <= slack) cast.motion.y = along;
    const Contact<Real> contact = cast_box(ground_, cast, others_, {}, budget_);
    if (!falls_away(contact, cast.motion, slack)) return contact;
    return cast_box(ground_, cast, others_, contact.piece, budget_);
  }

  // Whether the body has come to the place that it was cast to, but for rounding, when it meets something.
  bool arrives(const Contact<Real>& contact, const Moving<Real>& body, Vec goal) const {
    const Vec left = goal - contact.position;
    // Less than the next piece is looked for ahead, so that it is found from the contact, too.
    const Real slack =
        std::min(kSettledSlacks * rounding_slack<Real>({body.box, left, body.foot}), Real(kFloorStep / 2));
    return std::abs(left.x) <= slack && std::abs(left.y) <= slack;
  }

  // Whether the body is behind what it met just before its place, by more than the next cast forgives, which
  // would not meet it then.
  bool is_behind(const Contact<Real>& contact, const Moving<Real>& body) const {
    return room_at(body.box.position(), contact) < -rounding_slack<Real>({body.box, {}, body.foot}) / 2;
  }

  // Where the body goes on past a straight ceiling that it has met too early, by rounding: to the goal, or to
  // where it leaves that piece of the ceiling, if it is in it there by a rounding of its height at most.
  // Where floor and ceiling are almost parallel, that may be the whole way. Nothing: the ceiling, or
  // something else on that way, stops it.
  std::optional<Vec> place_past(const Contact<Real>& contact, const BasicRect<Real>& box, Vec goal,
                                Foot foot) const {
    const Piece<Real>* const piece = contact.piece;
    if (!contact || contact.facing != Facing::down || (piece != nullptr && piece->stretch != 0))
      return std::nullopt;
    Vec place = goal;
    const Vec way = goal - contact.position;
    bool leaves = false;
    if (piece != nullptr) {
      const Real share = (end_of_ceiling(contact, box, foot) - contact.position.x) / way.x;
      leaves = share > 0 && share < 1;
      if (leaves) place = contact.position + way * share;
    }
    const Vec rest = place - contact.position;
    if (rest.x == 0) return std::nullopt;
    // Without its lowest part, as the floor would hide what else is there.
    const Real lip = std::min(Real(kMaxLip), box.h);
    const BasicRect<Real> above{contact.position.x, contact.position.y, box.w, box.h - lip};
    const Real slack = rounding_slack<Real>({above, {}, foot}), rounding = kSettledSlacks * slack;
    // Where the ceiling goes on, the next cast must meet it.
    if (room_at(place, contact) < -(leaves ? rounding : slack / 2)) return std::nullopt;
    const Cast<Real> past{above, piece != nullptr ? rest : Vec{rest.x, 0}, foot,
                          std::max<Real>(sunk_ - lip, 0)};
    const Contact<Real> met = cast_box(ground_, past, others_, piece, budget_);
    return met && std::abs(met.position.x - place.x) > rounding ? std::nullopt : std::optional(place);
  }

  // Whether what the body met lies below the floor that its foot walks on, as the side of the tile below the
  // next piece does. From then on the lowest part of the body's corners meets nothing. `body` is at the
  // contact; goal_y: px, of the place to which it was going; fall: px, as for floor_leads_over().
  bool sinks(const Moving<Real>& body, const Contact<Real>& contact, Real goal_y, Real fall = 0) {
    if (body.foot != Foot::centre || contact.is_other || !ground_.has_pieces()) return false;
    const auto spot = corner_met(body, contact);
    if (!spot) return false;
    const Real depth = std::max(std::max(body.box.y, goal_y) + body.box.h - spot->y, Real(kFloorStep));
    const bool is_ceiling = contact.facing == Facing::down;
    const Real sunk = is_ceiling || depth > body.box.h ? body.box.h : depth;
    // A floor may begin to go into the ceiling just where a corner of the body has met that.
    const Real beyond = is_ceiling ? 128 * Real(kFloorStep) : 0;
    if (!(sunk > sunk_) || !floor_leads_over(body, *spot, fall, beyond)) return false;
    sunk_ = sunk;
    return true;
  }

  // px, as Cast::sunk: how much of the lowest part of its corners meets nothing.
  Real sunk() const { return sunk_; }

 private:
  // px from the left side of a body: its middle, or the side of a box that goes first.
  Real foot_of(const Moving<Real>& body) const {
    return body.foot == Foot::centre ? body.box.w / 2 : direction_ > 0 ? body.box.w : 0;
  }
  // The terrain's cell that is nearest to a point.
  Cell cell_near(Vec point) const {
    const auto index = [](Real at, int side, int count) {
      return static_cast<int>(std::clamp<Real>(at / Real(side), 0, Real(count - 1)));
    };
    const TileSize tile = ground_.tile_size();
    return {index(point.x, tile.width, ground_.width()), index(point.y, tile.height, ground_.height())};
  }
  // Ends a floor where this line begins, if that is up to kMaxLip above it.
  void end_below(FloorAhead<Real>& floor, const Moving<Real>& body, const Piece<Real>& line) const {
    const bool right = direction_ > 0;
    const Real x = (right ? line.x0 : line.x1) - foot_of(body);
    if (!((x - body.box.x) * direction_ > 0 && (floor.end - x) * direction_ > 0)) return;
    const Real bottom = place_on(floor, body.box, x, body.foot).y + body.box.h;
    const Real height = bottom - (right ? line.y0 : line.y1), slack = settled(body);
    if (height > slack && height <= Real(kMaxLip) + slack) floor.end = x;
  }

  // The same along the chord of a curve. It passes floors that the curve is above.
  Contact<Real> cast_along_chord(FloorAhead<Real>& floor, const Moving<Real>& body, Vec& goal) const {
    std::array<const Piece<Real>*, kMaxPassed> passed{};
    for (std::size_t count = 0;; ++count) {
      const Cast<Real> cast{body.box, goal - body.box.position(), body.foot, sunk_};
      const Contact<Real> contact = cast_box<Real>(
          ground_, cast, others_, {floor.contact.piece, std::span(passed).first(count)}, budget_);
      if (!contact || count == passed.size()) return contact;
      if (const auto end = end_above(floor, body, contact, goal)) {
        if ((*end - contact.position.x) * direction_ <= Real(kFloorStep)) return contact;
        floor.end = *end;
        goal = place_on(floor, body.box, *end, body.foot);
      }
      passed[count] = contact.piece;
    }
  }

  // Up to where a curve that is the floor is above the other floor that the body has met on its chord, or the
  // same as that, px, x of the box. Nothing: up to the goal. If what it met is no line of a floor, that is
  // where it is.
  std::optional<Real> end_above(const FloorAhead<Real>& floor, const Moving<Real>& body,
                                const Contact<Real>& contact, Vec goal) const {
    const Real from = contact.position.x;
    if (contact.facing != Facing::up || contact.piece == nullptr || contact.on_end) return from;
    const FloorAhead<Real> met = floor_of(contact, body.box, body.foot);
    const Real slack = settled(body);
    const auto is_below = [&](Real x) {
      return place_on(floor, body.box, x, body.foot).y > place_on(met, body.box, x, body.foot).y + slack;
    };
    const bool ends = (goal.x - met.end) * direction_ > 0;
    const Real to = ends ? met.end : goal.x, part = (to - from) / kPartsOfWay;
    for (int i = 0; i <= kPartsOfWay; ++i) {
      Real below = from + part * static_cast<Real>(i);
      if (!is_below(below)) continue;
      Real above = i == 0 ? below : below - part;
      for (int k = 0; k < kHalvings && i > 0; ++k) {
        const Real x = (above + below) / 2;
        (is_below(x) ? below : above) = x;
      }
      return above;
    }
    // Behind the end another piece of that floor may go on.
    const Real beyond = direction_ > 0 ? std::max(to, from + 2 * Real(kFloorStep))
                                       : std::min(to, from - 2 * Real(kFloorStep));
    return ends && (goal.x - beyond) * direction_ > 0 ? std::optional(beyond) : std::nullopt;
  }

  // Whether it only touches a hill, at its top, which is in its way by rounding alone.
  bool falls_away(const Contact<Real>& contact, Vec motion, Real slack) const {
    if (contact.t != 0 || contact.piece == nullptr || contact.piece->stretch == 0) return false;
    if (contact.facing != Facing::up || !ground_.stretches()[contact.piece->stretch - 1].bends_down)
      return false;
    return -dot(contact.normal, motion) <= slack;
  }

  // The floor is looked for a little further on, so that of two pieces that meet at the foot the next one is
  // found. A foot that is a point goes over a gap, as the flat bottom of a box does.
  std::optional<FloorAhead<Real>> look_ahead(const Moving<Real>& body, Real reach,
                                             Real gap = Real(kMaxLip)) const {
    const Real step = std::max<Real>(Real(kFloorStep), 2 * rounding_slack<Real>({body.box, {}, body.foot}));
    const auto floor = floor_at(body, reach, step);
    const bool is_point = body.foot == Foot::centre || body.box.w == 0;
    return floor || !is_point ? floor : floor_at(body, reach, step + gap);
  }
  // The floor `step` px further on.
  std::optional<FloorAhead<Real>> floor_at(const Moving<Real>& body, Real reach, Real step) const {
    const Real slack = rounding_slack<Real>({body.box, {}, body.foot});
    const Real rise = std::min<Real>(step * steepest_, 1) + Real(kMaxLip) + 2 * slack;
    BasicRect<Real> there = body.box;
    there.x = moved_x(body.box, direction_ * step);
    there.y -= rise;
    const Cast<Real> down{
        there, {0, rise + reach}, body.foot, sunk_ > 0 ? std::min(sunk_ + rise, body.box.h) : 0};
    Contact<Real> contact = cast_box<Real>(ground_, down, others_, nullptr, budget_);
    // The floor may go on to the foot of something too steep, which is met on the way then.
    const bool rises = contact && contact.piece != nullptr && contact.normal.x * direction_ < 0;
    if (rises && !is_level(contact, steepest_)) {
      contact = cast_box<Real>(ground_, down, others_, contact.piece, budget_);
      if (contact.position.y - body.box.y > rise) return std::nullopt;
    }
    if (!contact || !is_level(contact, steepest_)) return std::nullopt;
    if (contact.normal.x == 0 && contact.position.y - body.box.y > reach) return std::nullopt;
    FloorAhead<Real> floor = floor_of(contact, there, body.foot);
    if (body.foot == Foot::centre && contact.on_end) floor = beyond_end(floor, there, rise);
    if ((floor.end - there.x) * direction_ < 0) floor.end = there.x;  // by rounding: each piece leads on
    return floor;
  }

  // Of a body whose flat bottom is on the end of a floor: the floor that goes on under its middle, if that
  // begins up to kMaxLip lower. Else the same floor. rise: px, by which it may be lower here.
  FloorAhead<Real> beyond_end(const FloorAhead<Real>& ended, const BasicRect<Real>& box, Real rise) const {
    const BasicRect<Real> middle{box.x + box.w / 2, ended.contact.position.y - Real(kFloorStep), 0, box.h};
    const Cast<Real> down{middle, {0, Real(kFloorStep) + rise}, Foot::box};
    Contact<Real> contact = cast_box<Real>(ground_, down, {}, nullptr, budget_);
    if (!contact || contact.on_end || !is_level(contact, steepest_)) return ended;
    contact.position.x = box.x;
    return floor_of(contact, box, Foot::centre);
  }

  // box: where the body has the contact.
  FloorAhead<Real> floor_of(const Contact<Real>& contact, const BasicRect<Real>& box, Foot foot) const {
    const bool on_line = contact.piece != nullptr && !contact.on_end;
    return {contact, on_line, end_of(contact, on_line, box, foot)};
  }

  // The x of the box where it leaves the floor.
  Real end_of(const Contact<Real>& contact, bool on_line, const BasicRect<Real>& box, Foot foot) const {
    const bool right = direction_ > 0;
    if (contact.is_other) {
      const BasicRect<Real>& other = others_[static_cast<std::size_t>(-1 - contact.origin)];
      return right ? other.x + other.w : other.x - box.w;
    }
    if (contact.piece == nullptr) return end_of_tiles(contact, box, foot);
    const Piece<Real>& piece = *contact.piece;
    if (on_line) return (right ? piece.x1 : piece.x0) - foot_offset(piece, box.w, foot);
    // The flat bottom stands on an end of the piece, or on a level piece.
    const Real half = box.w / 2;
    if (foot == Foot::centre) {
      const bool on_first = piece.x1 - (box.x + half) > (box.x + half) - piece.x0;
      if (on_first) return right ? piece.x0 - half : piece.x0 - box.w;
      return right ? piece.x1 : piece.x1 - half;
    }
    if (piece.y0 == piece.y1) return right ? piece.x1 : piece.x0 - box.w;
    const Real end = piece.rises_to_the_right() ? piece.x1 : piece.x0;
    return right ? end : end - box.w;
  }

  // The x of the box where it leaves the piece of a ceiling that it has met.
  Real end_of_ceiling(const Contact<Real>& contact, const BasicRect<Real>& box, Foot foot) const {
    const Piece<Real>& piece = *contact.piece;
    const bool right = direction_ > 0;
    if (!contact.on_end) return (right ? piece.x1 : piece.x0) - foot_offset(piece, box.w, foot);
    // Its flat top is below the lower end, or below a level piece.
    if (right) return piece.y0 > piece.y1 ? piece.x0 : piece.x1;
    return (piece.y1 > piece.y0 ? piece.x1 : piece.x0) - box.w;
  }

  // The column of the solid tile in a row that is nearest to the middle of the box; if there is none under
  // the box, another one.
  int solid_column(const BasicRect<Real>& box, int row) const {
    const Real middle = box.x + box.w / 2;
    int left = static_cast<int>(std::floor(middle / Real(ground_.tile_size().width))), right = left;
    while (!ground_.is_solid({left, row}) && ground_.x_of(left) > box.x) --left;
    while (!ground_.is_solid({right, row}) && ground_.x_of(right + 1) < box.x + box.w) ++right;
    if (!ground_.is_solid({left, row})) return right;
    if (!ground_.is_solid({right, row})) return left;
    const Real to_left = middle - ground_.x_of(left + 1), to_right = ground_.x_of(right) - middle;
    return to_left < to_right || (to_left == to_right && direction_ < 0) ? left : right;
  }

  // The end of a row of full tiles. Where a slope may go on, only the middle of the box stands on the last
  // tile.
  Real end_of_tiles(const Contact<Real>& contact, const BasicRect<Real>& box, Foot foot) const {
    const int step = direction_ > 0 ? 1 : -1;
    const int row = contact.origin / ground_.width();
    Cell cell{solid_column(box, row), row};
    if (!ground_.is_solid(cell)) return box.x;  // it met the last corner of the row
    const auto is_floor = [&](Cell c) {
      return ground_.is_solid(c) && !ground_.is_detailed(c) && !ground_.is_solid({c.x, c.y - 1});
    };
    const Real far = box.x + direction_ * (box.w + kShortMotion);
    while (is_floor({cell.x + step, row}) && (ground_.x_of(cell.x + step) - far) * direction_ < 0)
      cell.x += step;
    const Cell next{cell.x + step, row};
    const bool leads_on = foot == Foot::centre && ground_.is_solid(next) && ground_.is_detailed(next);
    const Real rest = leads_on ? box.w / 2 : 0;
    return step > 0 ? ground_.x_of(next.x) - rest : ground_.x_of(cell.x) - box.w + rest;
  }

  // The upper end of what a corner of the body met, or the nearer end of a ceiling that is level or falls
  // from there. Nothing: its middle met it.
  std::optional<Vec> corner_met(const Moving<Real>& body, const Contact<Real>& contact) const {
    if (contact.facing == Facing::left || contact.facing == Facing::right)
      return top_of_side(ground_, contact);
    const Piece<Real>* piece = contact.piece;
    if (piece != nullptr && !contact.on_end) {
      if (contact.facing != Facing::down) return std::nullopt;
      if (piece->y0 != piece->y1) return underside_met(*piece, body.box, contact.position.y);
    }
    const int column = piece != nullptr ? 0 : solid_column(body.box, contact.origin / ground_.width());
    const Real x0 = piece != nullptr ? piece->x0 : ground_.x_of(column);
    const Real x1 = piece != nullptr ? piece->x1 : ground_.x_of(column + 1);
    const Real middle = body.box.x + body.box.w / 2;
    const bool is_ceiling = contact.facing == Facing::down;
    const Real y = contact.position.y + (is_ceiling ? 0 : body.box.h);
    // The next floor is found so much further on, while the middle is still on this one.
    const Real beside = is_ceiling ? 0 : Real(kFloorStep);
    if (middle < x0 - beside) return Vec{x0, y};
    if (middle > x1 + beside) return Vec{x1, y};
    return std::nullopt;
  }

  // Where a corner of the body has met a sloped ceiling, which may be the underside of the line that it walks
  // on. Of one that falls away from the middle of the body, as the far side of a roof does, it is the upper
  // end: there the floor leads over it.
  Vec underside_met(const Piece<Real>& piece, const BasicRect<Real>& box, Real y) const {
    const Real middle = box.x + box.w / 2;
    const bool falls = piece.y0 < piece.y1;  // to the right, where the corner is then
    if (falls) return middle < piece.x0 ? Vec{piece.x0, piece.y0} : Vec{std::min(box.x + box.w, piece.x1), y};
    return middle > piece.x1 ? Vec{piece.x1, piece.y1} : Vec{std::max(box.x, piece.x0), y};
  }

  // Whether a floor goes through a ceiling into the ground on the way of a box, so that not even its foot
  // gets to the goal. It meets the underside of the line that it walks on by rounding alone. Not inline,
  // which would keep the compiler from putting hotter functions into the steps of balls.
  [[gnu::noinline]] bool leads_into_ground(FloorAhead<Real> floor, const BasicRect<Real>& box,
                                           Vec goal) const {
    const Moving<Real> foot{{box.x, box.y + box.h, 0, 0}, {}, Foot::box};
    Vec to{goal.x, goal.y + box.h};
    const Contact<Real> met = cast_to(floor, foot, to);
    if (!met || met.facing != Facing::down || !(room_at(to, met) < -Real(kMaxLip)) ||
        std::abs(met.position.x - foot.box.x) <= Real(kFloorStep))
      return false;
    return is_in_ground(met.position);
  }
  // Whether what is just above a point is ground.
  bool is_in_ground(Vec point) const {
    constexpr Real lip = Real(kMaxLip);
    return overlaps_ground<Real>(ground_, {point.x - lip / 2, point.y - 2 * lip, lip, lip});
  }

  // Whether the floor goes on from the middle of the body to the x of the spot, and is not below it there.
  // fall: px; a floor up to so far below the middle of a body in the air counts. beyond: px; so far behind
  // the spot it must not go into the ground, either.
  bool floor_leads_over(const Moving<Real>& body, Vec spot, Real fall, Real beyond) const {
    const Real middle = body.box.x + body.box.w / 2;
    Moving<Real> point{{middle, body.box.y, 0, body.box.h}, {}, Foot::box};
    const Real direction = spot.x < middle ? -1 : 1;
    FloorWalk walk(ground_, {}, direction, steepest_, budget_);
    for (int i = 0; i < kMaxPiecesUnder && point.box.x != spot.x; ++i) {
      const bool falls = i == 0 && fall > 0;
      // A middle that is just before a floor is not on it.
      const Real gap = i == 0 ? 0 : Real(kMaxLip);
      auto floor = walk.look_ahead(point, falls ? fall : 1, gap);
      if (!floor) return false;
      if (i == 0) {
        const Vec place = walk.place_on(*floor, point.box, point.box.x, point.foot);
        if (falls) point.box.y = place.y;
        // The body may be far below a curve, on a chord of it.
        if (!is_straight(*floor) && is_in_ground({place.x, place.y + point.box.h})) return false;
      }
      Vec goal = walk.goal_on(*floor, point.box, spot.x - point.box.x, point.foot);
      if (goal.x == point.box.x) return false;
      const Real further = spot.x + direction * beyond - point.box.x;
      const Vec ahead = beyond > 0 ? walk.goal_on(*floor, point.box, further, point.foot) : goal;
      if (walk.leads_into_ground(*floor, point.box, ahead)) return false;
      // Another floor may cross it, further on or just here.
      const Contact<Real> met = walk.cast_to(*floor, point, goal);
      if (met && met.facing == Facing::up) {
        const bool is_here = met.t == 0 && is_level(met, steepest_);
        const auto crossing = is_here ? walk.floor_met(point, met) : std::nullopt;
        if (crossing)
          goal = walk.goal_on(*crossing, point.box, spot.x - point.box.x, point.foot);
        else if (met.position.x != point.box.x)
          goal = met.position;
      }
      point.box.x = (goal.x - spot.x) * direction < 0 ? goal.x : spot.x;
      point.box.y = goal.y;
    }
    const Real slack = rounding_slack<Real>({body.box, {}, body.foot});
    return point.box.x == spot.x && point.box.y + point.box.h <= spot.y + Real(kMaxLip) + 2 * slack;
  }

  const BasicTerrain<Real>& ground_;
  const std::span<const BasicRect<Real>> others_;
  const Real direction_, steepest_;
  CastBudget* const budget_;
  Real sunk_;                        // px, as Cast::sunk
  std::optional<Real> joint_asked_;  // px, x at which floor_to_joint() was last asked
};

}  // namespace talus
