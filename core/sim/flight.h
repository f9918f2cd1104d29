// Flight: the parabola of a body in a part of a step. Casts go along its chords, so a contact of a chord is
// moved to where the parabola itself meets the surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <talus/collision/cast.h>
#include "../collision/box_on_piece.h"

namespace talus {

// When a body on a parabola comes to a surface, and the normal there.
template <class Real>
struct Arrival {
  Real time;  // frames
  BasicVec2<Real> normal;
};

// The arrival at the surface of a contact: a curve may have another normal than where the chord of the
// parabola met it. box: of the body, at the place of the contact; time_to(point, normal): frames, until the
// body meets a plane; x_at(time): px, of the body.
template <class Real, class TimeTo, class XAt>
Arrival<Real> arrival_on(const Contact<Real>& contact, std::span<const CurveStretch<Real>> stretches,
                         BasicRect<Real> box, Foot foot, TimeTo time_to, XAt x_at) {
  Arrival<Real> found{time_to(box.position(), contact.normal), contact.normal};
  const Piece<Real>* const piece = contact.on_end ? nullptr : contact.piece;
  constexpr int kMostTries = 8;  // each has about twice as many right digits as the one before
  for (int i = 0; piece != nullptr && piece->stretch != 0 && i < kMostTries; ++i) {
    box.x = x_at(found.time);
    const Real x = box.x + foot_offset(*piece, box.w, foot);
    if (!(x >= piece->x0 && x <= piece->x1)) break;
    box.y = rest_on(*piece, stretches, box, foot);
    found.normal = normal_on(stretches[piece->stretch - 1].tangent_at(x), piece->facing);
    const Real before = found.time;
    found.time = time_to(box.position(), found.normal);
    if (found.time == before) break;
  }
  return found;
}

template <class Real>
class Flight {
 public:
  using Vec = BasicVec2<Real>;

  // place: px, of the body; velocity: px/frame there; gravity: px/frame^2; time: frames, of the part.
  void begin(Vec place, Vec velocity, Real gravity, Real time) {
    place_ = place;
    velocity_ = velocity;
    gravity_ = gravity;
    left_ = time;
  }

  // Flies on to the surface of a contact. box: of the body, at the place of the contact. Returns the normal
  // there: a curve may have another one than where its chord was met.
  Vec reach(const Contact<Real>& contact, std::span<const CurveStretch<Real>> stretches, BasicRect<Real> box,
            Foot foot) {
    const auto [time, normal] = arrival_on(
        contact, stretches, box, foot, [&](Vec point, Vec across) { return time_to(point, across); },
        [&](Real after) { return place_at(after).x; });
    begin(place_at(time), velocity_ + Vec{0, gravity_ * time}, gravity_, left_ - time);
    return normal;
  }

  // px/frame, where it is.
  Vec velocity() const { return velocity_; }
  // Flies on with another velocity. from: px, where the body is. Returns the chord to the end of the part.
  Vec fly(Vec velocity, Vec from) {
    velocity_ = velocity;
    return place_at(left_) - from;
  }
  // Goes on along a surface, which carries it. from: px, where the body is.
  Vec slide(Vec velocity, Vec from) {
    begin(from, velocity, 0, left_);
    return velocity * left_;
  }
  // px/frame, of the chord of a whole part that would end where this one ends. part: frames, its length.
  Vec chord_velocity(Real part) const { return velocity_ + Vec{0, gravity_ * (left_ - part / 2)}; }

 private:
  Vec place_at(Real time) const { return place_ + velocity_ * time + Vec{0, gravity_ * time * time / 2}; }

  // frames, until it meets a plane through a point, px.
  Real time_to(Vec point, Vec normal) const {
    const Real pull = -gravity_ * normal.y, start = -dot(velocity_, normal);
    if (!(start > 0 || pull > 0)) return 0;
    const Real distance = std::max<Real>(0, dot(place_ - point, normal));
    const Real into = std::sqrt(std::max<Real>(0, start * start + 2 * pull * distance));
    return std::min(start > 0 ? 2 * distance / (start + into) : (into - start) / pull, left_);
  }

  Vec place_, velocity_;
  Real gravity_ = 0, left_ = 0;
};

}  // namespace talus
