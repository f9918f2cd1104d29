// Mover: moves one box through the ground, contact by contact. The caller decides what a contact does to the
// rest of the motion; the mover puts the box on what it hit and makes it follow that.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <talus/collision/cast.h>
#include "../collision/box_on_piece.h"
#include "../collision/cast_rounding.h"
#include "../collision/ground_queries.h"

namespace talus {

// A box within this many times its rounding_slack() of a surface is put on the surface.
inline constexpr int kSettledSlacks = 4;
// px; the end of a curve may be so far off the end that it ought to meet, as ends are rounded to it.
inline constexpr double kMaxLip = 0.00390625;
static_assert(kMaxLip * kWeldParts == 1);

template <class Real>
struct Moving {
  BasicRect<Real> box;       // px
  BasicVec2<Real> velocity;  // px/frame
  Foot foot = Foot::box;
};

// px; a body so near to a surface is on it.
template <class Real>
Real settled(const Moving<Real>& body) {
  return kSettledSlacks * rounding_slack<Real>({body.box, {}, body.foot});
}

template <class Real>
Moving<Real> moved_to(Moving<Real> body, BasicVec2<Real> place) {
  body.box.x = place.x;
  body.box.y = place.y;
  return body;
}

// dy/dx of a floor or ceiling with this normal.
template <class Real>
Real slope_of(BasicVec2<Real> normal) {
  return -normal.x / normal.y;
}

// The part of a motion that a surface with this normal leaves.
template <class Real>
BasicVec2<Real> slide_along(BasicVec2<Real> normal, BasicVec2<Real> motion) {
  return motion - normal * dot(motion, normal);
}

// Whether two sides with these normals hold up a box that lies on both.
template <class Real>
bool hold_up(BasicVec2<Real> a, BasicVec2<Real> b) {
  return a.x * b.x < 0 && std::abs(b.x) * a.y + std::abs(a.x) * b.y < 0;
}

// Whether a contact with a piece is level, see is_level().
template <class Real>
bool is_level_piece(const Contact<Real>& contact, Real steepest) {
  if (contact.normal.y == 0) return false;
  const Piece<Real>& p = *contact.piece;
  if (p.stretch != 0) steepest = steepest_on_curve(steepest);
  if (p.stretch != 0 || contact.on_end || contact.normal.x == 0)
    return std::abs(contact.normal.x) <= steepest * std::abs(contact.normal.y);
  const Real slope = std::abs(p.slope);
  return slope != steepest ? slope < steepest : p.slope * p.slope_rest <= 0;
}

// Whether a contact is with ground level enough to stand on, or to bounce from like a floor: |dy/dx| is at
// most `steepest`, compared exactly, or on a curve steepest_on_curve(). Bodies at rest ask it of full tiles.
template <class Real>
[[gnu::always_inline]] inline bool is_level(const Contact<Real>& contact, Real steepest) {
  return contact.piece == nullptr ? contact.normal.y != 0 : is_level_piece(contact, steepest);
}

// The upper end of a side that a body has met.
template <class Real>
BasicVec2<Real> top_of_side(const BasicTerrain<Real>& ground, const Contact<Real>& contact) {
  const Piece<Real>* piece = contact.piece;
  if (piece != nullptr) return {piece->x0, piece->y0};
  const Cell cell{contact.origin % ground.width(), contact.origin / ground.width()};
  return {ground.x_of(cell.x + (contact.facing == Facing::left ? 0 : 1)), ground.y_of(cell.y)};
}

// Whether what a body has met is the side of a floor that begins up to kMaxLip higher. It is put on that
// floor.
template <class Real>
[[gnu::noinline]] bool climbs(const BasicTerrain<Real>& ground, std::span<const BasicRect<Real>> others,
                              Moving<Real>& body, const Contact<Real>& contact, CastBudget* budget) {
  if (contact.is_other || contact.normal.y != 0 || !ground.has_pieces()) return false;
  const Real top = top_of_side(ground, contact).y, rise = body.box.y + body.box.h - top;
  if (!(rise > 0) || rise > Real(kMaxLip) + settled(body)) return false;
  if (cast_box<Real>(ground, {body.box, {0, -rise}, body.foot}, others, nullptr, budget)) return false;
  body.box.y = top - body.box.h;
  return true;
}

// RestMemo: what a box met that fell straight down while it touched the ground. For a fall of up to
// kShortMotion the answer depends neither on its length nor on its speed, so a box at rest need not ask
// again.
template <class Real>
class RestMemo {
 public:
  static bool is_fall(const Cast<Real>& cast) {
    return cast.motion.y > 0 && cast.motion.y <= kShortMotion && !moves_sideways(cast);
  }
  // The answer for a fall, or null.
  Contact<Real>* find(const Cast<Real>& fall) {
    return known_ && foot_ == fall.foot && box_ == fall.box ? &contact_ : nullptr;
  }
  // False: the box did not touch the ground, and nothing is kept.
  bool keep(const Cast<Real>& fall, const Contact<Real>& contact) {
    known_ = contact.t == 0;
    if (!known_) return false;
    box_ = fall.box;
    foot_ = fall.foot;
    contact_ = contact;
    return true;
  }
  // The work that finding the answer takes, whether it is known or not: that of a fall of two cells.
  std::int64_t work() const { return work_; }
  void set_work(std::int64_t work) { work_ = work; }

 private:
  bool known_ = false;
  Foot foot_ = Foot::box;
  BasicRect<Real> box_;
  Contact<Real> contact_;
  std::int64_t work_ = 0;
};

template <class Real>
class Mover {
 public:
  using Vec = BasicVec2<Real>;
  struct Result {
    int passes = 0;
    bool capped = false;  // the passes were used up, and the rest of the motion was dropped
    bool wedged = false;  // wedged between the last two contacts: the rest of the motion leads nowhere
    bool held = false;    // so, in one place, and the two hold it up
    bool cut_short =
        false;  // the budget was used up: the box stopped at the last place that is known to be free
  };

  // rest: what this body met before, in this terrain and without others; null: nothing is remembered. budget:
  // of all casts together; null: no limit.
  Mover(const BasicTerrain<Real>& terrain, std::span<const BasicRect<Real>> others, int max_passes,
        RestMemo<Real>* rest = nullptr, CastBudget* budget = nullptr)
      : terrain_(terrain), others_(others), max_passes_(max_passes), rest_(rest), budget_(budget) {}

  // Moves the body by `motion`. For each contact, first calls seen(contact, motion), then respond(contact,
  // motion), where motion is the one that the contact is a part of. seen may change a contact with t > 0; if
  // it returns false, it has moved the body to the end of the motion. respond may change the body's velocity,
  // and returns the motion to go on with. Before that, of a body on its centre that meets a side, calls
  // sinks(contact, motion, sunk), if it is given, with the Cast::sunk of its casts, px: more than 0 is a new
  // one, with which it may pass.
  template <class Respond, class Seen, class Sinks>
  [[gnu::always_inline]] Result move(Moving<Real>& body, Vec motion, Respond respond, Seen seen,
                                     Sinks sinks) {
    Result result;
    Real sunk = 0;              // px, as Cast::sunk
    std::optional<Vec> before;  // normal of the contact before
    const Piece<Real>* followed = nullptr;
    Vec after_following;
    Real whole = 1;  // the chord and what is left after it, in chords
    while (body.box.x + motion.x != body.box.x || body.box.y + motion.y != body.box.y) {
      if (result.passes == max_passes_) {
        result.capped = true;
        break;
      }
      if (budget_ != nullptr && budget_->left <= 0) {
        result.cut_short = true;
        break;
      }
      if (budget_ != nullptr) --budget_->left;
      Contact<Real>& contact = first_contact({body.box, motion, body.foot, sunk}, followed);
      if (!contact && budget_ != nullptr && budget_->seen < 1) {
        advance(body, motion * static_cast<Real>(budget_->seen));
        result.cut_short = true;
        break;
      }
      if (!contact) {
        if (followed == nullptr) {
          advance(body, motion);
          break;
        }
        body.box.x = goal_.x;
        body.box.y = goal_.y;
        motion = after_following;
        followed = nullptr;
        ++result.passes;
        continue;
      }
      ++result.passes;
      if (contact.normal.y == 0) [[unlikely]] {
        if (const Real depth = body.foot == Foot::centre ? sinks(contact, motion, sunk) : 0; depth > 0) {
          sunk = depth;
          continue;
        }
        if (climbs_at(contact, body)) {
          motion = motion * ((followed != nullptr ? whole : 1) - contact.t);
          followed = nullptr;
          continue;
        }
      }
      if (followed != nullptr) [[unlikely]] {  // the way that was left at the chord's end is left here, too
        motion = motion * whole;
        contact_.t /= whole;
        followed = nullptr;
      }
      if (!seen(contact, motion)) {
        surface_ = nullptr;
        break;
      }
      const Vec from = body.box.position();
      body.box.x = contact.position.x;
      body.box.y = contact.position.y;
      surface_ = contact.on_end ? nullptr : contact.piece;
      const Vec way = motion;
      motion = respond(contact, motion);
      // Sliding along one plane leads into the one before: the box cannot go anywhere.
      const auto is_motion = [&](Real speed) { return speed > tolerance(motion) && speed > tolerance(way); };
      const bool slides = !is_motion(dot(motion, contact.normal));
      if (before && slides && is_motion(-dot(motion, *before))) {
        result.wedged = true;
        result.held = is_settled(body, from) && hold_up(contact.normal, *before);
        break;
      }
      before = contact.normal;
      if (slides && surface_ != nullptr && is_hollow(*surface_) &&
          follow(body, motion, after_following, whole))
        followed = surface_;
    }
    settle(body);
    return result;
  }

  template <class Respond, class Seen>
  Result move(Moving<Real>& body, Vec motion, Respond respond, Seen seen) {
    return move(body, motion, respond, seen, [](const Contact<Real>&, Vec, Real) { return Real(0); });
  }

 private:
  // Valid until the next call.
  Contact<Real>& first_contact(const Cast<Real>& cast, const Piece<Real>* followed) {
    const bool may_rest =
        rest_ != nullptr && followed == nullptr && cast.sunk == 0 && RestMemo<Real>::is_fall(cast);
    if (may_rest) {
      if (Contact<Real>* known = rest_->find(cast)) {
        if (budget_ != nullptr) budget_->left -= rest_->work();
        return *known;
      }
    }
    const std::int64_t left = budget_ != nullptr ? budget_->left : 0;
    contact_ = cast_box(terrain_, cast, others_, followed, budget_);
    if (may_rest && rest_->keep(cast, contact_) && budget_ != nullptr) {
      CastBudget whole;
      const std::int64_t most = whole.left;
      const Cast<Real> fall{cast.box, {0, kShortMotion}, cast.foot};
      cast_box(terrain_, fall, others_, followed, &whole);
      rest_->set_work(most - whole.left);
      budget_->left = left - rest_->work();
    }
    return contact_;
  }

  // Whether the body climbs over the edge that it has met. Not inline, and move() always is: the steps of
  // balls are quickest so.
  [[gnu::noinline]] bool climbs_at(const Contact<Real>& contact, Moving<Real>& body) const {
    Moving<Real> there = moved_to(body, contact.position);
    if (!climbs(terrain_, others_, there, contact, budget_)) return false;
    body.box = there.box;
    return true;
  }

  static Real tolerance(Vec motion) { return (std::abs(motion.x) + std::abs(motion.y)) * kRounding<Real>; }

  // A curve bends towards the box: a box that slides along it meets it again at once.
  bool is_hollow(const Piece<Real>& piece) const {
    if (piece.stretch == 0) return false;
    return terrain_.stretches()[piece.stretch - 1].bends_down != (piece.facing == Facing::up);
  }

  // Turns a motion along the tangent of a hollow curve into the chord to its end on the curve. Returns false
  // if the body is at the end of the piece, and goes on along the tangent there.
  bool follow(const Moving<Real>& body, Vec& motion, Vec& after, Real& whole) {
    const Piece<Real>& piece = *surface_;
    Moving<Real> there = body;
    there.box.x = moved_x(body.box, motion.x);
    const Real offset = foot_offset(piece, body.box.w, body.foot);
    there.box.x = std::clamp(there.box.x, std::min(body.box.x, piece.x0 - offset),
                             std::max(body.box.x, piece.x1 - offset));
    const Real y = rest_on(piece, terrain_.stretches(), there.box, body.foot);
    const Vec chord{there.box.x - body.box.x, y - body.box.y};
    const Real used = motion.x == 0 ? 1 : std::min<Real>(1, chord.x / motion.x);
    const Vec along = terrain_.stretches()[piece.stretch - 1].tangent_at(there.box.x + offset);
    const Real length = std::sqrt(dot(motion, motion)) * (1 - used);
    const Real sign = motion.x < 0 ? -1 : 1;
    after = used < 1 ? along * (sign * length) : Vec{};
    goal_ = {there.box.x, y};
    const bool is_at_end = !(used > 0);
    motion = is_at_end ? after : chord;
    whole = is_at_end ? 1 : 1 / used;
    return !is_at_end;
  }

  static void advance(Moving<Real>& body, Vec motion) {
    body.box.x = moved_x(body.box, motion.x);
    body.box.y += motion.y;
  }

  // A box that slid along a surface, and is not beyond its end, is on it exactly, without a rounding error.
  void settle(Moving<Real>& body) const {
    if (surface_ == nullptr || surface_->is_wall() || is_steep(*surface_)) return;
    const Real x = body.box.x + foot_offset(*surface_, body.box.w, body.foot);
    if (x < surface_->x0 || x > surface_->x1) return;
    const Real y = rest_on(*surface_, terrain_.stretches(), body.box, body.foot);
    if (is_settled(body, {body.box.x, y})) body.box.y = y;
  }

  // Whether a body is at a place, but for rounding.
  static bool is_settled(const Moving<Real>& body, Vec place) {
    const Real off = std::abs(body.box.x - place.x) + std::abs(body.box.y - place.y);
    return off <= settled(body);
  }

  const BasicTerrain<Real>& terrain_;
  const std::span<const BasicRect<Real>> others_;
  const int max_passes_;
  RestMemo<Real>* const rest_;
  CastBudget* const budget_;
  Contact<Real> contact_;                 // the last contact
  const Piece<Real>* surface_ = nullptr;  // of the last contact
  Vec goal_;                              // the end of the way along a curve
};

}  // namespace talus
