// How bodies of the exact solver move in a step: balls fall and bounce, players run and jump.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include <talus/level/tuning.h>
#include <talus/sim/state.h>
#include "ball_side.h"
#include "exact_mover.h"
#include "flight.h"
#include "lerp.h"

namespace talus {

// The numbers of a tuning that a step needs, in the precision of the step.
template <class Real>
struct ExactNumbers {
  explicit ExactNumbers(const Tuning& t)
      : fall_speed(static_cast<Real>(t.shared.fall_speed)),
        fall_blend(static_cast<Real>(t.shared.fall_blend)),
        drift_speed(static_cast<Real>(t.shared.drift_speed)),
        drift_blend(static_cast<Real>(t.shared.drift_blend)),
        floor_bounce(static_cast<Real>(t.shared.floor_bounce)),
        floor_grip(static_cast<Real>(t.shared.floor_grip)),
        wall_bounce(static_cast<Real>(t.shared.wall_bounce)),
        gravity(static_cast<Real>(t.exact.gravity)),
        steepest(static_cast<Real>(t.exact.steepest)),
        snap(static_cast<Real>(t.exact.snap)),
        rebound(t.exact.rebound != 0),
        flies(rebound && t.exact.gravity > 0),
        run_speed(static_cast<Real>(t.player.run_speed)),
        run_gain(static_cast<Real>(t.player.run_gain)),
        run_loss(static_cast<Real>(t.player.run_loss)),
        air_gain(static_cast<Real>(t.player.air_gain)),
        jump_speed(static_cast<Real>(t.player.jump_speed)),
        jump_cut(static_cast<Real>(t.player.jump_cut)),
        player_gravity(static_cast<Real>(t.player.gravity)),
        fall_limit(static_cast<Real>(t.player.fall_limit)),
        coyote_frames(static_cast<int>(t.player.coyote_frames)),
        surface_speed(t.player.surface_speed != 0) {}

  Real fall_speed, fall_blend, drift_speed, drift_blend, floor_bounce, floor_grip, wall_bounce;
  Real gravity, steepest, snap;
  bool rebound;
  bool flies;  // balls fly along parabolas, and leave what they meet on others
  Real run_speed, run_gain, run_loss, air_gain, jump_speed, jump_cut, player_gravity, fall_limit;
  int coyote_frames;
  bool surface_speed;
};

// A ball: the article's velocities, restitution and friction, with the true normal. flies: as in
// ExactNumbers.
template <class Real, bool flies>
class BallRule {
 public:
  using Vec = BasicVec2<Real>;
  using Side = BallSide<Real>;
  // budget: of all casts of the body together.
  BallRule(const ExactNumbers<Real>& numbers, const BasicTerrain<Real>& ground, CastBudget& budget,
           Moving<Real>& body)
      : n_(numbers), ground_(ground), budget_(budget), body_(body) {}

  // Called once in a step: falls as in the article, and rolls to rest. part: of a step, the length of its
  // equal parts.
  void pull(Real part) {
    Vec& v = body_.velocity;
    part_ = part;
    if (!(n_.gravity > 0)) v.y = lerp(v.y, n_.fall_speed, n_.fall_blend);
    v.x = lerp(v.x, n_.drift_speed, n_.drift_blend);
    if constexpr (flies) {
      // Between frames it has the velocity of the chord of its last frame; now that of a part.
      lift_ = n_.gravity * (1 - part) / 2;
      if (lift_ != 0) v.y += lift_;
    }
  }

  // Called before each part.
  void begin() {
    if (n_.gravity > 0) body_.velocity.y += n_.gravity * part_;
    left_ = part_;
    if constexpr (flies) {
      const Vec half{0, n_.gravity * part_ / 2};
      flight_.begin(body_.box.position(), body_.velocity - half, n_.gravity, part_);
    }
  }

  // Called after the last part.
  void end() {
    if (flies && lift_ != 0) body_.velocity.y -= lift_;
  }

  bool grounded() const { return grounded_; }

  // px/frame: how much the last contact changed the speed along its normal.
  Real change() const { return change_; }

  // Called before respond(): makes a contact of the motion, which is a chord, that of the flight. Returns
  // false if the flight meets nothing; then the body is at its end. others: as for a Mover.
  bool aim(Contact<Real>& contact, std::span<const BasicRect<Real>> others) {
    const bool may_sink = body_.foot == Foot::centre;  // the Mover alone knows how deep
    if (!flies || (may_sink && contact.normal.y == 0)) return true;
    const auto cast = [&](Vec from, Vec to) {
      const Cast<Real> way{moved_to(body_, from).box, to - from, body_.foot};
      const Contact<Real> met = cast_box<Real>(ground_, way, others, nullptr, &budget_);
      const bool unsure = budget_.seen < 1 || (met && may_sink && met.normal.y == 0);
      return unsure ? std::nullopt : std::optional(met);
    };
    if constexpr (flies) {
      if (flight_.aim(contact, ground_.stretches(), body_.box, body_.foot, cast)) return true;
      body_ = moved_to(body_, flight_.end());
    }
    return !flies;
  }

  // Reverses the velocity and returns the motion to go on with. As in the article, the rest of the motion
  // slides, or bounces if the tuning says so. motion: the one that the contact is a part of.
  Vec respond(const Contact<Real>& contact, Vec motion) {
    const Vec normal = contact.normal;
    const Vec rest = motion * (1 - contact.t);
    const bool level = is_level(contact, n_.steepest);
    grounded_ = grounded_ || (level && normal.y < 0);
    const Vec slide = slide_along(normal, rest);
    change_ = 0;
    if (has_just_arrived(contact, motion)) return slide;  // the next step bounces

    if constexpr (flies) return fly_off(contact, slide, level);
    Vec& v = body_.velocity;
    const Side side = side_of(normal, level);
    const bool stays = !n_.rebound || !(side.into(v) > 0);
    const Vec before = v;
    v = after_side(contact, side);
    change_ = dot(v - before, normal);
    if (stays) return slide;
    left_ = left_ * (1 - contact.t);
    return v * left_;
  }

 private:
  // A side that the ball met, where, and its velocity before that.
  struct Met {
    Vec place, velocity;
    Side side;
  };

  // Whether the ball meets something at the very end of a motion.
  bool has_just_arrived(const Contact<Real>& contact, Vec motion) const {
    constexpr double kNearEnd = 0.999;
    if (contact.t < Real(kNearEnd)) return false;
    return (std::abs(motion.x) + std::abs(motion.y)) * (1 - contact.t) <= settled(body_);
  }

  // level: as is_level().
  Side side_of(Vec normal, bool level) const {
    return {normal, level ? n_.floor_bounce : n_.wall_bounce, level ? n_.floor_grip : 1};
  }

  // The velocity after a contact, and after what is met at the same time.
  Vec after_side(const Contact<Real>& contact, const Side& side) {
    const Vec v = body_.velocity;
    const bool is_alone = contact.is_other || !ground_.has_pieces();
    if (!is_alone && (n_.rebound || met_)) return after_sides(contact, side);
    if (is_alone)
      met_.reset();
    else
      met_ = {body_.box.position(), v, side};
    return side.into(v) > 0 ? side.reflect(v) : v;
  }
  // Seldom called, and so kept out of what is inlined.
  [[gnu::noinline]] Vec after_sides(const Contact<Real>& contact, Side side) {
    Vec v = body_.velocity;
    std::optional<Side> other;
    if (n_.rebound) {
      if (!(side.into(v) > 0)) return v;
      other = side_beside(contact, side, v);
    } else {
      const Met last = *met_;
      met_ = {body_.box.position(), v, side};
      if (is_there(last.place)) {  // both were met at one time
        met_->velocity = v = last.velocity;
        other = side;
        side = last.side;
      }
    }
    keep_what_stops(v, side, other);
    if (other) return reflect_between(v, side, *other);
    return side.into(v) > 0 ? side.reflect(v) : v;
  }

  // px; sides so near to one another are met at one time.
  Real touch() const { return std::max(settled(body_), Real(kTouch)); }

  // Whether the ball is at a place, or as good as there.
  bool is_there(Vec place) const {
    const Vec off = body_.box.position() - place;
    return std::abs(off.x) + std::abs(off.y) <= touch();
  }

  // The side that the ball touches beside one that it has met, and that stops what this leaves of a velocity.
  // Sides of tiles are level or upright: two of them do the same one by one.
  std::optional<Side> side_beside(const Contact<Real>& contact, const Side& side, Vec velocity) {
    if (contact.is_other || !ground_.has_pieces()) return {};
    const Vec left = velocity + side.normal * side.into(velocity);
    const Real length = std::abs(left.x) + std::abs(left.y);
    if (!(length > 0)) return {};
    const Cast<Real> way{body_.box, left * (touch() / length), body_.foot};
    const Contact<Real> met = cast_box<Real>(ground_, way, {}, nullptr, &budget_);
    const bool may_sink = body_.foot == Foot::centre && met.normal.y == 0;  // the Mover alone knows how deep
    return met && !may_sink ? std::optional(side_of(met.normal, is_level(met, n_.steepest))) : std::nullopt;
  }

  // Flies off the surface of a contact, or stays on it. slide: the motion along it.
  Vec fly_off(const Contact<Real>& contact, Vec slide, bool level) {
    Vec& v = body_.velocity;
    const Vec place = body_.box.position();
    Side side = side_of(flight_.reach(contact, ground_.stretches(), body_.box, body_.foot), level);
    const Vec before = flight_.velocity();
    const Real into = side.into(before);
    if (!(into > 0)) return slide;
    change_ = into + into * side.bounce;
    std::optional<Side> other = side_beside(contact, side, before);
    keep_what_stops(before, side, other);
    bool stays = holds(side, before);
    if (other && holds(*other, before)) stays = true;
    if (stays) {
      if (lift_ != 0) v.y -= lift_;
      lift_ = 0;
      const Vec along{-side.normal.y, side.normal.x};
      v = other ? reflect_between(before, side, *other) : along * (dot(v, along) * side.grip);
      return flight_.slide(v, place);
    }
    const Vec off = other ? reflect_between(before, side, *other) : side.reflect(before);
    const Vec motion = flight_.fly(off, place);
    v = flight_.chord_velocity(part_);
    return motion;
  }

  // Whether a ball with a velocity would be too slow to leave a side for longer than a step. Then it stays,
  // and the side bounces nothing.
  bool holds(Side& side, Vec velocity) const {
    if (side.into(velocity) * side.bounce > -n_.gravity * side.normal.y) return false;
    side.bounce = 0;
    return true;
  }

  const ExactNumbers<Real>& n_;
  const BasicTerrain<Real>& ground_;
  CastBudget& budget_;
  Moving<Real>& body_;
  struct NoFlight {};
  std::conditional_t<flies, Flight<Real>, NoFlight> flight_;
  bool grounded_ = false;
  Real change_ = 0;
  Real part_ = 1;           // steps, the length of a part
  std::optional<Met> met_;  // the last contact, with the ground; not of one that rebounds
  Real left_ = 1;           // steps, of a part, that are left of it; not of one that flies
  Real lift_ = 0;           // px/frame, that the velocity has in this step for its parts
};

// A player: runs along the ground at the speed asked for, and jumps off it.
template <class Real>
class PlayerRule {
 public:
  using Vec = BasicVec2<Real>;
  PlayerRule(const ExactNumbers<Real>& numbers, Moving<Real>& body, Gait& gait)
      : n_(numbers), body_(body), gait_(gait) {}

  // The keys change the velocity. Letting go of the jump key cuts a jump. conveyor: px/frame, of the floor
  // along x: it runs, and stands, in relation to that.
  void take(const Input& input, Real conveyor) {
    Vec& v = body_.velocity;
    const int direction = (input.right ? 1 : 0) - (input.left ? 1 : 0);
    const Real target = n_.run_speed * static_cast<Real>(direction) + conveyor;
    const Real gain = direction == 0 ? n_.run_loss : gait_.grounded ? n_.run_gain : n_.air_gain;
    v.x = v.x < target ? std::min(v.x + gain, target) : std::max(v.x - gain, target);

    if (input.jump && !gait_.jump_held && (gait_.grounded || gait_.coyote > 0)) {
      v.y = -n_.jump_speed;
      gait_.grounded = false;
      gait_.coyote = 0;
      gait_.jumping = true;
    } else if (gait_.jumping && !input.jump && v.y < 0) {
      v.y = v.y * n_.jump_cut;
      gait_.jumping = false;
    }
    gait_.jump_held = input.jump;
    if (!gait_.grounded) v.y = std::min(v.y + n_.player_gravity, n_.fall_limit);
    if (v.y >= 0) gait_.jumping = false;
  }

  // The motion of a step that begins on a floor with this normal.
  Vec walk(Vec normal) const {
    const Real x = n_.surface_speed ? body_.velocity.x * -normal.y : body_.velocity.x;
    return {x, x * slope_of(normal)};
  }

  // What a player does on a contact in the air. It follows level ground and keeps its horizontal motion.
  // Along anything else it slides, until it has landed.
  Vec respond(const Contact<Real>& contact, Vec motion) {
    const Vec normal = contact.normal;
    const Vec rest = motion * (1 - contact.t);
    Vec& v = body_.velocity;
    if (normal.y < 0 && is_level(contact, n_.steepest)) {
      landed_ = true;
      v.y = 0;
      return {rest.x, rest.x * slope_of(normal)};
    }
    if (contact.t == 1) return {};
    if (gait_.grounded || landed_) {
      // A ceiling that does not come down holds it from rising alone.
      if (normal.y > 0 && normal.x * rest.x >= 0) return {rest.x, 0};
      stop_at(contact);
      return {};
    }
    const Real into = dot(v, normal);
    if (into < 0) v = v - normal * into;
    return slide_along(normal, rest);
  }

  // Ends a walk at what the player cannot walk on.
  void stop_at(const Contact<Real>& contact) {
    Real& x = body_.velocity.x;
    if (contact.t != 1 && contact.normal.x * x < 0) x = 0;
  }

  bool landed() const { return landed_; }

  // How far below a grounded player its floor may be after a step that moved it by dx.
  Real reach_down(Real dx) const { return n_.snap > 0 ? n_.snap : std::abs(dx) * n_.steepest + 1; }

  void leave_ground() {
    gait_.grounded = false;
    gait_.coyote = n_.coyote_frames;
  }
  void stand() {
    gait_.grounded = true;
    gait_.jumping = false;
    gait_.coyote = 0;
    body_.velocity.y = 0;
  }

 private:
  const ExactNumbers<Real>& n_;
  Moving<Real>& body_;
  Gait& gait_;
  bool landed_ = false;
};

}  // namespace talus
