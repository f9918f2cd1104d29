// When a box that moves straight meets one stretch of a curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <talus/collision/piece.h>
#include "curve_time.h"

namespace talus {

// The part of a motion during which a box is over or under a stretch, and how far it is from it then.
template <class Real>
struct CastWindow {
  Real from = 0, to = 0;  // times; from > to means never
  Real gap = 0;           // px, at the beginning
  Real last_gap = 0;      // px, at the end
};

// The iterations end when the gap is at most this share of the slack.
inline constexpr int kSharesOfSlack = 8;

template <class Real>
struct CurveCast {
  const Piece<Real>& piece;  // of a curve
  std::span<const CurveStretch<Real>> stretches;
  BasicVec2<Real> from, motion;  // of the box's top-left corner
  Real offset, lift;             // from there to the point of the box that meets the curve
  Real slack;                    // px, what rounding may have put the box behind the curve
  Real rounding;                 // the relative error of a rounded number

  // Returns nothing if the box does not meet the curve during the window.
  std::optional<Real> time(const CastWindow<Real>& window) const {
    if (window.from > window.to || window.gap < -slack) return std::nullopt;
    const bool dips = stretch().bends_down == up();  // the gap may close and open again
    Real last = window.to;
    if (window.gap <= slack) {
      // On the curve the answer depends on the tangent, which rounding makes a little wrong.
      const Real rate = opening(window.from);
      const Real wrong = rounding * (std::abs(motion.x) + std::abs(motion.y));
      if (rate < -wrong || (rate <= wrong && !dips)) return window.from;
      if (dips) return std::nullopt;
    }
    if (!(window.last_gap < 0)) {
      if (!dips || !(opening(window.from) < 0) || !(opening(window.to) > 0)) return std::nullopt;
      last = zero_between(window.from, window.to, [&](Real t) { return -opening(t); });
      if (!(gap(last) < 0)) return std::nullopt;
    }
    return closing_time(window, last);
  }

 private:
  const CurveStretch<Real>& stretch() const { return stretches[piece.stretch - 1]; }
  bool up() const { return piece.facing == Facing::up; }
  Real sign() const { return up() ? 1 : -1; }
  Real corner_x(Real t) const { return std::clamp(from.x + t * motion.x + offset, piece.x0, piece.x1); }
  Real gap(Real t) const {
    return sign() * (piece.y_at(corner_x(t), stretches) - lift - (from.y + t * motion.y));
  }
  // The rate at which the gap grows, times a positive factor that spares a division by an upright tangent.
  Real opening(Real t) const {
    const BasicVec2<Real> along = stretch().tangent_at(corner_x(t));
    return sign() * (along.y * motion.x - along.x * motion.y);
  }

  // The time, between the window's beginning and `last`, at which the gap closes. Circles and parabolas have
  // a closed form, which rounding may put a little outside.
  Real closing_time(const CastWindow<Real>& w, Real last) const {
    const CurveStretch<Real>& s = stretch();
    const Real u = from.x + w.from * motion.x + offset - s.c[0];
    Real t;
    if (s.kind == CurveStretch<Real>::Kind::arc) {
      const Real v = from.y + w.from * motion.y + lift - s.c[1];
      t = circle_time<Real>({u, v}, motion, s.c[2], up() == (s.sign < 0));
    } else if (s.kind == CurveStretch<Real>::Kind::polynomial && s.c[4] == 0) {
      t = parabola_time(w.gap, sign() * ((s.c[2] + 2 * s.c[3] * u) * motion.x - motion.y),
                        sign() * s.c[3] * motion.x * motion.x);
    } else {
      const auto rate = [&](Real at) {
        const BasicVec2<Real> along = s.tangent_at(corner_x(at));
        return sign() * (along.y / along.x * motion.x - motion.y);
      };
      t = newton_between(
              w.from, last, [this](Real at) { return gap(at); }, rate, slack / kSharesOfSlack) -
          w.from;
    }
    // clamp gives w.from for NaN, which comes from a start on the curve
    return std::clamp(w.from + t, w.from, last);
  }
};

}  // namespace talus
