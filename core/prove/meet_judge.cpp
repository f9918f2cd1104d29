#include "meet_judge.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr double kInGround =
    1.0 / 128;  // px; circles that come from a curve to other ground do so with small errors
constexpr double kWay = 1.0 / 16;     // px; how far ahead its way is looked at
constexpr double kFarthestWay = 8;    // px; the most that is said of a way where nothing stops it
constexpr double kBeside = 1.0 / 64;  // px; what touches a corner may be so far beside it
constexpr double kRestSlack = 1.0 / 8192, kRestWay = 1.0 / 128;  // px; the same two of a body that rests
// px; behind a low edge there is room so far on, and before it a level floor.
constexpr double kPastEdge = 0.5;
constexpr double kNarrow = 1.0 / (1 << 20);  // px; heights are found to this
constexpr double kThrough = 1.0 / 64;        // px below a floor: curves are so far off the chords of steps
constexpr double kLeastSlope = 1.0 / 16;     // a body may rest on what is less steep, whatever its friction
constexpr int kDirections = 48;              // in which a body at rest might go
constexpr double kLeastGain = 1.0 / 16;      // px of height
constexpr double kShareOfGain = 1.0 / 1024;  // of the energy that it has

RawForm form_of(const Body& body) { return {body.box, radius_of(body.kind, {body.box.w, body.box.h})}; }

// px^2/frame^2, of a mass of 1.
double energy(Vec2 velocity, double spin) { return dot(velocity, velocity) / 2 + spin * spin / 4; }

// px: a height between two at which something fits that does not fit just below. It fits at `high`.
template <class Fits>
double lowest(double low, double high, Fits fits) {
  while (high - low > kNarrow) {
    const double middle = (low + high) / 2;
    (fits(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

MeetJudge::MeetJudge(const RawGround& ground, const Scene& scene, double lip)
    : ground_(ground),
      tuning_(scene.tuning.shared),
      gravity_(scene.tuning.exact.gravity),
      only_weight_moves_(!scene.ground->has_conveyors() &&
                         !(tuning_.drift_blend > 0 && tuning_.drift_speed != 0)),
      lip_(lip) {}

std::optional<Verdict> MeetJudge::judge(const Body& before, const Body& after,
                                        const StepRecord& record) const {
  const RawForm from = form_of(before), to = form_of(after);
  if (!ground_.has_row_at(to.around().y1)) return std::nullopt;
  if (!is_free(to, kInGround) && is_free(from, kInGround))
    return Verdict{FindingKind::inside, depth_in_ground(to)};
  if (is_across_line(from)) return std::nullopt;
  if (const double px = depth_below_floor(from, to); px > 0) return Verdict{FindingKind::falls_through, px};
  if (const double px = gain(before, after); px > 0) return Verdict{FindingKind::gains, px};
  return judge_contacts(before, record);
}

// A body whose weight pulls it goes on if there is room in a direction that leads down, and is steeper than
// its friction holds. A circle rolls, whatever its friction.
std::optional<Verdict> MeetJudge::judge_rest(const Body& body) const {
  const RawForm form = form_of(body);
  if (!only_weight_moves_ || !(pull_on(body) > 0) || is_across_line(form) || !is_free(form, kRestSlack))
    return std::nullopt;
  const double friction = form.is_round() ? 0 : traits_of(body.kind).friction;
  // On the very end of a slope or a ledge both that and what is beside it may hold it.
  for (const double side : {0.0, -kBeside, kBeside})
    if (const RawForm there = form.moved({side, 0}); is_free(there, kRestSlack) && is_held(there, friction))
      return std::nullopt;
  return Verdict{FindingKind::stops, kRestWay};
}

bool MeetJudge::is_held(const RawForm& form, double friction) const {
  const auto has_way = [&](Vec2 way) {
    const auto is_free_after = [&](double share) {
      return !is_stopped(form, form.moved(way * (share * kRestWay)), kRestSlack);
    };
    return is_free_after(1.0 / 16) && is_free_after(1.0 / 4) && is_free_after(1);
  };
  for (int i = 1; i < kDirections; ++i) {
    const double turn = std::acos(-1.0) * i / kDirections;
    const Vec2 way{std::cos(turn), std::sin(turn)};
    if (way.y > (friction + kLeastSlope) * std::abs(way.x) && has_way(way)) return false;
  }
  return true;
}

std::optional<Rect> MeetJudge::standing_place(BodyKind kind, Rect box, double rise) const {
  const double radius = radius_of(kind, {box.w, box.h}), bottom = box.y;
  const auto is_free_at = [&](double lift) {
    box.y = bottom - lift;
    return is_clear({box, radius});
  };
  if (!is_free_at(rise)) return std::nullopt;
  box.y = bottom - lowest(0, rise, is_free_at) - kNarrow;
  return box;
}

bool MeetJudge::is_clear(BodyKind kind, const Rect& box) const {
  return is_clear({box, radius_of(kind, {box.w, box.h})});
}

bool MeetJudge::is_clear(const RawForm& form) const {
  return ground_.for_parts(form.around(), [&](const RawPart& part) { return !form.meets(part, 0); });
}

bool MeetJudge::is_free(const RawForm& form, double slack) const {
  return ground_.for_parts(form.around(), [&](const RawPart& part) {
    return part.kind != RawPart::Kind::solid || !form.meets(part, slack);
  });
}

bool MeetJudge::is_across_line(const RawForm& form) const {
  return !ground_.for_parts(form.around(), [&](const RawPart& part) {
    return part.kind == RawPart::Kind::solid || !form.meets(part, kInGround);
  });
}

bool MeetJudge::is_stopped(const RawForm& from, const RawForm& to, double slack) const {
  return !ground_.for_parts(hull(from.around(), to.around()),
                            [&](const RawPart& part) { return !from.is_stopped_by(part, to, slack); });
}

bool MeetJudge::is_stopped(const RawForm& from, const RawForm& to) const {
  return is_stopped(from, to, kInGround);
}

bool MeetJudge::is_there(const RawForm& touching, Vec2 normal) const {
  const Vec2 into = normal * -kWay, beside = Vec2{-normal.y, normal.x} * kBeside;
  return is_stopped(touching, touching.moved(into)) || is_stopped(touching, touching.moved(into + beside)) ||
         is_stopped(touching, touching.moved(into - beside));
}

// px, of a form that is not free: by so much all its sides must come in until it is.
double MeetJudge::depth_in_ground(const RawForm& form) const {
  const FineBox box = form.around();
  const double half = px_of(std::min(box.x1 - box.x0, box.y1 - box.y0)) / 2;
  return lowest(kInGround, half, [&](double slack) { return is_free(form, slack); });
}

// px: so far below a floor is the middle of its bottom, which was above it; 0: there is no such floor.
double MeetJudge::depth_below_floor(const RawForm& before, const RawForm& after) const {
  const Vec2 from = before.foot(), to = after.foot();
  if (to.y <= from.y) return 0;
  const Fine left = fine(std::min(from.x, to.x)), right = fine(std::max(from.x, to.x));
  double deepest = 0;
  ground_.for_parts({left, fine(from.y - kInGround), right, fine(to.y)}, [&](const RawPart& part) {
    if (!part.is_floor() || part.top.x0 > left || part.top.x1 < right) return true;
    const double depth = to.y - px_of(part.top.at(fine(to.x)));
    if (px_of(part.top.at(fine(from.x))) >= from.y - kInGround && depth > kThrough)
      deepest = std::max(deepest, depth);
    return true;
  });
  return deepest;
}

// px, of a body that something not there stopped: so far at least it could go on against that normal.
double MeetJudge::free_way(const RawForm& touching, Vec2 normal) const {
  double way = kWay;
  while (way < kFarthestWay && !is_stopped(touching, touching.moved(normal * -(way + kWay)))) way += kWay;
  return way;
}

std::optional<Verdict> MeetJudge::judge_contacts(const Body& before, const StepRecord& record) const {
  for (const ContactRecord& contact : record.contacts) {
    if (!contact.handled || contact.overlaps || contact.other.body != 0) continue;
    Body there = before;
    there.box.x = contact.touch.x;
    there.box.y = contact.touch.y;
    const RawForm touching = form_of(there);
    if (!ground_.has_row_at(touching.around().y1)) continue;
    if (!is_there(touching, contact.normal))
      return Verdict{FindingKind::ghost, free_way(touching, contact.normal)};
    if (auto lip = lip_met(touching, contact.normal)) return lip;
  }
  return std::nullopt;
}

// Of a body that goes along a level floor, and is stopped by a low edge.
std::optional<Verdict> MeetJudge::lip_met(const RawForm& touching, Vec2 normal) const {
  const auto height = lip_before(touching, normal);
  const int direction = normal.x > 0 ? -1 : 1;
  const RawForm behind = touching.moved({-direction * kPastEdge, 0});
  if (!height || !is_free(behind, kInGround) || !is_stopped(behind, behind.moved({0, 4 * kInGround})))
    return std::nullopt;
  const FineBox box = touching.around();
  const double front = px_of(direction > 0 ? box.x1 : box.x0);
  const double x = touching.is_round() ? touching.middle().x - normal.x * touching.radius() : front;
  return Verdict{FindingKind::lip, *height, Vec2{x, touching.foot().y - *height}, direction};
}

// px: how high the edge is that a body meets; nothing: it is no low edge.
std::optional<double> MeetJudge::lip_before(const RawForm& touching, Vec2 normal) const {
  const double ahead = normal.x > 0 ? -kPastEdge : kPastEdge;
  const auto has_room = [&](double height) {
    return !is_stopped(touching, touching.moved({0, -height})) &&
           !is_stopped(touching.moved({0, -height}), touching.moved({ahead, -height}));
  };
  const double weld = 1.0 / kWeldParts;
  if (touching.is_round()) {
    // Its middle must come to be above the edge.
    const double height = touching.radius() * (1 + normal.y);
    if (normal.x == 0 || height <= weld + kInGround || height > lip_ + kInGround) return std::nullopt;
    const Vec2 over{ahead - normal.x * touching.radius(), -height};
    const RawForm there = touching.moved(over);
    return is_free(there, kInGround) && !is_across_line(there) ? std::optional(height) : std::nullopt;
  }
  // What may be in ground by a slack has room by so much below the height.
  if (normal.y != 0 || !has_room(lip_) || has_room(weld)) return std::nullopt;
  return rounded_px(lowest(weld, lip_, has_room) + kInGround);
}

// px/frame^2, down.
double MeetJudge::pull_on(const Body& before) const {
  return gravity_ > 0 ? gravity_ : (tuning_.fall_speed - before.velocity.y) * tuning_.fall_blend;
}

// px: as much energy a body has got from nothing as a fall of so many px gives it; of a body that nothing
// pulls, how far it would go in a frame with that alone. 0: it has got none.
double MeetJudge::gain(const Body& before, const Body& after) const {
  if (!only_weight_moves_ || !before.is_clear) return 0;
  const double kept = 1 - tuning_.drift_blend, pull = pull_on(before);
  const double had = energy({before.velocity.x * kept, before.velocity.y}, before.spin * kept);
  const double has = energy(after.velocity, after.spin);
  const double gained = has - had - pull * (after.box.y - before.box.y);
  const double px = pull > 0 ? gained / pull : std::sqrt(std::max(2 * gained, 0.0));
  return px > kLeastGain && gained > kShareOfGain * has ? px : 0;
}

}  // namespace talus
