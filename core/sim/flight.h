// Flight: the parabola of a body in a part of a step. Casts go along its chords. So what a chord has met is
// looked for once more by shorter chords, and then moved to where the parabola itself meets the surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
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
  constexpr int kMaxTries = 8;  // each has about twice as many right digits as the one before
  for (int i = 0; piece != nullptr && piece->stretch != 0 && i < kMaxTries; ++i) {
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

// Whether a contact is with two mirror images at once, see cast_box(), one of which is a curve: then its
// normal is that of neither.
template <class Real>
bool is_between_curves(const Contact<Real>& contact, std::span<const CurveStretch<Real>> stretches,
                       BasicRect<Real> box, Foot foot) {
  const Piece<Real>* const piece = contact.on_end ? nullptr : contact.piece;
  if (piece == nullptr || piece->stretch == 0 || contact.normal.x != 0) return false;
  const Real x = std::clamp(box.x + foot_offset(*piece, box.w, foot), piece->x0, piece->x1);
  return stretches[piece->stretch - 1].tangent_at(x).y != 0;
}

// frames; so short a chord is the parabola but for the hit's time
inline constexpr double kNearHit = 0.0009765625;
inline constexpr int kMaxAims = 8;  // of one contact; more are needed by what the parabola grazes

template <class Real>
class Flight {
 public:
  using Vec = BasicVec2<Real>;

  // place: px, of the body; velocity: px/frame there; gravity: px/frame^2; time: frames, of the part.
  void begin(Vec place, Vec velocity, Real gravity, Real time) {
    from_ = place_ = place;
    velocity_ = velocity;
    gravity_ = gravity;
    left_ = time;
  }

  // Makes a contact of the chord that of the parabola: with what that meets first. Returns false if that is
  // nothing. cast(from, to): what the body meets on a straight way, px; without an answer the contact stays
  // as it is. box: of the body, anywhere.
  template <class CastTo>
  bool aim(Contact<Real>& contact, std::span<const CurveStretch<Real>> stretches, BasicRect<Real> box,
           Foot foot, CastTo cast) {
    if (gravity_ == 0 || contact.t == 0) return true;
    const Flight start = *this;
    std::optional<Contact<Real>> met = contact;
    Real to = left_;  // frames, to the end of the chord that met it
    for (int i = 0; i < kMaxAims; ++i) {
      Real time = arrival(*met, stretches, box, foot).time;
      if (!(time > 0 && time < to)) time = met->t * to;
      if (const Real before = time - Real(kNearHit); before > 0) {
        met = cast(from_, place_at(before));
        if (!met) break;
        to = before;
        if (*met) continue;
        go_on(before);
        time = Real(kNearHit);
      }
      to = std::min(time + Real(kNearHit), left_);
      met = cast(from_, place_at(to));
      if (!met) break;
      if (*met) {
        met->t = std::min<Real>(1, (start.left_ - left_ + met->t * to) / start.left_);
        contact = *met;
        return true;
      }
      if (!(to < left_)) return false;
      go_on(to);
      to = left_;
      met = cast(from_, place_at(to));
      if (!met) break;
      if (!*met) return false;
    }
    *this = start;
    return true;
  }

  // Flies on to the surface of a contact. Returns the normal there: a curve may have another one than where
  // its chord was met. box: of the body, anywhere.
  Vec reach(const Contact<Real>& contact, std::span<const CurveStretch<Real>> stretches, BasicRect<Real> box,
            Foot foot) {
    const auto [time, normal] = arrival(contact, stretches, box, foot);
    go_on(time);
    return normal;
  }

  // px, of the body at the end of the part.
  Vec end() const { return place_at(left_); }
  // px/frame, where it is.
  Vec velocity() const { return velocity_; }
  // Flies on with another velocity. from: px, where the body is. Returns the chord to the end of the part.
  Vec fly(Vec velocity, Vec from) {
    velocity_ = velocity;
    from_ = from;
    return end() - from;
  }
  // Goes on along a surface, which carries it. from: px, where the body is.
  Vec slide(Vec velocity, Vec from) {
    begin(from, velocity, 0, left_);
    return velocity * left_;
  }
  // px/frame, of the chord of a whole part that would end where this one ends. part: frames, its length.
  Vec chord_velocity(Real part) const { return velocity_ + Vec{0, gravity_ * (left_ - part / 2)}; }

 private:
  // time: frames.
  void go_on(Real time) {
    begin(place_at(time), velocity_ + Vec{0, gravity_ * time}, gravity_, left_ - time);
  }

  // Of the body on its parabola at the surface of a contact.
  Arrival<Real> arrival(Contact<Real> contact, std::span<const CurveStretch<Real>> stretches,
                        BasicRect<Real> box, Foot foot) const {
    box.x = contact.position.x;
    box.y = contact.position.y;
    if (is_between_curves(contact, stretches, box, foot)) contact.piece = nullptr;
    return arrival_on(
        contact, stretches, box, foot, [&](Vec point, Vec across) { return time_to(point, across); },
        [&](Real after) { return place_at(after).x; });
  }

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
  Vec from_;  // px, of the body where its chord begins: on what it has left, as a cast puts it there
  Real gravity_ = 0, left_ = 0;
};

}  // namespace talus
